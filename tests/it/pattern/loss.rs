//! Nothing is lost in silence: what a file holds and the pattern does not is named by a warning,
//! for the real files and for thousands of damaged copies. `SEAMSTER_MUTATIONS` sets how many
//! copies (500; every seed gives the same copy).

use seamster::config::Limits;
use seamster::pattern::{ImportOptions, Pattern, import};
use seamster_fixtures::damage::damaged;
use seamster_fixtures::loss::account;
use std::path::PathBuf;

/// The real text files, in the order of their names, the largest left out: they are like others.
fn files() -> Option<Vec<(String, Vec<u8>)>> {
    let folder = PathBuf::from(std::env::var_os("SEAMSTER_TEST_DATA")?).join("dxf");
    let entries = std::fs::read_dir(&folder).expect("a folder of files");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let is_dxf = |p: &PathBuf| p.extension().is_some_and(|e| e.eq_ignore_ascii_case("dxf"));
    let mut paths: Vec<PathBuf> = paths.filter(is_dxf).collect();
    paths.sort();
    let read = |p: &PathBuf| {
        let name = p
            .file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        (name, std::fs::read(p).expect("a file that can be read"))
    };
    Some(paths.iter().map(read).collect())
}

fn read(bytes: &[u8]) -> Option<Pattern> {
    import(bytes, &ImportOptions::default(), &Limits::default()).ok()
}

#[test]
fn real_files_are_held_whole_or_warned_about() {
    let Some(files) = files() else {
        println!("left out: what is lost of 48 real files (SEAMSTER_TEST_DATA is unset)");
        return;
    };
    let mut silent = Vec::new();
    let mut asked = 0;
    for (name, bytes) in files.iter().filter(|f| !f.0.starts_with("binary")) {
        let pattern = read(bytes).expect("a file that can be read");
        let account = account(bytes, &pattern).expect("nothing lies far away");
        println!(
            "{name:45} {:6} entities, {:3} not held, {:3} warned about",
            account.asked, account.missing, account.warned
        );
        asked += account.asked;
        if account.is_silent() {
            silent.push(format!("{name}: {account:?}"));
        }
    }
    assert!(silent.is_empty(), "{}", silent.join("\n"));
    assert!(asked > 2_000, "{asked}");
}

#[test]
fn damaged_files_are_held_whole_or_warned_about_or_refused() {
    let Some(files) = files() else {
        println!("left out: damaged copies of real files (SEAMSTER_TEST_DATA is unset)");
        return;
    };
    let count = std::env::var("SEAMSTER_MUTATIONS").ok();
    let count: u64 = count.map_or(500, |n| n.parse().expect("a number of copies"));
    let small: Vec<_> = files
        .iter()
        .filter(|f| count > 1000 || f.1.len() < 150_000)
        .collect();
    let (mut refused, mut compared) = (0, 0);
    let mut silent = Vec::new();
    for seed in 0..count {
        let (name, bytes) = small[usize::try_from(seed).expect("small") % small.len()];
        let bytes = damaged(bytes, seed);
        let Some(pattern) = read(&bytes) else {
            refused += 1;
            continue;
        };
        if name.starts_with("binary") {
            continue;
        }
        if let Some(account) = account(&bytes, &pattern) {
            compared += 1;
            if account.is_silent() {
                silent.push(format!("{name} with seed {seed}: {account:?}"));
            }
        }
    }
    println!(
        "{count} damaged copies: {refused} refused, {compared} compared, {} lost in silence",
        silent.len()
    );
    assert!(silent.is_empty(), "{}", silent.join("\n"));
    assert!(compared > count / 5 && refused > count / 20);
}
