//! Memory that reading a file takes: in proportion to a large one, bounded for a hostile one.

use seamster::config::Limits;
use seamster::memory::peak_bytes;
use seamster::pattern::{ImportOptions, import};
use seamster_fixtures::dxf::DxfBuilder;
use std::path::PathBuf;

/// Peak of the memory of this process since [`reset_peak`] \[bytes\]; `None` where the system does
/// not say.
fn peak_memory() -> Option<usize> {
    usize::try_from(peak_bytes()?).ok()
}

/// Begins the peak anew, so that what ran before in this process does not count.
fn reset_peak() {
    // Where the kernel cannot do it the peak of before counts too, and a test is harder to pass.
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}

/// Pieces as CAD writes them: a block each, runs of polylines with a vertex in eight lines, turn
/// points.
fn pieces() -> Vec<u8> {
    let mut file = DxfBuilder::metric();
    for i in 0..400 {
        let name = format!("PIECE-{i}");
        file = file.block(&name).text("1", &format!("Piece Name: {name}"));
        let corners = [
            [0.0, 0.0],
            [300.1234, 0.0],
            [300.1234, 400.4321],
            [0.0, 400.4321],
        ];
        for k in 0..4 {
            let (a, b) = (corners[k], corners[(k + 1) % 4]);
            let at = |t: f64| [0, 1].map(|k: usize| a[k] + t * (b[k] - a[k]));
            let run: Vec<[f64; 2]> = (0..=64).map(|i| at(f64::from(i) / 64.0)).collect();
            file = file.run("1", false, &run).point("2", a);
        }
    }
    file.bytes()
}

/// A piece, and then one kind of entity without end.
fn filled(add: impl Fn(DxfBuilder, [f64; 2]) -> DxfBuilder) -> Vec<u8> {
    let square = [[0.0, 0.0], [300.0, 0.0], [300.0, 400.0], [0.0, 400.0]];
    let mut file = DxfBuilder::metric().run("1", true, &square);
    for i in 0..50_000_u32 {
        file = add(file, [f64::from(i % 300), f64::from(i * 7 % 400)]);
    }
    file.bytes()
}

#[test]
fn large_files_stay_within_their_share_of_memory() {
    reset_peak();
    let Some(before) = peak_memory() else {
        println!("left out: memory of large files (the system does not tell it)");
        return;
    };
    let real = pieces();
    assert!(real.len() > 4_000_000, "{}", real.len());
    let read = |bytes: &[u8]| import(bytes, &ImportOptions::default(), &Limits::default());
    let pattern = read(&real).expect("400 pieces");
    assert_eq!(pattern.panels.len(), 400);
    let share = |bytes: usize| {
        let grown = peak_memory().expect("told before") - before;
        println!(
            "{bytes} bytes: peak of {:.1} times as much",
            grown as f64 / bytes as f64
        );
        grown / bytes
    };
    // The builder itself holds the file three times.
    assert!(share(real.len()) < 12 + 3);
    drop(pattern);
    for bytes in [
        filled(|file, p| file.point("13", p)),
        filled(|file, p| file.line("8", p, [p[1], p[0]])),
        filled(|file, p| file.text("1", &p[0].to_string())),
    ] {
        let pattern = read(&bytes).expect("one piece");
        assert_eq!(pattern.panels.len(), 1);
        assert!(share(bytes.len()) < 60);
    }
}

#[test]
fn hostile_files_take_little_memory() {
    let Some(data) = std::env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from) else {
        println!("left out: memory of hostile files (SEAMSTER_TEST_DATA is unset)");
        return;
    };
    reset_peak();
    let Some(before) = peak_memory() else {
        println!("left out: memory of hostile files (the system does not tell it)");
        return;
    };
    for entry in std::fs::read_dir(data.join("dxf-bad")).expect("a folder of hostile files") {
        let path = entry.expect("an entry").path();
        if path.is_file() {
            let bytes = std::fs::read(&path).expect("a file that can be read");
            drop(import(
                &bytes,
                &ImportOptions::default(),
                &Limits::default(),
            ));
        }
    }
    let grown = (peak_memory().expect("told before") - before) >> 20;
    assert!(grown < 200, "peak of all hostile files: {grown} MB");
}
