//! Generated text in a document, between two marks.

use std::path::Path;
use std::{fs, io};

/// Replaces what stands between `<!-- NAME: begin -->` and `<!-- NAME: end -->` in `file`.
///
/// # Errors
/// A file that cannot be read or written, or that has no such marks.
pub(crate) fn replace(file: &Path, name: &str, content: &str) -> io::Result<()> {
    let [begin, end] = ["begin", "end"].map(|which| format!("<!-- {name}: {which} -->"));
    let text = fs::read_to_string(file)?;
    let parts = text.split_once(&begin).and_then(|(before, rest)| {
        let (_, after) = rest.split_once(&end)?;
        Some((before, after))
    });
    let Some((before, after)) = parts else {
        let why = format!("{} has no {begin} with {end} after it", file.display());
        return Err(io::Error::new(io::ErrorKind::InvalidData, why));
    };
    fs::write(file, format!("{before}{begin}\n{content}{end}{after}"))
}
