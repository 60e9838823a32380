//! The truth table: what the project makes of real data against what is known of it, a section a subject. The example
//! `truth_table` prints it, the tests assert the same rows. The data is found by `SEAMSTER_TEST_DATA`.
#![allow(
    dead_code,
    reason = "each test program takes this in as its own and uses some of it"
)]

pub(crate) mod import;
#[path = "../raw.rs"]
mod raw;
#[path = "../rings.rs"]
mod rings;
#[path = "../seam_truth.rs"]
pub(crate) mod seam_truth;
pub(crate) mod seams;
pub(crate) mod suggest;
#[path = "../suggest_truth.rs"]
pub(crate) mod suggest_truth;

use serde_json::Value;
use std::path::{Path, PathBuf};

/// A part of the table: its name, and what makes it from the folder of data.
pub(crate) type Section = (&'static str, fn(&Path) -> Table);

/// Every section, in the order of printing.
pub(crate) const SECTIONS: [Section; 3] = [
    ("import", import::table),
    ("seams", seams::table),
    ("suggestions", suggest::table),
];

/// One section, made.
pub(crate) struct Table {
    /// Heads of the columns after the first.
    pub(crate) columns: &'static [&'static str],
    /// One line a file, or a garment.
    pub(crate) rows: Vec<Row>,
    /// What to know for reading it, a line each.
    pub(crate) notes: Vec<String>,
}

/// One line of a table.
pub(crate) struct Row {
    /// What it is about.
    pub(crate) name: String,
    /// As many as columns.
    pub(crate) cells: Vec<Cell>,
}

/// What one comparison gave.
pub(crate) enum Cell {
    /// As in truth; the text is a figure worth showing.
    Right(String),
    /// The truth does not say.
    Unsaid,
    /// What differs.
    Wrong(String),
}

impl Cell {
    /// Right where nothing differs.
    pub(crate) fn of(differences: &[String]) -> Self {
        if differences.is_empty() {
            Self::Right("ok".into())
        } else {
            Self::Wrong(differences.join("; "))
        }
    }

    fn shown(&self) -> String {
        match self {
            Self::Right(text) => text.clone(),
            Self::Unsaid => "-".into(),
            Self::Wrong(_) => "WRONG".into(),
        }
    }
}

impl Table {
    /// What differs, a line each: row, column, difference.
    pub(crate) fn wrong(&self) -> Vec<String> {
        let mut lines = Vec::new();
        for row in &self.rows {
            for (column, cell) in self.columns.iter().zip(&row.cells) {
                if let Cell::Wrong(what) = cell {
                    lines.push(format!("{}: {column}: {what}", row.name));
                }
            }
        }
        lines
    }

    /// Prints it, with what differs below.
    pub(crate) fn print(&self, title: &str) {
        println!("\n== {title}");
        let widest = self.rows.iter().map(|row| row.name.chars().count()).max();
        let name_width = widest.unwrap_or(0);
        let width = |k: usize| {
            let cells = self.rows.iter().map(|row| row.cells[k].shown().len());
            cells.max().unwrap_or(0).max(self.columns[k].len())
        };
        let widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        let line = |name: &str, cells: Vec<String>| {
            let cells = cells.iter().zip(&widths).map(|(c, w)| format!("{c:>w$}"));
            println!(
                "{name:name_width$}  {}",
                cells.collect::<Vec<_>>().join("  ")
            );
        };
        line("", self.columns.iter().map(|c| (*c).to_owned()).collect());
        for row in &self.rows {
            line(&row.name, row.cells.iter().map(Cell::shown).collect());
        }
        for text in self.wrong().iter().chain(&self.notes) {
            println!("   {text}");
        }
        let rows = self.rows.len();
        let right = |row: &&Row| !row.cells.iter().any(|c| matches!(c, Cell::Wrong(_)));
        println!(
            "   {} of {rows} right in every column",
            self.rows.iter().filter(right).count()
        );
    }
}

/// The data folder; `None` where the variable is unset.
pub(crate) fn data() -> Option<PathBuf> {
    std::env::var_os("SEAMSTER_TEST_DATA").map(PathBuf::from)
}

/// A JSON file of the data.
pub(crate) fn json(path: &Path) -> Value {
    let bytes = std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_slice(&bytes).expect("valid JSON")
}
