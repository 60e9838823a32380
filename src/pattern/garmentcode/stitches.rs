//! Stitches of a specification as seams. A stitch names two edges: the start of the one meets the
//! end of the other as drawn, or its start where the stitch is `right_wrong` (the right side of one
//! is sewn to the wrong side of the other).

use super::findings::SpecFindings;
use super::node::JsonNode;
use super::panel::DrawnPanel;
use crate::config::Limits;
use crate::fault::PatternCode;
use crate::pattern::{Match, OutlineRun, Place, SeamPair, Side};
use std::collections::BTreeMap;

/// Ease above which a stitch is one that is gathered: its file states which edges are sewn,
/// whatever their lengths.
const GATHERED: f64 = 0.15;

/// Returns true if a stitch of edges this long \[m\] is taken to be gathered.
pub(crate) fn is_gathered(a: f64, b: f64) -> bool {
    a.max(b) > (1.0 + GATHERED) * a.min(b)
}

/// Returns the id of the seam that is this stitch of a file.
pub(crate) fn seam_id(stitch: usize) -> String {
    format!("stitch-{stitch}")
}

/// The panels by name; `None` for one that could not be read.
pub(super) type DrawnPanels<'a> = BTreeMap<&'a str, Option<DrawnPanel>>;

/// Reads all stitches.
pub(super) fn read(
    node: &JsonNode<'_>,
    panels: &DrawnPanels<'_>,
    limits: &Limits,
    findings: &mut SpecFindings,
) -> Vec<SeamPair> {
    let items = node.items(limits.seams, findings).unwrap_or_default();
    let stitches = items.iter().enumerate();
    stitches
        .filter_map(|(i, item)| read_stitch(i, item, panels, findings))
        .collect()
}

/// Reads a stitch.
fn read_stitch(
    index: usize,
    node: &JsonNode<'_>,
    panels: &DrawnPanels<'_>,
    findings: &mut SpecFindings,
) -> Option<SeamPair> {
    let items = node.items(3, findings)?;
    let [a, b, rest @ ..] = items.as_slice() else {
        let detail = "a stitch has two sides";
        findings.fault(node.fault(PatternCode::Stitch, detail, "give two edges"));
        return None;
    };
    let word = rest.first().map(|word| read_right_wrong(word, findings));
    let [a, b] = [a, b].map(|side| read_side(side, panels, findings));
    let (a, b) = (a?, b?);
    let right_wrong = word.unwrap_or(Some(false))? || a.right_wrong || b.right_wrong;
    let gather = is_gathered(a.length, b.length);
    let b = if right_wrong { b.run } else { reversed(b.run) };
    Some(SeamPair {
        id: seam_id(index),
        a: Side::One(a.run),
        b: Side::One(b),
        matching: Match::AsPicked,
        stage: 0,
        gather,
        layered: false,
        allow_twist: false,
        confidence: None,
        because: None,
    })
}

/// Reads the third entry of a stitch: the word, or an object with the word as a key.
fn read_right_wrong(node: &JsonNode<'_>, findings: &mut SpecFindings) -> Option<bool> {
    if node.value.is_object() {
        node.fields(&["right_wrong"], findings)?;
        return node.require("right_wrong", findings)?.flag(findings);
    }
    if node.value == "right_wrong" {
        return Some(true);
    }
    let detail = "the third entry of a stitch is \"right_wrong\"";
    findings.fault(node.fault(PatternCode::Stitch, detail, "leave it out or correct it"));
    None
}

/// One side of a stitch, from the start to the end of its edge as drawn.
struct StitchSide {
    run: OutlineRun,
    right_wrong: bool,
    length: f64,
}

/// Reads one side of a stitch.
fn read_side(
    node: &JsonNode<'_>,
    panels: &DrawnPanels<'_>,
    findings: &mut SpecFindings,
) -> Option<StitchSide> {
    node.fields(&["panel", "edge", "right_wrong"], findings)?;
    let name = node.require("panel", findings);
    let edge = node.require("edge", findings);
    let right_wrong = node.get("right_wrong").map(|flag| flag.flag(findings));
    let (name, edge) = (name?, edge?);
    let (panel, index) = (name.text(findings), edge.index(findings));
    let (panel, index) = (panel?, index?);
    let Some(found) = panels.get(panel) else {
        let fix = "name a panel of the specification";
        let detail = format!("there is no panel {panel:?}");
        findings.fault(name.fault(PatternCode::UnknownPanel, detail, fix));
        return None;
    };
    // The faults of a panel that could not be read are noted already.
    let drawn = found.as_ref()?;
    let Some((from, to, direction)) = drawn.corners_of(index) else {
        let fix = format!("its edges are 0 to {}", drawn.panel.edges.len() - 1);
        let detail = format!("panel {panel:?} has no edge {index}");
        findings.fault(edge.fault(PatternCode::Edge, detail, &fix));
        return None;
    };
    Some(StitchSide {
        run: OutlineRun {
            panel: drawn.panel.id.clone(),
            from: Place::Corner(from),
            to: Place::Corner(to),
            direction: Some(direction),
        },
        right_wrong: right_wrong.unwrap_or(Some(false))?,
        length: drawn.length(index),
    })
}

/// Returns a run from its end to its beginning.
fn reversed(run: OutlineRun) -> OutlineRun {
    use crate::pattern::Direction::{Ccw, Cw};
    let turn = |way| if way == Cw { Ccw } else { Cw };
    OutlineRun {
        panel: run.panel,
        from: run.to,
        to: run.from,
        direction: run.direction.map(turn),
    }
}
