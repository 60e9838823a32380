//! The side that is out of parts of which no face is stated: seams tell which faces go together,
//! not which of the two ways round a part is worn.

use super::Face;
use super::chords::Chords;
use super::context::SeamCheckContext;
use super::faces::{self, FaceColoring};
use super::parity::ParityUnionFind;
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

/// Returns the faces of a coloring, with those parts turned over that start far closer to where
/// they are sewn then. Where that tells nothing, and no name tells a front, most of the cloth is
/// drawn as it is seen from outside.
pub(super) fn faces(
    context: &SeamCheckContext<'_>,
    stated: &[Option<Face>],
    coloring: &FaceColoring,
) -> Vec<Face> {
    let mut found = coloring.faces.clone();
    for part in parts(context, stated, coloring) {
        let mut turned = found.clone();
        for &panel in &part.panels {
            turned[panel] = turned[panel].other();
        }
        let chords = [&found, &turned].map(|faces| squares(context, coloring, &part, faces));
        let is_plain = |a: f64, b: f64| a < FAR_SHARE * b;
        let is_turned = match chords {
            [Some(kept), Some(other)] if is_plain(other, kept) => true,
            [Some(kept), Some(other)] if is_plain(kept, other) => false,
            _ => !part.has_front && is_mostly_down(context, &part, &found),
        };
        if is_turned {
            found = turned;
        }
    }
    found
}

fn parts(
    context: &SeamCheckContext<'_>,
    stated: &[Option<Face>],
    coloring: &FaceColoring,
) -> Vec<Part> {
    let mut parity = ParityUnionFind::new(stated.len() + 1);
    faces::stated_relations(stated).for_each(|relation| {
        parity.join(relation);
    });
    for implied in context.relations {
        parity.join_all(implied.relations(coloring));
    }
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

/// Returns true if more than half of the cloth of a part has its drawn side in.
fn is_mostly_down(context: &SeamCheckContext<'_>, part: &Part, faces: &[Face]) -> bool {
    let area = |face| -> f64 {
        let of_face = part.panels.iter().filter(|&&panel| faces[panel] == face);
        of_face
            .map(|&panel| context.pattern.panels[panel].area_m2)
            .sum()
    };
    area(Face::Down) > area(Face::Up) * (1.0 + f64::EPSILON.sqrt())
}
