//! Matching of the points of side A and side B by arc length, piecewise between the edge ends of
//! both sides.

use super::Stretch;

/// Edge ends of the two sides that meet within this share of the seam's length are sewn onto each
/// other: by arc length alone they would miss by what ease and drawing tolerance leave, and cut the
/// seam into slivers.
const MERGE_SHARE: f64 = 0.01;

/// Bounds of the same \[m\]: at least the gap up to which a seam counts as closed, at most half of
/// a usual mesh edge.
const MERGE_M: [f64; 2] = [1e-3, 5e-3];

/// Never more than this share, so that very short seams keep their edges apart.
const MAX_MERGE_SHARE: f64 = 0.1;

fn merge_distance(longer: f64) -> f64 {
    (MERGE_SHARE * longer)
        .clamp(MERGE_M[0], MERGE_M[1])
        .min(MAX_MERGE_SHARE * longer)
}

/// Cuts both sides into stretches that meet pairwise.
///
/// `a` and `b` are the stretches of each side with their lengths \[m\], which must be positive. A
/// cut is made wherever an edge ends on either side; the other side is cut at the same fraction of
/// what is left of it, or at its own edge end where that is near. Fractions 0 and 1 at edge ends
/// stay exact.
pub(super) fn match_stretches(a: &[(Stretch, f64)], b: &[(Stretch, f64)]) -> Vec<[Stretch; 2]> {
    let (mut a, mut b) = (StretchCursor::new(a), StretchCursor::new(b));
    let merge = {
        let longer = a.length.max(b.length);
        merge_distance(longer) / longer
    };
    let mut pairs = vec![];
    while !a.is_on_last() || !b.is_on_last() {
        let end_on_b = b.at + (a.end() - a.at) / (1.0 - a.at) * (1.0 - b.at);
        let near = (end_on_b - b.end()).abs() <= merge;
        pairs.push(if !a.is_on_last() && !b.is_on_last() && near {
            [a.take_all(), b.take_all()]
        } else if b.is_on_last() || (!a.is_on_last() && end_on_b < b.end()) {
            [a.take_all(), b.take_to(end_on_b)]
        } else {
            let end_on_a = a.at + (b.end() - b.at) / (1.0 - b.at) * (1.0 - a.at);
            [a.take_to(end_on_a), b.take_all()]
        });
    }
    pairs.push([a.take_all(), b.take_all()]);
    pairs
}

/// One side, of which stretches are taken off from the front. Positions are fractions of the whole
/// side's length.
struct StretchCursor<'a> {
    stretches: &'a [(Stretch, f64)],
    length: f64,
    index: usize,
    /// Start of the present stretch, before anything was taken off it.
    begin: f64,
    /// Position of the last cut.
    at: f64,
    /// Position of the last cut as a fraction of the present edge.
    edge_at: f64,
}

impl<'a> StretchCursor<'a> {
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

    fn is_on_last(&self) -> bool {
        self.index + 1 == self.stretches.len()
    }

    /// Returns the end of the present stretch.
    fn end(&self) -> f64 {
        if self.is_on_last() {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A side of edges of these lengths, gone against the edges where `against`.
    fn side(lengths: &[f64], against: bool) -> Vec<(Stretch, f64)> {
        let [from, to] = if against { [1.0, 0.0] } else { [0.0, 1.0] };
        let stretch = |edge| Stretch {
            panel: usize::from(against),
            track: crate::seam::Track::Outline,
            edge,
            from,
            to,
        };
        lengths
            .iter()
            .enumerate()
            .map(|(edge, &length)| (stretch(edge), length))
            .collect()
    }

    /// Checks that the stretches of one side follow one another and cover it, and gives where each
    /// ends \[m\].
    fn ends(side: &[(Stretch, f64)], taken: impl Iterator<Item = Stretch>) -> Vec<f64> {
        let (mut index, mut at, mut gone) = (0, side[0].0.from, 0.0);
        let ends = taken.map(|stretch| {
            if at == side[index].0.to {
                index += 1;
                at = side[index].0.from;
            }
            assert_eq!((stretch.edge, stretch.from), (side[index].0.edge, at));
            let length = (stretch.to - stretch.from).abs() * side[index].1;
            assert!(length > 0.0, "{stretch:?} is empty");
            assert_eq!(
                stretch.to > stretch.from,
                side[index].0.to > side[index].0.from
            );
            at = stretch.to;
            gone += length;
            gone
        });
        let ends = ends.collect();
        assert_eq!((index + 1, at), (side.len(), side[index].0.to));
        ends
    }

    #[test]
    fn pieces_cover_both_sides_and_meet_at_equal_fractions() {
        let cases: [(&[f64], &[f64]); 6] = [
            (&[0.3], &[0.3]),
            (&[0.4], &[0.15, 0.24]),
            (&[0.1, 0.2, 0.3], &[0.3, 0.2, 0.1]),
            (&[0.25, 0.25], &[0.251, 0.249]),
            (&[0.1, 0.000_5, 0.000_5, 0.2], &[0.101, 0.000_4, 0.2]),
            (&[1e-5], &[1e-6, 9e-6]),
        ];
        for (a, b) in cases {
            let (a, b) = (side(a, false), side(b, true));
            let pairs = match_stretches(&a, &b);
            let ends_a = ends(&a, pairs.iter().map(|pair| pair[0]));
            let ends_b = ends(&b, pairs.iter().map(|pair| pair[1]));
            let (length_a, length_b) = (ends_a[ends_a.len() - 1], ends_b[ends_b.len() - 1]);
            let longer = length_a.max(length_b);
            for (end_a, end_b) in ends_a.iter().zip(&ends_b) {
                let apart = (end_a / length_a - end_b / length_b).abs() * longer;
                assert!(apart <= merge_distance(longer) + 1e-12, "{apart} m apart");
            }
            assert!(pairs.len() < a.len() + b.len());
        }
    }

    #[test]
    fn matching_is_the_same_from_either_side() {
        let (a, b) = (side(&[0.1, 0.2, 0.3], false), side(&[0.15, 0.5], true));
        let swapped: Vec<_> = match_stretches(&b, &a)
            .into_iter()
            .map(|[b, a]| [a, b])
            .collect();
        assert_eq!(match_stretches(&a, &b), swapped);
    }
}
