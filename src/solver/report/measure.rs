//! Measures of a shape: seam gaps, strain, penetration, height, energies.

use crate::scene::Scene;
use crate::solver::forces::TermKind;
use crate::solver::model::system::System;
use crate::solver::report::schema::Energy;
use nalgebra::{Matrix2, Vector3};

/// Measures of a shape.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShapeMeasures {
    /// Largest distance between the two points of a stitch \[m\].
    pub(crate) seam_gap_m: f64,
    /// Largest principal stretch less 1.
    pub(crate) strain: f64,
    /// Deepest point inside the body \[m\].
    pub(crate) penetration_m: f64,
}

/// Returns the largest distance between the two points of any of `stitches` \[m\].
pub(crate) fn seam_gap(stitches: &[(usize, usize)], x: &[Vector3<f64>]) -> f64 {
    stitches
        .iter()
        .map(|&(a, b)| (x[a] - x[b]).norm_squared())
        .fold(0.0, f64::max)
        .sqrt()
}

/// Returns the RMS length of the vectors that `of` gives for each index below `count`.
pub(crate) fn rms(count: usize, of: impl Fn(usize) -> Vector3<f64>) -> f64 {
    let sum: f64 = (0..count).map(|i| of(i).norm_squared()).sum();
    (sum / count.max(1) as f64).sqrt()
}

/// Returns the RMS distance between two shapes \[m; `#V` each\].
pub fn rms_distance(x: &[Vector3<f64>], y: &[Vector3<f64>]) -> f64 {
    rms(x.len(), |i| x[i] - y[i])
}

/// Returns the metric of a triangle, whose entries are the scalar products of the images of the two
/// unit vectors of its rest positions, and its area at rest \[m²\]; none if it has none.
pub(crate) fn metric(
    [p, q, r]: [[f64; 2]; 3],
    [a, b, c]: [Vector3<f64>; 3],
) -> Option<(Matrix2<f64>, f64)> {
    let sides = Matrix2::new(q[0] - p[0], r[0] - p[0], q[1] - p[1], r[1] - p[1]);
    let rest = sides.try_inverse()?;
    let (e, f) = (b - a, c - a);
    let products = Matrix2::new(e.dot(&e), e.dot(&f), e.dot(&f), f.dot(&f));
    let area = 0.5 * sides.determinant().abs();
    Some((rest.transpose() * products * rest, area))
}

/// Returns the largest principal stretch of any triangle, less 1; the largest strain of any given
/// spring where there are no triangles.
fn strain(scene: &Scene, x: &[Vector3<f64>]) -> f64 {
    if scene.mesh.triangles.is_empty() {
        let net = scene.membrane.springs().iter();
        return net
            .map(|s| (x[s.a] - x[s.b]).norm() / s.rest_length_m - 1.0)
            .reduce(f64::max)
            .unwrap_or(0.0);
    }
    let stretch = |t: &[usize; 3]| {
        let (metric, _) = metric(t.map(|v| scene.mesh.uv[v]), t.map(|v| x[v]))?;
        let half = 0.5 * (metric[(0, 0)] - metric[(1, 1)]);
        Some((0.5 * metric.trace() + half.hypot(metric[(0, 1)])).sqrt())
    };
    scene
        .mesh
        .triangles
        .iter()
        .filter_map(stretch)
        .fold(f64::NEG_INFINITY, f64::max)
        - 1.0
}

/// Returns the depth of the deepest vertex, or middle of a triangle or of one of its edges, inside
/// the body \[m\]; 0 if none is.
///
/// Distances are those of the body's own triangles, not of the smooth field that contact uses.
fn penetration(scene: &Scene, x: &[Vector3<f64>]) -> f64 {
    let Some(body) = &scene.body else {
        return 0.0;
    };
    let depth = |p: &Vector3<f64>| match body.sample(p) {
        Some(near) if near.distance < 2e-3 => -body.exact_distance(p),
        _ => 0.0,
    };
    let vertices = x.iter().map(&depth).fold(0.0, f64::max);
    let middles = scene.mesh.triangles.iter().flat_map(|t| {
        let [p, q, r] = t.map(|v| x[v]);
        [
            (p + q + r) / 3.0,
            (p + q) / 2.0,
            (q + r) / 2.0,
            (r + p) / 2.0,
        ]
    });
    middles.map(|p| depth(&p)).fold(vertices, f64::max)
}

/// Measures seam gap, strain and penetration.
#[inline(never)] // so that a profile tells what it takes
pub(crate) fn measure_shape(scene: &Scene, x: &[Vector3<f64>]) -> ShapeMeasures {
    let stitches: Vec<_> = scene.mesh.stitches.iter().map(|s| (s.a, s.b)).collect();
    ShapeMeasures {
        seam_gap_m: seam_gap(&stitches, x),
        strain: strain(scene, x),
        penetration_m: penetration(scene, x),
    }
}

/// Returns the energies of the particles of `system` at `x` \[m\].
#[inline(never)] // so that a profile tells what it takes
pub(crate) fn energies(system: &mut System<'_>, x: &[Vector3<f64>]) -> Energy {
    Energy {
        stretch: system.energy_of(TermKind::Stretch, x),
        bend: system.energy_of(TermKind::Bend, x),
        gravity: system.energy_of(TermKind::Gravity, x),
        seam: system.energy_of(TermKind::Seam, x),
        contact: system.energy_of(TermKind::Contact, x)
            + system.energy_of(TermKind::SelfContact, x),
    }
}

/// Returns the mean height against gravity \[m\]; 0 where there is none.
pub(crate) fn mean_height(gravity: &Vector3<f64>, x: &[Vector3<f64>]) -> f64 {
    let up = -gravity.try_normalize(0.0).unwrap_or_default();
    x.iter().map(|p| p.dot(&up)).sum::<f64>() / x.len().max(1) as f64
}
