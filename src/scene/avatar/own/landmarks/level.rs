//! Level slices of a body, and which of their loops is the trunk.

use crate::scene::avatar::TriangleMesh;
use crate::scene::avatar::slice::{Plane, tape};
use nalgebra::Vector3;

/// Distance from the middle over which a finger closes a groove \[m\].
const FINGER: f64 = 0.018;

/// A loop of a level slice.
#[derive(Clone, Debug)]
pub(super) struct LevelLoop {
    /// (x, z) \[m\].
    pub(super) points: Vec<[f64; 2]>,
    /// Height above the floor \[m\].
    pub(super) y: f64,
    /// Enclosed area \[m²\].
    pub(super) area: f64,
}

/// Returns the loops of the slice at height `y`.
pub(super) fn loops_at(surface: &TriangleMesh, y: f64) -> Vec<LevelLoop> {
    let plane = Plane {
        point: Vector3::new(0.0, y, 0.0),
        across: Vector3::x(),
        along: Vector3::z(),
    };
    let loops = plane.loops(surface).into_iter();
    loops
        .map(|points| LevelLoop {
            area: enclosed(&points),
            points,
            y,
        })
        .collect()
}

/// Returns the loop of the trunk at height `y`: the largest one about the middle.
pub(super) fn trunk_at(surface: &TriangleMesh, y: f64) -> Option<LevelLoop> {
    let loops = loops_at(surface, y).into_iter();
    let middle = loops.filter(|found| {
        let [left, right] = found.sides();
        left.x > 0.0 && right.x < 0.0
    });
    middle.max_by(|a, b| a.area.total_cmp(&b.area))
}

/// Area enclosed by a polygon.
fn enclosed(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    let doubled = points.iter().zip(next);
    let doubled: f64 = doubled.map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum();
    0.5 * doubled.abs()
}

impl LevelLoop {
    fn at(&self, [x, z]: [f64; 2]) -> Vector3<f64> {
        Vector3::new(x, self.y, z)
    }

    /// Its points furthest to the left and to the right \[m\].
    pub(super) fn sides(&self) -> [Vector3<f64>; 2] {
        let by_x = |a: &&[f64; 2], b: &&[f64; 2]| a[0].total_cmp(&b[0]);
        let left = self.points.iter().max_by(by_x).copied();
        let right = self.points.iter().min_by(by_x).copied();
        [left, right].map(|p| self.at(p.unwrap_or_default()))
    }

    /// Middle of its bounds \[m\].
    pub(super) fn center(&self) -> Vector3<f64> {
        let [left, right] = self.sides();
        let z = self.points.iter().map(|p| p[1]);
        let [low, high] = z.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| {
            [low.min(z), high.max(z)]
        });
        self.at([0.5 * (left.x + right.x), 0.5 * (low + high)])
    }

    /// Its points in the middle, to the front and to the back, grooves bridged \[m\].
    pub(super) fn middle(&self) -> Option<[Vector3<f64>; 2]> {
        let mut z = self.crossings(0.0);
        z.extend(self.crossings(FINGER));
        z.extend(self.crossings(-FINGER));
        let within = self.points.iter().filter(|p| p[0].abs() <= FINGER);
        z.extend(within.map(|p| p[1]));
        let front = z.iter().copied().max_by(f64::total_cmp)?;
        let back = z.iter().copied().min_by(f64::total_cmp)?;
        Some([self.at([0.0, front]), self.at([0.0, back])])
    }

    /// z where it crosses the plane of this x \[m\].
    fn crossings(&self, x: f64) -> Vec<f64> {
        let next = self.points.iter().cycle().skip(1);
        let pieces = self.points.iter().zip(next);
        let crossed = pieces.filter(|(p, q)| (p[0] >= x) != (q[0] >= x));
        crossed
            .map(|(p, q)| p[1] + (p[0] - x) / (p[0] - q[0]) * (q[1] - p[1]))
            .collect()
    }

    /// Its largest z \[m\].
    pub(super) fn foremost(&self) -> f64 {
        let z = self.points.iter().map(|p| p[1]);
        z.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Girth of a tape about it \[m\].
    pub(super) fn girth(&self) -> f64 {
        tape(self.points.clone()).unwrap_or(f64::NAN)
    }
}
