//! Wavefront OBJ.

use super::garment_mesh::{DrapedPanel, GarmentMesh};
use super::normals;
use nalgebra::Vector3;
use std::fmt::Write;

/// Writes a garment as Wavefront OBJ, one group per panel, positions to the nanometer.
///
/// `usemtl` names the fabric; there is no material library.
pub fn obj(mesh: &GarmentMesh) -> String {
    let mut text = String::from("# seamster; metres, y up; vt = pattern coordinates in metres\n");
    let mut first = 1;
    for (panel, normals) in mesh.panels.iter().zip(normals::of_garment(mesh)) {
        // A `String` takes all that is written to it.
        let _ = group(&mut text, panel, &normals, first);
        first += panel.positions.len();
    }
    text
}

/// Writes one panel whose vertices are counted from `first`.
fn group(
    text: &mut String,
    panel: &DrapedPanel,
    normals: &[Vector3<f64>],
    first: usize,
) -> std::fmt::Result {
    writeln!(text, "g {}", word(&panel.panel))?;
    writeln!(text, "usemtl {}", word(&panel.fabric))?;
    for [x, y, z] in &panel.positions {
        writeln!(text, "v {x:.9} {y:.9} {z:.9}")?;
    }
    for [u, v] in &panel.uv {
        writeln!(text, "vt {u:.9} {v:.9}")?;
    }
    for n in normals {
        writeln!(text, "vn {:.6} {:.6} {:.6}", n.x, n.y, n.z)?;
    }
    for triangle in &panel.triangles {
        let [a, b, c] = triangle.map(|i| first + i as usize);
        writeln!(text, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}")?;
    }
    Ok(())
}

/// Returns a name as one word: OBJ ends names at white space.
fn word(name: &str) -> String {
    name.chars()
        .map(|c| {
            if c.is_whitespace() || c.is_control() {
                '_'
            } else {
                c
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_cannot_break_out_of_their_line() {
        assert_eq!(word("left sleeve\nv 1 2 3"), "left_sleeve_v_1_2_3");
    }
}
