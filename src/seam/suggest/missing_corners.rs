//! Corners that a file may lack, where a pattern is not read as a whole: at notches, and where the
//! other part of a sleeve tells how far the seam of this one goes.

use super::cut_edges::Cut;
use super::evidence;
use super::labels::PanelKind;
use super::names::NameHints;
use crate::pattern::Pattern;
use std::collections::BTreeSet;

/// Shares of an edge at which a cut is worth a look: neither a corner nor a rounding.
const SHARES: std::ops::Range<f64> = 0.15..0.9;
/// Edges agree that fit each other as well as this, 1 being the same length.
const SAME: f64 = 0.5;
/// A sleeve of fewer edges has two of its roles in one edge.
const SLEEVE_ROLES: usize = 4;
/// Most ways that are tried: each reads the pattern anew.
const MAX_WAYS: usize = 12;

/// Returns sets of cuts to read the pattern with; `open` are the panels that are not sewn as a
/// whole without.
pub(super) fn ways(
    pattern: &Pattern,
    hints: &[NameHints],
    open: &BTreeSet<usize>,
) -> Vec<Vec<Cut>> {
    let mut ways = vec![];
    let at_notches = at_notches(pattern, open);
    if !at_notches.is_empty() {
        ways.push(at_notches);
    }
    ways.extend(of_sleeves(pattern, hints));
    ways.truncate(MAX_WAYS);
    ways
}

/// Returns the notches of panels: where a part ends that has no corner, it is marked.
fn at_notches(pattern: &Pattern, open: &BTreeSet<usize>) -> Vec<Cut> {
    let of = |panel: usize| {
        let notches = pattern.panels[panel].notches.iter();
        notches.map(move |notch| Cut {
            panel,
            edge: notch.edge,
            at: notch.at,
        })
    };
    open.iter().flat_map(|panel| of(*panel)).collect()
}

/// Returns the cuts of parts of sleeves of two parts that have too few edges: each edge may go on
/// beyond an edge of the other part, from either of its ends.
fn of_sleeves(pattern: &Pattern, hints: &[NameHints]) -> Vec<Vec<Cut>> {
    let is = |i: &usize, kind| hints[*i].kind == Some(kind);
    let of = |kind| (0..hints.len()).filter(move |i| is(i, kind));
    let (uppers, unders): (Vec<usize>, Vec<usize>) = (
        of(PanelKind::Sleeve).collect(),
        of(PanelKind::UnderSleeve).collect(),
    );
    let (Some(upper), Some(under)) = (uppers.first(), unders.first()) else {
        return vec![];
    };
    let mut ways = vec![];
    for ((own, all), other) in [((upper, &uppers), under), ((under, &unders), upper)] {
        for cut in cuts_after(pattern, *own, *other) {
            // The part of the other arm has its edges in the same order or mirrored.
            let alike = all.iter().flat_map(|panel| same_edge(pattern, cut, *panel));
            ways.push(alike.collect());
        }
    }
    ways
}

/// Returns the cuts of a panel after which its edges have the length of an edge of another one.
fn cuts_after(pattern: &Pattern, panel: usize, other: usize) -> Vec<Cut> {
    let lengths = |panel: usize| -> Vec<f64> {
        let edges = &pattern.panels[panel].edges;
        edges.iter().map(|edge| edge.length_m).collect()
    };
    let (own, wanted) = (lengths(panel), lengths(other));
    if own.len() >= SLEEVE_ROLES {
        return vec![];
    }
    let has_partner = |long: f64| own.iter().any(|x| evidence::fit(*x, long) > SAME);
    let mut cuts: Vec<Cut> = vec![];
    for long in wanted.into_iter().filter(|long| !has_partner(*long)) {
        for (edge, whole) in own.iter().enumerate() {
            for at in [long / whole, 1.0 - long / whole] {
                if SHARES.contains(&at) {
                    cuts.push(Cut { panel, edge, at });
                }
            }
        }
    }
    cuts
}

/// Returns the same cut of a panel that is a copy of another one: as drawn, or mirrored.
fn same_edge(pattern: &Pattern, cut: Cut, panel: usize) -> Option<Cut> {
    if panel == cut.panel {
        return Some(cut);
    }
    let whole = pattern.panels[cut.panel].edges[cut.edge].length_m;
    let edges = &pattern.panels[panel].edges;
    let same = |length: f64| evidence::fit(length, whole) > SAME;
    let edge = edges.iter().position(|edge| same(edge.length_m))?;
    let before = |panel: usize, edge: usize| {
        let edges = &pattern.panels[panel].edges;
        edges[(edge + edges.len() - 1) % edges.len()].length_m
    };
    let as_drawn = evidence::fit(before(panel, edge), before(cut.panel, cut.edge)) > SAME;
    let at = if as_drawn { cut.at } else { 1.0 - cut.at };
    Some(Cut { panel, edge, at })
}
