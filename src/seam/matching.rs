//! Which point of side A meets which of side B: by arc length, piecewise between the edge ends of both sides.

use super::Stretch;

/// Edge ends of the two sides that meet within this share of the seam's length are sewn onto each other:
/// by arc length alone they would miss by what ease and drawing tolerance leave, and cut the seam into slivers.
const MERGE_SHARE: f64 = 0.01;

/// Bounds of the same \[m\]: at least the gap up to which a seam counts as closed, at most half of a usual mesh edge.
const MERGE_M: [f64; 2] = [1e-3, 5e-3];

/// Never more than this share, so that very short seams keep their edges apart.
const MERGE_SHARE_MOST: f64 = 0.1;

fn merge_distance(longer: f64) -> f64 {
    (MERGE_SHARE * longer)
        .clamp(MERGE_M[0], MERGE_M[1])
        .min(MERGE_SHARE_MOST * longer)
}

/// Cuts both sides into stretches that meet pairwise.
///
/// `a` and `b` are the stretches of each side with their lengths \[m\], which must be positive. A cut is made wherever
/// an edge ends on either side; the other side is cut at the same fraction of what is left of it, or at
/// its own edge end where that is near. Fractions 0 and 1 at edge ends stay exact.
pub(super) fn matched(a: &[(Stretch, f64)], b: &[(Stretch, f64)]) -> Vec<[Stretch; 2]> {
    let (mut a, mut b) = (Tape::new(a), Tape::new(b));
    let merge = {
        let longer = a.length.max(b.length);
        merge_distance(longer) / longer
    };
    let mut pairs = vec![];
    while !a.on_last() || !b.on_last() {
        let end_on_b = b.at + (a.end() - a.at) / (1.0 - a.at) * (1.0 - b.at);
        let near = (end_on_b - b.end()).abs() <= merge;
        pairs.push(if !a.on_last() && !b.on_last() && near {
            [a.take_all(), b.take_all()]
        } else if b.on_last() || (!a.on_last() && end_on_b < b.end()) {
            [a.take_all(), b.take_to(end_on_b)]
        } else {
            let end_on_a = a.at + (b.end() - b.at) / (1.0 - b.at) * (1.0 - a.at);
            [a.take_to(end_on_a), b.take_all()]
        });
    }
    pairs.push([a.take_all(), b.take_all()]);
    pairs
}

/// One side, of which stretches are taken off from the front. Positions are fractions of the whole side's length.
struct Tape<'a> {
    stretches: &'a [(Stretch, f64)],
    length: f64,
    index: usize,
    /// Where the present stretch begins, before anything was taken off it.
    begin: f64,
    /// Where the side was cut last.
    at: f64,
    /// The same as a fraction of the present edge.
    edge_at: f64,
}

impl<'a> Tape<'a> {
    fn new(stretches: &'a [(Stretch, f64)]) -> Self {
        Self {
            stretches,
            length: stretches.iter().map(|(_, length)| length).sum(),
            index: 0,
            begin: 0.0,
            at: 0.0,
            edge_at: stretches[0].0.from,
        }
    }

    fn on_last(&self) -> bool {
        self.index + 1 == self.stretches.len()
    }

    /// Where the present stretch ends.
    fn end(&self) -> f64 {
        if self.on_last() {
            1.0
        } else {
            self.begin + self.stretches[self.index].1 / self.length
        }
    }

    /// Takes off what is left of the present stretch.
    fn take_all(&mut self) -> Stretch {
        let (stretch, _) = self.stretches[self.index];
        let taken = Stretch {
            from: self.edge_at,
            ..stretch
        };
        self.begin = self.end();
        self.at = self.begin;
        if let Some((next, _)) = self.stretches.get(self.index + 1) {
            self.edge_at = next.from;
            self.index += 1;
        }
        taken
    }

    /// Takes the present stretch off up to `position`, which lies on it.
    fn take_to(&mut self, position: f64) -> Stretch {
        let (stretch, _) = self.stretches[self.index];
        let share = ((position - self.begin) / (self.end() - self.begin)).clamp(0.0, 1.0);
        let to = stretch.from + share * (stretch.to - stretch.from);
        let taken = Stretch {
            from: self.edge_at,
            to,
            ..stretch
        };
        self.at = position;
        self.edge_at = to;
        taken
    }
}
