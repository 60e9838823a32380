//! Ring panels: those that go round the body by a hole, as circle skirts, ponchos, round yokes and
//! flounces do.

use super::edge_chain::{EdgeChain, EdgeStep, WHOLE, length};
use super::hole_dart;
use super::labeled_panel::{LabeledPanel, RoleSegment};
use super::labels::{DrawnSide, EdgeRole, PanelKind};
use super::names::NameHints;
use super::outline_features::OutlineFeatures;
use crate::pattern::{Edge, Hole, Panel, Pattern};
use std::f64::consts::TAU;
use std::rc::Rc;

/// A hole that goes round a part of the body is at least this long \[m\]: more than the openings of
/// pockets and buttonholes, less than the hem of a sleeve.
const MIN_OPENING_M: f64 = 0.25;
/// A hole of this length is an opening whatever its shape \[m\]: the head passes it.
const HEAD_M: f64 = 0.45;
/// Share of the area of a circle of the same length that a shorter opening has at least; that of a
/// square is 0.79.
const MIN_ROUNDNESS: f64 = 0.4;
/// Least length over width of a strip.
const MIN_STRIP_ASPECT: f64 = 4.0;
/// Difference in length to a hole, as a share, up to which a strip that no name tells of is taken
/// for its band.
const STRIP_EASE: f64 = 0.02;
/// Length from which an opening that no name tells of goes round a waist, not a neck \[m\].
const MIN_WAIST_M: f64 = 0.62;

/// Place of a ring on the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RingPlace {
    /// Round the neck, on the shoulders.
    Neck,
    /// So far below the waist \[m\].
    Waist(f64),
    /// At the hem of the bodice.
    BodiceHem,
}

/// A panel that goes round the body by its largest hole.
#[derive(Clone, Debug)]
pub(super) struct RingPanel {
    /// Its index in the pattern.
    pub(super) panel: usize,
    /// Its kind by its name.
    pub(super) kind: Option<PanelKind>,
    pub(super) area: f64,
    pub(super) hole: EdgeChain,
    pub(super) outer: EdgeChain,
    pub(super) place: RingPlace,
}

impl RingPanel {
    fn of(index: usize, panel: &Panel, hints: &NameHints) -> Option<Self> {
        let is_ring_kind = matches!(
            hints.kind,
            None | Some(
                PanelKind::Skirt
                    | PanelKind::Bodice
                    | PanelKind::Yoke
                    | PanelKind::Collar
                    | PanelKind::NeckBand
            )
        );
        let is_placed = hints.front_back.is_some() || hints.laterality.is_some();
        if !is_ring_kind || is_placed || panel.copy_of.is_some() {
            return None;
        }
        let openings = panel.holes.iter().enumerate();
        let is_only = panel.holes.len() == 1;
        let openings = openings.filter(|(_, hole)| is_opening(hole, is_only));
        let (hole, opening) = openings.max_by(|a, b| around(a.1).total_cmp(&around(b.1)))?;
        let place = if hints.kind == Some(PanelKind::Skirt) {
            RingPlace::Waist(0.0)
        } else {
            RingPlace::Neck
        };
        Some(Self {
            panel: index,
            kind: hints.kind,
            area: panel.area_m2.abs(),
            hole: chain(index, Some(hole), &opening.edges),
            outer: chain(index, None, &panel.edges),
            place,
        })
    }

    /// Returns the kind of a band that no name tells of and that is as long as the hole.
    fn band_kind(&self) -> PanelKind {
        let is_waist = match self.kind {
            Some(PanelKind::Skirt) => true,
            None => length(&self.hole) >= MIN_WAIST_M,
            Some(_) => false,
        };
        if is_waist {
            PanelKind::Waistband
        } else {
            PanelKind::NeckBand
        }
    }
}

/// Returns the ring panels of a pattern.
pub(super) fn ring_panels(pattern: &Pattern, hints: &[NameHints]) -> Vec<RingPanel> {
    let panels = pattern.panels.iter().zip(hints).enumerate();
    panels
        .filter_map(|(index, (panel, hints))| RingPanel::of(index, panel, hints))
        .collect()
}

/// Labels strips that no name tells of as bands of the rings whose holes they are as long as.
pub(super) fn label_strips(
    pattern: &Pattern,
    hints: &[NameHints],
    rings: &[RingPanel],
    parts: &mut Vec<LabeledPanel>,
) {
    for (index, panel) in pattern.panels.iter().enumerate() {
        // A code of a letter may say front or back.
        if hints[index].kind.is_some()
            || panel.copy_of.is_some()
            || rings.iter().any(|ring| ring.panel == index)
        {
            continue;
        }
        let Some((strip, long)) = strip(index, panel) else {
            continue;
        };
        let fits = |ring: &&RingPanel| (long / length(&ring.hole)).ln().abs() <= STRIP_EASE;
        let Some(ring) = rings.iter().find(fits) else {
            continue;
        };
        parts.retain(|part| part.panel != index);
        parts.push(LabeledPanel {
            kind: ring.band_kind(),
            ..strip
        });
    }
}

/// Returns a long rectangle as a band, and the length of its long edges \[m\].
fn strip(index: usize, panel: &Panel) -> Option<(LabeledPanel, f64)> {
    let features = OutlineFeatures::of(panel, false, false);
    let [a, b, _, _] = features.ring[..] else {
        return None;
    };
    let lengths = [a, b].map(|edge| features.edges[edge].length);
    let long = usize::from(lengths[1] > lengths[0]);
    let role = |k: usize| {
        if k % 2 == long {
            EdgeRole::Long
        } else {
            EdgeRole::End
        }
    };
    let segments = features
        .ring
        .iter()
        .enumerate()
        .map(|(k, edge)| RoleSegment {
            role: role(k),
            drawn_side: if k < 2 {
                DrawnSide::Left
            } else {
                DrawnSide::Right
            },
            edges: vec![*edge],
            before: role(k + 1),
        });
    let part = LabeledPanel {
        panel: index,
        kind: PanelKind::Waistband,
        of: vec![],
        number: 0,
        front_back: None,
        laterality: None,
        laterality_named: false,
        half: false,
        drawn_from_inside: false,
        beside: None,
        segments: segments.collect(),
        features: Rc::new(features),
        cost: 0.0,
        named: false,
        kind_named: false,
    };
    let is_strip = lengths[long] >= MIN_STRIP_ASPECT * lengths[1 - long];
    (is_strip && super::bands::is_rectangle(&part)).then_some((part, lengths[long]))
}

fn chain(panel: usize, hole: Option<usize>, edges: &[Edge]) -> EdgeChain {
    let step = |edge: &Edge| EdgeStep {
        panel,
        hole,
        edge: edge.index,
        forward: true,
        length: edge.length_m,
        span: WHOLE,
    };
    edges.iter().map(step).collect()
}

fn around(hole: &Hole) -> f64 {
    hole.edges.iter().map(|edge| edge.length_m).sum()
}

/// Returns true for a hole that a part of the body passes through. A narrow one is a dart, unless
/// it is the only one and the head passes it.
fn is_opening(hole: &Hole, is_only: bool) -> bool {
    let around = around(hole);
    let points = hole.edges.iter().flat_map(|edge| edge.points.windows(2));
    let twice: f64 = points
        .map(|pair| pair[0][0] * pair[1][1] - pair[1][0] * pair[0][1])
        .sum();
    let roundness = TAU * twice.abs() / (around * around).max(f64::MIN_POSITIVE);
    if hole_dart::is_dart(hole) {
        return is_only && around >= HEAD_M;
    }
    around >= HEAD_M || around >= MIN_OPENING_M && roundness >= MIN_ROUNDNESS
}
