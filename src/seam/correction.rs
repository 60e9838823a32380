//! Corrections of a seam that twists the surface: its mirror edge, or side B reversed.

use super::context::SeamCheckContext;
use super::faces::SeamRelations;
use super::parity::{FaceRelation, ParityUnionFind};
use super::place::opposite;
use super::{RoutedSeam, Track};
use crate::pattern::{OutlineRun, Panel, Place, Point2, SeamPair, Side, polyline};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// Largest distance of the reflection of an edge from the edge that is taken for its mirror, as a
/// share of the panel's width and height.
const MIRROR_SHARE: f64 = 0.02;

/// A point of a panel: the track, and the bits of edge plus fraction.
type TrackPointKey = (usize, Track, u64);

/// A pair that could be sewn, and the change in words.
pub(super) struct Correction {
    pub pair: SeamPair,
    pub fix: String,
}

impl SeamCheckContext<'_> {
    /// The correction of a seam for which reversing side B agrees with the faces of all other
    /// panels.
    ///
    /// Its mirror edge is taken where that is free and heights agree as picked; else side B is
    /// reversed where heights then agree, no fewer notches meet and no fewer ends meet the ends of
    /// neighboring seams. More ends that meet weigh more than heights and notches.
    pub(super) fn correction(&self, implied: &SeamRelations<'_>) -> Option<Correction> {
        let pair = implied.pair;
        let neighbors = self.ends_gained(implied.seam);
        if implied.heights_agree != Some(false)
            && neighbors != Ordering::Greater
            && let Some((mirrored, fix)) = self.mirrored(pair)
        {
            return Some(Correction {
                pair: mirrored,
                fix,
            });
        }
        let agrees = match neighbors {
            Ordering::Greater => true,
            Ordering::Equal => {
                implied.heights_agree != Some(true) && implied.notches[0] <= implied.notches[1]
            }
            Ordering::Less => false,
        };
        agrees.then(|| Correction {
            pair: SeamPair {
                b: reversed_side(&pair.b),
                ..pair.clone()
            },
            fix: "pick the corners of side b in the other order".to_owned(),
        })
    }

    fn mirrored(&self, pair: &SeamPair) -> Option<(SeamPair, String)> {
        if let Some((run, fix)) = self.mirror_run(&pair.b) {
            return Some((
                SeamPair {
                    b: Side::One(run),
                    ..pair.clone()
                },
                fix,
            ));
        }
        let (run, fix) = self.mirror_run(&pair.a)?;
        Some((
            SeamPair {
                a: Side::One(run),
                ..pair.clone()
            },
            fix,
        ))
    }

    /// The run along the mirror image of the edge that `side` is, if there is such an edge and
    /// nothing is sewn to it.
    fn mirror_run(&self, side: &Side) -> Option<(OutlineRun, String)> {
        let Side::One(run) = side else { return None };
        let (Place::Corner(from), Place::Corner(to)) = (run.from, run.to) else {
            return None;
        };
        let index = self.pattern.panel_index(&run.panel)?;
        let panel = &self.pattern.panels[index];
        if panel.edges.len() < 3 {
            return None;
        }
        let (from, to) = (mirror_corner(panel, from)?, mirror_corner(panel, to)?);
        let edge = panel.edges.iter().position(|edge| {
            [edge.from, edge.to] == [from, to] || [edge.to, edge.from] == [from, to]
        })?;
        let stretches = self
            .seams
            .iter()
            .flat_map(|seam| seam.sides.iter().flatten());
        let taken = stretches
            .flat_map(|run| &run.stretches)
            .any(|s| (s.panel, s.track, s.edge) == (index, Track::Outline, edge));
        let fix = format!(
            "take the edge on the other side of `{}`, from corner {from} to corner {to}",
            panel.id
        );
        let run = OutlineRun {
            panel: run.panel.clone(),
            from: Place::Corner(from),
            to: Place::Corner(to),
            direction: None,
        };
        (!taken).then_some((run, fix))
    }

    /// Compares how many ends of a seam join points that other seams, one after another, join too:
    /// with side B reversed against as picked.
    fn ends_gained(&self, index: usize) -> Ordering {
        let Some(seam) = self.seams.iter().find(|seam| seam.index == index) else {
            return Ordering::Equal;
        };
        let [picked, reversed] = [self.ends(seam), self.ends(&seam.reversed())];
        let others = self.seams.iter().filter(|seam| seam.index != index);
        let others: Vec<_> = others.flat_map(|seam| self.ends(seam)).collect();
        let points: BTreeSet<TrackPointKey> =
            others.iter().chain(&picked).flatten().copied().collect();
        let numbers: BTreeMap<TrackPointKey, usize> = points.into_iter().zip(0..).collect();
        let mut joined = ParityUnionFind::new(numbers.len());
        let numbered = |ends: [TrackPointKey; 2]| ends.map(|point| numbers[&point]);
        for ends in others {
            let ends = numbered(ends);
            joined.join(FaceRelation { ends, same: true });
        }
        let mut count = |ends: [[TrackPointKey; 2]; 2]| {
            let mut heads = |ends| numbered(ends).map(|point| joined.find(point).0);
            let meeting = ends.into_iter().map(&mut heads).filter(|[a, b]| a == b);
            meeting.count()
        };
        count(reversed).cmp(&count(picked))
    }

    /// Returns the points that meet at the two ends of a seam.
    fn ends(&self, seam: &RoutedSeam) -> [[TrackPointKey; 2]; 2] {
        let point = |side: usize, last: bool| {
            let mut stretches = seam.sides[side].iter().flat_map(|run| &run.stretches);
            let (stretch, at) = if last {
                stretches.next_back().map(|s| (s, s.to))
            } else {
                stretches.next().map(|s| (s, s.from))
            }
            .expect("a run has at least one stretch");
            let panel = &self.pattern.panels[stretch.panel];
            let place = stretch.edge as f64 + at;
            let place = if stretch.track.is_closed(panel) {
                place % stretch.track.edge_count(panel) as f64
            } else {
                place
            };
            (stretch.panel, stretch.track, place.to_bits())
        };
        [false, true].map(|last| [point(0, last), point(1, last)])
    }
}

/// The corner at the reflection of `corner` about the upright line through the middle of the panel;
/// not itself.
fn mirror_corner(panel: &Panel, corner: usize) -> Option<usize> {
    let edges = panel.edges.iter();
    let points: Vec<Point2> = edges.flat_map(|edge| edge.points.iter().copied()).collect();
    let [[left, low], [right, high]] = polyline::bounds(&points);
    let of = panel.corners.get(corner)?;
    panel
        .corners
        .iter()
        .position(|other| {
            (other.x - (left + right - of.x)).abs() <= MIRROR_SHARE * (right - left)
                && (other.y - of.y).abs() <= MIRROR_SHARE * (high - low)
        })
        .filter(|&mirror| mirror != corner)
}

/// Returns a side whose runs go from its end to its start.
pub(super) fn reversed_side(side: &Side) -> Side {
    let turned = |run: &OutlineRun| OutlineRun {
        panel: run.panel.clone(),
        from: run.to,
        to: run.from,
        direction: run.direction.map(opposite),
    };
    match side {
        Side::One(run) => Side::One(turned(run)),
        Side::Many(runs) => Side::Many(runs.iter().rev().map(turned).collect()),
    }
}
