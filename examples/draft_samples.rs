//! Drafts the sample patterns for the default dress form and writes them as DXF, each with its garment file.
//!
//! `cargo run --example draft_samples [FOLDER]` writes `static/samples` unless told otherwise. The files
//! are in the repository: run it again after a change here, and `tests/samples.rs` checks that it was.

#[path = "draft_samples/mod.rs"]
mod drafting;

use std::path::PathBuf;

fn main() -> std::io::Result<()> {
    let folder = std::env::args_os().nth(1).map_or_else(
        || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/static/samples")),
        PathBuf::from,
    );
    std::fs::create_dir_all(&folder)?;
    for sample in drafting::samples() {
        let dxf = folder.join(format!("{}.dxf", sample.name));
        std::fs::write(&dxf, sample.dxf)?;
        let garment = folder.join(format!("{}.garment.json", sample.name));
        std::fs::write(&garment, sample.garment)?;
        println!("{}\n{}", dxf.display(), garment.display());
    }
    Ok(())
}
