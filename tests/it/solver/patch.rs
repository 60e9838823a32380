//! Patch tests: even strain is met exactly on uneven meshes, and moduli along warp, weft, bias and
//! in shear are the fabric's.

use nalgebra::{Matrix2, Vector3};
use seamster::scene::{Fabric, Scene};
use seamster::solver::SolverOptions;
use seamster_fixtures::sheet::{ClothSheet, SheetGrid, energy_of_start, fabric, random, settled};

const SIDE: f64 = 0.2;
const CELLS: usize = 8;

fn cloth() -> Fabric {
    Fabric {
        stretch_weft_n_m: 400.0,
        ..fabric(1000.0, 60.0, 1e-6, 0.2)
    }
}

fn square(warp_angle: f64) -> ClothSheet {
    ClothSheet {
        size: [SIDE; 2],
        cells: [CELLS; 2],
        grid: SheetGrid::Jittered,
        fabric: cloth(),
        warp_angle,
    }
}

/// The sheet with (u, v) moved to `by` (u, v), without gravity.
fn strained(sheet: &ClothSheet, by: Matrix2<f64>) -> Scene {
    let mut scene = sheet.scene(|[u, v]| {
        let p = by * nalgebra::Vector2::new(u, v);
        Vector3::new(p.x, p.y, 0.0)
    });
    scene.gravity = Vector3::zeros();
    scene
}

/// Inner vertices find their way back to the even strain from 3 mm off; the bound is what r = 1e-10
/// leaves, 1e-12 N on stiffnesses of 10 N/m and more.
#[test]
fn an_even_strain_of_the_border_is_even_inside() {
    for (name, by) in [
        ("along u", Matrix2::new(1.02, 0.0, 0.0, 1.001)),
        ("along v", Matrix2::new(1.001, 0.0, 0.0, 1.03)),
        ("shear", Matrix2::new(1.01, 0.02, 0.02, 1.01)),
    ] {
        for degrees in [0.0_f64, 90.0, 45.0, 20.0] {
            let sheet = square(degrees.to_radians());
            let mut scene = strained(&sheet, by);
            let even = scene.start.clone();
            scene.pins = sheet.border();
            let mut random = random();
            for (v, p) in scene.start.iter_mut().enumerate() {
                if !scene.pins.contains(&v) {
                    *p += Vector3::new(random(), random(), 0.0) * 6e-3;
                }
            }
            let x = settled(&scene, 1e-10).positions;
            let apart = x
                .iter()
                .zip(&even)
                .map(|(x, y)| (x - y).norm())
                .fold(0.0, f64::max);
            assert!(apart < 1e-11, "{name}, warp at {degrees}: {apart} m off");
        }
    }
}

/// The energy of an even small strain, per area and strain squared, twice: what the cloth resists
/// it with when it cannot give otherwise [N/m]. Strains of 1e-4: what is not linear is below 2e-4.
fn resistance(warp_angle: f64, strain: Matrix2<f64>) -> f64 {
    let scene = strained(&square(warp_angle), Matrix2::identity() + strain);
    2.0 * energy_of_start(&scene, &SolverOptions::default()).stretch / (SIDE * SIDE)
}

#[test]
fn warp_weft_and_shear_moduli_are_those_of_the_fabric() {
    let e = 1e-4;
    let fabric = cloth();
    for (strain, modulus) in [
        (Matrix2::new(e, 0.0, 0.0, 0.0), fabric.stretch_warp_n_m),
        (Matrix2::new(0.0, 0.0, 0.0, e), fabric.stretch_weft_n_m),
        (Matrix2::new(0.0, e, 0.0, 0.0), fabric.shear_n_m),
    ] {
        let measured = resistance(0.0, strain) / (e * e);
        assert!(
            (measured / modulus - 1.0).abs() < 1e-3,
            "{measured} {modulus}"
        );
    }
}

/// A strip cut at an angle and hung with a load, its sides free: 1/E = cos⁴/Kw + sin⁴/Kf + sin²
/// cos²/G, measured in the middle third, some widths from the ends.
#[test]
fn a_strip_cut_on_the_bias_has_the_modulus_of_the_orthotropic_cloth() {
    for degrees in [0.0_f64, 30.0, 45.0, 90.0] {
        let (size, cells, load) = ([0.48, 0.04], [72, 6], 0.3);
        let angle = degrees.to_radians();
        let sheet = ClothSheet {
            size,
            cells,
            fabric: Fabric {
                density_kg_m2: 1e-3,
                ..cloth()
            },
            ..square(angle)
        };
        let mut scene = sheet.scene(|[u, v]| Vector3::new(v, -u, 0.0));
        scene.pins = sheet.column(0);
        let end = sheet.column(cells[0]);
        for (j, &v) in end.iter().enumerate() {
            let share = if j == 0 || j == cells[1] { 0.5 } else { 1.0 } / cells[1] as f64;
            scene.mass[v] += load * size[1] * share / 9.80665;
        }
        let x = settled(&scene, 1e-9).positions;
        let [a, b] = [24, 48].map(|i| sheet.vertex(i, 3));
        let [p, q] = [a, b].map(|v| scene.mesh.uv[v]);
        let along = (x[b] - x[a]).norm() / (q[0] - p[0]).hypot(q[1] - p[1]);
        let modulus = load / along / (0.5 * (along * along - 1.0));
        let (s, c) = angle.sin_cos();
        let f = cloth();
        let soft = c.powi(4) / f.stretch_warp_n_m
            + s.powi(4) / f.stretch_weft_n_m
            + (s * c).powi(2) / f.shear_n_m;
        assert!(
            (modulus * soft - 1.0).abs() < 0.01,
            "at {degrees}: {modulus}"
        );
    }
}

/// A square hinged at its corners, its angle changed by γ: energy G γ² a² / 2, and dE/dγ = G γ a².
/// Its threads keep their length; the even shear is at rest, and stays as it is.
#[test]
fn a_picture_frame_has_the_energy_of_shear_alone() {
    let energy = |angle: f64| {
        let (s, c) = (0.5 * angle).sin_cos();
        let sheet = square(0.0);
        let mut scene = strained(&sheet, Matrix2::new(c, s, s, c));
        scene.pins = sheet.border();
        let drape = settled(&scene, 1e-9);
        let apart = |(x, y): (&Vector3<f64>, &Vector3<f64>)| (x - y).norm();
        let moved = drape.positions.iter().zip(&scene.start).map(apart);
        assert!(moved.fold(0.0, f64::max) < 1e-9);
        drape.report.energy_j.stretch
    };
    let (shear, area) = (cloth().shear_n_m, SIDE * SIDE);
    for angle in [0.02, 0.05, 0.1] {
        let exact = 0.5 * shear * angle * angle * area;
        let measured = energy(angle);
        assert!((measured / exact - 1.0).abs() < 0.01, "{measured} {exact}");
        let h = 1e-3;
        let slope = (energy(angle + h) - energy(angle - h)) / (2.0 * h);
        let exact = shear * angle * area;
        assert!((slope / exact - 1.0).abs() < 0.01, "{slope} {exact}");
    }
}
