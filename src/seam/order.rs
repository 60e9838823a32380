//! Seams whose order the faces cannot tell: the only bridge between two parts, or the side of an internal line.
//! Where panels start in space tells it.

use super::chords::Chords;
use super::colour::{Order, Told};
use super::correct::{Request, reversed};
use super::faces::{self, Colouring, Saying};
use super::parity::Parity;
use super::{Face, Routed, SeamFinding, Starts};
use crate::fault::Warning;
use crate::pattern::{Match, Pattern, SeamPair};

/// Judges seams as picked by where their panels start.
pub(super) struct Judge<'a> {
    pub request: &'a Request<'a>,
    pub stated: &'a [Option<Face>],
    pub fronts_first: &'a [usize],
}

/// A seam that is far shorter in the other order: chords as sewn and in the other one.
struct Verdict {
    seam: usize,
    as_sewn: Chords,
    other: Chords,
}

impl Judge<'_> {
    /// Warns of the seams as picked that are likely reversed; gives them as they would be in the other order.
    pub(super) fn tell(
        &self,
        colouring: &Colouring,
        findings: &mut [SeamFinding],
    ) -> Vec<SeamPair> {
        let mut corrected = vec![];
        let sayings = self.request.sayings.iter();
        let as_picked = sayings
            .filter(|saying| saying.pair.matching == Match::AsPicked && !saying.pair.allow_twist);
        for verdict in as_picked.filter_map(|saying| self.verdict(saying, colouring)) {
            let pair = &self.request.pairs[verdict.seam];
            let told = format!(
                "seam `{}` is likely reversed: as picked its two sides start {:.0} mm apart, with side b in the other order {:.0} mm (root of the mean square); pick the corners of side b in the other order, or set `match` to `auto`",
                pair.id,
                verdict.as_sewn.rms * 1e3,
                verdict.other.rms * 1e3
            );
            findings[verdict.seam].warnings.push(Warning::new(
                "seam/likely_reversed",
                format!("/seams/{}/b", verdict.seam),
                told,
            ));
            corrected.push(SeamPair {
                b: reversed(&pair.b),
                ..pair.clone()
            });
        }
        corrected
    }

    /// What chords say of a seam as picked of which parity says nothing.
    fn verdict(&self, saying: &Saying<'_>, colouring: &Colouring) -> Option<Verdict> {
        let seam = routed(self.request, saying)?;
        let chords = |seam, faces: &[Face]| {
            Chords::of(self.request.pattern, seam, faces, self.request.starts)
        };
        // Where panels start nowhere there is nothing to look further for.
        let as_sewn = chords(seam, &colouring.faces)?;
        let mut others = self.others(saying, colouring);
        if !others.fits(&saying.picked) || !others.fits(&saying.reversed) {
            return None;
        }
        others.join_all(&saying.reversed);
        let other_faces = faces::coloured(self.fronts_first, others);
        let other = chords(&seam.reversed(), &other_faces)?;
        as_sewn.left_by(&other).map(|_| Verdict {
            seam: saying.seam,
            as_sewn,
            other,
        })
    }

    /// What stated faces and all other seams say.
    fn others(&self, of: &Saying<'_>, colouring: &Colouring) -> Parity {
        let mut parity = Parity::new(self.stated.len() + 1);
        for link in faces::stated_links(self.stated) {
            parity.join(link);
        }
        for saying in self.request.sayings.iter().filter(|s| s.seam != of.seam) {
            parity.join_all(saying.links(colouring));
        }
        parity
    }
}

/// What places tell of a seam; see [`super::colour::Shorter`].
pub(super) fn shorter(
    pattern: &Pattern,
    seam: &Routed,
    faces: &[Vec<Face>; 2],
    starts: Starts<'_>,
) -> Option<Told> {
    let picked = Chords::of(pattern, seam, &faces[0], starts)?;
    let reversed = Chords::of(pattern, &seam.reversed(), &faces[1], starts)?;
    if let Some(left) = picked.left_by(&reversed) {
        let order = Order::Reversed;
        return Some(Told { order, left });
    }
    let left = reversed.left_by(&picked)?;
    let order = Order::AsPicked;
    Some(Told { order, left })
}

/// Whether a seam is far shorter in the other order on panels with these faces.
pub(super) fn is_far_apart(
    request: &Request<'_>,
    saying: &Saying<'_>,
    colouring: &Colouring,
) -> bool {
    let Some(seam) = routed(request, saying) else {
        return false;
    };
    let seam = colouring.ordered(seam);
    let faces = [0, 1].map(|_| colouring.faces.clone());
    let told = shorter(request.pattern, &seam, &faces, request.starts);
    told.is_some_and(|told| told.order == Order::Reversed)
}

fn routed<'a>(request: &Request<'a>, saying: &Saying<'_>) -> Option<&'a Routed> {
    let mut seams = request.seams.iter();
    seams.find(|seam| seam.index == saying.seam)
}
