//! Chords between the two sides of a seam where its panels start: they tell its order where the
//! faces of panels cannot.

use super::{Face, RoutedSeam, StartPositions, Stretch};
use crate::pattern::Pattern;

/// Points at which the two sides are compared.
const SAMPLE_COUNT: usize = 17;

/// The other order is far shorter if what goes beyond the shared distance is at most this share of
/// what does in the first one, the tangent of 30 degrees: two straight sides of one length are then
/// at most 60 degrees off in the other order, and at least 120 in the first. Sleeves turned down by
/// 45 degrees against their armholes stay below it.
const FAR_RATIO: f64 = 0.577;

/// Sides shorter than this are not judged \[m\]: the bit of an edge that is left at a corner points
/// any way.
const MIN_SIDE_M: f64 = 0.02;

/// Sides that start as well together as this share of the seam's length are left alone.
const CLOSE_SHARE: f64 = 0.1;

/// The chords between the points that meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chords {
    /// Root of the mean square of their lengths \[m\].
    pub rms: f64,
    /// Length of the mean chord \[m\].
    mean: f64,
    /// Length of the longer side \[m\].
    length: f64,
}

impl Chords {
    /// Returns the chords of `seam` in the order it has, on panels with these faces; nothing where
    /// the start of a panel is not known.
    pub(super) fn of(
        pattern: &Pattern,
        seam: &RoutedSeam,
        faces: &[Face],
        starts: StartPositions<'_>,
    ) -> Option<Self> {
        let matched = seam.matched(pattern);
        let lengths: Vec<f64> = matched
            .iter()
            .map(|pair| pair.iter().map(|s| s.length(pattern)).sum())
            .collect();
        let whole: f64 = lengths.iter().sum();
        let (mut pair, mut passed) = (0, 0.0);
        let (mut sum, mut squares) = ([0.0; 3], 0.0);
        for sample in 0..SAMPLE_COUNT {
            #[expect(clippy::cast_precision_loss, reason = "a few samples")]
            let at = whole * sample as f64 / (SAMPLE_COUNT - 1) as f64;
            while pair + 1 < matched.len() && passed + lengths[pair] < at {
                passed += lengths[pair];
                pair += 1;
            }
            let share = ((at - passed) / lengths[pair]).clamp(0.0, 1.0);
            let start = |s: &Stretch| starts(s.panel, faces[s.panel], s.point(pattern, share));
            let (a, b) = (start(&matched[pair][0])?, start(&matched[pair][1])?);
            let chord = [0, 1, 2].map(|k| b[k] - a[k]);
            squares += chord.iter().map(|c| c * c).sum::<f64>();
            sum = [0, 1, 2].map(|k| sum[k] + chord[k]);
        }
        #[expect(clippy::cast_precision_loss, reason = "a few samples")]
        let count = SAMPLE_COUNT as f64;
        let [a, b] = seam.lengths(pattern);
        let mean = sum.iter().map(|c| c * c).sum::<f64>().sqrt() / count;
        let found = Self {
            rms: (squares / count).sqrt(),
            mean,
            length: a.max(b),
        };
        found.rms.is_finite().then_some(found)
    }

    /// Length of the longer side \[m\].
    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// Returns what the other order leaves of this one's length, in thousandths, if it is far
    /// shorter.
    ///
    /// Panels start apart from one another, and the distance that both orders share tells nothing:
    /// of each is judged what goes beyond the shorter of the two mean chords.
    pub(super) fn remaining_permille(&self, other: &Self) -> Option<u32> {
        let shared = self.mean.min(other.mean);
        let beyond = |chords: &Self| (chords.rms * chords.rms - shared * shared).max(0.0).sqrt();
        let is_far = self.length >= MIN_SIDE_M
            && beyond(self) > CLOSE_SHARE * self.length
            && beyond(other) <= FAR_RATIO * beyond(self);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a share below 1"
        )]
        let left = (1e3 * beyond(other) / beyond(self)).round() as u32;
        is_far.then_some(left)
    }
}
