//! Reads all panels together: of what each may be, that is chosen with which its neighbours agree best.
//!
//! A reading of a front is good if its side is as long as that of the back, and if it mirrors the other half. Starting
//! from the likeliest readings, each panel in turn takes the one that fits the others best, until none changes.

use super::piece::{Kind, Piece, Role};

/// Rounds at most: each lowers the misfit, so that few are needed.
const ROUNDS: usize = 8;
/// How much edges that are sewn together, edges that mirror each other, and the same edges of front and back usually
/// differ, as a logarithm.
const SEWN: f64 = 0.06;
const ALIKE: f64 = 0.3;
const MIRRORED: f64 = 0.03;
/// The same for an edge that goes round an opening, where the longer one is usually gathered and where it is not,
/// and what that may cost at most.
const GATHERED: f64 = 0.7;
const JOINED: f64 = 0.12;
const EASED: f64 = 0.3;
const FULL: f64 = 0.45;
const MOST_JOINED: f64 = 2.5;
/// The edges of a band that may be sewn.
const BAND_EDGES: [Role; 3] = [Role::Long, Role::Hem, Role::Waist];
/// What it costs if a front is half and its back whole.
const UNLIKE: f64 = 0.5;
/// What disagreement of two panels may cost at most.
const MOST: f64 = 3.0;

/// One reading for each panel that has any.
pub(super) fn together(candidates: Vec<Vec<Piece>>) -> Vec<Piece> {
    let candidates: Vec<Vec<Piece>> = candidates.into_iter().filter(|c| !c.is_empty()).collect();
    let table = Table::new(&candidates);
    let mut chosen = vec![0; candidates.len()];
    for _ in 0..ROUNDS {
        let before = chosen.clone();
        for i in 0..candidates.len() {
            table.settle(&mut chosen, i);
        }
        for pair in &table.pairs {
            table.settle_pair(&mut chosen, pair);
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

/// What every reading costs alone and with every other.
struct Table {
    alone: Vec<Vec<f64>>,
    pairs: Vec<Pair>,
    /// For each panel, the pairs it is in.
    of: Vec<Vec<usize>>,
}

/// Two panels whose readings are not indifferent to each other.
struct Pair {
    ends: [usize; 2],
    /// By the reading of the first, then of the second.
    cost: Vec<Vec<f64>>,
}

impl Table {
    fn new(candidates: &[Vec<Piece>]) -> Self {
        let alone = candidates
            .iter()
            .map(|c| c.iter().map(|p| p.cost).collect())
            .collect();
        let mut pairs: Vec<Pair> = vec![];
        let mut of = vec![vec![]; candidates.len()];
        for i in 0..candidates.len() {
            for j in i + 1..candidates.len() {
                let row = |a: &Piece| candidates[j].iter().map(|b| disagreement(a, b)).collect();
                let cost: Vec<Vec<f64>> = candidates[i].iter().map(row).collect();
                if cost.iter().flatten().any(|c| *c > 0.0) {
                    of[i].push(pairs.len());
                    of[j].push(pairs.len());
                    pairs.push(Pair { ends: [i, j], cost });
                }
            }
        }
        Self { alone, pairs, of }
    }

    /// What panel `i` costs with reading `k`, without the pair with panel `but`.
    fn cost(&self, chosen: &[usize], (i, k): (usize, usize), but: Option<usize>) -> f64 {
        let with = |pair: &Pair| {
            let [a, b] = pair.ends;
            let other = if a == i { b } else { a };
            match (Some(other) == but, a == i) {
                (true, _) => 0.0,
                (false, true) => pair.cost[k][chosen[b]],
                (false, false) => pair.cost[chosen[a]][k],
            }
        };
        self.alone[i][k]
            + self.of[i]
                .iter()
                .map(|p| with(&self.pairs[*p]))
                .sum::<f64>()
    }

    /// Takes the reading of one panel that fits the others best.
    fn settle(&self, chosen: &mut [usize], i: usize) {
        let cost = |k: &usize| self.cost(chosen, (i, *k), None);
        let best = (0..self.alone[i].len()).min_by(|a, b| cost(a).total_cmp(&cost(b)));
        chosen[i] = best.unwrap_or_default();
    }

    /// Takes the readings of two panels that fit each other and the others best: two halves may be wrong together.
    fn settle_pair(&self, chosen: &mut [usize], pair: &Pair) {
        let [i, j] = pair.ends;
        let of = |i: usize, but: usize| -> Vec<f64> {
            (0..self.alone[i].len())
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

/// How little two panels fit each other.
fn disagreement(a: &Piece, b: &Piece) -> f64 {
    if a.kind != b.kind {
        let mixed = !a.kind_said && !b.kind_said && a.named && b.named;
        let misfits = f64::from(u8::from(is_misfit(a, b)) + u8::from(mixed));
        return joined(a, b) + joined(b, a) + misfits * MOST;
    }
    if a.number != b.number {
        return 0.0;
    }
    let same_side = a.lateral == b.lateral;
    match (a.which, b.which) {
        (Some(x), Some(y)) if x != y && same_side => sewn(a, b),
        (x, y) if x == y && !same_side => mirrored(a, b),
        _ => 0.0,
    }
}

/// A sleeve needs an armhole; one that runs up to the neck a bodice without shoulders, any other one with.
fn is_misfit(a: &Piece, b: &Piece) -> bool {
    let (sleeve, bodice) = match (a.kind, b.kind) {
        (Kind::Sleeve, Kind::Bodice) => (a, b),
        (Kind::Bodice, Kind::Sleeve) => (b, a),
        _ => return false,
    };
    let armhole = bodice.segment(Role::Armhole, None).is_some();
    let shoulder = bodice.segment(Role::Shoulder, None).is_some();
    !armhole || shoulder == sleeve.segment(Role::Neck, None).is_some()
}

/// How little an edge of `a` fits the opening of `b` that it goes round: 0 where the two are not sewn together.
fn joined(a: &Piece, b: &Piece) -> f64 {
    let same = a.which == b.which
        && a.which.is_some()
        && (a.lateral == b.lateral || a.kind == Kind::Waistband || b.kind == Kind::Waistband);
    let (edges, opening): (&[Role], Role) = match (a.kind, b.kind) {
        (Kind::Sleeve, Kind::Bodice) => (&[Role::Cap], Role::Armhole),
        (Kind::Cuff, Kind::Sleeve) if !a.of.contains(&Kind::Trouser) => (&BAND_EDGES, Role::Hem),
        (Kind::Cuff, Kind::Trouser) if a.of.contains(&Kind::Trouser) => (&BAND_EDGES, Role::Hem),
        (Kind::Waistband, Kind::Skirt | Kind::Trouser) => (&BAND_EDGES, Role::Waist),
        (Kind::Waistband, Kind::Bodice) => (&BAND_EDGES, Role::Hem),
        _ => return 0.0,
    };
    let (Some(opening), true) = (total(b, opening), same) else {
        return 0.0;
    };
    let fits = edges
        .iter()
        .filter_map(|role| a.segment(*role, None))
        .map(|s| {
            let longer = (a.shape.length(&s.edges) / opening).ln();
            // Sleeves are gathered into armholes, skirts into waistbands and sleeves into cuffs: not the other way round.
            let gathered = if a.kind == Kind::Sleeve {
                longer > 0.0
            } else {
                longer < 0.0
            };
            let spread = match (gathered, a.kind) {
                (true, Kind::Waistband) => FULL,
                (true, _) => GATHERED,
                (false, Kind::Waistband) => EASED,
                (false, _) => JOINED,
            };
            (0.5 * (longer / spread).powi(2)).min(MOST_JOINED)
        });
    fits.fold(MOST_JOINED, f64::min)
}

/// Length of a role of a piece, that of both halves for one of two.
fn total(piece: &Piece, role: Role) -> Option<f64> {
    let length: f64 = piece.all(role).map(|s| piece.shape.length(&s.edges)).sum();
    let halves =
        piece.half && matches!(role, Role::Hem | Role::Waist) && piece.kind != Kind::Sleeve;
    (length > 0.0).then_some(if halves { 2.0 * length } else { length })
}

/// What of a front and a back is sewn together.
fn sewn(a: &Piece, b: &Piece) -> f64 {
    if a.half != b.half {
        return if a.kind == Kind::Sleeve { MOST } else { UNLIKE };
    }
    let roles: &[Role] = match a.kind {
        Kind::Bodice => &[Role::Side, Role::Shoulder],
        Kind::Skirt => &[Role::Side],
        Kind::Trouser => &[Role::Side, Role::Inseam],
        Kind::Sleeve => &[Role::Top, Role::Underarm],
        _ => &[],
    };
    let alike: &[Role] = match a.kind {
        Kind::Skirt => &[Role::Waist, Role::Hem],
        Kind::Bodice => &[Role::Hem],
        _ => &[],
    };
    difference(a, b, roles, SEWN) + 0.5 * difference(a, b, alike, ALIKE)
}

/// How much two halves are no mirror images.
fn mirrored(a: &Piece, b: &Piece) -> f64 {
    if a.half != b.half {
        return MOST;
    }
    let roles: Vec<Role> = a.segments.iter().map(|s| s.role).collect();
    difference(a, b, &roles, MIRRORED)
}

/// Mean difference in length of the segments of some roles.
fn difference(a: &Piece, b: &Piece, roles: &[Role], spread: f64) -> f64 {
    if roles.is_empty() {
        return 0.0;
    }
    let length = |p: &Piece, role| -> Option<f64> {
        let all: Vec<f64> = p.all(role).map(|s| p.shape.length(&s.edges)).collect();
        (!all.is_empty()).then(|| all.iter().sum())
    };
    let of = |role: &Role| match (length(a, *role), length(b, *role)) {
        (Some(x), Some(y)) => Some((0.5 * ((x / y).ln() / spread).powi(2)).min(MOST)),
        (None, None) => None,
        _ => Some(MOST),
    };
    let all: Vec<f64> = roles.iter().filter_map(of).collect();
    #[expect(clippy::cast_precision_loss, reason = "a handful of roles")]
    let count = all.len().max(1) as f64;
    all.iter().sum::<f64>() / count
}
