//! Counts the instructions of a program by valgrind's callgrind: repeatable where seconds are not.
//!
//! The output is text (<https://valgrind.org/docs/manual/cl-format.html>). `fl=`, `fi=`, `fe=` name the source file of the costs
//! that follow, `fn=` the function, whose inlined parts keep their own files; `calls=` is followed by the cost of a callee with
//! all that it calls. Names come in full once, `(3) name`, then as `(3)`.
#![allow(
    dead_code,
    reason = "each program takes this file in as its own and uses some of it"
)]

use std::collections::BTreeMap;
use std::process::Command;

/// The functions that make the report, or tell before that there is no use in beginning.
pub(crate) const REPORT: [&str; 7] = [
    "solver::motion::needs::refuse",
    "solver::trace::Trace::look",
    "solver::way::Way::to_go",
    "solver::way::Way::points",
    "solver::settling::estimate",
    "solver::summary::energies",
    "solver::drape::measure_all",
];

/// What a program did, in instructions.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Profile {
    /// By source file, without what was called.
    files: BTreeMap<String, u64>,
    /// By function, with all that it called.
    functions: BTreeMap<String, u64>,
    /// By function, without what was called.
    own: BTreeMap<String, u64>,
}

/// Runs this program once more, with `arguments`, under callgrind.
///
/// # Errors
/// What valgrind or the program said, if it failed.
pub(crate) fn run(arguments: &[&str]) -> Result<Profile, String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let out = folder.path().join("callgrind.out");
    let ran = Command::new("valgrind")
        .args(["--tool=callgrind", "--quiet"])
        .arg(format!("--callgrind-out-file={}", out.display()))
        .arg(program)
        .args(arguments)
        .output()
        .map_err(|error| {
            format!("valgrind counts instructions, and make test installs it: {error}")
        })?;
    if !ran.status.success() {
        let said = [ran.stdout, ran.stderr].concat();
        return Err(String::from_utf8_lossy(&said).into_owned());
    }
    let text = std::fs::read_to_string(&out).map_err(|error| error.to_string())?;
    Ok(Profile::read(&text))
}

impl Profile {
    /// Reads the output of callgrind.
    pub(crate) fn read(text: &str) -> Self {
        let mut reader = Reader::default();
        text.lines().for_each(|line| reader.line(line));
        reader.profile
    }

    /// Instructions in the source files whose path ends in `path`, or goes on below it; inlined ones too.
    pub(crate) fn in_file(&self, path: &str) -> u64 {
        let here = |file: &&String| file.ends_with(path) || file.contains(&format!("{path}/"));
        let files = self.files.keys().filter(here);
        files.map(|file| self.files[file]).sum()
    }

    /// Instructions of the functions whose name ends in `name`, with all that they call; `None` if there is no such function.
    pub(crate) fn of(&self, name: &str) -> Option<u64> {
        let functions = self.functions.iter();
        let found: Vec<u64> = functions
            .filter(|(function, _)| plain(function).ends_with(name))
            .map(|(_, cost)| *cost)
            .collect();
        (!found.is_empty()).then(|| found.iter().sum())
    }

    /// The functions with the most instructions of their own.
    pub(crate) fn most_expensive(&self) -> Vec<(&str, u64)> {
        let mut own: Vec<_> = self.own.iter().map(|(f, c)| (f.as_str(), *c)).collect();
        own.sort_by_key(|(_, cost)| std::cmp::Reverse(*cost));
        own
    }
}

/// A Rust path without angle brackets and hash: `<a::b::C>::d` is `a::b::C::d`.
fn plain(function: &str) -> String {
    let is_hash = |end: &str| end.len() == 16 && end.bytes().all(|b| b.is_ascii_hexdigit());
    let path = match function.rsplit_once("::h") {
        Some((path, end)) if is_hash(end) => path,
        _ => function,
    };
    path.replace(['<', '>'], "")
}

#[derive(Default)]
struct Reader {
    profile: Profile,
    files: BTreeMap<String, String>,
    functions: BTreeMap<String, String>,
    file: String,
    function: String,
    callee: String,
    /// Whether the next line of costs is that of a call.
    called: bool,
}

impl Reader {
    fn line(&mut self, line: &str) {
        if let Some((key, value)) = line.split_once('=') {
            match key {
                "fl" | "fi" | "fe" => self.file = name(&mut self.files, value),
                "cfl" | "cfi" => drop(name(&mut self.files, value)),
                "fn" => self.function = name(&mut self.functions, value),
                "cfn" => self.callee = name(&mut self.functions, value),
                "calls" => self.called = true,
                _ => {}
            }
        } else if line.starts_with(|c: char| c.is_ascii_digit() || "+-*".contains(c)) {
            let cost = line.split(' ').nth(1).and_then(|cost| cost.parse().ok());
            self.cost(cost.unwrap_or(0));
        }
    }

    fn cost(&mut self, cost: u64) {
        let add = |sums: &mut BTreeMap<String, u64>, key: &String| {
            *sums.entry(key.clone()).or_insert(0) += cost;
        };
        // What calls itself is counted once for all.
        if !(self.called && self.callee == self.function) {
            add(&mut self.profile.functions, &self.function);
        }
        if !std::mem::take(&mut self.called) {
            add(&mut self.profile.files, &self.file);
            add(&mut self.profile.own, &self.function);
        }
    }
}

/// The name that `value` gives in full, `(3) name`, or by its number, `(3)`.
fn name(known: &mut BTreeMap<String, String>, value: &str) -> String {
    let (number, name) = value.split_once(' ').unwrap_or((value, ""));
    if !name.is_empty() {
        known.insert(number.to_owned(), name.to_owned());
    }
    known.get(number).cloned().unwrap_or_default()
}
