//! Suggested seams against the true ones: of drafts whose files state them, and of real garments as written down.

use super::seam_truth::garments;
use super::suggest_truth::{Score, Truth, score, written};
use super::{Cell, Row, Table};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The least share of seams that must be found, and be right, for each garment and for all together.
const EACH: f64 = 0.85;
const POOLED: f64 = 0.95;

/// Every garment whose seams are known.
pub(crate) fn table(data: &Path) -> Table {
    let mut rows: Vec<Row> = vec![];
    let mut drafts = Score::default();
    for garment in garments(data) {
        let truth = Truth {
            pattern: garment.pattern,
            seams: garment.pairs,
            alternatives: vec![],
            unused: BTreeSet::new(),
            complete: true,
        };
        let found = score(&truth);
        drafts.add(&found);
        rows.push(row(garment.name, &found, Some(EACH)));
    }
    let mut real = Score::default();
    for file in truths() {
        let truth = written(&file, data);
        let found = score(&truth);
        if truth.complete {
            real.add(&found);
        }
        let name = file
            .file_stem()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        rows.push(row(name, &found, truth.complete.then_some(EACH)));
    }
    rows.push(row("all drafts".into(), &drafts, Some(POOLED)));
    rows.push(row("all real garments".into(), &real, Some(POOLED)));
    Table {
        columns: &["seams", "recall", "suggested", "precision"],
        rows,
        notes: vec!["garments whose truth is known in part only are shown, and not judged".into()],
    }
}

/// The truths that were written down by hand.
fn truths() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/truth");
    let entries = std::fs::read_dir(folder).expect("tests/truth");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("readable").path())
        .collect();
    files.sort();
    files
}

fn row(name: String, score: &Score, least: Option<f64>) -> Row {
    let cell = |share: f64, names: &[String]| match least {
        Some(least) if share < least => Cell::Wrong(format!("{share:.2}: {}", names.join(", "))),
        _ => Cell::Right(format!("{share:.2}")),
    };
    Row {
        cells: vec![
            Cell::Right(format!("{}/{}", score.found, score.seams)),
            cell(score.recall(), &score.missed),
            Cell::Right(format!("{}/{}", score.right, score.suggested)),
            cell(score.precision(), &score.wrong),
        ],
        name,
    }
}
