//! The scenes that most cases are made of.

use super::scenes::tube::tube;
use super::sheet::{Grid, Sheet};
use nalgebra::Vector3;
use seamster::scene::{Fabric, Scene, library};

/// Width and length of the sheet that is hung \[m\].
const SIDE: f64 = 0.5;
/// Radius of the arc that it starts as \[m\]: its ends are 0.9 of its width apart.
const ARC: f64 = std::f64::consts::FRAC_1_PI;

pub(super) fn poplin() -> Fabric {
    library()["cotton-poplin"].clone()
}

/// The same, so many times stiffer in stretch and shear.
pub(super) fn stiffer(by: f64) -> Fabric {
    let fabric = poplin();
    Fabric {
        stretch_warp_n_m: by * fabric.stretch_warp_n_m,
        stretch_weft_n_m: by * fabric.stretch_weft_n_m,
        shear_n_m: by * fabric.shear_n_m,
        ..fabric
    }
}

/// A square of `fabric` of `cells` x `cells`, hung by two corners that are nearer to each other than the cloth is wide. It starts
/// bent to an arc without any stretch.
pub(super) fn hung(fabric: Fabric, cells: usize) -> Scene {
    let sheet = sheet(fabric, cells);
    Scene {
        pins: vec![sheet.vertex(0, 0), sheet.vertex(cells, 0)],
        ..sheet.scene(arc)
    }
}

pub(super) fn sheet(fabric: Fabric, cells: usize) -> Sheet {
    Sheet {
        size: [SIDE; 2],
        cells: [cells; 2],
        grid: Grid::Alternate,
        fabric,
        warp_angle: 0.0,
    }
}

/// Where (u, v) of the sheet starts.
pub(super) fn arc([u, v]: [f64; 2]) -> Vector3<f64> {
    let (angle, end) = ((u - SIDE / 2.0) / ARC, SIDE / 2.0 / ARC);
    Vector3::new(ARC * angle.sin(), ARC * (end.cos() - angle.cos()), v)
}

/// Two panels of `fabric`, sewn to a tube over a cylinder, of about so many vertices.
pub(super) fn sewn(fabric: Fabric, vertices: usize) -> Scene {
    let scene = tube(vertices, 1.0);
    let denser = fabric.density_kg_m2 / scene.fabrics[0].density_kg_m2;
    Scene {
        mass: scene.mass.iter().map(|m| denser * m).collect(),
        fabrics: vec![fabric],
        ..scene
    }
}
