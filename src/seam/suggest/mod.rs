//! Seams that need not be said: what is known of each class of garment, applied to the panels of a pattern (P13).
//!
//! Every panel is taken for what its name and its look say ([`words`], [`looks`], [`template`]), and its edges get roles:
//! hem, side, armhole. Then each class of garment joins the roles that its tailors join: [`top`], [`sleeve`], [`skirt`],
//! [`trousers`], [`waist`] (dresses too), [`neck`], [`cuff`]. Where corners of both sides meet, a seam is parted there.

mod band;
mod cap;
mod choose;
mod classify;
mod cuff;
mod dart;
mod garment;
mod godet;
mod hood;
mod join;
mod looks;
mod neck;
mod piece;
mod raglan;
mod shape;
mod skirt;
mod sleeve;
mod template;
mod top;
mod trousers;
mod waist;
mod words;

use crate::pattern::{Direction, Match, Pattern, Place, Run, SeamPair, Side};
use garment::{Draft, Garment};
use piece::{Chain, Step};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A seam that the rules propose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SuggestedSeam {
    /// The seam, as a client would state it.
    #[serde(flatten)]
    pub pair: SeamPair,
    /// How sure it is: 0 is a guess, 1 is certain.
    pub confidence: f64,
    /// Why, in words.
    pub because: String,
}

/// What the rules propose for a pattern.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Suggestion {
    /// The seams.
    pub seams: Vec<SuggestedSeam>,
}

/// Proposes seams for `pattern`.
pub fn suggest(pattern: &Pattern) -> Suggestion {
    let mut garment = Garment {
        pieces: classify::pieces(pattern),
        drafts: vec![],
    };
    godet::sew(&mut garment);
    dart::sew(&mut garment, pattern);
    top::sew(&mut garment);
    sleeve::sew(&mut garment);
    raglan::sew(&mut garment);
    skirt::sew(&mut garment);
    trousers::sew(&mut garment);
    waist::sew(&mut garment);
    hood::sew(&mut garment);
    neck::sew(&mut garment);
    cuff::sew(&mut garment);
    let ids = Ids(pattern, &garment);
    Suggestion {
        seams: garment.drafts.iter().map(|draft| ids.seam(draft)).collect(),
    }
}

/// Debug view of what panels were taken for.
pub fn describe(pattern: &Pattern) -> String {
    let pieces = classify::pieces(pattern);
    let mut text = String::new();
    for p in &pieces {
        text += &format!(
            "{} {:?} {:?} {:?} half {} mirrored {} turned {} cost {:.2}",
            pattern.panels[p.panel % pattern.panels.len()].id,
            p.kind,
            p.which,
            p.lateral,
            p.half,
            p.shape.mirrored,
            p.turned,
            p.cost
        );
        for s in &p.segments {
            text += &format!(
                " {:?}{}{:?}",
                s.role,
                if s.hand == piece::Hand::Left {
                    "<"
                } else {
                    ">"
                },
                s.edges
            );
        }
        text += "\n";
    }
    text
}

/// Names panels, mirrored copies among them.
struct Ids<'a>(&'a Pattern, &'a Garment);

impl Ids<'_> {
    fn seam(&self, draft: &Draft) -> SuggestedSeam {
        let [a, b] = draft.sides.each_ref().map(|chain| self.side(chain));
        SuggestedSeam {
            pair: SeamPair {
                id: draft.id.clone(),
                a,
                b,
                matching: Match::AsPicked,
                stage: draft.stage,
                gather: draft.gather,
                layered: false,
                allow_twist: false,
            },
            confidence: (1e3 * draft.confidence).round() / 1e3,
            because: draft.because.clone(),
        }
    }

    fn side(&self, chain: &Chain) -> Side {
        let mut runs: Vec<(Step, Step)> = vec![];
        for step in chain {
            match runs.last_mut() {
                Some((_, last)) if self.goes_on(last, step) => *last = *step,
                _ => runs.push((*step, *step)),
            }
        }
        let mut runs: Vec<Run> = runs
            .iter()
            .map(|(first, last)| self.run(first, last))
            .collect();
        if runs.len() == 1 {
            Side::One(runs.remove(0))
        } else {
            Side::Many(runs)
        }
    }

    fn goes_on(&self, last: &Step, next: &Step) -> bool {
        let count = self.count(last);
        let expected = if last.forward {
            last.edge + 1
        } else {
            last.edge + count - 1
        } % count;
        last.panel == next.panel && last.forward == next.forward && next.edge == expected
    }

    fn count(&self, step: &Step) -> usize {
        self.0.panels[step.panel % self.0.panels.len()]
            .edges
            .len()
            .max(1)
    }

    fn run(&self, first: &Step, last: &Step) -> Run {
        let count = self.count(first);
        let corner = |edge: usize, forward: bool| {
            Place::Corner(if forward { edge } else { (edge + 1) % count })
        };
        Run {
            panel: self.name(first.panel),
            from: corner(first.edge, first.forward),
            to: corner(last.edge, !last.forward),
            direction: Some(if first.forward {
                Direction::Cw
            } else {
                Direction::Ccw
            }),
        }
    }

    /// Panels beyond the pattern's own are mirrored copies, in the same order.
    fn name(&self, panel: usize) -> String {
        let count = self.0.panels.len();
        match self.0.panels.get(panel) {
            Some(panel) => panel.id.clone(),
            None => format!("{}~mirror", self.0.panels[panel - count].id),
        }
    }
}
