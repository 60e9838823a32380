//! Drafts the sample patterns for the default dress form and writes them as DXF, each with its
//! garment file.
//!
//! `cargo run -p seamster-tools draft-samples [FOLDER]` writes `static/samples` unless told
//! otherwise. The files are in the repository: run it again after a change of
//! `tests/fixtures/src/drafting`, and `tests/it/fit/samples.rs` checks that it was.

use std::path::Path;

/// Writes the samples into `folder`.
///
/// # Errors
/// Files that cannot be written.
pub(crate) fn main(folder: &Path) -> std::io::Result<()> {
    std::fs::create_dir_all(folder)?;
    for sample in seamster_fixtures::drafting::samples() {
        let dxf = folder.join(format!("{}.dxf", sample.name));
        std::fs::write(&dxf, sample.dxf)?;
        let garment = folder.join(format!("{}.garment.json", sample.name));
        std::fs::write(&garment, sample.garment)?;
        println!("{}\n{}", dxf.display(), garment.display());
    }
    Ok(())
}
