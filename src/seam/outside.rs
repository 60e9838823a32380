//! The side that is out of parts of which no face is stated: seams tell which faces go together,
//! not which of the two ways round a part is worn.

use super::Face;
use super::chords::Chords;
use super::context::SeamCheckContext;
use super::faces::{self, FaceColoring};
use crate::fault::{SeamCode, Warning};
use crate::pattern::Pattern;
use std::collections::BTreeMap;

/// A part is turned over if this share of its squared chords is left then. Parts that are alike on
/// both sides of the wearer keep all of them; sleeves that would cross to the other side lose most.
const FAR_SHARE: f64 = 0.5;

/// Panels whose faces seams tie to each other, and to no stated one.
struct Part {
    panels: Vec<usize>,
    /// True if a name tells a front, whose face is up.
    has_front: bool,
}

/// What tells that a part is turned over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Evidence {
    /// Its panels start far closer to where they are sewn.
    Starts,
    /// Most of its cloth is drawn as it is seen from outside.
    Cloth,
}

/// A part that is worn the other way round than its front, or else its first panel, is drawn.
#[derive(Clone, Debug)]
pub(super) struct TurnedPart {
    pub(super) panels: Vec<usize>,
    pub(super) evidence: Evidence,
}

/// Returns the parts of a coloring that are to be turned over: those that start far closer to where
/// they are sewn then, and where that tells nothing, and no name tells a front, those most of whose
/// cloth would be drawn from inside.
pub(super) fn turned(
    context: &SeamCheckContext<'_>,
    stated: &[Option<Face>],
    coloring: &FaceColoring,
) -> Vec<TurnedPart> {
    let is_turned = |part: Part| {
        let faces = &coloring.faces;
        let over = turned_over(faces, &part.panels);
        let chords = [faces, &over].map(|faces| squares(context, coloring, &part, faces));
        let is_plain = |a: f64, b: f64| a < FAR_SHARE * b;
        let evidence = match chords {
            [Some(kept), Some(other)] if is_plain(other, kept) => Some(Evidence::Starts),
            [Some(kept), Some(other)] if is_plain(kept, other) => None,
            _ => (!part.has_front && is_mostly_down(context, &part, faces))
                .then_some(Evidence::Cloth),
        };
        evidence.map(|evidence| TurnedPart {
            panels: part.panels,
            evidence,
        })
    };
    let parts = parts(context, stated, coloring).into_iter();
    parts.filter_map(is_turned).collect()
}

/// Returns the same faces with those of these panels the other way round.
pub(super) fn turned_over(faces: &[Face], panels: &[usize]) -> Vec<Face> {
    let mut over = faces.to_vec();
    for &panel in panels {
        over[panel] = over[panel].other();
    }
    over
}

/// Says which panels are turned over, and why.
pub(super) fn warning(pattern: &Pattern, part: &TurnedPart, faces: &[Face]) -> Warning {
    let down = part
        .panels
        .iter()
        .filter(|&&panel| faces[panel] == Face::Down);
    let ids: Vec<_> = down
        .map(|&panel| format!("`{}`", pattern.panels[panel].id))
        .collect();
    let ids = ids.join(", ");
    let why = match part.evidence {
        Evidence::Starts => "its panels start nearer to what they are sewn to so",
        Evidence::Cloth => "most of its cloth is seen from outside as it is drawn so",
    };
    let detail = if ids.is_empty() {
        format!("the drawn side of all its panels is out: {why}")
    } else {
        format!("the drawn side of {ids} is in: {why}")
    };
    Warning::new(
        SeamCode::FaceChosen,
        "/panels",
        format!("{detail}; `panels.<id>.face` chooses"),
    )
}

fn parts(
    context: &SeamCheckContext<'_>,
    stated: &[Option<Face>],
    coloring: &FaceColoring,
) -> Vec<Part> {
    let mut parity = context.parity(stated, coloring, None);
    let (known, _) = parity.find(stated.len());
    let mut parts: BTreeMap<usize, Part> = BTreeMap::new();
    for panel in 0..stated.len() {
        let (head, _) = parity.find(panel);
        let part = parts.entry(head).or_insert(Part {
            panels: vec![],
            has_front: false,
        });
        part.panels.push(panel);
        part.has_front |= faces::is_front(context.pattern, panel);
    }
    parts.remove(&known);
    parts.into_values().collect()
}

/// Returns the sum of the squared chords of the seams of a part, times their lengths \[m3\], on
/// panels with these faces; nothing where a start is not known.
fn squares(
    context: &SeamCheckContext<'_>,
    coloring: &FaceColoring,
    part: &Part,
    faces: &[Face],
) -> Option<f64> {
    let is_of_part = |panel| part.panels.binary_search(&panel).is_ok();
    let seams = context.seams.iter();
    let of_part = seams.filter(|seam| {
        seam.sides
            .iter()
            .flatten()
            .flat_map(|run| &run.stretches)
            .all(|s| is_of_part(s.panel))
    });
    let each = of_part.map(|seam| {
        let seam = coloring.ordered(seam);
        let chords = Chords::of(context.pattern, &seam, faces, context.starts)?;
        Some(chords.rms.powi(2) * chords.length())
    });
    each.sum()
}

/// Returns true if more than half of the cloth of a part has its drawn side in; halves are equal to
/// rounding.
fn is_mostly_down(context: &SeamCheckContext<'_>, part: &Part, faces: &[Face]) -> bool {
    let area = |face| -> f64 {
        let of_face = part.panels.iter().filter(|&&panel| faces[panel] == face);
        of_face
            .map(|&panel| context.pattern.panels[panel].area_m2)
            .sum()
    };
    area(Face::Down) > area(Face::Up) * (1.0 + f64::EPSILON.sqrt())
}
