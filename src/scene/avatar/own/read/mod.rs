//! Files of bodies: bytes to triangles, in the file's own axes and unit.

mod builder;
mod glb;
mod obj;
mod ply;
mod unreadable;

use super::super::TriangleMesh;
use crate::config::Limits;
use crate::fault::{AvatarCode, Fault};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Format of the file of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum BodyFormat {
    /// Wavefront OBJ.
    Obj,
    /// Binary glTF 2.0.
    Glb,
    /// Polygon file format, ASCII or binary.
    Ply,
}

impl BodyFormat {
    /// Returns the format that the first bytes of a file tell; OBJ has none of its own.
    fn of(bytes: &[u8]) -> Self {
        if bytes.starts_with(b"glTF") {
            Self::Glb
        } else if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") {
            Self::Ply
        } else {
            Self::Obj
        }
    }
}

/// Reads the triangles of a file.
///
/// # Errors
/// `avatar/file` with the line, byte or pointer that cannot be read, `avatar/too_large`.
pub(super) fn read(bytes: &[u8], limits: &Limits) -> Result<(BodyFormat, TriangleMesh), Fault> {
    if bytes.len() > limits.body_bytes {
        let most = limits.body_bytes;
        let detail = format!(
            "the file has {} bytes; at most {most} are taken",
            bytes.len()
        );
        let fault = Fault::new(AvatarCode::TooLarge, "", detail);
        return Err(fault.fix("simplify the surface, or leave textures out of the file"));
    }
    let format = BodyFormat::of(bytes);
    let surface = match format {
        BodyFormat::Obj => obj::read(bytes, limits),
        BodyFormat::Glb => glb::read(bytes, limits),
        BodyFormat::Ply => ply::read(bytes, limits),
    }?;
    if surface.triangles.is_empty() {
        let fault = Fault::new(AvatarCode::Empty, "", "the file has no triangle");
        return Err(fault.fix("export the surface of the body as an OBJ, GLB or PLY mesh"));
    }
    Ok((format, surface))
}
