//! Cloth on cloth: closed forms, and scenes in which cloth would pass through cloth; crossings are
//! counted by the judge, which knows nothing of contact.

use nalgebra::{Rotation3, Vector3};
use seamster::scene::Scene;
use seamster_crossings::{SearchLimits, Surface, find_crossings};
use seamster_fixtures::layers::together;
use seamster_fixtures::sheet::{ClothSheet, SheetGrid, fabric, mean, settled};

/// Pairs of triangles of a scene that meet.
pub(super) fn crossings(scene: &Scene, x: &[Vector3<f64>]) -> usize {
    #[expect(clippy::cast_possible_truncation, reason = "positions of a few meters")]
    let points: Vec<_> = x
        .iter()
        .map(|p| [p.x as f32, p.y as f32, p.z as f32])
        .collect();
    let index = |i: usize| u32::try_from(i).expect("few vertices");
    let triangles: Vec<_> = scene.mesh.triangles.iter().map(|t| t.map(index)).collect();
    let stitches = scene.mesh.stitches.iter();
    let stitches: Vec<_> = stitches.map(|s| [index(s.a), index(s.b)]).collect();
    let cloth = Surface::new(&points, &triangles, &stitches).expect("finite positions");
    let limits = SearchLimits {
        kept: 0,
        pairs: usize::MAX,
    };
    let report = find_crossings(&cloth, None, limits).expect("no limit");
    report.cloth.count + report.degenerate.len()
}

fn sheet(size: [f64; 2], cells: [usize; 2]) -> ClothSheet {
    ClothSheet {
        size,
        cells,
        grid: SheetGrid::Alternate,
        fabric: fabric(1000.0, 300.0, 1e-5, 0.15),
        warp_angle: 0.0,
    }
}

/// Sheets of 1 mm held along one edge at the heights of a stack. The lowest, which lies still,
/// carries nine: 13 Pa, which press the layers by a tenth of their thickness at most.
#[test]
fn a_stack_of_ten_sheets_is_ten_thicknesses_high() {
    let (count, thickness) = (10, 1e-3);
    let sheet = sheet([0.06, 0.05], [6, 5]);
    let layer = |number: usize| {
        // Slightly turned, so that no edges of two sheets are parallel.
        let turn = Rotation3::new(Vector3::y() * 0.03 * number as f64);
        let height = number as f64 * thickness;
        let mut scene = sheet.scene(|[u, v]| turn * Vector3::new(u, height, v));
        scene.pins = if number == 0 {
            (0..scene.start.len()).collect()
        } else {
            sheet.column(0)
        };
        scene
    };
    let scene = together((0..count).map(layer).collect());
    let shape = settled(&scene, 1e-4);
    assert_eq!(crossings(&scene, &shape.positions), 0);
    let first_of_top = (count - 1) * scene.start.len() / count;
    let free_end = sheet
        .column(6)
        .into_iter()
        .map(|v| shape.positions[first_of_top + v].y);
    let height = free_end.sum::<f64>() / 6.0;
    let whole = (count - 1) as f64 * thickness;
    assert!(height <= whole && height > 0.9 * whole, "{height}");
}

/// Two hanging sheets, a corner of one of them through the other at the start.
#[test]
fn two_sheets_that_start_through_each_other_hang_apart() {
    let sheet = sheet([0.2, 0.2], [10, 10]);
    let hung = |mut scene: Scene| {
        // The edge at u = 0, which is on top.
        scene.pins = sheet.column(0);
        scene
    };
    let one = sheet.scene(|[u, v]| Vector3::new(v, -u, 0.0));
    let other = sheet.scene(|[u, v]| Vector3::new(v - 0.013, -u, 0.031 - 1.25 * u * v));
    let scene = together(vec![hung(one), hung(other)]);
    assert!(crossings(&scene, &scene.start) > 0);
    let shape = settled(&scene, 1e-4);
    assert_eq!(crossings(&scene, &shape.positions), 0);
}

/// A sheet held by one end that falls onto a fixed one and hangs over its edge; without contact it
/// falls through.
#[test]
fn a_sheet_that_falls_onto_another_lies_on_it_and_hangs_over_its_edge() {
    let (table, cloth) = (sheet([0.12, 0.12], [6, 6]), sheet([0.25, 0.08], [15, 5]));
    let mut fixed = table.scene(|[u, v]| Vector3::new(u - 0.06, 0.0, v - 0.06));
    fixed.pins = (0..fixed.start.len()).collect();
    let mut falling = cloth.scene(|[u, v]| Vector3::new(u - 0.051, 0.01, v - 0.043 + 0.05 * u));
    falling.pins = cloth.column(0);
    let scene = together(vec![fixed, falling]);
    let through = Scene {
        carriers: vec![],
        self_contact: false,
        ..scene.clone()
    };
    assert!(crossings(&scene, &settled(&through, 1e-4).positions) > 0);
    let shape = settled(&scene, 1e-4);
    assert_eq!(crossings(&scene, &shape.positions), 0);
    let end = mean(&shape.positions[49..], &cloth.column(15));
    assert!(end.y < -0.05, "{end}");
    // Where it lies on the fixed sheet it is above its middle.
    let above = shape.positions[49..].iter().filter(|p| p.x < 0.05);
    assert!(above.map(|p| p.y).fold(1.0, f64::min) > 0.0);
}
