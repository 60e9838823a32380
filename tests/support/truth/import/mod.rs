//! The import of the 48 real files against `manifest.json` and the truth files beside them: a column a property.

mod corners;
mod drawn;
mod marks;
mod warned;

use super::raw::{self, Drawing};
use super::{Cell, Row, Table, json};
use seamster::config::Limits;
use seamster::fault::Faults;
use seamster::pattern::{ImportOptions, Panel, Pattern, import};
use serde_json::Value;
use std::path::Path;

const COLUMNS: [&str; 14] = [
    "panels", "area", "length", "corners", "grain", "fold", "notches", "drills", "lines", "sew",
    "sizes", "names", "quantity", "warnings",
];

/// The section.
pub(crate) fn table(data: &Path) -> Table {
    let folder = data.join("dxf");
    let manifest = json(&folder.join("manifest.json"));
    let entries = manifest["files"].as_array().expect("a list of files");
    let mut notes = Vec::new();
    let rows = entries
        .iter()
        .map(|entry| {
            let (row, said) = row(&folder, entry);
            notes.extend(said);
            row
        })
        .collect();
    Table {
        columns: &COLUMNS,
        rows,
        notes,
    }
}

fn row(folder: &Path, entry: &Value) -> (Row, Vec<String>) {
    let name = entry["file"].as_str().expect("a file name").to_owned();
    let read =
        |name: &str| std::fs::read(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    let found = import(&read(&name), &ImportOptions::default(), &Limits::default());
    let pattern = match found {
        // The truth counts panels before copies.
        Ok(mut pattern) => {
            pattern.panels.retain(|panel| panel.copy_of.is_none());
            pattern
        }
        Err(faults) => return (refused(name, &faults), Vec::new()),
    };
    // The binary file is another one saved anew: its tags are read there.
    let text_of = match name.as_str() {
        "binary_ezdxf_ORILEGWB_AAMA.dxf" => "gerber_ORILEGWB_AAMA.DXF",
        other => other,
    };
    let truth = entry["truth_file"]
        .as_str()
        .map(|file| json(&folder.join(file)));
    let file = File {
        scale: entry["scale_used_to_mm"].as_f64().expect("a scale"),
        drawing: raw::read(&read(text_of)),
        entry,
        truth,
        pattern,
    };
    let notes = corners::notes(&file);
    (
        Row {
            cells: file.cells(),
            name,
        },
        notes,
    )
}

fn refused(name: String, faults: &Faults) -> Row {
    let cells = COLUMNS
        .iter()
        .map(|_| Cell::Wrong(format!("refused: {faults}")));
    Row {
        name,
        cells: cells.collect(),
    }
}

/// A file with all that is known of it.
struct File<'a> {
    entry: &'a Value,
    truth: Option<Value>,
    drawing: Drawing,
    /// Millimetres per drawing unit.
    scale: f64,
    pattern: Pattern,
}

/// A panel, the piece of the manifest that it is, and the block it came from.
struct Pair<'a> {
    panel: &'a Panel,
    piece: &'a Value,
    block: Option<&'a raw::Block>,
}

impl File<'_> {
    fn cells(&self) -> Vec<Cell> {
        let pieces = self.pieces();
        let count = self.entry["pieces_in_sample_size"]
            .as_u64()
            .or(self.entry["piece_count"].as_u64());
        let (found, wanted) = (self.pattern.panels.len(), count.unwrap_or(0));
        if found as u64 != wanted || pieces.len() != found {
            let what = format!(
                "{found}, the truth has {wanted} ({} described)",
                pieces.len()
            );
            return COLUMNS.iter().map(|_| Cell::Wrong(what.clone())).collect();
        }
        let pairs = self.pairs(&pieces);
        vec![
            Cell::Right(found.to_string()),
            drawn::areas(&pairs),
            drawn::perimeters(self, &pairs),
            corners::cell(self, &pairs),
            marks::grain(self, &pairs),
            marks::fold(&pairs),
            marks::notches(self, &pairs),
            marks::drills(&pairs),
            drawn::lines(self, &pairs),
            drawn::sew(self, &pairs),
            marks::sizes(self),
            marks::names(&pairs),
            marks::quantities(&pairs),
            warned::cell(self, &pairs),
        ]
    }

    /// The pieces that a panel must be of: those of the sample size, where the file is graded.
    fn pieces(&self) -> Vec<&Value> {
        let graded = !self.entry["pieces_in_sample_size"].is_null();
        let pieces = self.entry["pieces"].as_array().expect("a list of pieces");
        let kept = pieces
            .iter()
            .filter(|p| !graded || p["size"] == self.entry["sample_size"]);
        kept.collect()
    }

    /// Each panel with its piece: of those with its name (or all, where none has it), the nearest in area.
    fn pairs<'a>(&'a self, pieces: &[&'a Value]) -> Vec<Pair<'a>> {
        let mut free: Vec<&Value> = pieces.to_vec();
        let pair = |panel: &'a Panel| {
            let cost = |piece: &Value| {
                let named = name(piece).is_some_and(|n| n != panel.name);
                let off = (1e6 * panel.drawn_area_m2 / area(piece) - 1.0).abs();
                f64::from(u8::from(named)) + off
            };
            let best = (0..free.len()).min_by(|a, b| cost(free[*a]).total_cmp(&cost(free[*b])));
            let piece = free.remove(best.expect("as many pieces as panels"));
            let index = piece["index"]
                .as_u64()
                .and_then(|i| usize::try_from(i).ok());
            let block = index.and_then(|i| self.drawing.blocks.get(i));
            let block = block.filter(|b| {
                piece["block"]
                    .as_str()
                    .is_some_and(|n| n.is_ascii() && n == b.name || !n.is_ascii())
            });
            Pair {
                panel,
                piece,
                block,
            }
        };
        self.pattern.panels.iter().map(pair).collect()
    }
}

/// The name that a panel of this piece has, where the file says one.
fn name(piece: &Value) -> Option<&str> {
    piece["piece_name"].as_str().or(piece["block"].as_str())
}

fn area(piece: &Value) -> f64 {
    let area = piece["outline"]["area_mm2"]
        .as_f64()
        .or(piece["area_mm2"].as_f64());
    area.expect("an area")
}

fn off(found: f64, wanted: f64) -> f64 {
    (found / wanted - 1.0).abs()
}

/// A list of the manifest.
fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

impl Pair<'_> {
    fn says(&self, what: impl std::fmt::Display) -> String {
        format!("{}: {what}", self.panel.id)
    }

    /// The fold that the manifest knows [mm].
    fn mirror(&self) -> Option<[[f64; 2]; 2]> {
        let line: Vec<f64> = list(self.piece["mirror_line"].get(0)?)
            .iter()
            .filter_map(Value::as_f64)
            .collect();
        let at = |i: usize| [line[i], line[i + 1]];
        (line.len() >= 4).then(|| [at(0), at(line.len() - 2)])
    }

    /// The outline [mm].
    fn ring(&self) -> Vec<[f64; 2]> {
        let points = self
            .panel
            .edges
            .iter()
            .flat_map(|e| &e.points[..e.points.len() - 1]);
        points.map(|p| [1000.0 * p[0], 1000.0 * p[1]]).collect()
    }

    /// The outline that was cut [mm]: the cut line where there is one.
    fn cut(&self) -> Vec<[f64; 2]> {
        if self.panel.cut_line.is_empty() {
            return self.ring();
        }
        self.panel
            .cut_line
            .iter()
            .map(|p| [1000.0 * p[0], 1000.0 * p[1]])
            .collect()
    }
}
