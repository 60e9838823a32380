//! Panels of garments drawn here, and what is suggested for them.

use seamster::config::Limits;
use seamster::pattern::Panel;
use seamster::seam::suggest::{Suggestion, suggest};
use seamster_fixtures::panels::{panel_of, pattern};
use std::collections::BTreeSet;

type Points = Vec<[f64; 2]>;

/// A panel of edges that are drawn one after another, the last back to the beginning.
pub(super) fn drawn(id: &str, edges: &[&[[f64; 2]]]) -> Panel {
    let start = |i: usize| edges[i % edges.len()][0];
    let closed = |i: usize| -> Points { [edges[i], &[start(i + 1)]].concat() };
    panel_of(id, &(0..edges.len()).map(closed).collect::<Vec<_>>())
}

/// Half of a bodice, its side on the left; the neck is so deep.
pub(super) fn bodice(id: &str, neck: f64) -> Panel {
    drawn(
        id,
        &[
            &[[0.0, 0.0]],
            &[[0.0, 0.40], [0.04, 0.42], [0.06, 0.47], [0.05, 0.56]],
            &[[0.05, 0.60]],
            &[[0.18, 0.64], [0.19, 0.64 - 0.7 * neck], [0.22, 0.64 - neck]],
            &[[0.26, 0.64 - neck]],
            &[[0.26, 0.0]],
        ],
    )
}

/// A back that ends under a yoke, its side on the left.
pub(super) fn back_under_yoke(id: &str) -> Panel {
    drawn(
        id,
        &[
            &[[0.0, 0.0]],
            &[[0.0, 0.40], [0.035, 0.42], [0.05, 0.47]],
            &[[0.05, 0.50]],
            &[[0.26, 0.50]],
            &[[0.26, 0.0]],
        ],
    )
}

/// Half a yoke, its armhole on the left.
pub(super) fn yoke(id: &str) -> Panel {
    drawn(
        id,
        &[
            &[[0.05, 0.50]],
            &[[0.05, 0.60]],
            &[[0.18, 0.64], [0.20, 0.62], [0.23, 0.61]],
            &[[0.26, 0.61]],
            &[[0.26, 0.50]],
        ],
    )
}

/// The middle of half a front or back with a princess seam up to the shoulder, on its left.
pub(super) fn middle(id: &str, neck: f64) -> Panel {
    drawn(
        id,
        &[
            &[[0.05, 0.0], [0.02, 0.2]],
            &[[0.0, 0.42]],
            &[[0.045, 0.435], [0.06, 0.435 - 0.7 * neck]],
            &[[0.12, 0.435 - neck]],
            &[[0.12, 0.0]],
        ],
    )
}

/// The part beside it, its side on the left.
pub(super) fn outer(id: &str) -> Panel {
    drawn(
        id,
        &[
            &[[0.0, 0.0]],
            &[[-0.02, 0.21], [0.03, 0.23], [0.055, 0.30], [0.055, 0.36]],
            &[[0.055, 0.395]],
            &[[0.12, 0.415], [0.13, 0.2]],
            &[[0.10, 0.0]],
        ],
    )
}

pub(super) fn suggested(panels: Vec<Panel>) -> Suggestion {
    suggest(&pattern(panels), &Limits::default())
}

/// Names of the seams of at least even confidence, without the numbers of their parts.
pub(super) fn sure(found: &Suggestion) -> BTreeSet<&str> {
    let sure = found.seams.iter().filter(|seam| seam.confidence >= 0.5);
    sure.map(|seam| seam.pair.id.as_str()).collect()
}

/// Pairs of panels that seams of at least even confidence join, mirrored copies as their sources.
pub(super) fn joined(found: &Suggestion) -> BTreeSet<[String; 2]> {
    let source = |panel: &str| panel.trim_end_matches("~mirror").to_owned();
    let mut all = BTreeSet::new();
    for seam in found.seams.iter().filter(|seam| seam.confidence >= 0.5) {
        for a in seam.pair.a.runs() {
            for b in seam.pair.b.runs() {
                let mut pair = [source(&a.panel), source(&b.panel)];
                pair.sort();
                all.insert(pair);
            }
        }
    }
    all
}

pub(super) fn are_joined(found: &Suggestion, pairs: &[[&str; 2]]) {
    let joined = joined(found);
    for [a, b] in pairs {
        let pair = [(*a).to_owned(), (*b).to_owned()];
        assert!(joined.contains(&pair), "{a} to {b}: {joined:?}");
    }
}
