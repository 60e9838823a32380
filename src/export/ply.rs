//! PLY, the polygon file format of Stanford (G. Turk, "The PLY Polygon File Format", 1994), in its
//! binary little-endian form.

use super::garment_mesh::GarmentMesh;
use super::normals;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Writes a garment as binary PLY: one list of vertices with positions \[m\], normals, pattern
/// coordinates \[m\] as `s` and `t`, and the maps that the mesh has, by their names and in their
/// order, no number where a panel lacks one; one of
/// triangles, each with the number of its panel. Comments name the panels in that order.
pub fn ply(mesh: &GarmentMesh) -> Vec<u8> {
    let mut file = header(mesh).into_bytes();
    let names = map_names(mesh);
    for (panel, normals) in mesh.panels.iter().zip(normals::of_garment(mesh)) {
        let own: BTreeMap<_, _> = panel.maps.named().collect();
        let maps: Vec<Option<&[f64]>> = names.iter().map(|name| own.get(name).copied()).collect();
        for (v, (position, normal)) in panel.positions.iter().zip(&normals).enumerate() {
            let values = position.iter().chain(normal.iter()).chain(&panel.uv[v]);
            let of_maps = maps
                .iter()
                .map(|values| values.map_or(f64::NAN, |values| values[v]));
            let values = values.copied().chain(of_maps);
            file.extend(values.flat_map(|value| single(value).to_le_bytes()));
        }
    }
    let mut first = 0;
    for (number, panel) in mesh.panels.iter().enumerate() {
        for triangle in &panel.triangles {
            file.push(3);
            for vertex in triangle {
                file.extend((first + vertex).to_le_bytes());
            }
            file.extend(count(number).to_le_bytes());
        }
        first += count(panel.positions.len());
    }
    file
}

/// Returns the names of the maps that any panel has, in their order.
fn map_names(mesh: &GarmentMesh) -> Vec<&'static str> {
    let mut names = vec![];
    for (name, _) in mesh.panels.iter().flat_map(|panel| panel.maps.named()) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

fn header(mesh: &GarmentMesh) -> String {
    let mut text = String::from(
        "ply\nformat binary_little_endian 1.0\ncomment seamster; metres, y up; s t = pattern coordinates in metres\n",
    );
    for (number, panel) in mesh.panels.iter().enumerate() {
        // A `String` takes all that is written to it. A comment ends with its line.
        let id = panel.panel.replace(char::is_control, "_");
        let _ = writeln!(text, "comment panel {number} {id}");
    }
    let vertices: usize = mesh.panels.iter().map(|panel| panel.positions.len()).sum();
    let triangles: usize = mesh.panels.iter().map(|panel| panel.triangles.len()).sum();
    let _ = writeln!(text, "element vertex {vertices}");
    let maps = map_names(mesh).into_iter();
    let names = ["x", "y", "z", "nx", "ny", "nz", "s", "t"]
        .into_iter()
        .chain(maps);
    for name in names {
        let _ = writeln!(text, "property float {name}");
    }
    let _ = writeln!(
        text,
        "element face {triangles}\nproperty list uchar uint vertex_indices\nproperty uint panel\nend_header"
    );
    text
}

fn count(count: usize) -> u32 {
    u32::try_from(count).expect("limits keep meshes far below 2^32 vertices")
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "meshes are read in single precision"
)]
fn single(x: f64) -> f32 {
    x as f32
}
