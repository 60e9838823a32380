//! Seams as stitches: pairs of edges, of which the start of the one meets the end of the other as
//! drawn, or its start where the stitch is `right_wrong`.

use super::panel::DrawnPanel;
use crate::pattern::{Direction, Match, OutlineRun, Pattern, Place, SeamPair, Side};
use serde_json::{Value, json};

/// The panels as drawn, with their names.
type NamedPanels<'a> = (&'a [DrawnPanel], &'a [String]);

/// One side of a stitch.
struct StitchSide<'a> {
    panel: &'a str,
    edge: usize,
    /// True if the side of the seam runs along the edge as drawn.
    is_along: bool,
}

/// Returns a seam as a stitch; `None` where it is not one of two edges from corner to corner.
pub(super) fn written(
    seam: &SeamPair,
    pattern: &Pattern,
    panels: NamedPanels<'_>,
) -> Option<Value> {
    if seam.matching != Match::AsPicked {
        return None;
    }
    let a = side(&seam.a, pattern, panels)?;
    let b = side(&seam.b, pattern, panels)?;
    let edge = |side: &StitchSide<'_>| json!({"panel": side.panel, "edge": side.edge});
    let mut stitch = vec![edge(&a), edge(&b)];
    if a.is_along == b.is_along {
        stitch.push(json!("right_wrong"));
    }
    Some(Value::Array(stitch))
}

/// Returns the edge that a side runs along.
fn side<'a>(
    side: &Side,
    pattern: &Pattern,
    (drawn, names): NamedPanels<'a>,
) -> Option<StitchSide<'a>> {
    let [run] = side.runs() else {
        return None;
    };
    let panel = pattern.panel_index(&run.panel)?;
    let (stored, direction) = stored_edge(run, pattern.panels[panel].edges.len())?;
    let is_cw = direction == Direction::Cw;
    Some(StitchSide {
        panel: names.get(panel)?,
        edge: drawn.get(panel)?.index_of(stored)?,
        is_along: is_cw != drawn[panel].reversed,
    })
}

/// Returns the stored edge of a run from corner to corner, and the direction along it.
pub(super) fn stored_edge(run: &OutlineRun, count: usize) -> Option<(usize, Direction)> {
    let (Place::Corner(from), Place::Corner(to)) = (run.from, run.to) else {
        return None;
    };
    if from >= count || to >= count {
        return None;
    }
    let is_forth = (from + 1) % count == to && run.direction != Some(Direction::Ccw);
    let is_back = (to + 1) % count == from && run.direction != Some(Direction::Cw);
    match (is_forth, is_back) {
        (true, false) => Some((from, Direction::Cw)),
        (false, true) => Some((to, Direction::Ccw)),
        _ => None,
    }
}
