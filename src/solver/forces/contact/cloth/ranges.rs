//! The box that each particle may move in before pairs are sought anew, and those of triangles.

use super::boxes::{Bounds, BoxTree};
use super::surface::ContactSurface;
use nalgebra::Vector3;

/// Share of the triangles whose boxes are not those of before, above which all pairs are sought:
/// to look for those of single triangles takes longer for each.
const MOST_MOVED: f64 = 0.3;
/// Times that a particle's box may be wider than it needs to be, before it gets another one.
const LOOSE: f64 = 2.0;

/// The way of all particles, and how far they may move beside it.
#[derive(Clone, Copy)]
pub(super) struct Way<'a> {
    /// Where it begins \[m\].
    pub(super) from: &'a [Vector3<f64>],
    /// Where it ends \[m\].
    pub(super) to: &'a [Vector3<f64>],
    /// Distance beside it \[m\].
    pub(super) slack: f64,
}

impl Way<'_> {
    /// Returns the furthest from its begin that particle `i` gets \[m\].
    fn reach(&self, i: usize) -> f64 {
        (self.from[i] - self.to[i]).norm() + self.slack * 3f64.sqrt()
    }
}

/// The boxes of particles and triangles.
#[derive(Clone, Debug, Default)]
pub(super) struct Ranges {
    /// Position of each particle when it got its box, from which distances are taken \[m\].
    pub(super) base: Vec<Vector3<f64>>,
    boxes: Vec<Bounds>,
    /// The same, wider by half the thickness.
    pub(super) near: Vec<Bounds>,
    /// Furthest from its base that each particle gets in its box \[m\].
    pub(super) reach: Vec<f64>,
    /// Around those of the corners of each triangle.
    pub(super) triangles: Vec<Bounds>,
    pub(super) tree: BoxTree,
}

/// What has another box than before.
pub(super) struct Moved {
    /// True for each such particle.
    pub(super) particles: Vec<bool>,
    /// Triangles with one of them, ascending.
    pub(super) triangles: Vec<usize>,
}

impl Ranges {
    /// Returns true if no particle has a box yet.
    pub(super) fn is_empty(&self) -> bool {
        self.boxes.is_empty()
    }

    /// Returns true if every particle at `x` is in its box.
    pub(super) fn cover(&self, x: &[Vector3<f64>]) -> bool {
        self.boxes.len() == x.len() && self.boxes.iter().zip(x).all(|(b, x)| b.contains(x))
    }

    /// Gives every particle a box about its way.
    pub(super) fn renew(&mut self, surface: &ContactSurface, way: &Way<'_>) {
        self.base = way.from.to_vec();
        self.boxes = vec![Bounds::default(); self.base.len()];
        self.near = self.boxes.clone();
        self.reach = vec![0.0; self.base.len()];
        let thickness = surface.most_thickness();
        for i in 0..self.base.len() {
            self.enclose(i, way, thickness);
        }
        let of_triangle = |corners| around(&self.near, corners);
        self.triangles = surface.triangles.iter().map(of_triangle).collect();
        if self.tree.is_empty() {
            self.tree = BoxTree::new(&self.triangles, surface.moving_triangles);
        } else {
            self.tree.refit(&self.triangles);
        }
    }

    /// Gives those particles a box about their way that leave theirs on it or do not need so wide a
    /// one, and those of `also`; returns none, and changes nothing, if these are too many.
    pub(super) fn follow(
        &mut self,
        surface: &ContactSurface,
        way: &Way<'_>,
        also: &[usize],
    ) -> Option<Moved> {
        let count = way.from.len();
        if self.boxes.len() != count {
            return None;
        }
        let is_left = |i: usize| {
            let bounds = &self.boxes[i];
            let is_inside = bounds.contains(&way.from[i]) && bounds.contains(&way.to[i]);
            !is_inside || self.reach[i] > LOOSE * way.reach(i)
        };
        let mut particles: Vec<bool> = (0..count).map(is_left).collect();
        also.iter().for_each(|&i| particles[i] = true);
        let has_one = |t: &usize| surface.triangles[*t].iter().any(|&i| particles[i]);
        let triangles: Vec<usize> = (0..surface.triangles.len()).filter(has_one).collect();
        if triangles.len() as f64 > MOST_MOVED * surface.triangles.len() as f64 {
            return None;
        }
        let thickness = surface.most_thickness();
        for i in (0..count).filter(|&i| particles[i]) {
            self.base[i] = way.from[i];
            self.enclose(i, way, thickness);
        }
        for &t in &triangles {
            self.triangles[t] = around(&self.near, &surface.triangles[t]);
        }
        self.tree.refit(&self.triangles);
        Some(Moved {
            particles,
            triangles,
        })
    }

    /// Gives particle `i`, which is at its base, a box about its way.
    fn enclose(&mut self, i: usize, way: &Way<'_>, thickness: f64) {
        let about = |margin| Bounds::about(&way.from[i], &way.to[i], margin);
        self.boxes[i] = about(way.slack);
        // Half the thickness on either side.
        self.near[i] = about(way.slack + 0.5 * thickness);
        self.reach[i] = way.reach(i);
    }

    /// Returns how far each particle is from its base \[m\].
    pub(super) fn moved(&self, x: &[Vector3<f64>]) -> Vec<f64> {
        let moved = self.base.iter().zip(x);
        moved.map(|(base, x)| (x - base).norm()).collect()
    }
}

/// Returns the box around those of the corners of a triangle.
fn around(boxes: &[Bounds], [a, b, c]: &[usize; 3]) -> Bounds {
    boxes[*a].with(&boxes[*b]).with(&boxes[*c])
}
