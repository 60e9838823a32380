//! Assignment of one labeling to each panel: that with which its neighbors agree best.
//!
//! A labeling of a front is good if its side is as long as that of the back, and if it mirrors the
//! other half. Starting from the likeliest labelings, each panel in turn takes the one that fits
//! the others best, until none changes.

use super::evidence::evidence;
use super::labeled_panel::LabeledPanel;
use super::labels::{EdgeRole, PanelKind};
use serde::Deserialize;

/// Rounds at most: each lowers the misfit, so that few are needed.
const MAX_ROUNDS: usize = 8;
/// The edges of a band that may be sewn.
const BAND_EDGES: [EdgeRole; 3] = [EdgeRole::Long, EdgeRole::Hem, EdgeRole::Waist];
/// Weights of how little two panels fit each other. Spreads are logarithms of ratios of lengths.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AssignmentWeights {
    /// Of edges that are sewn together.
    sewn_spread: f64,
    /// Of the same edges of front and back, and how much these count.
    alike_spread: f64,
    alike_weight: f64,
    /// Of edges that mirror each other.
    mirrored_spread: f64,
    /// Of an edge and the opening that it goes round, where the longer one is usually gathered
    /// and where it is not.
    gathered_spread: f64,
    joined_spread: f64,
    /// Of a waistband and its opening, likewise.
    gathered_waist_spread: f64,
    eased_waist_spread: f64,
    /// Most that an opening may cost.
    max_opening_cost: f64,
    /// Cost of a front that is half and its back whole.
    half_to_whole: f64,
    /// Most that disagreement of two panels may cost.
    max_pair_cost: f64,
    /// Weight of edges that are as long as each other, where no names tell.
    exact_weight: f64,
}

/// Returns one labeling for each panel that has any.
pub(super) fn assign(
    candidates: Vec<Vec<LabeledPanel>>,
    weights: &AssignmentWeights,
) -> Vec<LabeledPanel> {
    let candidates: Vec<Vec<LabeledPanel>> =
        candidates.into_iter().filter(|c| !c.is_empty()).collect();
    let table = CostTable::new(&candidates, weights);
    let mut chosen = vec![0; candidates.len()];
    for _ in 0..MAX_ROUNDS {
        let before = chosen.clone();
        for i in 0..candidates.len() {
            table.improve_one(&mut chosen, i);
        }
        for pair in &table.pairs {
            table.improve_pair(&mut chosen, pair);
        }
        if chosen == before {
            break;
        }
    }
    candidates
        .into_iter()
        .zip(chosen)
        .map(|(mut c, k)| c.swap_remove(k))
        .collect()
}

/// Cost of every labeling alone and with every other.
struct CostTable {
    unary: Vec<Vec<f64>>,
    pairs: Vec<PairCosts>,
    /// For each panel, the pairs it is in.
    of: Vec<Vec<usize>>,
}

/// Two panels whose labelings are not indifferent to each other.
struct PairCosts {
    ends: [usize; 2],
    /// By the labeling of the first, then of the second.
    cost: Vec<Vec<f64>>,
}

impl CostTable {
    fn new(candidates: &[Vec<LabeledPanel>], weights: &AssignmentWeights) -> Self {
        let unary = candidates
            .iter()
            .map(|c| c.iter().map(|p| p.cost).collect())
            .collect();
        let mut pairs: Vec<PairCosts> = vec![];
        let mut of = vec![vec![]; candidates.len()];
        for i in 0..candidates.len() {
            for j in i + 1..candidates.len() {
                // Copies of each other have edges of one length whatever they are.
                let twins = candidates[i][0]
                    .features
                    .is_twin(&candidates[j][0].features);
                let exact_weight = if twins { 0.0 } else { weights.exact_weight };
                let row = |a: &LabeledPanel| {
                    candidates[j]
                        .iter()
                        .map(|b| weights.pair_cost(a, b) - exact_weight * evidence(a, b))
                        .collect()
                };
                let cost: Vec<Vec<f64>> = candidates[i].iter().map(row).collect();
                if cost.iter().flatten().any(|c| *c != 0.0) {
                    of[i].push(pairs.len());
                    of[j].push(pairs.len());
                    pairs.push(PairCosts { ends: [i, j], cost });
                }
            }
        }
        Self { unary, pairs, of }
    }

    /// Returns the cost of panel `i` with labeling `k`, without the pair with panel `but`.
    fn cost(&self, chosen: &[usize], (i, k): (usize, usize), but: Option<usize>) -> f64 {
        let with = |pair: &PairCosts| {
            let [a, b] = pair.ends;
            let other = if a == i { b } else { a };
            match (Some(other) == but, a == i) {
                (true, _) => 0.0,
                (false, true) => pair.cost[k][chosen[b]],
                (false, false) => pair.cost[chosen[a]][k],
            }
        };
        self.unary[i][k]
            + self.of[i]
                .iter()
                .map(|p| with(&self.pairs[*p]))
                .sum::<f64>()
    }

    /// Takes the labeling of one panel that fits the others best.
    fn improve_one(&self, chosen: &mut [usize], i: usize) {
        let cost = |k: &usize| self.cost(chosen, (i, *k), None);
        let best = (0..self.unary[i].len()).min_by(|a, b| cost(a).total_cmp(&cost(b)));
        chosen[i] = best.unwrap_or_default();
    }

    /// Takes the labelings of two panels that fit each other and the others best: two halves may be
    /// wrong together.
    fn improve_pair(&self, chosen: &mut [usize], pair: &PairCosts) {
        let [i, j] = pair.ends;
        let of = |i: usize, but: usize| -> Vec<f64> {
            (0..self.unary[i].len())
                .map(|k| self.cost(chosen, (i, k), Some(but)))
                .collect()
        };
        let (first, second) = (of(i, j), of(j, i));
        let mut best = (
            first[chosen[i]] + second[chosen[j]] + pair.cost[chosen[i]][chosen[j]] - 1e-9,
            chosen[i],
            chosen[j],
        );
        for (a, x) in first.iter().enumerate() {
            for (b, y) in second.iter().enumerate() {
                let cost = x + y + pair.cost[a][b];
                if cost < best.0 {
                    best = (cost, a, b);
                }
            }
        }
        (chosen[i], chosen[j]) = (best.1, best.2);
    }
}

impl AssignmentWeights {
    /// Returns how little two panels fit each other.
    fn pair_cost(&self, a: &LabeledPanel, b: &LabeledPanel) -> f64 {
        if a.kind != b.kind {
            let mixed = !a.kind_named && !b.kind_named && a.named && b.named;
            let misfits = f64::from(u8::from(is_misfit(a, b)) + u8::from(mixed));
            return self.opening_cost(a, b)
                + self.opening_cost(b, a)
                + self.princess_cost(a, b)
                + self.princess_cost(b, a)
                + misfits * self.max_pair_cost;
        }
        if a.number != b.number {
            return 0.0;
        }
        let same_side = a.laterality == b.laterality;
        match (a.front_back, b.front_back) {
            (Some(x), Some(y)) if x != y && same_side => self.sewn_edges_cost(a, b),
            (x, y) if x == y && !same_side => self.mirror_cost(a, b),
            _ => 0.0,
        }
    }

    /// Returns how little an edge of `a` fits the opening of `b` that it goes round: 0 where the
    /// two are not sewn together.
    fn opening_cost(&self, a: &LabeledPanel, b: &LabeledPanel) -> f64 {
        let same = a.front_back == b.front_back
            && a.front_back.is_some()
            && (a.laterality == b.laterality
                || a.kind == PanelKind::Waistband
                || b.kind == PanelKind::Waistband);
        let (edges, opening): (&[EdgeRole], EdgeRole) = match (a.kind, b.kind) {
            (PanelKind::Sleeve, PanelKind::Bodice) => (&[EdgeRole::Cap], EdgeRole::Armhole),
            (PanelKind::Cuff, PanelKind::Sleeve) if !a.of.contains(&PanelKind::Trouser) => {
                (&BAND_EDGES, EdgeRole::Hem)
            }
            (PanelKind::Cuff, PanelKind::Trouser) if a.of.contains(&PanelKind::Trouser) => {
                (&BAND_EDGES, EdgeRole::Hem)
            }
            (PanelKind::Waistband, PanelKind::Skirt | PanelKind::Trouser) => {
                (&BAND_EDGES, EdgeRole::Waist)
            }
            (PanelKind::Waistband, PanelKind::Bodice) => (&BAND_EDGES, EdgeRole::Hem),
            _ => return 0.0,
        };
        let (Some(opening), true) = (opening_length(b, opening), same) else {
            return 0.0;
        };
        let fits = edges
            .iter()
            .filter_map(|role| a.segment(*role, None))
            .map(|s| {
                let longer = (a.features.length(&s.edges) / opening).ln();
                // Sleeves are gathered into armholes, skirts into waistbands and sleeves into
                // cuffs: not the other way round.
                let gathered = if a.kind == PanelKind::Sleeve {
                    longer > 0.0
                } else {
                    longer < 0.0
                };
                let spread = match (gathered, a.kind) {
                    (true, PanelKind::Waistband) => self.gathered_waist_spread,
                    (true, _) => self.gathered_spread,
                    (false, PanelKind::Waistband) => self.eased_waist_spread,
                    (false, _) => self.joined_spread,
                };
                (0.5 * (longer / spread).powi(2)).min(self.max_opening_cost)
            });
        fits.fold(self.max_opening_cost, f64::min)
    }

    /// Returns how little the side of a front or back `b` fits either long edge of a side panel
    /// `a`: 0 where the two are not sewn together.
    fn princess_cost(&self, a: &LabeledPanel, b: &LabeledPanel) -> f64 {
        let apart = a.front_back.is_some() && a.front_back != b.front_back;
        if a.kind != PanelKind::Side || b.kind != PanelKind::Bodice || apart {
            return 0.0;
        }
        let side = b.one_side_length(EdgeRole::Side);
        let edges = [EdgeRole::Side, EdgeRole::Center].map(|role| a.role_length(role));
        let off = edges.map(|edge| {
            (0.5 * ((edge / side.max(1e-6)).ln() / self.sewn_spread).powi(2))
                .min(self.max_pair_cost)
        });
        off[0].min(off[1])
    }

    /// Returns how little the edges of a front and a back agree that are sewn together.
    fn sewn_edges_cost(&self, a: &LabeledPanel, b: &LabeledPanel) -> f64 {
        if a.half != b.half && a.kind == PanelKind::Sleeve {
            return self.max_pair_cost;
        }
        let mixed = if a.half == b.half {
            0.0
        } else {
            self.half_to_whole
        };
        let roles: &[EdgeRole] = match a.kind {
            PanelKind::Bodice => &[EdgeRole::Side, EdgeRole::Shoulder],
            PanelKind::Skirt => &[EdgeRole::Side],
            PanelKind::Trouser => &[EdgeRole::Side, EdgeRole::Inseam],
            PanelKind::Sleeve => &[EdgeRole::Top, EdgeRole::Underarm],
            _ => &[],
        };
        let alike: &[EdgeRole] = match a.kind {
            PanelKind::Skirt => &[EdgeRole::Waist, EdgeRole::Hem],
            PanelKind::Bodice => &[EdgeRole::Hem],
            _ => &[],
        };
        mixed
            + self.length_cost(a, b, roles, self.sewn_spread)
            + self.alike_weight * self.length_cost(a, b, alike, self.alike_spread)
    }

    /// Returns how little two halves mirror each other.
    fn mirror_cost(&self, a: &LabeledPanel, b: &LabeledPanel) -> f64 {
        if a.half != b.half {
            return self.max_pair_cost;
        }
        let roles: Vec<EdgeRole> = a.segments.iter().map(|s| s.role).collect();
        self.length_cost(a, b, &roles, self.mirrored_spread)
    }

    /// Returns the mean difference in length of the segments of some roles, of one side of the
    /// wearer: a whole panel has those of two halves.
    fn length_cost(
        &self,
        a: &LabeledPanel,
        b: &LabeledPanel,
        roles: &[EdgeRole],
        spread: f64,
    ) -> f64 {
        if roles.is_empty() {
            return 0.0;
        }
        let length = |p: &LabeledPanel, role| -> Option<f64> {
            let all: Vec<f64> = p
                .segments_of(role)
                .map(|s| p.features.length(&s.edges))
                .collect();
            (!all.is_empty()).then(|| all.iter().sum::<f64>() / p.sides())
        };
        let of = |role: &EdgeRole| match (length(a, *role), length(b, *role)) {
            (Some(x), Some(y)) => {
                Some((0.5 * ((x / y).ln() / spread).powi(2)).min(self.max_pair_cost))
            }
            (None, None) => None,
            _ => Some(self.max_pair_cost),
        };
        let all: Vec<f64> = roles.iter().filter_map(of).collect();
        #[expect(clippy::cast_precision_loss, reason = "a handful of roles")]
        let count = all.len().max(1) as f64;
        all.iter().sum::<f64>() / count
    }
}

/// Returns true for a sleeve and a bodice that do not go together: a sleeve needs an armhole; one
/// that runs up to the neck a bodice without shoulders, any other one with.
fn is_misfit(a: &LabeledPanel, b: &LabeledPanel) -> bool {
    let (sleeve, bodice) = match (a.kind, b.kind) {
        (PanelKind::Sleeve, PanelKind::Bodice) => (a, b),
        (PanelKind::Bodice, PanelKind::Sleeve) => (b, a),
        _ => return false,
    };
    // A side panel takes the armhole of the front beside it, a yoke the shoulder of the back.
    let has = |role| bodice.segment(role, None).is_some();
    let armhole = has(EdgeRole::Armhole) || bodice.beside == Some(PanelKind::Side);
    let shoulder = has(EdgeRole::Shoulder) || bodice.beside == Some(PanelKind::Yoke);
    !armhole || shoulder == sleeve.segment(EdgeRole::Neck, None).is_some()
}

/// Returns the length of a role of a panel, that of both halves for one of two.
fn opening_length(part: &LabeledPanel, role: EdgeRole) -> Option<f64> {
    let length = part.role_length(role);
    let halves = part.half
        && matches!(role, EdgeRole::Hem | EdgeRole::Waist)
        && part.kind != PanelKind::Sleeve;
    (length > 0.0).then_some(if halves { 2.0 * length } else { length })
}
