//! Modules use names only of modules to their left, and what they may not know they do not name.
//!
//! ARCHITECTURE.md gives the order and the reasons. The source is read as text, less comments and
//! strings, so that a use is found however it is written: `use crate::a::B`,
//! `use crate::{a, b::C}`, `crate::a::f()`, `super::super::a`.

use super::sources::code;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// From left to right; those on one line may use each other.
const ORDER: &[&[&str]] = &[
    &["fault", "config", "progress", "memory"],
    &["json"],
    &["pattern"],
    &["seam"],
    &["mesh"],
    &["scene"],
    &["solver"],
    &["export"],
    &["fit"],
    &["study"],
    &["job"],
    &["http"],
    &["cli"],
    &["main"],
];

/// A name, and the modules that alone may use it.
const KEPT_TO: &[(&str, &[&str])] = &[
    ("axum", &["http", "cli"]),
    ("tower", &["http", "cli"]),
    ("tower_http", &["http", "cli"]),
    ("StatusCode", &["http", "cli"]),
    ("tokio", &["job", "http", "cli"]),
    ("tokio_stream", &["job", "http", "cli"]),
    ("rusqlite", &["job"]),
    ("dxf", &["pattern"]),
    ("png", &["export"]),
    ("spade", &["mesh"]),
    ("jsonschema", &["fit"]),
    ("seamster_cholesky", &["solver"]),
    ("seamster_crossings", &["fit", "scene"]),
    ("std::env", &["config"]),
    ("std::fs", &["memory", "job", "http", "cli"]),
    ("std::net", &["config", "http", "cli"]),
    ("std::thread", &["config", "job", "http", "cli"]),
    ("std::process", &["cli", "main"]),
    ("Instant", &["job", "http", "cli"]),
    ("SystemTime", &["job", "http", "cli"]),
    ("Timestamp", &["job", "http", "cli"]),
    ("RandomState", &[]),
];

#[test]
fn no_module_uses_one_to_its_right() {
    let mut wrong = vec![];
    for file in sources() {
        let own = rank(&file.module);
        for used in uses(&file) {
            if modules().contains(&used.as_str()) && rank(&used) > own {
                wrong.push(format!(
                    "{}: {} uses {used}",
                    file.path.display(),
                    file.module
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_is_kept_to_a_module_is_named_nowhere_else() {
    let mut wrong = vec![];
    for file in sources() {
        for (name, modules) in KEPT_TO {
            if !modules.contains(&file.module.as_str()) && names(&file.code, name) {
                wrong.push(format!("{}: names {name}", file.path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_module_has_its_place_in_the_order() {
    let found: BTreeSet<String> = sources().into_iter().map(|file| file.module).collect();
    let known: BTreeSet<String> = modules().iter().map(|&m| m.to_owned()).collect();
    assert_eq!(found, known);
}

#[test]
fn uses_are_found_however_they_are_written() {
    let file = |path: &str, text: &str| SourceFile::new(PathBuf::from(path), text);
    let found = |path, text| uses(&file(path, text)).into_iter().collect::<Vec<_>>();
    assert_eq!(found("mesh/a.rs", "use crate::solver::Drape;"), ["solver"]);
    assert_eq!(
        found(
            "mesh/a.rs",
            "use crate::{\n job,\n fault::{Fault, Faults},\n};"
        ),
        ["fault", "job"]
    );
    assert_eq!(
        found("mesh/a.rs", "fn f() { crate :: http::serve() }"),
        ["http"]
    );
    assert_eq!(found("mesh/a.rs", "use super::super::job::Queue;"), ["job"]);
    assert_eq!(found("mesh/mod.rs", "use super::job;"), ["job"]);
    assert!(
        found(
            "mesh/a.rs",
            "use super::job;\n// crate::http\n/* crate::http */"
        )
        .is_empty()
    );
    assert!(found("mesh/a.rs", r#"const A: &str = "crate::http \" // ";"#).is_empty());
    assert!(names("let t = Instant::now();", "Instant"));
    assert!(!names(
        "let t = MyInstant::now(); let instantly = 1;",
        "Instant"
    ));
}

/// One file of `src/`.
struct SourceFile {
    path: PathBuf,
    /// The top-level module it belongs to.
    module: String,
    /// Number of `super` that lead from it to the crate.
    depth: usize,
    /// Its text less comments and strings, blanks only where words would run together.
    code: String,
}

impl SourceFile {
    /// `path` is relative to `src/`.
    fn new(path: PathBuf, text: &str) -> Self {
        let parts: Vec<String> = path
            .with_extension("")
            .iter()
            .map(|part| part.to_string_lossy().into_owned())
            .collect();
        let depth = parts.iter().filter(|part| *part != "mod").count();
        Self {
            module: parts[0].clone(),
            depth,
            code: code(text),
            path,
        }
    }
}

/// Every file of `src/` but `lib.rs`, which only names the modules.
fn sources() -> Vec<SourceFile> {
    let files = super::sources::sources().into_iter();
    files
        .filter(|(path, _)| path != "lib.rs")
        .map(|(path, text)| SourceFile::new(PathBuf::from(path), &text))
        .collect()
}

fn modules() -> Vec<&'static str> {
    ORDER.concat()
}

fn rank(module: &str) -> usize {
    let place = ORDER.iter().position(|group| group.contains(&module));
    place.unwrap_or_else(|| panic!("module {module} has no place in ORDER"))
}

/// The names that a file takes from the crate's root.
fn uses(file: &SourceFile) -> BTreeSet<String> {
    let to_root = "super::".repeat(file.depth);
    let after_root = ["crate::", &to_root].into_iter().flat_map(|start| {
        let hits = file.code.match_indices(start);
        let whole = hits.filter(|(at, _)| is_free(&file.code, *at));
        whole.map(move |(at, _)| &file.code[at + start.len()..])
    });
    after_root.flat_map(first_names).collect()
}

/// Returns true if what begins at `at` is not the end of a longer name or path.
fn is_free(code: &str, at: usize) -> bool {
    !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':')
}

/// The first name of a path, or of every path in a group of them.
fn first_names(rest: &str) -> Vec<String> {
    let Some(group) = rest.strip_prefix('{') else {
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        return vec![rest[..end.unwrap_or(rest.len())].to_owned()];
    };
    let mut depth = 0;
    let mut names = vec![String::new()];
    let mut in_name = true;
    for c in group.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                names.push(String::new());
                in_name = true;
            }
            c if depth == 0 && in_name && (c.is_alphanumeric() || c == '_') => {
                names.last_mut().expect("never empty").push(c);
            }
            _ => in_name = false,
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

/// Returns true if a name or path occurs whole.
fn names(code: &str, name: &str) -> bool {
    code.match_indices(name).any(|(at, _)| {
        let after = code[at + name.len()..].chars().next();
        let before = code[..at].chars().next_back();
        let word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
        // A crate is named by a path that begins with it; a module or a field may have the same
        // name.
        let is_crate = name.chars().all(|c| c.is_lowercase() || c == '_');
        let begins =
            before != Some(':') && before != Some('.') && code[at + name.len()..].starts_with("::");
        !word(before) && !word(after) && (!is_crate || begins)
    })
}
