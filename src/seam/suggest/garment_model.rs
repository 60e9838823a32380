//! The labeled panels of a garment round the body, and the seams proposed so far.

use super::cut_twice;
use super::edge_chain::{EdgeChain, EdgeStep, length, reversed};
use super::join;
use super::labeled_panel::{LabeledPanel, RoleSegment};
use super::labels::{EdgeRole, FrontBack, Laterality, PanelKind};
use super::orientation::OtherForm;
use super::ring_panel::RingPanel;
use std::collections::BTreeSet;

/// Ease above which two edges are no seam, unless one of them may be gathered; and then.
const MAX_EASE: f64 = 0.30;
const MAX_GATHERED_EASE: f64 = 3.0;
/// Ease at which trust in a seam has fallen to 60 %.
const USUAL_EASE: f64 = 0.05;
/// The same for two panels that no name tells of: nothing but their lengths speaks for the seam.
/// As a share, or \[m\]: shoulders are eased by some millimeters.
const UNNAMED_EASE: f64 = 0.012;
const UNNAMED_EASE_M: f64 = 0.006;
/// Ease up to which that is trusted that is usual in bands, and in what is set in, where no name
/// tells of a panel.
const GATHERED_UNNAMED_EASE: f64 = 0.85;
const EASED_UNNAMED_EASE: f64 = 0.13;
/// Trust that ease leaves at least, where much of it is usual.
const GATHERED_TRUST: f64 = 0.7;

/// Confidence of a seam that may as well stay open, at most.
const OFFERED: f64 = 0.45;
/// The same of one of two ways that are as good as each other.
const GUESSED: f64 = 0.5;
/// Most that a seam has otherwise.
const MOST_CONFIDENCE: f64 = 0.99;

/// A seam that a rule proposes.
#[derive(Clone, Debug)]
pub(super) struct ProposedSeam {
    pub(super) id: String,
    pub(super) sides: [EdgeChain; 2],
    pub(super) gather: bool,
    pub(super) confidence: f64,
    pub(super) because: String,
}

/// Name and reason that a rule gives a seam.
#[derive(Clone, Copy, Debug)]
pub(super) struct SeamRationale<'a> {
    /// Its name, to which numbers are added where it has several parts.
    pub(super) id: &'a str,
    /// Reason why these edges belong together.
    pub(super) because: &'a str,
    /// True where much ease is usual.
    pub(super) gather: bool,
    /// Ease up to which that is trusted where no names tell.
    pub(super) unnamed_ease: f64,
    /// Confidence that it has at most.
    pub(super) most: f64,
}

impl<'a> SeamRationale<'a> {
    /// Returns the rationale of a seam of edges of one length.
    pub(super) fn new(id: &'a str, because: &'a str) -> Self {
        Self {
            id,
            because,
            gather: false,
            unnamed_ease: GATHERED_UNNAMED_EASE,
            most: MOST_CONFIDENCE,
        }
    }

    /// Returns the rationale of a seam where much ease is usual.
    pub(super) fn gathered(self) -> Self {
        Self {
            gather: true,
            ..self
        }
    }

    /// Returns the rationale of a seam that may as well stay open.
    pub(super) fn offered(self) -> Self {
        Self {
            most: OFFERED,
            ..self
        }
    }

    /// Returns the rationale of a seam of which nothing tells between two ways.
    pub(super) fn guessed(self, is_guess: bool) -> Self {
        Self {
            most: if is_guess {
                GUESSED.min(self.most)
            } else {
                self.most
            },
            ..self
        }
    }

    /// Returns the rationale of a seam that is eased in, seldom gathered.
    pub(super) fn eased(self) -> Self {
        Self {
            unnamed_ease: EASED_UNNAMED_EASE,
            ..self.gathered()
        }
    }
}

/// Labeled panels of a garment round the body, with the seams proposed for them.
#[derive(Clone, Debug)]
pub(super) struct GarmentModel {
    pub(super) parts: Vec<LabeledPanel>,
    /// Spare panels that are other forms of these.
    pub(super) forms: Vec<OtherForm>,
    /// Panels that go round the body by a hole; they are no parts.
    pub(super) rings: Vec<RingPanel>,
    pub(super) proposed: Vec<ProposedSeam>,
}

impl GarmentModel {
    /// Returns the panels of a kind.
    pub(super) fn parts_of(&self, kind: PanelKind) -> impl Iterator<Item = &LabeledPanel> {
        self.parts.iter().filter(move |part| part.kind == kind)
    }

    pub(super) fn has(&self, kind: PanelKind) -> bool {
        self.parts_of(kind).next().is_some()
    }

    /// Returns the panel of a kind in front of or behind one side of the wearer.
    pub(super) fn part(
        &self,
        kind: PanelKind,
        front_back: FrontBack,
        laterality: Laterality,
    ) -> Option<&LabeledPanel> {
        let covers = |part: &&LabeledPanel| {
            part.front_back == Some(front_back)
                && (!part.half || part.laterality == Some(laterality))
        };
        self.parts_of(kind)
            .filter(covers)
            .min_by_key(|part| part.number)
    }

    /// Returns true if an edge of an outline is part of a seam already.
    pub(super) fn is_sewn(&self, panel: usize, edge: usize) -> bool {
        self.has_seam_at((panel, None, edge))
    }

    /// Returns true if the edge of a step, of an outline or a hole, is part of a seam already.
    pub(super) fn is_step_sewn(&self, step: &EdgeStep) -> bool {
        self.has_seam_at((step.panel, step.hole, step.edge))
    }

    fn has_seam_at(&self, edge: (usize, Option<usize>, usize)) -> bool {
        let mut steps = self.proposed.iter().flat_map(|d| d.sides.iter().flatten());
        steps.any(|step| (step.panel, step.hole, step.edge) == edge)
    }

    /// Returns the segment of a role on one side of the wearer.
    pub(super) fn segment(
        &self,
        kind: PanelKind,
        front_back: FrontBack,
        place: (EdgeRole, Laterality),
    ) -> Option<(&LabeledPanel, &RoleSegment)> {
        let (role, laterality) = place;
        let part = self.part(kind, front_back, laterality)?;
        if !part.half && part.segments_of(role).count() < 2 {
            return None; // It lies on both sides.
        }
        let drawn_side = if part.half {
            None
        } else {
            Some(part.drawn_side_of(laterality))
        };
        Some((part, part.segment(role, drawn_side)?))
    }

    /// Returns a segment of a role on one side of the wearer as a chain from where it meets `from`.
    pub(super) fn chain(
        &self,
        kind: PanelKind,
        front_back: FrontBack,
        place: (EdgeRole, Laterality),
        from: EdgeRole,
    ) -> Option<EdgeChain> {
        let (part, segment) = self.segment(kind, front_back, place)?;
        Some(part.chain_from(segment, from))
    }

    /// Returns an upper or lower edge of a panel, from the wearer's side `from` to the other; of
    /// half a panel, what it has of that.
    pub(super) fn across(
        &self,
        part: &LabeledPanel,
        segment: &RoleSegment,
        from: Laterality,
    ) -> EdgeChain {
        let chain = part.chain(segment);
        if part.half {
            let outer = |role| {
                matches!(
                    role,
                    EdgeRole::Side | EdgeRole::Shoulder | EdgeRole::Underarm | EdgeRole::Armhole
                )
            };
            let begins_outside = outer(segment.before);
            let outside_first = part.laterality == Some(from);
            return if begins_outside == outside_first {
                chain
            } else {
                reversed(&chain)
            };
        }
        let top = segment.role != EdgeRole::Hem;
        let first = part.first_drawn_side();
        let begins = if top { first } else { first.other() };
        if part.laterality_of(begins) == from {
            chain
        } else {
            reversed(&chain)
        }
    }

    /// Returns the edges of a role in front of the body from the wearer's left, or behind it from
    /// the right.
    pub(super) fn half_ring(
        &self,
        kind: PanelKind,
        role: EdgeRole,
        front_back: FrontBack,
    ) -> Option<EdgeChain> {
        let from = match front_back {
            FrontBack::Front => Laterality::Left,
            FrontBack::Back => Laterality::Right,
        };
        let first = self.part(kind, front_back, from)?;
        let mut chain = self.across(first, first.segment(role, None)?, from);
        if first.half {
            let second = self.part(kind, front_back, from.other())?;
            chain.extend(self.across(second, second.segment(role, None)?, from));
        }
        Some(chain)
    }

    /// Proposes that two chains that begin and end together are sewn.
    pub(super) fn sew(
        &mut self,
        rationale: SeamRationale<'_>,
        a: Option<EdgeChain>,
        b: Option<EdgeChain>,
    ) -> bool {
        let (Some(a), Some(b)) = (a, b) else {
            return false;
        };
        self.propose(rationale, [&a, &b], join::split_at_corners(&a, &b))
    }

    /// Proposes that two closed chains are sewn that may be turned against each other in any way.
    pub(super) fn sew_free_ring(
        &mut self,
        rationale: SeamRationale<'_>,
        a: &EdgeChain,
        b: &EdgeChain,
    ) -> bool {
        self.propose(rationale, [a, b], join::split_free_ring(a, b))
    }

    /// Proposes that two closed chains are sewn.
    pub(super) fn sew_ring(
        &mut self,
        rationale: SeamRationale<'_>,
        a: Option<EdgeChain>,
        b: Option<EdgeChain>,
    ) -> bool {
        let (Some(a), Some(b)) = (a, b) else {
            return false;
        };
        self.propose(rationale, [&a, &b], join::split_ring(&a, &b))
    }

    fn propose(
        &mut self,
        rationale: SeamRationale<'_>,
        whole: [&EdgeChain; 2],
        parts: Vec<join::JoinedParts>,
    ) -> bool {
        let ease = ease(whole[0], whole[1]);
        let most = if rationale.gather {
            MAX_GATHERED_EASE
        } else {
            MAX_EASE
        };
        if ease.is_nan() || ease > most {
            return false;
        }
        let fit = self.recognition_confidence(whole);
        let judged = self.judged_by_shape(whole);
        let count = parts.len();
        for (i, sides) in parts.into_iter().enumerate() {
            let ease = join_ease(&sides);
            let usual = self.ease_trust(rationale, &sides);
            let id = if count == 1 {
                rationale.id.to_owned()
            } else {
                format!("{}-{}", rationale.id, i + 1)
            };
            self.proposed.push(ProposedSeam {
                id,
                sides,
                gather: ease > MAX_EASE,
                confidence: (fit * (0.4 + 0.6 * usual)).clamp(0.01, rationale.most),
                because: format!(
                    "{}; the lengths agree to {:.1} %{judged}",
                    rationale.because,
                    100.0 * ease
                ),
            });
        }
        true
    }

    /// Returns how sure the ease of a seam leaves it, from 0 to 1.
    fn ease_trust(&self, rationale: SeamRationale<'_>, sides: &join::JoinedParts) -> f64 {
        let part = |step: &EdgeStep| self.parts.iter().find(|p| p.panel == step.panel);
        let parts: Vec<&LabeledPanel> = sides.iter().flatten().filter_map(part).collect();
        let several = parts.windows(2).any(|pair| pair[0].panel != pair[1].panel);
        let unnamed = several && parts.iter().any(|p| !p.named);
        let ease = join_ease(sides);
        let most = if unnamed {
            rationale.unnamed_ease
        } else {
            f64::INFINITY
        };
        let least = if rationale.gather && ease <= most {
            GATHERED_TRUST
        } else {
            0.0
        };
        let shorter = length(&sides[0]).min(length(&sides[1])).max(1e-9);
        let usual = if unnamed {
            UNNAMED_EASE.max(UNNAMED_EASE_M / shorter).min(USUAL_EASE)
        } else {
            USUAL_EASE
        };
        (-0.5 * (ease / usual).powi(2)).exp().max(least)
    }

    /// Returns the end of a reason, where shape or quantity alone tell what panels of a seam are.
    fn judged_by_shape(&self, sides: [&EdgeChain; 2]) -> String {
        let part = |step: &EdgeStep| self.parts.iter().find(|p| p.panel == step.panel);
        let parts: Vec<&LabeledPanel> = sides.into_iter().flatten().filter_map(part).collect();
        let unnamed = parts.iter().filter(|p| !p.named);
        let kinds: BTreeSet<&str> = unnamed.map(|p| p.kind.noun()).collect();
        let mut told = String::new();
        if !kinds.is_empty() {
            let kinds: Vec<&str> = kinds.into_iter().collect();
            told = format!("; no name says so: {} by shape alone", kinds.join(" and "));
        }
        if cut_twice::are_front_and_back(&parts) {
            told.push_str("; one panel that is cut twice is taken for the front and the back");
        }
        told
    }

    /// Returns how sure it is that the panels of a seam are what they are taken for, from 0 to 1.
    fn recognition_confidence(&self, sides: [&EdgeChain; 2]) -> f64 {
        let part = |step: &EdgeStep| self.parts.iter().find(|p| p.panel == step.panel);
        let trust = |p: &LabeledPanel| {
            let look = (-p.cost / 6.0).exp();
            if p.named {
                0.7 + 0.3 * look
            } else {
                0.2 + 0.8 * look
            }
        };
        let all = sides.into_iter().flatten();
        all.filter_map(part).map(trust).fold(1.0, f64::min)
    }
}

fn join_ease(sides: &join::JoinedParts) -> f64 {
    ease(&sides[0], &sides[1])
}

/// Returns longer over shorter, less 1.
pub(super) fn ease(a: &[EdgeStep], b: &[EdgeStep]) -> f64 {
    let (a, b) = (length(a), length(b));
    a.max(b) / a.min(b).max(1e-9) - 1.0
}
