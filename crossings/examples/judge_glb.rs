//! Judges a GLB file that Seamster wrote: `judge_glb GARMENT.glb [SCENE.json]`.
//!
//! All meshes are cloth, in the order of the nodes, but for the node `avatar`. Stitches and body
//! are those of the scene (`seamster sew … --scene SCENE.json`), as the file does not tell
//! stitches. Without a scene, vertices at exactly one place count as stitched.

use seamster_crossings::{CrossingList, SearchLimits, Surface, find_crossings};
use serde_json::Value;
use std::collections::HashMap;
use std::error::Error;
use std::fs::File;
use std::io::BufReader;

const LIMITS: SearchLimits = SearchLimits {
    kept: usize::MAX,
    pairs: usize::MAX,
};

#[derive(Default)]
struct Mesh {
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments
        .next()
        .ok_or("usage: judge_glb GARMENT.glb [SCENE.json]")?;
    let (cloth, mut avatar) = read_glb(&file)?;
    let stitches = match arguments.next() {
        Some(scene) => read_scene(&scene, &mut avatar)?,
        None => same_places(&cloth.positions),
    };
    let surface = Surface::new(&cloth.positions, &cloth.triangles, &stitches)?;
    let body = Surface::new(&avatar.positions, &avatar.triangles, &[])?;
    let report = find_crossings(&surface, Some(&body), LIMITS)?;
    print("cloth", &report.cloth);
    print("body", &report.body);
    for triangle in report.degenerate {
        println!("degenerate {triangle}");
    }
    for vertex in report.inside {
        println!("inside {vertex}");
    }
    Ok(())
}

fn print(kind: &str, list: &CrossingList) {
    for crossing in &list.kept {
        let ([a, b], [x, y, z]) = (crossing.triangles, crossing.point);
        println!("{kind} {a} {b} at {x:.4} {y:.4} {z:.4}");
    }
}

/// Reads the garment's mesh and the avatar's.
fn read_glb(file: &str) -> Result<(Mesh, Mesh), Box<dyn Error>> {
    let gltf = gltf::Gltf::open(file)?;
    let (mut cloth, mut avatar) = (Mesh::default(), Mesh::default());
    for node in gltf.nodes() {
        let is_avatar = node.name() == Some("avatar");
        let mesh = if is_avatar { &mut avatar } else { &mut cloth };
        for primitive in node.mesh().iter().flat_map(gltf::Mesh::primitives) {
            let first = u32::try_from(mesh.positions.len())?;
            let reader = primitive.reader(|_| gltf.blob.as_deref());
            mesh.positions
                .extend(reader.read_positions().ok_or("no positions")?);
            let corners = reader.read_indices().ok_or("no indices")?.into_u32();
            let corners: Vec<u32> = corners.map(|v| v + first).collect();
            mesh.triangles.extend(corners.as_chunks::<3>().0);
        }
    }
    Ok((cloth, avatar))
}

/// Reads a scene's stitches, and its body if it is one of triangles.
fn read_scene(file: &str, avatar: &mut Mesh) -> Result<Vec<[u32; 2]>, Box<dyn Error>> {
    let mut scene: Value = serde_json::from_reader(BufReader::new(File::open(file)?))?;
    let collider = &mut scene["collider"];
    if collider["triangles"].is_array() {
        let positions: Vec<[f64; 3]> = serde_json::from_value(collider["vertices"].take())?;
        #[expect(clippy::cast_possible_truncation, reason = "as it is written to files")]
        let single = positions.into_iter().map(|p| p.map(|x| x as f32));
        avatar.positions = single.collect();
        avatar.triangles = serde_json::from_value(collider["triangles"].take())?;
    }
    Ok(serde_json::from_value(scene["stitches"].take())?)
}

/// Returns each vertex with the first one at its place.
fn same_places(positions: &[[f32; 3]]) -> Vec<[u32; 2]> {
    let mut first = HashMap::new();
    let place = |p: &[f32; 3]| p.map(|x| (x + 0.0).to_bits());
    let vertices = (0..).zip(positions);
    vertices
        .map(|(v, p)| [*first.entry(place(p)).or_insert(v), v])
        .collect()
}
