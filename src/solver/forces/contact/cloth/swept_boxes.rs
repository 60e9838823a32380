//! A box for each particle about its motion, and the triangles whose boxes overlap.
//!
//! A particle keeps its box until it leaves it. Distances are taken from the positions that
//! particles had when they got their boxes, which may be of different times: they are bounds, and
//! hold as long as every particle stays in its box.

use super::boxes::{Bounds, BoxTree};
use super::surface::ContactSurface;
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Share of the triangles that are not fixed above which all boxes are made anew: to look for the
/// neighbors of single triangles takes longer for each.
const MOST_UPDATED: f64 = 0.3;
/// Times as far as its motion goes that a box may reach, before its particle gets another one.
const LOOSE: f64 = 2.0;

/// A motion of all particles along straight lines.
#[derive(Clone, Copy)]
pub(super) struct SweptMotion<'a> {
    /// Positions where it begins \[m\].
    pub(super) from: &'a [Vector3<f64>],
    /// Positions where it ends \[m\].
    pub(super) to: &'a [Vector3<f64>],
    /// Distance beside the line that a particle may move \[m\].
    pub(super) slack: f64,
}

impl SweptMotion<'_> {
    /// Returns the box about the motion of particle `i`.
    fn bounds(&self, i: usize) -> Bounds {
        Bounds::about(&self.from[i], &self.to[i], self.slack)
    }

    /// Returns the furthest in that box from the begin of the motion \[m\].
    fn reach(&self, i: usize) -> f64 {
        (self.from[i] - self.to[i]).norm() + self.slack * 3f64.sqrt()
    }
}

/// The boxes of all particles and triangles.
#[derive(Clone, Debug, Default)]
pub(super) struct SweptBoxes {
    /// Position of each particle when it got its box \[m\].
    pub(super) base: Vec<Vector3<f64>>,
    pub(super) particles: Vec<Bounds>,
    /// Furthest from its base that each particle gets in its box \[m\].
    pub(super) reach: Vec<f64>,
    /// Around the boxes of the corners of each triangle, and half the thickness wider.
    triangles: Vec<Bounds>,
    tree: BoxTree,
}

/// Particles and triangles that have got other boxes.
pub(super) struct UpdatedBoxes {
    /// True for each such particle.
    pub(super) particles: Vec<bool>,
    /// Triangles with such a corner, ascending.
    pub(super) triangles: Vec<usize>,
}

impl SweptBoxes {
    /// Returns true if every particle at `x` is in its box.
    pub(super) fn cover(&self, x: &[Vector3<f64>]) -> bool {
        let is_inside = |(bounds, x): (&Bounds, &Vector3<f64>)| bounds.contains(x);
        self.particles.len() == x.len() && self.particles.iter().zip(x).all(is_inside)
    }

    /// Gives every particle a box about its motion.
    pub(super) fn rebuild(&mut self, surface: &ContactSurface, motion: &SweptMotion<'_>) {
        let all = 0..motion.from.len();
        self.base = motion.from.to_vec();
        self.particles = all.clone().map(|i| motion.bounds(i)).collect();
        self.reach = all.map(|i| motion.reach(i)).collect();
        let margin = 0.5 * surface.most_thickness();
        let bounds = surface.triangles.iter();
        self.triangles = bounds.map(|t| self.around(t).wider(margin)).collect();
        if self.tree.is_empty() {
            self.tree = BoxTree::new(&self.triangles, surface.moving_triangles);
        } else {
            self.tree.refit(&self.triangles);
        }
    }

    /// Gives a box about their motion to those particles that would leave theirs or whose boxes
    /// are much wider than it, and to those of `also`; returns none, and changes nothing, if these
    /// are too many.
    pub(super) fn update(
        &mut self,
        surface: &ContactSurface,
        motion: &SweptMotion<'_>,
        also: &[usize],
    ) -> Option<UpdatedBoxes> {
        let count = motion.from.len();
        if self.particles.len() != count {
            return None;
        }
        let needs_another = |i: usize| {
            let bounds = &self.particles[i];
            let is_inside = bounds.contains(&motion.from[i]) && bounds.contains(&motion.to[i]);
            !is_inside || self.reach[i] > LOOSE * motion.reach(i)
        };
        let mut particles: Vec<bool> = (0..count).map(needs_another).collect();
        also.iter().for_each(|&i| particles[i] = true);
        let has_updated = |t: &usize| surface.triangles[*t].iter().any(|&i| particles[i]);
        let triangles: Vec<usize> = (0..surface.triangles.len()).filter(has_updated).collect();
        let moving = triangles.partition_point(|&t| t < surface.moving_triangles);
        if moving as f64 > MOST_UPDATED * surface.moving_triangles as f64 {
            return None;
        }
        for i in (0..count).filter(|&i| particles[i]) {
            self.base[i] = motion.from[i];
            self.particles[i] = motion.bounds(i);
            self.reach[i] = motion.reach(i);
        }
        let margin = 0.5 * surface.most_thickness();
        for &t in &triangles {
            self.triangles[t] = self.around(&surface.triangles[t]).wider(margin);
        }
        self.tree.refit(&self.triangles);
        Some(UpdatedBoxes {
            particles,
            triangles,
        })
    }

    /// Returns the box around those of the corners of a triangle.
    pub(super) fn around(&self, [a, b, c]: &[usize; 3]) -> Bounds {
        let [a, b, c] = [a, b, c].map(|&i| &self.particles[i]);
        a.with(b).with(c)
    }

    /// Calls `visit` with every pair of triangles whose boxes overlap and that are not both fixed,
    /// always in the same order, until it breaks.
    pub(super) fn for_each_pair(
        &self,
        mut visit: impl FnMut(usize, usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let tree = &self.tree;
        tree.for_each_pair(&mut |s, t| visit(s as usize, t as usize))
    }

    /// Calls `visit` as [`SweptBoxes::for_each_pair`] does, with those pairs that have a triangle
    /// of `updated`, which ascend.
    pub(super) fn for_each_pair_of(
        &self,
        updated: &[usize],
        surface: &ContactSurface,
        mut visit: impl FnMut(usize, usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let is_updated = |t: usize| updated.binary_search(&t).is_ok();
        for &s in updated {
            self.tree.for_each_near(&self.triangles[s], &mut |t| {
                let t = t as usize;
                let was_visited = t == s || (t < s && is_updated(t));
                let are_fixed = s.min(t) >= surface.moving_triangles;
                if was_visited || are_fixed {
                    return ControlFlow::Continue(());
                }
                visit(s, t)
            })?;
        }
        ControlFlow::Continue(())
    }

    /// Returns how far each particle is from its base \[m\].
    pub(super) fn moved(&self, x: &[Vector3<f64>]) -> Vec<f64> {
        let moved = self.base.iter().zip(x);
        moved.map(|(base, x)| (x - base).norm()).collect()
    }
}
