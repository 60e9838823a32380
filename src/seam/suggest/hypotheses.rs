//! Hypotheses of what panels are that no name tells of: a garment that they make whole is stronger
//! evidence than the look of each.
//!
//! Side panels, under sleeves, yokes, hoods and legs in one piece look like many other panels. They
//! are looked for only where the usual reading leaves panels over, and taken only where everything
//! that must be sewn then finds its partner, and the edges that meet are as long as each other.

use super::cut_edges::CutPattern;
use super::labels::PanelKind;
use super::missing_corners;
use super::reading::Reading;
use crate::config::Limits;
use crate::pattern::Pattern;

/// Kinds that are looked for, beside the usual ones.
const RARE: [PanelKind; 5] = [
    PanelKind::Side,
    PanelKind::UnderSleeve,
    PanelKind::Yoke,
    PanelKind::Hood,
    PanelKind::Leg,
];
/// Most kinds that are looked for together.
const MAX_TOGETHER: usize = 2;
/// Most panels of a pattern that is read more than once: each reading weighs every two of them.
const MAX_PANELS: usize = 40;
/// Share of the area of all panels from which one that is left over is worth another reading, and
/// by which another reading must sew more.
const MIN_SHARE: f64 = 0.02;

/// Returns the reading that makes the most of a pattern, the usual one where others are not better.
pub(super) fn best_reading(pattern: &Pattern, limits: &Limits) -> Reading {
    let mut best = Reading::of(pattern, limits, &[]);
    let mut kinds: Vec<PanelKind> = vec![];
    let few = pattern.panels.len() <= MAX_PANELS;
    while few && kinds.len() < MAX_TOGETHER && leaves_over(pattern, &best) {
        let more = RARE.iter().filter(|kind| !kinds.contains(kind));
        let ways = more.map(|kind| [kinds.as_slice(), &[*kind]].concat());
        let found = ways.map(|rare| (Reading::of(pattern, limits, &rare), rare));
        let exact = found.filter(|(reading, rare)| reading.is_exact(rare));
        let graded = exact.map(|(reading, rare)| (grade(pattern, &reading), reading, rare));
        // Of equally good ones the first.
        let better = graded.rev().max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((its_grade, reading, rare)) = better else {
            break;
        };
        if its_grade < grade(pattern, &best) + MIN_SHARE {
            break;
        }
        (best, kinds) = (reading, rare);
    }
    if few && (best.completeness.trust() < 1.0 || leaves_over(pattern, &best)) {
        best = with_missing_corners(pattern, limits, &kinds, best);
    }
    best
}

/// Returns the reading with corners that the file lacks, where one of them makes the pattern whole;
/// else the one without.
fn with_missing_corners(
    pattern: &Pattern,
    limits: &Limits,
    rare: &[PanelKind],
    usual: Reading,
) -> Reading {
    let open = usual.completeness.unfinished();
    let ways = missing_corners::ways(pattern, &usual.hints, &open);
    let read = ways.iter().map(|cuts| {
        let cut = CutPattern::new(pattern, cuts);
        let mut reading = Reading::of(&cut.pattern, limits, rare);
        for seam in &mut reading.seams {
            seam.pair.a = cut.restored(&seam.pair.a);
            seam.pair.b = cut.restored(&seam.pair.b);
        }
        reading
    });
    let whole = read.filter(|reading| reading.completeness.trust() > usual.completeness.trust());
    let graded = whole.map(|reading| (grade(pattern, &reading) + reading.confidence(), reading));
    let best = graded.max_by(|a, b| a.0.total_cmp(&b.0));
    best.map_or(usual, |(_, reading)| reading)
}

/// Returns how much of a pattern a reading explains: the trust in it, then the area that it sews.
fn grade(pattern: &Pattern, reading: &Reading) -> f64 {
    2.0 * reading.completeness.trust() + reading.sewn_share(pattern)
}

/// Returns true if a reading leaves a panel over that no name tells of and that is no trifle.
fn leaves_over(pattern: &Pattern, reading: &Reading) -> bool {
    let area = |i: usize| pattern.panels[i].area_m2.abs();
    let all: f64 = (0..pattern.panels.len()).map(area).sum();
    let sewn = reading.sewn(pattern);
    let mut over = (0..pattern.panels.len()).filter(|i| !sewn.contains(i));
    over.any(|i| reading.hints[i].kind.is_none() && area(i) >= MIN_SHARE * all)
}
