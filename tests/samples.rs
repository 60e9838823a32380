//! The samples that ship are what the drafting program writes, and they are patterns that can be sewn.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

#[path = "../examples/draft_samples/mod.rs"]
mod drafting;

use std::path::PathBuf;

fn shipped(file: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("static/samples")
        .join(file);
    std::fs::read_to_string(&path).unwrap()
}

#[test]
fn shipped_samples_are_those_that_are_drafted() {
    for sample in drafting::samples() {
        let hint = "run `cargo run --example draft_samples`";
        assert!(
            shipped(&format!("{}.dxf", sample.name)) == sample.dxf,
            "{hint}"
        );
        let garment = shipped(&format!("{}.garment.json", sample.name));
        assert_eq!(garment, sample.garment, "{hint}");
    }
}
