//! The pairs of features that may come into contact while every particle stays in a box of its own.

use super::boxes::{Bounds, BoxTree};
use super::proximity::{Features, Proximity};
use super::surface::ContactSurface;
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Share of the thickness below which a pair is left out: its features meet, and nothing tells on
/// which side of each other they were.
const MET: f64 = 1e-6;

/// Pairs for each particle that are looked at at most: where cloth is crumpled to a point, what is
/// beyond is left out, and the judge tells what comes of it.
const MOST_PAIRS: usize = 400;

/// Two features that may meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct FeaturePair {
    pub(super) features: Features,
    pub(super) corners: [usize; 4],
    /// Distance of their middles at which they touch \[m\].
    pub(super) thickness: f64,
    /// Distance at the base \[m\].
    pub(super) distance: f64,
}

impl FeaturePair {
    pub(super) fn gather(&self, x: &[Vector3<f64>]) -> [Vector3<f64>; 4] {
        self.corners.map(|i| x[i])
    }

    pub(super) fn proximity(&self, x: &[Vector3<f64>]) -> Proximity {
        Proximity::of(self.features, &self.gather(x))
    }

    /// Returns the furthest that the features may have come nearer when their corners have moved
    /// by `moved` \[m\].
    pub(super) fn approach(&self, moved: &[f64]) -> f64 {
        let [a, b, c, d] = self.corners.map(|i| moved[i]);
        match self.features {
            Features::VertexTriangle => a + b.max(c).max(d),
            Features::Edges => a.max(b) + c.max(d),
        }
    }
}

/// Pairs that may meet while every particle stays in its box.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    /// Positions at which the distances were taken \[m\].
    base: Vec<Vector3<f64>>,
    boxes: Vec<Bounds>,
    tree: BoxTree,
    pub(super) pairs: Vec<FeaturePair>,
}

impl Candidates {
    /// Returns true if every particle at `x` is in its box.
    pub(super) fn cover(&self, x: &[Vector3<f64>]) -> bool {
        self.boxes.len() == x.len() && self.boxes.iter().zip(x).all(|(b, x)| b.contains(x))
    }

    /// Finds the pairs that may meet while particles move from `from` to `to` and by `slack` \[m\]
    /// beside the way.
    pub(super) fn find(
        &mut self,
        surface: &ContactSurface,
        (from, to): (&[Vector3<f64>], &[Vector3<f64>]),
        slack: f64,
    ) {
        let thickness = surface.most_thickness();
        self.base.clear();
        self.base.extend_from_slice(from);
        self.boxes.clear();
        let around = |(a, b)| Bounds::about(a, b, slack);
        self.boxes.extend(from.iter().zip(to).map(around));
        // Half the thickness on either side.
        let near = |(a, b)| Bounds::about(a, b, slack + 0.5 * thickness);
        let near: Vec<_> = from.iter().zip(to).map(near).collect();
        let of_triangle = |[a, b, c]: &[usize; 3]| near[*a].with(&near[*b]).with(&near[*c]);
        let bounds: Vec<_> = surface.triangles.iter().map(of_triangle).collect();
        if self.tree.is_empty() {
            self.tree = BoxTree::new(&bounds, surface.moving_triangles);
        } else {
            self.tree.refit(&bounds);
        }
        let reach: Vec<f64> = from
            .iter()
            .zip(to)
            .map(|(a, b)| (a - b).norm() + slack * 3f64.sqrt())
            .collect();
        let mut search = Search {
            surface,
            from,
            near: &near,
            reach: &reach,
            pairs: &mut self.pairs,
        };
        search.pairs.clear();
        let most = MOST_PAIRS * from.len();
        let _ = self.tree.for_each_pair(&mut |s, t| {
            search.add_pairs(s as usize, t as usize);
            if search.pairs.len() < most {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        });
    }

    /// Returns how far each particle is from its base \[m\].
    pub(super) fn moved(&self, x: &[Vector3<f64>]) -> Vec<f64> {
        let moved = self.base.iter().zip(x);
        moved.map(|(base, x)| (x - base).norm()).collect()
    }
}

/// A search for pairs.
struct Search<'a> {
    surface: &'a ContactSurface,
    from: &'a [Vector3<f64>],
    /// Boxes of the particles, wider by half the thickness.
    near: &'a [Bounds],
    /// Furthest that each particle may move \[m\].
    reach: &'a [f64],
    pairs: &'a mut Vec<FeaturePair>,
}

impl Search<'_> {
    /// Adds the pairs of features of two triangles whose boxes overlap.
    fn add_pairs(&mut self, s: usize, t: usize) {
        let (s, t) = (s.min(t), s.max(t));
        let surface = self.surface;
        for (s, t) in [(s, t), (t, s)] {
            let corners = surface.triangles[t];
            let [a, b, c] = corners;
            for &v in &surface.own[s].vertices {
                let is_near = || {
                    let triangle = self.near[a].with(&self.near[b]).with(&self.near[c]);
                    self.near[v].overlaps(&triangle)
                };
                if !surface.share_corner(&[v], &corners) && is_near() {
                    self.add(Features::VertexTriangle, [v, a, b, c]);
                }
            }
        }
        for &[a, b] in &surface.own[s].edges {
            let first = self.near[a].with(&self.near[b]);
            for &[c, d] in &surface.own[t].edges {
                let is_near = || first.overlaps(&self.near[c].with(&self.near[d]));
                if !surface.share_corner(&[a, b], &[c, d]) && is_near() {
                    self.add(Features::Edges, [a, b, c, d]);
                }
            }
        }
    }

    fn add(&mut self, features: Features, corners: [usize; 4]) {
        let of = |i: usize| self.surface.thickness[corners[i]];
        // The mean of the two.
        let thickness = 0.5
            * match features {
                Features::VertexTriangle => of(0) + of(1).max(of(2)).max(of(3)),
                Features::Edges => of(0).max(of(1)) + of(2).max(of(3)),
            };
        let mut pair = FeaturePair {
            features,
            corners,
            thickness,
            distance: 0.0,
        };
        pair.distance = pair.proximity(self.from).distance();
        let is_apart = pair.distance > MET * thickness;
        if is_apart && pair.distance - pair.approach(self.reach) < thickness {
            self.pairs.push(pair);
        }
    }
}
