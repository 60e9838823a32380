//! The pairs of features that may come into contact while every particle stays in a box of its own.

use super::proximity::{Features, Proximity};
use super::surface::ContactSurface;
use super::swept_boxes::{SweptBoxes, SweptMotion};
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
    /// Cloth area over which they press each other \[m²\]; 0 until the contact has weighed them.
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
    boxes: SweptBoxes,
    pub(super) pairs: Vec<FeaturePair>,
    /// Corners of pairs that were left out because their features meet.
    met: Vec<[usize; 4]>,
    /// True if there were more pairs than are kept.
    is_cut_off: bool,
}

impl Candidates {
    /// Returns true if every particle at `x` is in its box.
    pub(super) fn cover(&self, x: &[Vector3<f64>]) -> bool {
        self.boxes.cover(x)
    }

    /// Finds the pairs that may meet on a motion.
    pub(super) fn rebuild(&mut self, surface: &ContactSurface, motion: &SweptMotion<'_>) {
        self.boxes.rebuild(surface, motion);
        self.pairs.clear();
        self.met.clear();
        let mut search = self.search(surface, motion.from, None);
        let boxes = search.boxes;
        let flow = boxes.for_each_pair(|s, t| search.add_pairs(s, t));
        self.is_cut_off = flow.is_break();
    }

    /// Finds the pairs that may meet on a motion like [`Candidates::rebuild`], with less work where
    /// few particles leave their boxes: the others keep theirs, and only pairs of those that leave,
    /// or that are where features meet, are sought. Returns the number of pairs that stayed, which
    /// are the first ones.
    pub(super) fn update(&mut self, surface: &ContactSurface, motion: &SweptMotion<'_>) -> usize {
        self.find_met(motion.from);
        let met = self.met.as_flattened();
        // Of the pairs beyond the limit nothing is known.
        let updated = match self.is_cut_off {
            true => None,
            false => self.boxes.update(surface, motion, met),
        };
        if let Some(updated) = updated {
            let is_updated = |&i: &usize| updated.particles[i];
            self.pairs
                .retain(|pair| !pair.corners.iter().any(is_updated));
            self.met.clear();
            let stayed = self.pairs.len();
            let mut search = self.search(surface, motion.from, Some(&updated.particles));
            let boxes = search.boxes;
            let add = |s, t| search.add_pairs(s, t);
            let flow = boxes.for_each_pair_of(&updated.triangles, surface, add);
            if flow.is_continue() {
                return stayed;
            }
        }
        self.rebuild(surface, motion);
        0
    }

    /// Finds those of the pairs whose features meet at `x`.
    fn find_met(&mut self, x: &[Vector3<f64>]) {
        let moved = self.boxes.moved(x);
        let meets = |pair: &&FeaturePair| {
            pair.distance - pair.approach(&moved) <= MET * pair.thickness && pair.meets(x)
        };
        let met = self.pairs.iter().filter(meets).map(|pair| pair.corners);
        self.met.extend(met);
    }

    /// Returns a search for pairs that are apart at `from`: all, or those with a particle that is
    /// `updated`.
    fn search<'a>(
        &'a mut self,
        surface: &'a ContactSurface,
        from: &'a [Vector3<f64>],
        updated: Option<&'a [bool]>,
    ) -> Search<'a> {
        Search {
            surface,
            thickness: surface.most_thickness(),
            from,
            updated,
            boxes: &self.boxes,
            most: MOST_PAIRS * from.len(),
            pairs: &mut self.pairs,
            met: &mut self.met,
        }
    }

    /// Returns how far each particle is from where distances are taken \[m\].
    pub(super) fn moved(&self, x: &[Vector3<f64>]) -> Vec<f64> {
        self.boxes.moved(x)
    }
}

/// A search for pairs.
struct Search<'a> {
    surface: &'a ContactSurface,
    /// Thickness of the cloth where it is thickest \[m\].
    thickness: f64,
    /// Positions in which features that meet are left out \[m\].
    from: &'a [Vector3<f64>],
    /// The particles one of which a pair has to have, if not all pairs are sought.
    updated: Option<&'a [bool]>,
    boxes: &'a SweptBoxes,
    /// Pairs that are kept at most, those that meet among them.
    most: usize,
    pairs: &'a mut Vec<FeaturePair>,
    met: &'a mut Vec<[usize; 4]>,
}

impl Search<'_> {
    /// Adds the pairs of features of two triangles whose boxes overlap; breaks where there are too
    /// many.
    fn add_pairs(&mut self, s: usize, t: usize) -> ControlFlow<()> {
        let (s, t) = (s.min(t), s.max(t));
        let surface = self.surface;
        for (s, t) in [(s, t), (t, s)] {
            let corners = surface.triangles[t];
            let [a, b, c] = corners;
            let near = self.boxes.around(&corners).wider(self.thickness);
            for &v in &surface.own[s].vertices {
                let is_near = self.boxes.particles[v].overlaps(&near);
                if is_near && !surface.share_corner(&[v], &corners) {
                    self.add(Features::VertexTriangle, [v, a, b, c]);
                }
            }
        }
        let bounds = |[a, b]: [usize; 2]| self.boxes.particles[a].with(&self.boxes.particles[b]);
        for &[a, b] in &surface.own[s].edges {
            let near = bounds([a, b]).wider(self.thickness);
            for &[c, d] in &surface.own[t].edges {
                let is_near = near.overlaps(&bounds([c, d]));
                if is_near && !surface.share_corner(&[a, b], &[c, d]) {
                    self.add(Features::Edges, [a, b, c, d]);
                }
            }
        }
        if self.pairs.len() + self.met.len() < self.most {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    }

    fn add(&mut self, features: Features, corners: [usize; 4]) {
        let is_sought = |updated: &[bool]| corners.iter().any(|&i| updated[i]);
        if !self.updated.is_none_or(is_sought) {
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
        pair.distance = pair.proximity(&self.boxes.base).distance();
        if pair.distance - pair.approach(&self.boxes.reach) >= thickness {
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
