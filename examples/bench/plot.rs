//! tmp
use crate::line::Line;
pub(crate) fn write_all(_folder: &std::path::Path, _lines: &[Line]) -> std::io::Result<()> {
    Ok(())
}
