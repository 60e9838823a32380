//! Thin strips that buckle: under a push (Euler), upright under their own weight (Greenhill), on
//! edge under it (Michell, Prandtl).

use nalgebra::Vector3;
use seamster::scene::Scene;
use seamster::solver::SolverOptions;
use seamster_fixtures::sheet::{ClothSheet, SheetGrid, energy_of_start, fabric, mean, settled};
use std::f64::consts::PI;

const G: f64 = 9.80665;
const DENSITY: f64 = 0.15;

fn strip(size: [f64; 2], cells: [usize; 2], rigidity: f64, grid: SheetGrid) -> ClothSheet {
    ClothSheet {
        size,
        cells,
        grid,
        fabric: fabric(3e4, 3e3, rigidity, DENSITY),
        warp_angle: 0.0,
    }
}

/// Elastica: shortening over L and deflection of the middle over L, of a strip hinged at both ends.
#[test]
fn a_pushed_strip_arches_as_the_elastica() {
    for [shortening, deflection] in [
        [0.030269, 0.109707],
        [0.149344, 0.23426],
        [0.25898, 0.296604],
        [0.543053, 0.38138],
    ] {
        for grid in [SheetGrid::Rising, SheetGrid::Falling] {
            let (length, cells) = (0.1, 40);
            let sheet = strip([length, 0.02], [cells, 8], 1e-5, grid);
            let span = 1.0 - shortening;
            let mut scene = sheet.scene(|[u, v]| {
                let s = u / length;
                Vector3::new(span * u, deflection * length * 0.8 * (PI * s).sin(), v)
            });
            scene.gravity = Vector3::zeros();
            scene.pins = [sheet.column(0), sheet.column(cells)].concat();
            let x = settled(&scene, 1e-7).positions;
            let arch = mean(&x, &sheet.column(cells / 2)).y / length;
            assert!(
                (arch / deflection - 1.0).abs() < 0.02,
                "{shortening}: {arch}"
            );
        }
    }
}

/// Distance of the tip of an upright strip of Γ = w L³ / B from the upright, over its length; it
/// starts a little bent.
fn tip_of_upright(gamma: f64, grid: SheetGrid) -> f64 {
    let (length, cells) = (0.1_f64, 30);
    let rigidity = DENSITY * G * length.powi(3) / gamma;
    let whole = length * cells as f64 / (cells as f64 - 0.5);
    let sheet = strip([whole, 0.03], [cells, 8], rigidity, grid);
    let clamp = whole - length;
    let mut scene = sheet.scene(|[u, v]| {
        // The held columns stand straight.
        let s = ((u - 2.0 * clamp) / length).max(0.0);
        Vector3::new(0.02 * length * s * s, u - clamp, v)
    });
    scene.pins = [sheet.column(0), sheet.column(1)].concat();
    let x = settled(&scene, 1e-5).positions;
    mean(&x, &sheet.column(cells)).x.abs() / length
}

/// Greenhill 1881: it bends over when Γ > 7.8373. Two per cent of the length are six of Γ.
#[test]
fn an_upright_strip_bends_over_at_greenhills_length() {
    for grid in [SheetGrid::Rising, SheetGrid::Falling] {
        let [below, above] = [0.98_f64, 1.02].map(|l| tip_of_upright(7.8373 * l.powi(3), grid));
        // Past the critical load the tip goes aside as the square root of the excess: for 6 %, over
        // a third of the length.
        assert!(below < 1e-3 && above > 0.1, "{grid:?}: {below}, {above}");
    }
}

/// Torsional stiffness C of a strip per its width, over the rigidity B: from the energy C θ'² / 2
/// of an even twist that stretches nothing, z = θ' u v.
fn torsional_stiffness(sheet: &ClothSheet) -> f64 {
    let twist = 0.01;
    let scene = sheet.scene(|[u, v]| Vector3::new(u, v, twist * u * v));
    let scene = Scene {
        gravity: Vector3::zeros(),
        ..scene
    };
    let area = sheet.size[0] * sheet.size[1];
    let bend = energy_of_start(&scene, &SolverOptions::default()).bend;
    2.0 * bend / (twist * twist * area) / sheet.fabric.bending_warp_n_m
}

/// Distance by which the tip of a strip on edge, clamped at one end, goes aside; it starts a little
/// bent.
fn tip_of_edgewise(load: f64, grid: SheetGrid) -> (f64, f64) {
    let (length, cells) = (0.2_f64, 40);
    let rigidity = DENSITY * G * length.powi(3) / load;
    let whole = length * cells as f64 / (cells as f64 - 0.5);
    let sheet = strip([whole, 0.02], [cells, 6], rigidity, grid);
    let clamp = whole - length;
    let mut scene = sheet.scene(|[u, v]| {
        // The held columns stand straight.
        let s = ((u - 2.0 * clamp) / length).max(0.0);
        Vector3::new(u - clamp, v, 0.01 * length * s * s)
    });
    scene.pins = [sheet.column(0), sheet.column(1)].concat();
    let x = settled(&scene, 1e-5).positions;
    let aside = mean(&x, &sheet.column(cells)).z.abs() / length;
    (aside, torsional_stiffness(&sheet))
}

/// w b L³ / sqrt(B b C) = 12.8538 (Timoshenko & Gere): with C = c B b, ρ g L³ / B = 12.8538
/// sqrt(c). A plate without Poisson coupling has c = 2. Critical lengths within 4 %.
#[test]
fn a_strip_on_edge_falls_over_at_the_length_of_lateral_buckling() {
    for grid in [SheetGrid::Rising, SheetGrid::Falling] {
        let at = |c: f64, l: f64| tip_of_edgewise(12.8538 * c.sqrt() * l.powi(3), grid);
        let (_, c) = at(2.0, 0.5);
        let [(below, _), (above, _)] = [0.96, 1.04].map(|l| at(c, l));
        assert!((c / 2.0 - 1.0).abs() < 0.01, "{c}");
        assert!(below < 2e-3 && above > 0.05, "{grid:?}: {below}, {above}");
    }
}
