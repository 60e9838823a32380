//! Seams whose order the faces cannot tell: the only bridge between two parts, or the side of an
//! internal line. The start positions of panels tell it.

use super::chords::Chords;
use super::coloring::{SeamOrder, ShorterOrder};
use super::context::SeamCheckContext;
use super::correction::reversed_side;
use super::faces::{self, FaceColoring, SeamRelations};
use super::{Face, RoutedSeam, SeamFinding, StartPositions};
use crate::fault::{SeamCode, Warning};
use crate::pattern::{Match, Pattern, SeamPair};

/// Finds likely reversed seams by the start positions of their panels.
pub(super) struct ReversalDetector<'a> {
    pub context: &'a SeamCheckContext<'a>,
    pub stated: &'a [Option<Face>],
    /// Panels whose faces lead those of their parts, in this order.
    pub leads: &'a [(usize, Face)],
}

/// A seam that is far shorter in the other order: chords as sewn and in the other one.
struct LikelyReversal {
    seam: usize,
    as_sewn: Chords,
    other: Chords,
}

impl ReversalDetector<'_> {
    /// Warns of the seams as picked that are likely reversed; gives them as they would be in the
    /// other order.
    pub(super) fn warn(
        &self,
        coloring: &FaceColoring,
        findings: &mut [SeamFinding],
    ) -> Vec<SeamPair> {
        let mut corrected = vec![];
        let relations = self.context.relations.iter();
        let as_picked = relations.filter(|implied| {
            let is_judged = !implied.pair.allow_twist && !implied.folds[0];
            implied.pair.matching == Match::AsPicked && is_judged
        });
        for reversal in as_picked.filter_map(|implied| self.likely_reversal(implied, coloring)) {
            let pair = &self.context.pairs[reversal.seam];
            let detail = format!(
                "seam `{}` is likely reversed: as picked its two sides start {:.0} mm apart, with side b in the other order {:.0} mm (root of the mean square); pick the corners of side b in the other order, or set `match` to `auto`",
                pair.id,
                reversal.as_sewn.rms * 1e3,
                reversal.other.rms * 1e3
            );
            findings[reversal.seam].warnings.push(Warning::new(
                SeamCode::LikelyReversed,
                format!("/seams/{}/b", reversal.seam),
                detail,
            ));
            corrected.push(SeamPair {
                b: reversed_side(&pair.b),
                ..pair.clone()
            });
        }
        corrected
    }

    /// Returns the likely reversal of a seam as picked whose order parity leaves open.
    fn likely_reversal(
        &self,
        implied: &SeamRelations<'_>,
        coloring: &FaceColoring,
    ) -> Option<LikelyReversal> {
        let seam = find_routed(self.context, implied)?;
        let chords = |seam, faces: &[Face]| {
            Chords::of(self.context.pattern, seam, faces, self.context.starts)
        };
        // Where panels start nowhere there is nothing to look further for.
        let as_sewn = chords(seam, &coloring.faces)?;
        let mut others = self
            .context
            .parity(self.stated, coloring, Some(implied.seam));
        if !others.fits(&implied.picked) || !others.fits(&implied.reversed) {
            return None;
        }
        others.join_all(&implied.reversed);
        let other_faces = faces::color_faces(self.leads, others);
        let other = chords(&seam.reversed(), &other_faces)?;
        as_sewn.remaining_permille(&other).map(|_| LikelyReversal {
            seam: implied.seam,
            as_sewn,
            other,
        })
    }
}

/// Returns the far shorter order of a seam; see [`super::coloring::ShorterOrderFn`].
pub(super) fn shorter_order(
    pattern: &Pattern,
    seam: &RoutedSeam,
    faces: &[Vec<Face>; 2],
    starts: StartPositions<'_>,
) -> Option<ShorterOrder> {
    let picked = Chords::of(pattern, seam, &faces[0], starts)?;
    let reversed = Chords::of(pattern, &seam.reversed(), &faces[1], starts)?;
    if let Some(remaining_permille) = picked.remaining_permille(&reversed) {
        let order = SeamOrder::Reversed;
        return Some(ShorterOrder {
            order,
            remaining_permille,
        });
    }
    let remaining_permille = reversed.remaining_permille(&picked)?;
    let order = SeamOrder::AsPicked;
    Some(ShorterOrder {
        order,
        remaining_permille,
    })
}

/// Returns true if a seam is far shorter in the other order on panels with these faces.
pub(super) fn is_shorter_reversed(
    context: &SeamCheckContext<'_>,
    implied: &SeamRelations<'_>,
    coloring: &FaceColoring,
) -> bool {
    let Some(seam) = find_routed(context, implied) else {
        return false;
    };
    let seam = coloring.ordered(seam);
    let faces = [0, 1].map(|_| coloring.faces.clone());
    let shorter = shorter_order(context.pattern, &seam, &faces, context.starts);
    shorter.is_some_and(|shorter| shorter.order == SeamOrder::Reversed)
}

fn find_routed<'a>(
    context: &SeamCheckContext<'a>,
    implied: &SeamRelations<'_>,
) -> Option<&'a RoutedSeam> {
    let mut seams = context.seams.iter();
    seams.find(|seam| seam.index == implied.seam)
}
