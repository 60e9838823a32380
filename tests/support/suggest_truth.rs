//! Suggested seams against true ones: how many true seams are found, and how many suggested ones are right.
//!
//! Seams are compared by the points that they join, not by how they are stated. A seam is explained where along nine
//! tenths of its length seams of the other set join the same points, up to 3 % of its length and at least 15 mm.
//! A band that is closed on itself may begin anywhere on its ring.
#![allow(
    dead_code,
    reason = "each test program takes this file in as its own and uses some of it"
)]

use seamster::config::Limits;
use seamster::pattern::{ImportOptions, Pattern, SeamPair, import};
use seamster::seam::{self, suggest};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

#[path = "symmetry.rs"]
mod symmetry;
use symmetry::axis;

/// The part of a seam that must be explained.
const MOST_OF_IT: f64 = 0.9;
/// How near points must be: as a share of the seam, and at least \[m\].
const NEAR_SHARE: f64 = 0.03;
const NEAR_M: f64 = 0.015;
/// Distance of the points that are compared \[m\].
const STEP: f64 = 0.005;
/// Symmetric panels of which every combination is tried.
const MOST_TURNED: usize = 5;
/// Words in the names of seams round a ring, which may begin anywhere on it.
const RINGS: [&str; 7] = ["band", "rib", "binding", "waist", "collar", "cuff", "neck"];

/// The true seams of a garment.
pub(crate) struct Truth {
    pub(crate) pattern: Pattern,
    pub(crate) seams: Vec<SeamPair>,
    /// Seams that are as right as others of the same name.
    pub(crate) alternatives: Vec<SeamPair>,
    /// Panels of other styles in the same file: whatever is suggested for them is not judged.
    pub(crate) unused: BTreeSet<String>,
    /// Whether these are all seams of the garment.
    pub(crate) complete: bool,
}

/// What was found about one garment.
#[derive(Clone, Debug, Default)]
pub(crate) struct Score {
    pub(crate) seams: usize,
    pub(crate) found: usize,
    pub(crate) suggested: usize,
    pub(crate) right: usize,
    /// Names of true seams that were not found, and of suggested ones that are wrong.
    pub(crate) missed: Vec<String>,
    pub(crate) wrong: Vec<String>,
}

impl Score {
    pub(crate) fn recall(&self) -> f64 {
        share(self.found, self.seams)
    }

    pub(crate) fn precision(&self) -> f64 {
        share(self.right, self.suggested)
    }

    pub(crate) fn add(&mut self, other: &Self) {
        self.seams += other.seams;
        self.found += other.found;
        self.suggested += other.suggested;
        self.right += other.right;
    }
}

fn share(part: usize, whole: usize) -> f64 {
    if whole == 0 {
        1.0
    } else {
        part as f64 / whole as f64
    }
}

/// A truth written down by hand, with the drawing that it is about.
pub(crate) fn written(file: &Path, data: &Path) -> Truth {
    let stem = file.file_stem().expect("a name").to_string_lossy();
    let drawing = ["dxf", "DXF"]
        .map(|end| data.join("dxf").join(format!("{stem}.{end}")))
        .into_iter()
        .find(|path| path.exists())
        .unwrap_or_else(|| panic!("{stem}: no drawing of that name"));
    let bytes = std::fs::read(drawing).expect("a readable drawing");
    let pattern = import(&bytes, &ImportOptions::default(), &Limits::default()).expect("a pattern");
    let truth: Value =
        serde_json::from_slice(&std::fs::read(file).expect("a truth")).expect("JSON");
    let pairs = |value: &Value| -> Vec<SeamPair> {
        serde_json::from_value(value.clone()).unwrap_or_else(|e| panic!("{stem}: {e}"))
    };
    let list = |key: &str| truth[key].as_array().cloned().unwrap_or_default();
    Truth {
        pattern,
        seams: pairs(&truth["seams"]),
        alternatives: list("alternatives")
            .iter()
            .flat_map(|a| pairs(&a["seams"]))
            .collect(),
        unused: list("unused")
            .iter()
            .filter_map(|v| Some(v.as_str()?.to_owned()))
            .collect(),
        complete: truth["complete"].as_bool().unwrap_or(true),
    }
}

/// Suggests seams for the pattern without what its file states, and compares them with the truth. A panel that is its
/// own mirror image may be turned over: the way that agrees best counts.
pub(crate) fn score(truth: &Truth) -> Score {
    let suggested: Vec<SeamPair> = suggest::suggest(&truth.pattern, &Limits::default())
        .seams
        .into_iter()
        .map(|seam| seam.pair)
        .collect();
    let all = [&truth.seams, &truth.alternatives, &suggested];
    let whole = with_copies(&truth.pattern, all.into_iter().flatten());
    let joined = |pairs: &[SeamPair]| -> Vec<Joined> {
        pairs.iter().map(|pair| Joined::new(&whole, pair)).collect()
    };
    let known = [joined(&truth.seams), joined(&truth.alternatives)];
    let axes: Vec<Option<f64>> = whole.panels.iter().map(axis).collect();
    let symmetric: Vec<usize> = (0..axes.len()).filter(|i| axes[*i].is_some()).collect();
    let ways = 1_usize << symmetric.len().min(MOST_TURNED);
    let of_way = |way: usize| {
        let mut found = joined(&suggested);
        let turned = symmetric.iter().take(MOST_TURNED).enumerate();
        for (_, panel) in turned.filter(|(bit, _)| way >> bit & 1 == 1) {
            let c = axes[*panel].expect("it is symmetric");
            found.iter_mut().for_each(|seam| seam.turn_over(*panel, c));
        }
        compared(truth, &whole, &known, &found)
    };
    let best = (0..ways).map(of_way).max_by_key(|score| {
        (
            score.found + score.right,
            std::cmp::Reverse(score.wrong.len()),
        )
    });
    best.expect("at least one way")
}

fn compared(
    truth: &Truth,
    whole: &Pattern,
    [seams, others]: &[Vec<Joined>; 2],
    found: &[Joined],
) -> Score {
    let mut score = Score::default();
    for seam in seams {
        let mut ways = others
            .iter()
            .filter(|other| other.id == seam.id)
            .chain([seam]);
        score.seams += 1;
        if ways.any(|way| way.is_explained_by(found)) {
            score.found += 1;
        } else {
            score.missed.push(seam.id.clone());
        }
    }
    let edges: BTreeSet<&(usize, usize)> = seams.iter().flat_map(|seam| &seam.edges).collect();
    let known: Vec<&Joined> = seams.iter().chain(others).collect();
    for seam in found {
        let base = |panel: usize| whole.panels[panel].id.trim_end_matches("~mirror");
        let unused = seam
            .edges
            .iter()
            .any(|(panel, _)| truth.unused.contains(base(*panel)));
        let beyond = !truth.complete && !seam.edges.iter().all(|edge| edges.contains(edge));
        if unused || beyond {
            continue;
        }
        score.suggested += 1;
        if seam.is_explained_by(known.iter().copied()) {
            score.right += 1;
        } else {
            score.wrong.push(seam.id.clone());
        }
    }
    score
}

fn with_copies<'a>(pattern: &Pattern, pairs: impl Iterator<Item = &'a SeamPair>) -> Pattern {
    let runs = pairs.flat_map(|pair| pair.a.runs().iter().chain(pair.b.runs()));
    let names: Vec<&str> = runs.map(|run| run.panel.as_str()).collect();
    pattern.with_copies(names).into_owned()
}

/// A point of an outline: panel, and the way along its outline from corner 0 \[m\].
type Spot = (usize, f64);

/// A seam as the pairs of points that it joins.
struct Joined {
    id: String,
    ring: bool,
    near: f64,
    pairs: Vec<([Spot; 2], f64)>,
    edges: BTreeSet<(usize, usize)>,
    /// Length of each outline \[m\].
    around: Vec<f64>,
}

impl Joined {
    fn new(pattern: &Pattern, pair: &SeamPair) -> Self {
        let alone = SeamPair {
            gather: true,
            layered: true,
            allow_twist: true,
            ..pair.clone()
        };
        let (_, set) = seam::check(
            pattern,
            &[alone],
            &BTreeMap::new(),
            STEP,
            &Limits::default(),
        );
        let set = set.unwrap_or_else(|faults| panic!("{}: {faults}", pair.id));
        let mut joined = Self {
            id: pair.id.clone(),
            ring: RINGS.iter().any(|word| pair.id.contains(word))
                && !pair.id.contains("end")
                && !pair.id.contains("join"),
            near: 0.0,
            pairs: vec![],
            edges: BTreeSet::new(),
            around: pattern
                .panels
                .iter()
                .map(|p| p.edges.iter().map(|e| e.length_m).sum())
                .collect(),
        };
        let mut whole = 0.0;
        for stretches in &set.seams[0].matched {
            let lengths = stretches
                .map(|s| (s.to - s.from).abs() * pattern.panels[s.panel].edges[s.edge].length_m);
            whole += lengths[0];
            joined.edges.extend(stretches.map(|s| (s.panel, s.edge)));
            #[expect(
                clippy::cast_possible_truncation,
                reason = "a length over a step, bounded by the size of panels"
            )]
            let count = (lengths[0].max(lengths[1]) / STEP).ceil().max(2.0) as usize;
            for k in 0..count {
                let t = (k as f64 + 0.5) / count as f64;
                let spots = stretches.map(|s| {
                    let edges = &pattern.panels[s.panel].edges;
                    let before: f64 = edges[..s.edge].iter().map(|e| e.length_m).sum();
                    (
                        s.panel,
                        before + (s.from + t * (s.to - s.from)) * edges[s.edge].length_m,
                    )
                });
                joined.pairs.push((spots, lengths[0] / count as f64));
            }
        }
        joined.near = NEAR_M.max(NEAR_SHARE * whole);
        joined
    }

    /// The same seam with a symmetric panel turned over.
    fn turn_over(&mut self, panel: usize, c: f64) {
        let around = self.around[panel];
        for spot in self.pairs.iter_mut().flat_map(|(pair, _)| pair) {
            if spot.0 == panel {
                spot.1 = (c - spot.1).rem_euclid(around);
            }
        }
    }

    fn is_explained_by<'a>(&self, others: impl IntoIterator<Item = &'a Self> + Clone) -> bool {
        let whole: f64 = self.pairs.iter().map(|(_, weight)| weight).sum();
        let met = |pair: &[Spot; 2]| {
            others
                .clone()
                .into_iter()
                .any(|other| self.meets(pair, other))
        };
        let explained: f64 = self
            .pairs
            .iter()
            .filter(|(pair, _)| met(pair))
            .map(|(_, weight)| weight)
            .sum();
        explained >= MOST_OF_IT * whole
    }

    fn meets(&self, [a, b]: &[Spot; 2], other: &Self) -> bool {
        let near = |x: &Spot, y: &Spot, most: f64| {
            let way = (x.1 - y.1).rem_euclid(self.around[x.0]);
            x.0 == y.0 && way.min(self.around[x.0] - way) <= most
        };
        let pairs = || other.pairs.iter().map(|(pair, _)| pair);
        if self.ring && other.ring {
            let on =
                |spot: &Spot, side: usize| pairs().any(|pair| near(spot, &pair[side], self.near));
            return (0..2).any(|side| on(a, side) && on(b, 1 - side));
        }
        pairs().any(|[c, d]| {
            let same = |c, d| near(a, c, self.near) && near(b, d, self.near);
            same(c, d) || same(d, c)
        })
    }
}
