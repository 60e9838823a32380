//! Darts of an outline: legs that meet at a tip and are sewn together.

use super::edge_features::EdgeFeatures;
use crate::pattern::point::sub;
use std::f64::consts::PI;

/// A dart is no wider at its tip than this \[rad\], and no wider at its mouth than this \[m\]; a
/// slit for a godet may be.
const MAX_DART: [f64; 2] = [PI / 2.4, 0.16];
const MAX_SLIT: [f64; 2] = [PI / 1.6, 0.5];
/// A wider one on the axis of a symmetric panel is a neck \[m\].
const MIN_NECK_M: f64 = 0.1;
/// Edges that mirror each other there agree in length to this share.
const MIRROR_LENGTH_SHARE: f64 = 0.01;
/// The legs of a dart are straight up to this (deviation over chord), as long as each other up to
/// this share, and no shorter than this \[m\].
const MAX_LEG_BULGE: f64 = 0.12;
const MAX_LEG_DIFFERENCE: f64 = 0.03;
const MIN_LEG_M: f64 = 0.015;
/// A leg of several edges bends by at most this from one to the next \[rad\].
const MAX_LEG_BEND: f64 = 0.5;

/// Two legs that meet at the tip of a dart and are sewn together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dart {
    /// The edge that leads to the tip.
    pub(super) inward: usize,
    /// The edge that leads back.
    pub(super) outward: usize,
    /// Edges of each leg: several where its legs bend.
    pub(super) per_leg: usize,
}

impl Dart {
    /// Returns the edges of both legs of an outline of `count`, each from the mouth to the tip.
    pub(super) fn legs(self, count: usize) -> [Vec<usize>; 2] {
        let from_mouth = (0..self.per_leg).rev();
        [
            from_mouth
                .clone()
                .map(|k| (self.inward + count - k) % count)
                .collect(),
            from_mouth.map(|k| (self.outward + k) % count).collect(),
        ]
    }

    /// Width of its mouth \[m\].
    fn mouth(self, edges: &[EdgeFeatures]) -> f64 {
        let count = edges.len();
        let a = (self.inward + count + 1 - self.per_leg) % count;
        let b = (self.outward + self.per_leg - 1) % count;
        mouth_between(edges[a], edges[b])
    }

    fn has(self, edge: usize, count: usize) -> bool {
        self.legs(count).concat().contains(&edge)
    }
}

/// Returns the darts of an outline by its edges and the turn where each begins, positive where the
/// outline is convex \[rad\]. `slits`: wide slits that godets are set into count too.
pub(super) fn darts(edges: &[EdgeFeatures], turns: &[f64], slits: bool) -> Vec<Dart> {
    let [opening, mouth] = if slits { MAX_SLIT } else { MAX_DART };
    let count = edges.len();
    if count < 5 {
        return vec![];
    }
    let mut darts: Vec<Dart> = vec![];
    for tip in 0..count {
        let dart = Dart {
            inward: (tip + count - 1) % count,
            outward: tip,
            per_leg: 1,
        };
        let taken = darts
            .iter()
            .any(|d| d.has(dart.inward, count) || d.has(dart.outward, count));
        let narrow = turns[tip] < opening - PI && dart.mouth(edges) <= mouth;
        if taken || !narrow || !are_legs(edges[dart.inward], edges[tip]) {
            continue;
        }
        let dart = lengthened(dart, edges, turns, mouth);
        let is_neck = !slits && dart.mouth(edges) > MIN_NECK_M && is_axis(edges, tip);
        if !is_neck {
            darts.push(dart);
        }
    }
    darts
}

fn mouth_between(inward: EdgeFeatures, outward: EdgeFeatures) -> f64 {
    let [x, y] = sub(inward.ends[0], outward.ends[1]);
    x.hypot(y)
}

/// Returns a dart with the edges beside its legs that go on along them.
fn lengthened(mut dart: Dart, edges: &[EdgeFeatures], turns: &[f64], mouth: f64) -> Dart {
    let count = edges.len();
    // The outline keeps three edges.
    while 2 * (dart.per_leg + 1) + 3 <= count {
        let a = (dart.inward + count - dart.per_leg) % count;
        let b = (dart.outward + dart.per_leg) % count;
        let bends = [turns[(a + 1) % count], turns[b]];
        let goes_on = bends.iter().all(|turn| turn.abs() <= MAX_LEG_BEND)
            && mouth_between(edges[a], edges[b]) <= mouth
            && are_legs(edges[a], edges[b]);
        if !goes_on {
            break;
        }
        dart.per_leg += 1;
    }
    dart
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
