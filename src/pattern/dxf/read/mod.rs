//! Bytes of a DXF file to records: the kind of file, its encoding, its tags, and the records that
//! the tags make up.

pub(super) mod binary;
mod byte_signs;
pub(super) mod encoding;
mod escapes;
pub(super) mod file_type;
mod raw_text;
pub(super) mod records;
pub(super) mod tags;

use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::TextEncoding;
use crate::pattern::dxf::findings::DxfFindings;
use std::borrow::Cow;

/// Decodes a DXF file, text or binary, to text. `encoding`: that of its texts, by the caller.
///
/// # Errors
/// More bytes than `limits.dxf_bytes`, a file of another kind, a binary DXF that is cut off.
pub(super) fn text<'a>(
    bytes: &'a [u8],
    encoding: Option<TextEncoding>,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Result<Cow<'a, str>, Fault> {
    if bytes.len() > limits.dxf_bytes {
        let detail = format!(
            "the file has {} bytes; at most {} are read",
            bytes.len(),
            limits.dxf_bytes
        );
        return Err(
            Fault::new(PatternCode::TooLarge, "line 1", detail).fix("export fewer pieces or sizes")
        );
    }
    file_type::reject_other(bytes)?;
    match bytes.strip_prefix(file_type::BINARY) {
        Some(binary) => {
            let text = binary::to_text(binary)?;
            Ok(Cow::Owned(
                encoding::decode(&text, encoding, findings).into_owned(),
            ))
        }
        None => Ok(encoding::decode(bytes, encoding, findings)),
    }
}
