//! Binary glTF 2.0: one node and mesh per panel, named by its id; one material per fabric.
//!
//! Written by hand after the glTF 2.0 specification (Khronos Group, 2021), sections 3.6 (buffers,
//! accessors), 3.7 (meshes), 3.9 (materials) and 4.4 (the binary container).

use super::garment_mesh::{DrapedPanel, GarmentMesh, VertexMaps};
use super::normals;
use crate::scene::TriangleMesh;
use nalgebra::Vector3;
use serde_json::{Map, Value, json};

/// Linear base colors of fabrics, in the order in which they appear: muted, and apart for readers
/// who see few hues.
const COLORS: [[f64; 3]; 6] = [
    [0.20, 0.34, 0.50],
    [0.60, 0.22, 0.12],
    [0.28, 0.38, 0.20],
    [0.68, 0.45, 0.12],
    [0.30, 0.12, 0.28],
    [0.55, 0.50, 0.42],
];
const AVATAR_COLOR: [f64; 3] = [0.45, 0.45, 0.45];

const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;

/// Writes a garment as binary glTF 2.0.
///
/// `POSITION` and `NORMAL` in meters, y up; `TEXCOORD_0` = pattern coordinates in meters with v up
/// (glTF draws images with v down: a texture wants `KHR_texture_transform`). A panel without
/// triangles is a node without a mesh.
pub fn glb(mesh: &GarmentMesh) -> Vec<u8> {
    let mut file = GlbWriter::default();
    file.garment(mesh);
    file.bytes()
}

/// Writes a body as binary glTF 2.0: one node, `avatar`.
pub fn avatar_glb(surface: &TriangleMesh) -> Vec<u8> {
    let mut file = GlbWriter::default();
    file.avatar(surface);
    file.bytes()
}

/// Writes a garment as [`glb`] does with the body beside it, as a node `avatar`.
pub fn garment_with_avatar_glb(mesh: &GarmentMesh, surface: &TriangleMesh) -> Vec<u8> {
    let mut file = GlbWriter::default();
    file.garment(mesh);
    file.avatar(surface);
    file.bytes()
}

/// A glTF document and its buffer as they grow.
#[derive(Default)]
struct GlbWriter {
    buffer: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    materials: Vec<Value>,
    meshes: Vec<Value>,
    nodes: Vec<Value>,
}

impl GlbWriter {
    fn garment(&mut self, mesh: &GarmentMesh) {
        let mut fabrics: Vec<&str> = Vec::new();
        for (panel, normals) in mesh.panels.iter().zip(normals::of_garment(mesh)) {
            let known = fabrics.iter().position(|fabric| *fabric == panel.fabric);
            let material = known.unwrap_or_else(|| {
                let color = COLORS[fabrics.len() % COLORS.len()];
                fabrics.push(&panel.fabric);
                self.material(&panel.fabric, color, true)
            });
            self.panel(panel, &normals, material);
        }
    }

    fn panel(&mut self, panel: &DrapedPanel, normals: &[Vector3<f64>], material: usize) {
        let triangles: Vec<_> = panel
            .triangles
            .iter()
            .map(|t| t.map(|i| i as usize))
            .collect();
        if triangles.is_empty() {
            self.nodes.push(json!({"name": panel.panel}));
            return;
        }
        let mut primitive = self.surface(&panel.positions, normals, &triangles);
        primitive["attributes"]["TEXCOORD_0"] = self.floats(&panel.uv, false).into();
        primitive["material"] = material.into();
        let mut extras =
            json!({"panel": panel.panel, "texcoord_0": "pattern coordinates in metres, v up"});
        self.maps(&panel.maps, &mut primitive["attributes"], &mut extras);
        self.mesh(
            &panel.panel,
            json!({
                "name": panel.panel,
                "primitives": [primitive],
                "extras": extras,
            }),
        );
    }

    /// Adds the maps of a panel as attributes of its own, and says in `extras` what they are.
    fn maps(&mut self, maps: &VertexMaps, attributes: &mut Value, extras: &mut Value) {
        if !maps.strain_warp.is_empty() {
            let both = maps.strain_warp.iter().zip(&maps.strain_weft);
            let both: Vec<[f64; 2]> = both.map(|(warp, weft)| [*warp, *weft]).collect();
            attributes["_STRAIN"] = self.floats(&both, false).into();
            extras["_strain"] = "strain along warp and weft".into();
        }
        for (name, values, meaning) in [
            (
                "_STRAIN_SHARE",
                &maps.strain_share,
                "share of the extension that the fabric gives",
            ),
            (
                "_PRESSURE",
                &maps.pressure_kpa,
                "pressure of the body in kPa",
            ),
            (
                "_GAP",
                &maps.gap_mm,
                "gap to the body in mm, its depth within the body, negative",
            ),
        ] {
            if !values.is_empty() {
                let values: Vec<[f64; 1]> = values.iter().map(|value| [*value]).collect();
                attributes[name] = self.floats(&values, false).into();
                extras[name.to_ascii_lowercase()] = meaning.into();
            }
        }
    }

    fn avatar(&mut self, surface: &TriangleMesh) {
        let material = self.material("avatar", AVATAR_COLOR, false);
        if surface.triangles.is_empty() {
            return;
        }
        let positions: Vec<[f64; 3]> = surface.vertices.iter().map(|p| (*p).into()).collect();
        let normals = normals::smooth(&surface.vertices, &surface.triangles);
        let mut primitive = self.surface(&positions, &normals, &surface.triangles);
        primitive["material"] = material.into();
        self.mesh(
            "avatar",
            json!({"name": "avatar", "primitives": [primitive]}),
        );
    }

    /// Adds positions, normals and triangles, and returns their primitive.
    fn surface(
        &mut self,
        positions: &[[f64; 3]],
        normals: &[Vector3<f64>],
        triangles: &[[usize; 3]],
    ) -> Value {
        let normals: Vec<[f64; 3]> = normals.iter().map(|n| (*n).into()).collect();
        json!({
            "attributes": {
                "POSITION": self.floats(positions, true),
                "NORMAL": self.floats(&normals, false),
            },
            "indices": self.indices(triangles),
        })
    }

    fn mesh(&mut self, node: &str, mesh: Value) {
        self.nodes
            .push(json!({"name": node, "mesh": self.meshes.len()}));
        self.meshes.push(mesh);
    }

    /// Adds a cloth-like material, and returns its index.
    fn material(&mut self, name: &str, [r, g, b]: [f64; 3], double_sided: bool) -> usize {
        self.materials.push(json!({
            "name": name,
            "pbrMetallicRoughness": {
                "baseColorFactor": [r, g, b, 1.0],
                "metallicFactor": 0.0,
                "roughnessFactor": 0.9,
            },
            "doubleSided": double_sided,
        }));
        self.materials.len() - 1
    }

    /// Adds an accessor of vectors, with its bounds where asked for, and returns its index.
    fn floats<const N: usize>(&mut self, vectors: &[[f64; N]], bounded: bool) -> usize {
        let vectors: Vec<[f32; N]> = vectors.iter().map(|v| v.map(single)).collect();
        let start = self.buffer.len();
        let bytes = vectors.iter().flatten().flat_map(|x| x.to_le_bytes());
        self.buffer.extend(bytes);
        let mut accessor = json!({
            "bufferView": self.view(start, ARRAY_BUFFER),
            "componentType": FLOAT,
            "count": vectors.len(),
            "type": if N == 1 { "SCALAR".to_owned() } else { format!("VEC{N}") },
        });
        if bounded {
            let bound = |pick: fn(f32, f32) -> f32, start: f32| {
                let fold = |k| vectors.iter().map(|v: &[f32; N]| v[k]).fold(start, pick);
                (0..N).map(fold).collect::<Vec<_>>()
            };
            accessor["min"] = json!(bound(f32::min, f32::INFINITY));
            accessor["max"] = json!(bound(f32::max, f32::NEG_INFINITY));
        }
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// Adds an accessor of vertex indices, and returns its index.
    fn indices(&mut self, triangles: &[[usize; 3]]) -> usize {
        let start = self.buffer.len();
        let bytes = triangles
            .iter()
            .flatten()
            .flat_map(|i| length(*i).to_le_bytes());
        self.buffer.extend(bytes);
        let accessor = json!({
            "bufferView": self.view(start, ELEMENT_ARRAY_BUFFER),
            "componentType": UNSIGNED_INT,
            "count": 3 * triangles.len(),
            "type": "SCALAR",
        });
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// Adds a view of the buffer from `start` to its end, and returns its index.
    fn view(&mut self, start: usize, target: u32) -> usize {
        self.views.push(json!({
            "buffer": 0,
            "byteOffset": start,
            "byteLength": self.buffer.len() - start,
            "target": target,
        }));
        self.views.len() - 1
    }

    /// Returns the container: a header, the document, the buffer.
    fn bytes(self) -> Vec<u8> {
        let mut document = self.document().to_string().into_bytes();
        // Every component has four bytes, so the buffer is aligned already.
        document.resize(document.len().next_multiple_of(4), b' ');
        let mut bytes = b"glTF".to_vec();
        bytes.extend(2_u32.to_le_bytes());
        bytes.extend([0; 4]);
        chunk(&mut bytes, *b"JSON", &document);
        if !self.buffer.is_empty() {
            chunk(&mut bytes, *b"BIN\0", &self.buffer);
        }
        let total = length(bytes.len());
        bytes[8..12].copy_from_slice(&total.to_le_bytes());
        bytes
    }

    fn document(&self) -> Value {
        let generator = concat!("seamster ", env!("CARGO_PKG_VERSION"));
        let mut document = Map::new();
        document.insert(
            "asset".into(),
            json!({"version": "2.0", "generator": generator}),
        );
        // The specification has no empty lists: without a node there is no scene.
        if self.nodes.is_empty() {
            return document.into();
        }
        document.insert("scene".into(), 0.into());
        let roots: Vec<usize> = (0..self.nodes.len()).collect();
        document.insert(
            "scenes".into(),
            json!([{"name": "garment", "nodes": roots}]),
        );
        let lists = [
            ("nodes", &self.nodes),
            ("meshes", &self.meshes),
            ("materials", &self.materials),
            ("accessors", &self.accessors),
            ("bufferViews", &self.views),
        ];
        for (name, list) in lists {
            if !list.is_empty() {
                document.insert(name.into(), json!(list));
            }
        }
        if !self.buffer.is_empty() {
            document.insert("buffers".into(), json!([{"byteLength": self.buffer.len()}]));
        }
        document.into()
    }
}

fn chunk(bytes: &mut Vec<u8>, kind: [u8; 4], data: &[u8]) {
    bytes.extend(length(data.len()).to_le_bytes());
    bytes.extend(kind);
    bytes.extend(data);
}

fn length(count: usize) -> u32 {
    u32::try_from(count).expect("limits keep meshes far below 4 GiB")
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "glTF stores single precision"
)]
fn single(x: f64) -> f32 {
    x as f32
}
