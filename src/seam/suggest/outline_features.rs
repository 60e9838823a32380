//! Features of a panel's outline: bend of each edge, turn of each corner, with darts closed.

use crate::pattern::point::{cross, dot, sub, turn};
use crate::pattern::{Edge, Panel, Point2};
use std::f64::consts::{PI, TAU};

/// Outlines of more edges than this fit no template.
pub(super) const MAX_EDGES: usize = 40;
/// Distance from a corner over which its direction is measured \[m\]: above the noise of digitized
/// outlines, below their curvature.
const DIRECTION_LENGTH_M: f64 = 0.008;
/// A dart is no wider at its tip than this \[rad\], and no wider at its mouth than this \[m\]; a
/// slit for a godet may be.
const MAX_DART: [f64; 2] = [PI / 2.4, 0.16];
/// A wider one on the axis of a symmetric panel is a neck \[m\].
const MIN_NECK_M: f64 = 0.1;
const MAX_SLIT: [f64; 2] = [PI / 1.6, 0.5];
/// The legs of a dart are straight up to this (deviation over chord), as long as each other up to
/// this share, and no shorter than this \[m\].
const MAX_LEG_BULGE: f64 = 0.12;
const MAX_LEG_DIFFERENCE: f64 = 0.03;
const MIN_LEG_M: f64 = 0.015;

/// Lengths of the edges of copies agree to this share.
const TWIN_LENGTH_SHARE: f64 = 0.01;
/// Edges that mirror each other agree in length to this share, and in their turns to this \[rad\].
const MIRROR_LENGTH_SHARE: f64 = 0.01;
const MIRROR_TURN: f64 = 0.12;

/// Features of one edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeFeatures {
    /// Arc length \[m\].
    pub(super) length: f64,
    /// Turn between its ends, positive where the outline is convex \[rad\].
    pub(super) bend: f64,
    /// Turns to either side, each counted \[rad\].
    pub(super) curl: f64,
    /// Its mean height in the drawing \[m\].
    pub(super) height: f64,
    /// Start and end, in the order of numbers \[m\].
    pub(super) ends: [Point2; 2],
}

/// Two edges that meet at the tip of a dart and are sewn together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dart {
    /// The edge that leads to the tip.
    pub(super) inward: usize,
    /// The edge that leads back.
    pub(super) outward: usize,
}

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
    /// The edges that are left once the darts are sewn, in order.
    pub(super) ring: Vec<usize>,
    /// The turn from each edge of `ring` to the next, positive where the outline is convex \[rad\].
    pub(super) joints: Vec<f64>,
}

impl OutlineFeatures {
    /// Measures a panel. Where a pattern has godets, the wide slits that they are set into count as
    /// darts too.
    pub(super) fn of(panel: &Panel, slits: bool) -> Self {
        let mirrored = panel.copy_of.is_some();
        let sense = if mirrored { 1.0 } else { -1.0 };
        let edges: Vec<EdgeFeatures> = panel
            .edges
            .iter()
            .map(|e| edge_features(e, sense))
            .collect();
        let count = edges.len();
        let turns: Vec<f64> = (0..count)
            .map(|i| sense * turn_between(&panel.edges[(i + count - 1) % count], &panel.edges[i]))
            .collect();
        let darts = darts(&edges, &turns, if slits { MAX_SLIT } else { MAX_DART });
        let (ring, joints) = ring(count, &turns, &darts);
        Self {
            size: panel.area_m2.abs().sqrt(),
            mirrored,
            slits,
            points: std::rc::Rc::new(panel.edges.iter().map(|e| e.points.clone()).collect()),
            notches: panel.notches.iter().map(|n| (n.edge, n.at)).collect(),
            edges,
            darts,
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

    /// Length of a run of edges \[m\].
    pub(super) fn length(&self, edges: &[usize]) -> f64 {
        edges.iter().map(|e| self.edges[*e].length).sum()
    }
}

fn edge_features(edge: &Edge, sense: f64) -> EdgeFeatures {
    let bend: f64 = edge
        .points
        .windows(3)
        .map(|p| sense * turn(p[0], p[1], p[2]))
        .sum();
    let curl: f64 = edge
        .points
        .windows(3)
        .map(|p| turn(p[0], p[1], p[2]).abs())
        .sum();
    let lifted: f64 = edge
        .points
        .windows(2)
        .map(|p| 0.5 * (p[0][1] + p[1][1]) * (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]))
        .sum();
    let first = edge.points.first().copied().unwrap_or_default();
    let last = edge.points.last().copied().unwrap_or_default();
    EdgeFeatures {
        length: edge.length_m,
        bend,
        curl,
        height: lifted / edge.length_m.max(1e-9),
        ends: [first, last],
    }
}

/// The turn where one edge ends and the next begins, counter-clockwise positive \[rad\].
fn turn_between(before: &Edge, after: &Edge) -> f64 {
    let reversed: Vec<Point2> = before.points.iter().rev().copied().collect();
    let arriving = leaving(&reversed).map(|c| -c);
    turn_of(arriving, leaving(&after.points))
}

/// Direction in which a polyline leaves its first point, not of unit length.
fn leaving(points: &[Point2]) -> Point2 {
    let Some(&first) = points.first() else {
        return [1.0, 0.0];
    };
    let mut way = 0.0;
    let mut last = first;
    for &point in &points[1..] {
        let [x, y] = sub(point, last);
        way += x.hypot(y);
        last = point;
        if way >= DIRECTION_LENGTH_M {
            break;
        }
    }
    sub(last, first)
}

/// Returns the turn from one direction to another, counter-clockwise positive \[rad\].
fn turn_of(u: Point2, v: Point2) -> f64 {
    cross(u, v).atan2(dot(u, v))
}

fn darts(edges: &[EdgeFeatures], turns: &[f64], [opening, mouth]: [f64; 2]) -> Vec<Dart> {
    let count = edges.len();
    if count < 5 {
        return vec![];
    }
    let mut darts: Vec<Dart> = vec![];
    for tip in 0..count {
        let dart = Dart {
            inward: (tip + count - 1) % count,
            outward: tip,
        };
        let taken = darts
            .iter()
            .any(|d| d.outward == dart.inward || d.inward == dart.outward);
        let [x, y] = sub(edges[dart.inward].ends[0], edges[tip].ends[1]);
        let wide = x.hypot(y);
        let narrow = turns[tip] < opening - PI && wide <= mouth;
        let neck = narrow && wide > MIN_NECK_M && mouth < MAX_SLIT[1] && is_axis(edges, tip);
        let narrow = narrow && !neck;
        if !taken && narrow && are_legs(edges[dart.inward], edges[tip]) {
            darts.push(dart);
        }
    }
    darts
}

/// Returns true if the outline reads the same from a corner in both directions.
fn is_axis(edges: &[EdgeFeatures], corner: usize) -> bool {
    let count = edges.len();
    (0..count / 2).all(|k| {
        let (a, b) = (
            edges[(corner + k) % count],
            edges[(corner + count - 1 - k) % count],
        );
        (a.length - b.length).abs() <= MIRROR_LENGTH_SHARE * a.length.max(b.length) + 1e-3
    })
}

fn are_legs(a: EdgeFeatures, b: EdgeFeatures) -> bool {
    let straight = |e: EdgeFeatures| {
        let [x, y] = sub(e.ends[1], e.ends[0]);
        e.length <= (1.0 + MAX_LEG_BULGE * MAX_LEG_BULGE * 8.0 / 3.0) * x.hypot(y)
    };
    let (short, long) = (a.length.min(b.length), a.length.max(b.length));
    short >= MIN_LEG_M
        && long - short <= MAX_LEG_DIFFERENCE * long + 1e-3
        && straight(a)
        && straight(b)
}

/// The edges left once darts are sewn, and the turns between them: where a dart was, its two mouth
/// corners become one, whose inner angle is the sum of theirs.
fn ring(count: usize, turns: &[f64], darts: &[Dart]) -> (Vec<usize>, Vec<f64>) {
    let is_leg = |edge: usize| darts.iter().any(|d| d.inward == edge || d.outward == edge);
    let ring: Vec<usize> = (0..count).filter(|edge| !is_leg(*edge)).collect();
    let joints = (0..ring.len())
        .map(|k| {
            let mut edge = (ring[k] + 1) % count;
            let mut joint = turns[edge];
            while is_leg(edge) {
                edge = (edge + 2) % count;
                joint += turns[edge] - PI;
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
