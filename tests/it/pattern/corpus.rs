//! The corpus of the fuzz targets replayed: seeds made for it, and the real and hostile files where
//! they are.

use seamster::job::thread_cpu_s;
use seamster_fixtures::holds;
use std::path::{Path, PathBuf};

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut files: Vec<PathBuf> = entries.map(|e| e.expect("an entry").path()).collect();
    files.retain(|file| file.is_file());
    files.sort();
    assert!(!files.is_empty());
    files
}

fn replay(folder: &Path, holds: fn(&[u8])) {
    for file in files(folder) {
        let bytes = std::fs::read(&file).expect("a file that can be read");
        let start = thread_cpu_s();
        holds(&bytes);
        let seconds = thread_cpu_s() - start;
        assert!(seconds < 2.0, "{} took {seconds:.1} s", file.display());
    }
}

fn corpus(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/corpus")
        .join(name)
}

#[test]
fn seeds_of_the_importer_are_read_or_refused() {
    replay(&corpus("import"), holds::of_file);
}

#[test]
fn seeds_of_the_seam_check_are_reported_on() {
    replay(&corpus("seams"), holds::of_seams);
}

#[test]
fn real_and_hostile_files_are_read_or_refused() {
    let Some(data) = std::env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from) else {
        println!("left out: the corpus of real and hostile files (SEAMSTER_TEST_DATA is unset)");
        return;
    };
    replay(&data.join("dxf"), holds::of_file);
    replay(&data.join("dxf-bad"), holds::of_file);
}
