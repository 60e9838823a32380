//! The pairs of features that may come into contact while every particle stays in a box of its own.

use super::proximity::{Features, Proximity};
use super::ranges::{Moved, Ranges, Way};
use super::surface::ContactSurface;
use nalgebra::Vector3;
use std::ops::ControlFlow;

/// Share of the thickness up to which the features of a pair meet, and it is left out.
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
    /// Cloth area over which they press each other \[m²\].
    pub(super) weight: f64,
}

impl FeaturePair {
    pub(super) fn gather(&self, x: &[Vector3<f64>]) -> [Vector3<f64>; 4] {
        self.corners.map(|i| x[i])
    }

    pub(super) fn proximity(&self, x: &[Vector3<f64>]) -> Proximity {
        Proximity::of(self.features, &self.gather(x))
    }

    /// Returns true if the features meet at `x`, and nothing tells on which side of each other they
    /// were.
    fn meets(&self, x: &[Vector3<f64>]) -> bool {
        self.proximity(x).distance() <= MET * self.thickness
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
    ranges: Ranges,
    pub(super) pairs: Vec<FeaturePair>,
    /// Corners of pairs that were left out because their features meet.
    met: Vec<[usize; 4]>,
}

impl Candidates {
    /// Returns true if every particle at `x` is in its box.
    pub(super) fn cover(&self, x: &[Vector3<f64>]) -> bool {
        self.ranges.cover(x)
    }

    /// Finds the pairs that may meet on a way.
    pub(super) fn find(&mut self, surface: &ContactSurface, way: &Way<'_>) {
        self.ranges.renew(surface, way);
        self.pairs.clear();
        self.met.clear();
        let mut search = self.search(surface, way.from, None);
        let tree = &search.ranges.tree;
        let _ = tree.for_each_pair(&mut |s, t| search.add_pairs(s as usize, t as usize));
    }

    /// Finds the pairs that may meet on a way like [`Candidates::find`], with less work where few
    /// particles leave their boxes: the others keep theirs, and only pairs of those that leave, or
    /// that are where features meet, are sought. Returns the number of pairs that stayed, which are
    /// the first ones.
    pub(super) fn follow(&mut self, surface: &ContactSurface, way: &Way<'_>) -> usize {
        self.find_met(way.from);
        let met = self.met.as_flattened();
        let Some(Moved {
            particles,
            triangles,
        }) = self.ranges.follow(surface, way, met)
        else {
            self.find(surface, way);
            return 0;
        };
        let has_moved = |pair: &FeaturePair| pair.corners.iter().any(|&i| particles[i]);
        self.pairs.retain(|pair| !has_moved(pair));
        self.met.clear();
        let stayed = self.pairs.len();
        let mut search = self.search(surface, way.from, Some(&particles));
        let ranges = search.ranges;
        let is_done = |t: usize| triangles.binary_search(&t).is_ok();
        for &s in &triangles {
            let flow = ranges.tree.for_each_near(&ranges.triangles[s], &mut |t| {
                let t = t as usize;
                if t > s || (t < s && !is_done(t)) {
                    search.add_pairs(s, t)
                } else {
                    ControlFlow::Continue(())
                }
            });
            if flow.is_break() {
                break;
            }
        }
        stayed
    }

    /// Finds those of the pairs whose features meet at `x`.
    fn find_met(&mut self, x: &[Vector3<f64>]) {
        if self.ranges.is_empty() {
            return;
        }
        let moved = self.ranges.moved(x);
        let meets = |pair: &&FeaturePair| {
            pair.distance - pair.approach(&moved) <= MET * pair.thickness && pair.meets(x)
        };
        let met = self.pairs.iter().filter(meets).map(|pair| pair.corners);
        self.met.extend(met);
    }

    /// Returns a search for pairs that are apart at `from`, of particles that `has_moved` or all.
    fn search<'a>(
        &'a mut self,
        surface: &'a ContactSurface,
        from: &'a [Vector3<f64>],
        has_moved: Option<&'a [bool]>,
    ) -> Search<'a> {
        Search {
            surface,
            from,
            has_moved,
            ranges: &self.ranges,
            most: MOST_PAIRS * from.len(),
            pairs: &mut self.pairs,
            met: &mut self.met,
        }
    }

    /// Returns how far each particle is from where distances are taken \[m\].
    pub(super) fn moved(&self, x: &[Vector3<f64>]) -> Vec<f64> {
        self.ranges.moved(x)
    }
}

/// A search for pairs.
struct Search<'a> {
    surface: &'a ContactSurface,
    /// Positions in which features that meet are left out \[m\].
    from: &'a [Vector3<f64>],
    /// The particles one of which a pair has to have, if not all pairs are sought.
    has_moved: Option<&'a [bool]>,
    ranges: &'a Ranges,
    /// Pairs that are kept at most.
    most: usize,
    pairs: &'a mut Vec<FeaturePair>,
    met: &'a mut Vec<[usize; 4]>,
}

impl Search<'_> {
    /// Adds the pairs of features of two triangles whose boxes overlap; breaks where there are too
    /// many.
    fn add_pairs(&mut self, s: usize, t: usize) -> ControlFlow<()> {
        let (s, t) = (s.min(t), s.max(t));
        let (surface, near) = (self.surface, &self.ranges.near);
        for (s, t) in [(s, t), (t, s)] {
            let corners = surface.triangles[t];
            let [a, b, c] = corners;
            for &v in &surface.own[s].vertices {
                let is_near = || {
                    let triangle = near[a].with(&near[b]).with(&near[c]);
                    near[v].overlaps(&triangle)
                };
                if !surface.share_corner(&[v], &corners) && is_near() {
                    self.add(Features::VertexTriangle, [v, a, b, c]);
                }
            }
        }
        for &[a, b] in &surface.own[s].edges {
            let first = near[a].with(&near[b]);
            for &[c, d] in &surface.own[t].edges {
                let is_near = || first.overlaps(&near[c].with(&near[d]));
                if !surface.share_corner(&[a, b], &[c, d]) && is_near() {
                    self.add(Features::Edges, [a, b, c, d]);
                }
            }
        }
        if self.pairs.len() < self.most {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    }

    fn add(&mut self, features: Features, corners: [usize; 4]) {
        let is_sought = |has_moved: &[bool]| corners.iter().any(|&i| has_moved[i]);
        if !self.has_moved.is_none_or(is_sought) {
            return;
        }
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
            weight: 0.0,
        };
        pair.distance = pair.proximity(&self.ranges.base).distance();
        if pair.distance - pair.approach(&self.ranges.reach) >= thickness {
            return;
        }
        // Bases of some particles are of another time than those of others.
        if pair.meets(self.from) {
            self.met.push(corners);
        } else {
            self.pairs.push(pair);
        }
    }
}
