//! Matched stretches of seams seen from both sides, and the points at which their ends meet.

use super::{RoutedSeam, Stretch, Track};
use crate::pattern::Pattern;
use std::collections::BTreeMap;

/// Ends of stretches on one track that are nearer than this are one point \[m\]: the gap up to
/// which a seam counts as closed.
const SAME_POINT_M: f64 = 1e-3;

/// Ends at one point that an end is paired with.
const MAX_NEIGHBORS: usize = 32;

/// A matched stretch of a seam seen from one of its sides: cloth that lies on a base.
#[derive(Clone, Copy, Debug)]
pub(super) struct SeamSide {
    /// Position of the seam in the request.
    pub seam: usize,
    /// Index of the matched pair of stretches in the seam.
    pub pair: usize,
    pub cloth: Stretch,
    pub base: Stretch,
    /// The first and the last end.
    pub ends: [SeamSideEnd; 2],
}

/// An end of a side.
#[derive(Clone, Copy, Debug)]
pub(super) struct SeamSideEnd {
    /// Points of cloth and base that meet, by number.
    pub cloth_node: usize,
    pub base_node: usize,
    /// Places along the tracks of cloth and base \[m\].
    cloth_m: f64,
    base_m: f64,
    /// Share of the edge of the base at which it lies.
    pub base_at: f64,
    /// True if the side lies ahead of this end in the order of corners, on the cloth and on the
    /// base.
    pub cloth_ahead: bool,
    pub base_ahead: bool,
}

/// Both sides of all matched stretches of a set of seams.
pub(super) struct SeamSides {
    pub sides: Vec<SeamSide>,
    pub node_count: usize,
}

/// A panel and a track of it.
type TrackKey = (usize, Track);

impl SeamSides {
    pub(super) fn new<'a>(
        pattern: &Pattern,
        seams: impl Iterator<Item = std::borrow::Cow<'a, RoutedSeam>>,
    ) -> Self {
        let mut places = TrackPlaces::new(pattern);
        let mut sides = vec![];
        for seam in seams {
            for (pair, &[a, b]) in seam.matched(pattern).iter().enumerate() {
                for [cloth, base] in [[a, b], [b, a]] {
                    let ends = [false, true].map(|last| places.end([cloth, base], last));
                    sides.push(SeamSide {
                        seam: seam.index,
                        pair,
                        cloth,
                        base,
                        ends,
                    });
                }
            }
        }
        let node_count = number_nodes(&mut sides);
        Self { sides, node_count }
    }

    /// Returns the pairs of ends that meet at a point of cloth, with the indices of their sides.
    /// Each end is paired with at most 32 others: more than any pleat lays there, and a bound on
    /// the work.
    pub(super) fn meeting_ends(&self) -> impl Iterator<Item = [(usize, SeamSideEnd); 2]> {
        let mut by_node = vec![vec![]; self.node_count];
        for (i, side) in self.sides.iter().enumerate() {
            for end in side.ends {
                by_node[end.cloth_node].push((i, end));
            }
        }
        by_node.into_iter().flat_map(|ends| {
            let pairs_of = |(i, one): (usize, &(usize, SeamSideEnd))| {
                let others = ends.iter().skip(i + 1).take(MAX_NEIGHBORS);
                others.map(|other| [*one, *other]).collect::<Vec<_>>()
            };
            ends.iter()
                .enumerate()
                .flat_map(pairs_of)
                .collect::<Vec<_>>()
        })
    }
}

impl SeamSide {
    pub(super) fn has_base_track_of(&self, other: &Self) -> bool {
        (self.base.panel, self.base.track) == (other.base.panel, other.base.track)
    }
}

/// Arc lengths at which the edges of tracks begin, each track measured once.
struct TrackPlaces<'a> {
    pattern: &'a Pattern,
    starts: BTreeMap<TrackKey, Vec<f64>>,
}

impl<'a> TrackPlaces<'a> {
    fn new(pattern: &'a Pattern) -> Self {
        Self {
            pattern,
            starts: BTreeMap::new(),
        }
    }

    fn end(&mut self, [cloth, base]: [Stretch; 2], last: bool) -> SeamSideEnd {
        let is_ahead = |stretch: Stretch| (stretch.to > stretch.from) != last;
        let mut place =
            |stretch: Stretch| self.place(stretch, if last { stretch.to } else { stretch.from });
        SeamSideEnd {
            cloth_node: 0,
            base_node: 0,
            cloth_m: place(cloth),
            base_m: place(base),
            base_at: if last { base.to } else { base.from },
            cloth_ahead: is_ahead(cloth),
            base_ahead: is_ahead(base),
        }
    }

    /// Returns the place along its track \[m\]; the end of a closed track is its start.
    fn place(&mut self, stretch: Stretch, at: f64) -> f64 {
        let panel = &self.pattern.panels[stretch.panel];
        let track = stretch.track;
        let starts = self
            .starts
            .entry((stretch.panel, track))
            .or_insert_with(|| {
                let lengths = (0..track.edge_count(panel)).map(|edge| track.length(panel, edge));
                let ends = lengths.scan(0.0, |sum, length| {
                    *sum += length;
                    Some(*sum)
                });
                std::iter::once(0.0).chain(ends).collect()
            });
        let place = starts[stretch.edge] + at * track.length(panel, stretch.edge);
        let whole = starts[starts.len() - 1];
        if track.is_closed(panel) && place > whole - SAME_POINT_M {
            place - whole
        } else {
            place
        }
    }
}

/// Numbers the points at which sides end, those of one track that are near each other as one;
/// returns how many there are.
fn number_nodes(sides: &mut [SeamSide]) -> usize {
    let mut places: Vec<(TrackKey, f64, &mut usize)> = vec![];
    for side in sides {
        let keys = [side.cloth, side.base].map(|stretch| (stretch.panel, stretch.track));
        for end in &mut side.ends {
            places.push((keys[0], end.cloth_m, &mut end.cloth_node));
            places.push((keys[1], end.base_m, &mut end.base_node));
        }
    }
    places.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut count = 0;
    let mut before: Option<(TrackKey, f64)> = None;
    for (track, place, node) in places {
        let is_same = before.is_some_and(|(other, at)| other == track && place - at < SAME_POINT_M);
        count += usize::from(!is_same);
        *node = count - 1;
        before = Some((track, place));
    }
    count
}
