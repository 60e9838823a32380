//! Seams whose order the faces cannot tell: the only bridge between two parts, or the side of an internal line.
//! Where panels start in space tells it.

use super::chords::Chords;
use super::correct::{Request, reversed};
use super::faces::{self, Colouring, Saying};
use super::parity::Parity;
use super::{Face, Routed, SeamFinding};
use crate::fault::Warning;
use crate::pattern::{Match, SeamPair};
use std::collections::BTreeSet;

/// Judges seams by where their panels start.
pub(super) struct Judge<'a> {
    pub request: &'a Request<'a>,
    pub stated: &'a [Option<Face>],
}

/// A seam that is far shorter in the other order: chords as sewn and in the other one.
struct Verdict {
    seam: usize,
    as_sewn: Chords,
    other: Chords,
}

impl Judge<'_> {
    /// The `auto` seams that are to be sewn in the other order than `colouring` has them in.
    pub(super) fn auto_to_turn(&self, colouring: &Colouring) -> BTreeSet<usize> {
        let verdicts = self.verdicts(colouring, Match::Auto);
        verdicts.map(|verdict| verdict.seam).collect()
    }

    /// Warns of the seams as picked that are likely reversed; gives them as they would be in the other order.
    pub(super) fn tell(
        &self,
        colouring: &Colouring,
        findings: &mut [SeamFinding],
    ) -> Vec<SeamPair> {
        let mut corrected = vec![];
        for verdict in self.verdicts(colouring, Match::AsPicked) {
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

    fn verdicts<'a>(
        &'a self,
        colouring: &'a Colouring,
        matching: Match,
    ) -> impl Iterator<Item = Verdict> + 'a {
        let sayings = self
            .request
            .sayings
            .iter()
            .filter(move |saying| saying.pair.matching == matching && !saying.pair.allow_twist);
        sayings.filter_map(|saying| self.verdict(saying, colouring))
    }

    /// What chords say of a seam of which parity says nothing.
    fn verdict(&self, saying: &Saying<'_>, colouring: &Colouring) -> Option<Verdict> {
        let mut others = self.others(saying, colouring);
        if !others.fits(&saying.picked) || !others.fits(&saying.reversed) {
            return None;
        }
        let seam = self.routed(saying)?;
        let is_turned = colouring.reversed.contains_key(&saying.seam);
        let (as_sewn, other, links) = if is_turned {
            (&seam.reversed(), seam, &saying.picked)
        } else {
            (seam, &seam.reversed(), &saying.reversed)
        };
        others.join_all(links);
        let other_faces = faces::coloured(self.request.pattern, others);
        let chords = |seam, faces: &[Face]| {
            Chords::of(self.request.pattern, seam, faces, self.request.starts)
        };
        let verdict = Verdict {
            seam: saying.seam,
            as_sewn: chords(as_sewn, &colouring.faces)?,
            other: chords(other, &other_faces)?,
        };
        verdict
            .as_sewn
            .far_longer_than(&verdict.other)
            .then_some(verdict)
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

    fn routed(&self, saying: &Saying<'_>) -> Option<&Routed> {
        let mut seams = self.request.seams.iter();
        seams.find(|seam| seam.index == saying.seam)
    }
}

/// Whether a seam is far shorter in the other order on panels with these faces.
pub(super) fn is_far_apart(
    request: &Request<'_>,
    saying: &Saying<'_>,
    colouring: &Colouring,
) -> bool {
    let mut seams = request.seams.iter();
    let Some(seam) = seams.find(|seam| seam.index == saying.seam) else {
        return false;
    };
    let seam = colouring.ordered(seam);
    let chords = |seam| Chords::of(request.pattern, seam, &colouring.faces, request.starts);
    let (as_sewn, other) = (chords(&seam), chords(&seam.reversed()));
    as_sewn.is_some_and(|chords| other.is_some_and(|other| chords.far_longer_than(&other)))
}
