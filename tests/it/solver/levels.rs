//! Coarser meshes: what a garment's mesh keeps on its way down, and what a net of springs becomes.

use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::fit;
use seamster::mesh::ClothMesh;
use seamster::progress::CancelToken;
use seamster::scene::{CoarserScene, Scene, coarser};
use seamster_fixtures::samples::{sample, with_context};
use seamster_fixtures::scenes::net::{Family, Net};
use serde_json::json;
use std::collections::BTreeSet;

fn garment(name: &str) -> Scene {
    let prepared = sample(name, json!({"simulate": {"edge_length_m": 0.012}}));
    let (limits, cancel) = (Limits::default(), CancelToken::new());
    let scene = with_context(&limits, &cancel, |_| {}, |c| fit::scene(&prepared, c));
    scene.expect("the shipped samples are sound")
}

/// A scene with each of its coarser ones, from the finest pair on.
fn pairs(finest: Scene) -> Vec<(Scene, CoarserScene)> {
    let mut pairs = vec![];
    let mut fine = finest;
    while let Some(next) = coarser(&fine) {
        let scene = next.scene.clone();
        pairs.push((fine, next));
        fine = scene;
    }
    pairs
}

fn garments() -> Vec<(Scene, CoarserScene)> {
    let all: Vec<_> = ["skirt", "top"]
        .into_iter()
        .flat_map(|n| pairs(garment(n)))
        .collect();
    assert!(
        all.len() >= 4,
        "two garments of thousands of vertices have levels"
    );
    all
}

fn twice_area(mesh: &ClothMesh, [a, b, c]: [usize; 3]) -> f64 {
    let [p, q, r] = [a, b, c].map(|v| mesh.uv[v]);
    (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
}

/// Each holds for every level of both samples, whose bodies and meshes take the most time here.
#[test]
fn garments_are_the_same_on_coarser_meshes() {
    for (fine, coarse) in garments() {
        coarse_vertices_are_fine_ones_and_far_fewer(&fine, &coarse);
        panels_keep_corners_and_cover_what_thinned_outlines_enclose(&fine, &coarse);
        stitches_stay_or_go_with_both_their_vertices(&fine, &coarse);
        weights_say_where_each_fine_vertex_lies(&fine, &coarse);
        mass_is_kept(&fine, &coarse);
    }
}

fn coarse_vertices_are_fine_ones_and_far_fewer(fine: &Scene, coarse: &CoarserScene) {
    assert!(coarse.finer.windows(2).all(|w| w[0] < w[1]));
    for (v, &of) in coarse.finer.iter().enumerate() {
        assert_eq!(coarse.scene.mesh.uv[v], fine.mesh.uv[of]);
        assert_eq!(coarse.scene.start[v], fine.start[of]);
    }
    assert!(coarse.finer.len() * 2 < fine.start.len());
}

fn panels_keep_corners_and_cover_what_thinned_outlines_enclose(
    fine: &Scene,
    coarse: &CoarserScene,
) {
    for (of, to) in fine.mesh.panels.iter().zip(&coarse.scene.mesh.panels) {
        let kept = to.corners.iter().map(|&v| coarse.finer[v]);
        assert!(kept.eq(of.corners.iter().copied()));
        let area = |mesh: &ClothMesh, range: &std::ops::Range<usize>| -> f64 {
            let triangles = &mesh.triangles[range.clone()];
            assert!(triangles.iter().all(|&t| twice_area(mesh, t) > 0.0));
            0.5 * triangles.iter().map(|&t| twice_area(mesh, t)).sum::<f64>()
        };
        let (whole, left) = (
            area(&fine.mesh, &of.triangles),
            area(&coarse.scene.mesh, &to.triangles),
        );
        // Outlines turn by less than 30 degrees where a vertex goes, so that a chord over two
        // parts cuts off at most tan(15 deg)/4 of its length squared; of panels that are many
        // parts wide that is a few per cent.
        assert!((left / whole - 1.0).abs() < 0.05, "{left} of {whole}");
    }
}

fn stitches_stay_or_go_with_both_their_vertices(fine: &Scene, coarse: &CoarserScene) {
    let number = |v: usize| coarse.finer.binary_search(&v).ok();
    let mut expected = BTreeSet::new();
    for s in &fine.mesh.stitches {
        match (number(s.a), number(s.b)) {
            (Some(a), Some(b)) => {
                expected.insert((s.seam, a, b));
            }
            (None, None) => {}
            _ => panic!("a stitch lost one vertex"),
        }
    }
    let found = coarse
        .scene
        .mesh
        .stitches
        .iter()
        .map(|s| (s.seam, s.a, s.b));
    assert_eq!(found.collect::<BTreeSet<_>>(), expected);
    assert!(expected.len() * 3 > fine.mesh.stitches.len());
}

fn weights_say_where_each_fine_vertex_lies(fine: &Scene, coarse: &CoarserScene) {
    for (corners, uv) in coarse.weights.iter().zip(&fine.mesh.uv) {
        for (k, uv) in uv.iter().enumerate() {
            let at: f64 = corners
                .iter()
                .map(|&(v, w)| w * coarse.scene.mesh.uv[v][k])
                .sum();
            // Barycentric coordinates of meters, in a triangle whose height is above a
            // thousandth of its edges.
            assert!((at - uv).abs() < 1e-12);
        }
    }
}

fn mass_is_kept(fine: &Scene, coarse: &CoarserScene) {
    let sum = |scene: &Scene| scene.mass.iter().sum::<f64>();
    assert!((sum(&coarse.scene) / sum(fine) - 1.0).abs() < 1e-12);
    assert!(coarse.scene.mass.iter().all(|m| *m > 0.0));
}

/// Wherever cloth deforms the same everywhere, a net and its fibers have the same energy: nothing
/// was lost on the way down.
#[test]
fn fibers_have_the_energy_of_the_springs_they_stand_for() {
    let limits = Limits::default();
    let net = Net {
        family: Family::Capsule,
        rows: 41,
        stiffer: 1.0,
    };
    let scene = net.scene().into_scene(&limits).expect("a sound scene");
    let stretched =
        |uv: &[f64; 2]| Vector3::new(1.1 * uv[0] + 0.2 * uv[1], 0.9 * uv[1], 0.1 * uv[0]);
    let x: Vec<_> = scene.mesh.uv.iter().map(stretched).collect();
    let springs = scene.membrane.springs().iter();
    let energy: f64 = springs
        .map(|s| 0.5 * s.stiffness_n_m * ((x[s.a] - x[s.b]).norm() - s.rest_length_m).powi(2))
        .sum();
    let levels = pairs(scene);
    assert!(levels.len() >= 2);
    for (_, coarse) in levels {
        let x: Vec<_> = coarse.scene.mesh.uv.iter().map(stretched).collect();
        let fibers = coarse.scene.membrane.fibers().iter();
        let carried: f64 = fibers
            .map(|f| {
                let image: Vector3<f64> = (0..3).map(|i| x[f.corners[i]] * f.weights[i]).sum();
                0.5 * f.stiffness_n_m * (image.norm() - f.rest_length_m).powi(2)
            })
            .sum();
        // Directions and rest lengths of fibers that are made one differ by up to 1e-6.
        assert!(
            (carried / energy - 1.0).abs() < 1e-4,
            "{carried} J of {energy} J"
        );
    }
}
