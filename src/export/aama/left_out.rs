//! Sentences on all that a pattern holds and its DXF cannot say.

use super::super::counted::counted;
use super::drawn_piece::DrawnPiece;
use super::piece::{MOST_CURVE_POINTS, MOST_CUT};
use crate::config::Limits;
use crate::pattern::{NotchKind, Panel, Pattern};

/// Turn points up to which the file is surely read again: each is an entity, of 300 000 in all.
const MOST_TURNS: usize = 200_000;

/// Returns a sentence on everything that the DXF of a pattern leaves out. `panels` are drawn as
/// `pieces`.
pub(super) fn sentences(
    pattern: &Pattern,
    panels: &[&Panel],
    pieces: &[DrawnPiece],
) -> Vec<String> {
    let all = [
        other_sizes(pattern),
        counted(
            pattern.seams.len(),
            "seam: DXF has no place for it",
            "seams: DXF has no place for them",
        ),
        counted(
            pattern.placements.len(),
            "placement of a panel: DXF has no place for it",
            "placements of panels: DXF has no place for them",
        ),
        counted(
            labels(panels),
            "label or face of a panel or an edge: DXF has no place for it",
            "labels and faces of panels and edges: DXF has no place for them",
        ),
        counted(
            slits(panels),
            "notch is a slit; it is on layer 4, as a V notch",
            "notches are slits; they are on layer 4, as V notches",
        ),
        counted(
            panels
                .iter()
                .zip(pieces)
                .filter(|(panel, piece)| panel.unfolded && piece.fold.is_none())
                .count(),
            "panel on the fold is not its own mirror image with all that is on it; it is drawn whole",
            "panels on the fold are not their own mirror images with all that is on them; they are drawn whole",
        ),
        counted(
            pieces.iter().filter(|piece| piece.is_cut_beside).count(),
            "cut line does not go round its outline; it is a line on the cloth",
            "cut lines do not go round their outline; they are lines on the cloth",
        ),
        counted(
            panels.iter().filter(|panel| is_many(panel)).count(),
            &format!("panel is cut more than {MOST_CUT} times; {MOST_CUT} is written"),
            &format!("panels are cut more than {MOST_CUT} times; {MOST_CUT} is written"),
        ),
        without_curve_points(pieces),
        too_many_turns(pieces),
    ];
    all.into_iter().flatten().collect()
}

fn other_sizes(pattern: &Pattern) -> Option<String> {
    let chosen = pattern.source.sample_size.as_deref();
    let others = pattern.source.sizes.iter().map(String::as_str);
    let others: Vec<&str> = others.filter(|size| Some(*size) != chosen).collect();
    let chosen = chosen.unwrap_or("without a name");
    (!others.is_empty()).then(|| {
        format!(
            "the sizes {}; the pattern was imported in size {chosen}",
            others.join(", ")
        )
    })
}

fn labels(panels: &[&Panel]) -> usize {
    let of_panel = |panel: &&&Panel| panel.label.is_some() || panel.face.is_some();
    let edges = panels.iter().flat_map(|panel| &panel.edges);
    panels.iter().filter(of_panel).count() + edges.filter(|edge| edge.label.is_some()).count()
}

fn slits(panels: &[&Panel]) -> usize {
    let notches = panels.iter().flat_map(|panel| &panel.notches);
    notches
        .filter(|notch| notch.kind == NotchKind::Slit)
        .count()
}

fn is_many(panel: &Panel) -> bool {
    panel
        .quantity
        .is_some_and(|cut| cut.left.max(cut.right) > MOST_CUT)
}

fn too_many_turns(pieces: &[DrawnPiece]) -> Option<String> {
    let count: usize = pieces.iter().map(|piece| piece.turns.len()).sum();
    (count > MOST_TURNS).then(|| {
        format!("a size that this service is sure to read again: it has {count} turn points")
    })
}

/// Returns a sentence on a file that is larger than what this service reads.
pub(super) fn too_large(bytes: usize) -> Option<String> {
    let most = Limits::default().dxf_bytes;
    (bytes > most).then(|| {
        format!(
            "a size that this service reads again: it has more than {} MiB",
            most >> 20
        )
    })
}

fn without_curve_points(pieces: &[DrawnPiece]) -> Option<String> {
    let count: usize = pieces.iter().map(DrawnPiece::point_count).sum();
    (count > MOST_CURVE_POINTS)
        .then(|| format!("curve points (layer 3): {count} points are too many"))
}
