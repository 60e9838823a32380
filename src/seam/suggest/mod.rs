//! Seams that need not be said: what is known of each class of garment, applied to the panels of a pattern (P13).
//!
//! Every panel is taken for what its name and its look say (`words`, `looks`, `template`), and its edges get roles:
//! hem, side, armhole. Then each class of garment joins the roles that its tailors join: `top`, `sleeve`, `skirt`,
//! `raglan`, `trousers`, `waist` (dresses too), `neck`, `hood`, `cuff`, `godet`, `dart`. Where corners of both sides meet, a seam is parted there.

mod band;
mod cap;
mod choose;
mod classify;
mod cuff;
mod dart;
mod doubts;
mod garment;
mod godet;
mod hood;
mod join;
mod looks;
mod neck;
mod piece;
mod raglan;
mod settle;
mod shape;
mod sides;
mod skirt;
mod sleeve;
mod stand;
mod template;
mod top;
mod trousers;
mod waist;
mod words;

use crate::config::Limits;
use crate::fault::Warning;
use crate::pattern::{Direction, Match, Pattern, Place, Placement, Run, SeamPair, Side};
use garment::{Draft, Garment};
use piece::{Chain, Step};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
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
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Suggestion {
    /// Seams that can be sewn together. They may name mirrored copies (`sleeve~mirror`) of panels that are drawn once.
    pub seams: Vec<SuggestedSeam>,
    /// Where panels start, by id, as a garment states it.
    pub panels: BTreeMap<String, SuggestedPanel>,
    /// What a user should know, panels that were not recognised among it.
    pub warnings: Vec<Warning>,
}

/// What the rules propose for a panel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SuggestedPanel {
    /// Where it starts.
    pub placement: Placement,
}

/// Proposes seams and placements for `pattern` from the names, outlines and notches of its panels.
///
/// What the pattern itself states (`seams`, `placements`) is not used. Seams are by corner numbers, one for each stretch
/// between corners that meet. Every seam passes [`check`](crate::seam::check) together with all others.
///
/// # Assumptions
/// Panels are those of one garment; of parts that are drawn in several styles (short and long sleeve) the first is
/// taken. Lengths are those of the sew line. Sleeves, cuffs and bindings that are drawn once are worn on both sides.
pub fn suggest(pattern: &Pattern, limits: &Limits) -> Suggestion {
    if pattern.panels.len() > limits.suggested_panels {
        return too_many(pattern.panels.len(), limits.suggested_panels);
    }
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
    let ids = Ids(pattern);
    let seams = garment.drafts.iter().map(|draft| ids.seam(draft)).collect();
    let seams = settle::together(pattern, seams, limits);
    let sewn: BTreeSet<&str> = seams
        .iter()
        .flat_map(|s| s.pair.a.runs().iter().chain(s.pair.b.runs()))
        .map(|run| run.panel.as_str())
        .collect();
    let stands = stand::placements(&garment)
        .into_iter()
        .map(|(panel, placement)| (ids.name(panel), SuggestedPanel { placement }));
    let panels = stands
        .filter(|(id, _)| sewn.contains(id.as_str()))
        .collect();
    let loose = pattern
        .panels
        .iter()
        .filter(|panel| !sewn.contains(panel.id.as_str()));
    let warnings = loose
        .map(|panel| {
            let told = format!("no seam is suggested for panel `{}`: what it is was not recognised, or it is not needed", panel.id);
            Warning::new("seam/not_suggested", "/seams", told)
        })
        .collect();
    Suggestion {
        seams,
        panels,
        warnings,
    }
}

fn too_many(count: usize, most: usize) -> Suggestion {
    let told = format!(
        "the pattern has {count} panels; seams are suggested for one garment of at most {most}"
    );
    Suggestion {
        warnings: vec![Warning::new("seam/not_suggested", "/seams", told)],
        ..Suggestion::default()
    }
}

/// Names panels, mirrored copies among them.
struct Ids<'a>(&'a Pattern);

impl Ids<'_> {
    fn seam(&self, draft: &Draft) -> SuggestedSeam {
        let [a, b] = draft.sides.each_ref().map(|chain| self.side(chain));
        SuggestedSeam {
            pair: SeamPair {
                id: draft.id.clone(),
                a,
                b,
                matching: Match::AsPicked,
                stage: 0,
                gather: draft.gather,
                layered: false,
                allow_twist: false,
                confidence: None,
                because: None,
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
