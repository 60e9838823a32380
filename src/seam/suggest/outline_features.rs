//! Features of a panel's outline: bend of each edge, turn of each corner, with darts closed.

use super::darts::{Dart, darts};
use super::edge_features::{EdgeFeatures, turn_between};
use super::vents::{self, Vent};
use crate::pattern::point::sub;
use crate::pattern::{Panel, Point2};
use std::f64::consts::{PI, TAU};

/// Outlines of more edges than this fit no template.
pub(super) const MAX_EDGES: usize = 40;

/// Lengths of the edges of copies agree to this share.
const TWIN_LENGTH_SHARE: f64 = 0.01;
/// Edges that mirror each other agree in length to this share, and in their turns to this \[rad\].
const MIRROR_LENGTH_SHARE: f64 = 0.01;
const MIRROR_TURN: f64 = 0.12;

/// Features of a panel's outline with its darts closed.
#[derive(Clone, Debug)]
pub(super) struct OutlineFeatures {
    /// Side of the square of the same area \[m\].
    pub(super) size: f64,
    /// True if the order of numbers runs counter-clockwise (mirrored copies).
    pub(super) mirrored: bool,
    /// True if slits for godets count as darts.
    pub(super) slits: bool,
    /// The edges and places of its notches.
    pub(super) notches: Vec<(usize, f64)>,
    /// Every edge of the outline.
    pub(super) edges: Vec<EdgeFeatures>,
    /// The points of every edge \[m\].
    pub(super) points: std::rc::Rc<Vec<Vec<Point2>>>,
    /// Its darts.
    pub(super) darts: Vec<Dart>,
    /// Its vents.
    vents: Vec<Vent>,
    /// The edges that are left without darts and vents, in order.
    pub(super) ring: Vec<usize>,
    /// The turn from each edge of `ring` to the next, positive where the outline is convex \[rad\].
    pub(super) joints: Vec<f64>,
}

impl OutlineFeatures {
    /// Measures a panel. `slits`: wide slits that godets are set into count as darts too. `vents`:
    /// seams may end in vents, which are left out.
    pub(super) fn of(panel: &Panel, slits: bool, vents: bool) -> Self {
        let mirrored = panel.copy_of.is_some();
        let sense = if mirrored { 1.0 } else { -1.0 };
        let edges: Vec<EdgeFeatures> = panel
            .edges
            .iter()
            .map(|e| EdgeFeatures::of(e, sense))
            .collect();
        let count = edges.len();
        let turns: Vec<f64> = (0..count)
            .map(|i| sense * turn_between(&panel.edges[(i + count - 1) % count], &panel.edges[i]))
            .collect();
        let darts = darts(&edges, &turns, slits);
        let mut left_out: Vec<LeftOut> = darts
            .iter()
            .map(|dart| LeftOut::of_dart(*dart, count))
            .collect();
        let lengths: Vec<f64> = edges.iter().map(|edge| edge.length).collect();
        let vents = if vents {
            vents::vents(&lengths, &turns)
        } else {
            vec![]
        };
        left_out.extend(vents.iter().map(|vent| LeftOut::of_vent(*vent, &turns)));
        let (ring, joints) = ring(&turns, &left_out);
        Self {
            size: panel.area_m2.abs().sqrt(),
            mirrored,
            slits,
            points: std::rc::Rc::new(panel.edges.iter().map(|e| e.points.clone()).collect()),
            notches: panel.notches.iter().map(|n| (n.edge, n.at)).collect(),
            edges,
            darts,
            vents,
            ring,
            joints,
        }
    }

    /// Returns the features of the mirrored copy: reflected x -> -x, with the same numbers.
    pub(super) fn reflected(&self) -> Self {
        let reflect = |[x, y]: Point2| [-x, y];
        let points = self
            .points
            .iter()
            .map(|edge| edge.iter().copied().map(reflect).collect());
        let mut copy = Self {
            mirrored: !self.mirrored,
            points: std::rc::Rc::new(points.collect()),
            ..self.clone()
        };
        for edge in &mut copy.edges {
            edge.ends = edge.ends.map(reflect);
        }
        copy
    }

    /// Returns true if both outlines have edges of the same lengths.
    pub(super) fn is_twin(&self, other: &Self) -> bool {
        let sorted = |features: &Self| {
            let mut all: Vec<f64> = features.edges.iter().map(|e| e.length).collect();
            all.sort_by(f64::total_cmp);
            all
        };
        let (a, b) = (sorted(self), sorted(other));
        let alike = |(x, y): (&f64, &f64)| (x - y).abs() <= TWIN_LENGTH_SHARE * x.max(*y) + 1e-3;
        a.len() == b.len() && a.iter().zip(&b).all(alike)
    }

    /// Returns true if some axis mirrors the outline onto itself.
    pub(super) fn is_symmetric(&self) -> bool {
        let count = self.ring.len();
        let edge = |k: usize| self.edges[self.ring[k % count]];
        // An axis goes through a corner or the middle of an edge: reading on from it is reading
        // back from it.
        count <= MAX_EDGES
            && (0..2 * count).any(|axis| {
                let (on, back) = (axis / 2 + axis % 2, (axis / 2 + count - 1) % count);
                (0..count / 2).all(|k| {
                    let (a, b) = (edge(on + k), edge(back + count - k));
                    let joint = |k: usize| self.joints[k % count];
                    let (turn_a, turn_b) = (joint(on + k), joint(back + 2 * count - k - 1));
                    (a.length - b.length).abs()
                        <= MIRROR_LENGTH_SHARE * a.length.max(b.length) + 1e-3
                        && (a.bend - b.bend).abs() < MIRROR_TURN
                        && (turn_a - turn_b).abs() < MIRROR_TURN
                })
            })
    }

    /// Returns true if edges run across the drawing rather than up.
    pub(super) fn is_level(&self, edges: &[usize]) -> bool {
        let extent = |k: usize| -> f64 {
            edges
                .iter()
                .map(|e| (self.edges[*e].ends[1][k] - self.edges[*e].ends[0][k]).abs())
                .sum()
        };
        extent(0) >= extent(1)
    }

    /// Returns the distance of a point from the straight line through the ends of a run of edges,
    /// positive on the side of the panel \[m\].
    pub(super) fn above(&self, edges: &[usize], point: Point2) -> f64 {
        let (Some(first), Some(last)) = (edges.first(), edges.last()) else {
            return 0.0;
        };
        let (a, b) = (self.edges[*first].ends[0], self.edges[*last].ends[1]);
        let ([x, y], [u, v]) = (sub(b, a), sub(point, a));
        let across = (x * v - y * u) / x.hypot(y).max(1e-9);
        if self.mirrored { across } else { -across }
    }

    /// The points of a run of edges, in order \[m\].
    pub(super) fn polyline(&self, edges: &[usize]) -> Vec<Point2> {
        edges
            .iter()
            .flat_map(|e| self.points[*e].iter().copied())
            .collect()
    }

    /// Returns how much edges turn to either side, each turn counted \[rad\].
    pub(super) fn curl(&self, edges: &[usize]) -> f64 {
        edges.iter().map(|e| self.edges[*e].curl).sum()
    }

    /// Mean height of edges in the drawing \[m\].
    pub(super) fn height(&self, edges: &[usize]) -> f64 {
        let all = || edges.iter().map(|e| &self.edges[*e]);
        all().map(|e| e.length * e.height).sum::<f64>() / self.length(edges).max(1e-9)
    }

    /// Returns true if a run of edges ends at a vent.
    pub(super) fn ends_in_vent(&self, edges: &[usize]) -> bool {
        let count = self.edges.len();
        let beside = |vent: &Vent| [vent.first + count - 1, vent.first + vent.count];
        let mut all = self.vents.iter().flat_map(beside);
        all.any(|edge| edges.contains(&(edge % count)))
    }

    /// Length of a run of edges \[m\].
    pub(super) fn length(&self, edges: &[usize]) -> f64 {
        edges.iter().map(|e| self.edges[*e].length).sum()
    }
}

/// A run of edges that is no part of the ring.
struct LeftOut {
    first: usize,
    count: usize,
    /// Turn within it \[rad\].
    turn: f64,
}

impl LeftOut {
    fn of_dart(dart: Dart, count: usize) -> Self {
        Self {
            first: (dart.inward + count + 1 - dart.per_leg) % count,
            count: 2 * dart.per_leg,
            turn: -PI,
        }
    }

    fn of_vent(vent: Vent, turns: &[f64]) -> Self {
        let within = (1..vent.count).map(|k| turns[(vent.first + k) % turns.len()]);
        Self {
            first: vent.first,
            count: vent.count,
            turn: within.sum(),
        }
    }
}

/// The edges left without darts and vents, and the turns between them: where a dart was, its two
/// mouth corners become one, whose inner angle is the sum of theirs.
fn ring(turns: &[f64], left_out: &[LeftOut]) -> (Vec<usize>, Vec<f64>) {
    let count = turns.len();
    let has = |run: &&LeftOut, edge: usize| (edge + count - run.first) % count < run.count;
    let is_in = |edge: &usize| !left_out.iter().any(|run| has(&run, *edge));
    let ring: Vec<usize> = (0..count).filter(is_in).collect();
    let joints = (0..ring.len())
        .map(|k| {
            let mut edge = (ring[k] + 1) % count;
            let mut joint = turns[edge];
            while let Some(run) = left_out.iter().find(|run| run.first == edge) {
                edge = (edge + run.count) % count;
                joint += run.turn + turns[edge];
            }
            wrapped(joint)
        })
        .collect();
    (ring, joints)
}

/// Returns the angle between -π and π.
fn wrapped(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    /// A strip whose right seam ends in a vent: the hem follows the seam at a right angle.
    #[test]
    fn vents_are_no_part_of_the_ring() {
        let corners = [
            [0.0, 0.0],
            [0.0, 0.6],
            [0.2, 0.6],
            [0.2, 0.1],
            [0.23, 0.1],
            [0.23, 0.0],
        ];
        let panel = Panel::polygon("sleeve", &corners);
        let features = OutlineFeatures::of(&panel, false, true);
        assert_eq!(features.ring, [0, 1, 2, 5]);
        for joint in &features.joints {
            assert!((joint - FRAC_PI_2).abs() < 1e-12);
        }
        assert!(features.ends_in_vent(&[2]) && !features.ends_in_vent(&[0]));
        let features = OutlineFeatures::of(&panel, false, false);
        assert_eq!(features.ring.len(), 6);
    }
}
