//! From proposed seams to seam pairs as a client would state them.

use super::edge_chain::{EdgeChain, EdgeStep};
use super::garment_model::ProposedSeam;
use super::suggestion::SuggestedSeam;
use crate::pattern::{Direction, Match, OutlineRun, Pattern, Place, SeamPair, Side};

/// Writes proposed seams as seam pairs; names panels, mirrored copies among them.
pub(super) struct SeamPairWriter<'a>(pub(super) &'a Pattern);

impl SeamPairWriter<'_> {
    pub(super) fn seam(&self, proposed: &ProposedSeam) -> SuggestedSeam {
        let [a, b] = proposed.sides.each_ref().map(|chain| self.side(chain));
        SuggestedSeam {
            pair: SeamPair {
                id: proposed.id.clone(),
                a,
                b,
                matching: Match::AsPicked,
                stage: 0,
                gather: proposed.gather,
                layered: false,
                allow_twist: false,
                confidence: None,
                because: None,
            },
            confidence: (1e3 * proposed.confidence).round() / 1e3,
            because: proposed.because.clone(),
        }
    }

    fn side(&self, chain: &EdgeChain) -> Side {
        let mut runs: Vec<(EdgeStep, EdgeStep)> = vec![];
        for step in chain {
            match runs.last_mut() {
                Some((_, last)) if self.continues(last, step) => *last = *step,
                _ => runs.push((*step, *step)),
            }
        }
        let mut runs: Vec<OutlineRun> = runs
            .iter()
            .map(|(first, last)| self.run(first, last))
            .collect();
        if runs.len() == 1 {
            Side::One(runs.remove(0))
        } else {
            Side::Many(runs)
        }
    }

    fn continues(&self, last: &EdgeStep, next: &EdgeStep) -> bool {
        let count = self.edge_count(last);
        let expected = if last.forward {
            last.edge + 1
        } else {
            last.edge + count - 1
        } % count;
        let whole_between = share(last, false) == 1.0 && share(next, true) == 0.0;
        last.panel == next.panel
            && last.hole == next.hole
            && last.forward == next.forward
            && next.edge == expected
            && whole_between
    }

    fn edge_count(&self, step: &EdgeStep) -> usize {
        let panel = &self.0.panels[step.panel % self.0.panels.len()];
        let edges = step
            .hole
            .map_or(&panel.edges, |hole| &panel.holes[hole].edges);
        edges.len().max(1)
    }

    fn run(&self, first: &EdgeStep, last: &EdgeStep) -> OutlineRun {
        let count = self.edge_count(first);
        let place = |step: &EdgeStep, begins: bool| {
            let gone = share(step, begins);
            let at = if step.forward { gone } else { 1.0 - gone };
            let edge = step.edge;
            let corner = (edge + usize::from(at > 0.5)) % count;
            match (gone > 0.0 && gone < 1.0, step.hole) {
                (true, None) => Place::OnEdge { edge, at },
                (true, Some(hole)) => Place::OnHoleEdge { hole, edge, at },
                (false, None) => Place::Corner(corner),
                (false, Some(hole)) => Place::HoleCorner { hole, corner },
            }
        };
        OutlineRun {
            panel: self.panel_id(first.panel),
            from: place(first, true),
            to: place(last, false),
            direction: Some(if first.forward {
                Direction::Cw
            } else {
                Direction::Ccw
            }),
        }
    }

    /// Panels beyond the pattern's own are mirrored copies, in the same order.
    pub(super) fn panel_id(&self, panel: usize) -> String {
        let count = self.0.panels.len();
        match self.0.panels.get(panel) {
            Some(panel) => panel.id.clone(),
            None => format!("{}~mirror", self.0.panels[panel - count].id),
        }
    }
}

/// Returns where a step begins or ends as a share of its edge, counted the way it is gone.
fn share(step: &EdgeStep, begins: bool) -> f64 {
    let [from, to] = step.span;
    match (step.forward, begins) {
        (true, true) => from,
        (true, false) => to,
        (false, true) => 1.0 - to,
        (false, false) => 1.0 - from,
    }
}
