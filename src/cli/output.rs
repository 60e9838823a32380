//! Output files, in the format that their names say.

use seamster::export::{self, GarmentMesh};
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// A mesh file to be written.
#[derive(Clone, Debug)]
pub(super) struct MeshOutput {
    path: PathBuf,
    format: MeshFormat,
}

#[derive(Clone, Copy, Debug)]
enum MeshFormat {
    Glb,
    Obj,
    Ply,
    Json,
}

impl FromStr for MeshOutput {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let path = PathBuf::from(text);
        let extension = path.extension().and_then(|extension| extension.to_str());
        let format = match extension.map(str::to_ascii_lowercase).as_deref() {
            Some("glb") => MeshFormat::Glb,
            Some("obj") => MeshFormat::Obj,
            Some("ply") => MeshFormat::Ply,
            Some("json") => MeshFormat::Json,
            _ => return Err("its name must end in .glb, .obj, .ply or .json".to_owned()),
        };
        Ok(Self { path, format })
    }
}

impl MeshOutput {
    /// Writes the mesh.
    ///
    /// # Errors
    /// The file and why it cannot be written.
    pub(super) fn write(&self, mesh: &GarmentMesh) -> Result<(), String> {
        let bytes = match self.format {
            MeshFormat::Glb => export::glb(mesh),
            MeshFormat::Obj => export::obj(mesh).into_bytes(),
            MeshFormat::Ply => export::ply(mesh),
            MeshFormat::Json => serde_json::to_vec(mesh).map_err(|error| error.to_string())?,
        };
        write(&self.path, &bytes)
    }
}

/// Writes a file.
///
/// # Errors
/// The file and why it cannot be written.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()))
}
