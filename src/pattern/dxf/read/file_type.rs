//! Files that are no DXF, recognized by their first bytes: the fault names the kind of file and the
//! fix.

use crate::fault::{Fault, PatternCode};

/// First bytes of files that people upload by mistake, their kind, and the fix.
const OTHERS: [(&[u8], &str, &str); 8] = [
    (
        b"\x89PNG",
        "a PNG picture",
        "upload the DXF itself, not a picture of it",
    ),
    (
        b"\xff\xd8\xff",
        "a JPEG picture",
        "upload the DXF itself, not a picture of it",
    ),
    (
        b"PK\x03\x04",
        "a ZIP archive",
        "unpack it and upload the DXF inside",
    ),
    (
        b"\x1f\x8b",
        "a gzip archive",
        "unpack it and upload the DXF inside",
    ),
    (b"%PDF", "a PDF", "export the pattern as DXF (AAMA or ASTM)"),
    (
        b"AC10",
        "a DWG drawing",
        "save it as DXF in the CAD program",
    ),
    (b"\xff\xfe", "UTF-16 text", "save it as ASCII or UTF-8 DXF"),
    (b"\xfe\xff", "UTF-16 text", "save it as ASCII or UTF-8 DXF"),
];

/// The first bytes of a binary DXF.
pub(crate) const BINARY: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

/// Returns true if bytes begin as a DXF does: binary, or with the group code 0 or 999.
pub(crate) fn is_dxf(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let first = bytes.split(|b| matches!(b, b'\n' | b'\r')).next();
    bytes.starts_with(BINARY) || first.is_some_and(|l| matches!(l.trim_ascii(), b"0" | b"999"))
}

/// Checks that bytes are not plainly something else than a DXF.
///
/// # Errors
/// A file of another kind, or an empty one.
pub(crate) fn reject_other(bytes: &[u8]) -> Result<(), Fault> {
    if bytes.is_empty() {
        return Err(not_dxf("the file is empty", "upload a DXF file"));
    }
    for (magic, what, fix) in OTHERS {
        if bytes.starts_with(magic) {
            return Err(not_dxf(&format!("the file is {what}"), fix));
        }
    }
    let start = bytes.iter().position(|b| !b.is_ascii_whitespace());
    match start {
        None => Err(not_dxf("the file is blank", "upload a DXF file")),
        Some(at) if bytes[at] == b'<' => Err(not_dxf(
            "the file is HTML or XML",
            "upload the DXF itself; the download may have been an error page",
        )),
        Some(at) if bytes[at] == b'{' => Err(not_dxf(
            "the file is JSON",
            "send JSON patterns as application/json",
        )),
        Some(_) => Ok(()),
    }
}

/// Returns the fault for a file that is no DXF.
pub(crate) fn not_dxf(detail: &str, fix: &str) -> Fault {
    Fault::new(PatternCode::NotDxf, "line 1", detail).fix(fix)
}
