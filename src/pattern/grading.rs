//! Grade rule tables (`.rul`): how far the points of a pattern move from size to size.
//!
//! The text format beside AAMA and ASTM D6673 DXF, as two public documents on GitHub describe it,
//! from tables of Boke, Gerber and Lectra: "AAMA/ASTM DXF+RUL Grading Parser Specification" (of a
//! nesting engine, `aama_parser.py`) and the exporter of "BERA Converter". The standard itself,
//! which was withdrawn in 2019, is not public.
//!
//! A head of `KEY: VALUE` lines with `UNITS`, `SIZE LIST` and `SAMPLE SIZE`; then `RULE: DELTA n`,
//! each with a pair x, y a size in the order of the list; and `END`. A pair is the way of a point
//! from its place in the sample size.

use super::point::{FARTHEST, Point2};
use super::units::Units;
use crate::config::Limits;
use crate::fault::{Fault, Faults, PatternCode};
use std::collections::BTreeMap;

/// Most faults of one table that are reported.
const MOST: usize = 20;

/// A grade rule table. Lengths in meters.
#[derive(Clone, Debug, PartialEq)]
pub struct GradeTable {
    /// The sizes, in the order of the table.
    pub(super) sizes: Vec<String>,
    /// Position of the sample size among them.
    pub(super) sample: usize,
    /// Ways of a point from its place in the sample size, one a size, by the number of the rule.
    pub(super) rules: BTreeMap<u32, Vec<Point2>>,
}

impl GradeTable {
    /// Reads a table from the bytes of a `.rul` file.
    ///
    /// # Errors
    /// Every place where it is not one, with its line.
    pub fn read(bytes: &[u8], limits: &Limits) -> Result<Self, Faults> {
        if bytes.len() > limits.dxf_bytes {
            let detail = format!(
                "the grade rule table has more than {} bytes",
                limits.dxf_bytes
            );
            return Err(at(0, &detail).into());
        }
        let text = String::from_utf8_lossy(bytes);
        let mut reader = TableReader::default();
        for (line, text) in (1..).zip(text.lines()) {
            reader.read(line, text);
            if reader.is_done || reader.faults.len() >= MOST {
                break;
            }
        }
        reader.into_table()
    }

    /// Returns the position of a size, whatever the case of its letters.
    pub(super) fn size(&self, name: &str) -> Option<usize> {
        let name = name.trim();
        let mut sizes = self.sizes.iter();
        sizes.position(|size| size.eq_ignore_ascii_case(name))
    }

    /// Returns the way of the points of a rule to a size.
    pub(super) fn delta(&self, rule: u32, size: usize) -> Option<Point2> {
        self.rules.get(&rule).map(|deltas| deltas[size])
    }
}

/// The numbers of a rule, read so far.
struct OpenRule {
    number: u32,
    line: usize,
    values: Vec<f64>,
}

/// A table as it is read, line by line.
#[derive(Default)]
struct TableReader {
    /// The values of the head, each with its line.
    head: BTreeMap<String, (String, usize)>,
    open: Option<OpenRule>,
    rules: BTreeMap<u32, (usize, Vec<f64>)>,
    faults: Vec<Fault>,
    is_done: bool,
}

impl TableReader {
    fn read(&mut self, line: usize, text: &str) {
        let text = text.split('#').next().unwrap_or_default().trim();
        if let Some((key, value)) = text.split_once(':') {
            let key = key.trim().to_uppercase();
            if key == "RULE" {
                self.close_rule();
                self.open_rule(line, value);
            } else if self.open.is_none() {
                self.head.insert(key, (value.trim().to_owned(), line));
            } else {
                let detail = format!("{key:?} stands where the numbers of a rule must");
                self.faults.push(at(line, &detail));
            }
        } else if text.eq_ignore_ascii_case("END") {
            self.is_done = true;
        } else if let Some(rule) = &mut self.open {
            let words = text.split(|c: char| c == ',' || c.is_whitespace());
            for word in words.filter(|word| !word.is_empty()) {
                match word.parse::<f64>() {
                    Ok(value) if value.abs() <= FARTHEST * 1e3 => rule.values.push(value),
                    _ => {
                        let detail = format!("{word:?} is no length");
                        self.faults.push(at(line, &detail));
                        return;
                    }
                }
            }
        }
    }

    fn open_rule(&mut self, line: usize, value: &str) {
        let mut words = value.split_whitespace();
        let (kind, number) = (words.next(), words.next().and_then(|n| n.parse().ok()));
        match (kind, number) {
            (Some(kind), Some(number)) if kind.eq_ignore_ascii_case("DELTA") => {
                let values = vec![];
                self.open = Some(OpenRule {
                    number,
                    line,
                    values,
                });
            }
            _ => {
                let detail = format!("{:?} is no rule of the kind `DELTA n`", value.trim());
                self.faults.push(at(line, &detail));
                self.open = None;
            }
        }
    }

    fn close_rule(&mut self) {
        let Some(rule) = self.open.take() else {
            return;
        };
        if let Some((other, _)) = self.rules.insert(rule.number, (rule.line, rule.values)) {
            let detail = format!("rule {} stands on line {other} as well", rule.number);
            self.faults.push(at(rule.line, &detail));
        }
    }

    fn into_table(mut self) -> Result<GradeTable, Faults> {
        self.close_rule();
        let (sizes, sample) = self.sizes();
        let meters = self.meters();
        let mut rules = BTreeMap::new();
        for (number, (line, values)) in std::mem::take(&mut self.rules) {
            match deltas(&values, sizes.len(), sample) {
                Ok(deltas) => {
                    let in_meters = |delta: &Point2| delta.map(|c| c * meters);
                    rules.insert(number, deltas.iter().map(in_meters).collect());
                }
                Err(detail) => self
                    .faults
                    .push(at(line, &format!("rule {number} {detail}"))),
            }
        }
        if rules.is_empty() && self.faults.is_empty() {
            self.faults.push(at(0, "the table has no `RULE: DELTA n`"));
        }
        self.faults.truncate(MOST);
        Faults(self.faults).or(GradeTable {
            sizes,
            sample,
            rules,
        })
    }

    /// Returns a value of the head, empty if there is none, and its line.
    fn value(&self, key: &str) -> (String, usize) {
        self.head.get(key).cloned().unwrap_or_default()
    }

    /// Returns the sizes and the position of the sample size.
    fn sizes(&mut self) -> (Vec<String>, usize) {
        let (list, line) = self.value("SIZE LIST");
        let sizes: Vec<String> = list.split_whitespace().map(str::to_owned).collect();
        if sizes.is_empty() {
            self.faults.push(at(line, "the table has no `SIZE LIST:`"));
        }
        let (count, line) = self.value("NUMBER OF SIZES");
        if !count.is_empty() && count.parse() != Ok(sizes.len()) {
            let detail = format!("the table says {count} sizes and lists {}", sizes.len());
            self.faults.push(at(line, &detail));
        }
        let (name, line) = self.value("SAMPLE SIZE");
        let sample = sizes.iter().position(|s| s.eq_ignore_ascii_case(&name));
        if sample.is_none() {
            let detail = "the table has no `SAMPLE SIZE:` that is in its `SIZE LIST:`";
            self.faults.push(at(line, detail));
        }
        (sizes, sample.unwrap_or_default())
    }

    /// Returns the meters of a unit of the table.
    fn meters(&mut self) -> f64 {
        let (name, line) = self.value("UNITS");
        match &*name.to_uppercase() {
            "METRIC" => Units::Mm.in_meters(),
            "ENGLISH" => Units::Inch.in_meters(),
            _ => {
                let detail =
                    "the table does not say its units (`UNITS: METRIC` or `UNITS: ENGLISH`)";
                self.faults.push(at(line, detail));
                1.0
            }
        }
    }
}

/// Returns the pairs of a rule, one a size, of which that of the sample size is 0.
fn deltas(values: &[f64], sizes: usize, sample: usize) -> Result<Vec<Point2>, String> {
    /// The last digit of coordinates that tables are written with.
    const ROUNDING: f64 = 1e-3;
    if values.len() != 2 * sizes {
        return Err(format!(
            "has {} numbers; {sizes} sizes need {}",
            values.len(),
            2 * sizes
        ));
    }
    let pairs: Vec<Point2> = values.chunks(2).map(|pair| [pair[0], pair[1]]).collect();
    let moves = pairs
        .get(sample)
        .is_some_and(|delta| delta.iter().any(|c| c.abs() > ROUNDING));
    if moves {
        return Err("moves its points in the sample size too".to_owned());
    }
    Ok(pairs)
}

fn at(line: usize, detail: &str) -> Fault {
    let place = format!("grading line {line}");
    Fault::new(PatternCode::GradeTable, place, detail)
        .fix("export the grade rule table again, or leave it out to read the sample size")
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "ANSI/AAMA VERSION: 1.0.0\r\nAUTHOR: X\r\nCREATION TIME: 14:03\r\nUNITS: METRIC\r\n\
        GRADE RULE TABLE: SKIRT\r\nNUMBER OF SIZES:  3\r\nSIZE LIST: S M L \r\nSAMPLE SIZE: M\r\n\
        RULE: DELTA  1\r\n    -10.00,     2.50      0.00,     0.00     12.00,    -3.00\r\n\
        RULE: DELTA 12\r\n-1, 0 # size S\r\n0, -0.0\r\n1, 0\r\nEND\r\nnot read: at all\r\n";

    fn read(text: &str) -> Result<GradeTable, Faults> {
        GradeTable::read(text.as_bytes(), &Limits::default())
    }

    #[test]
    fn pairs_on_one_line_or_several_are_read() {
        let table = read(TABLE).expect("a table");
        assert_eq!(table.sizes, ["S", "M", "L"]);
        assert_eq!((table.sample, table.size("l")), (1, Some(2)));
        assert_eq!(table.delta(1, 0), Some([-0.01, 0.0025]));
        assert_eq!(table.delta(12, 2), Some([0.001, 0.0]));
        assert_eq!(table.delta(2, 0), None);
        let inches = read(&TABLE.replace("METRIC", "ENGLISH")).expect("a table");
        assert_eq!(inches.delta(12, 2), Some([0.0254, 0.0]));
    }

    #[test]
    fn wrong_tables_are_refused_with_their_lines() {
        let wrong = [
            ("UNITS: METRIC", "UNITS: ELLS", "grading line 4"),
            ("SIZES:  3", "SIZES:  4", "grading line 6"),
            ("SAMPLE SIZE: M", "SAMPLE SIZE: XL", "grading line 8"),
            ("12.00,    -3.00", "12.00", "grading line 9"),
            ("0.00,     0.00", "1.00,     0.00", "grading line 9"),
            ("-10.00", "ten", "grading line 10"),
            ("DELTA 12", "DELTA 1", "grading line 11"),
            ("DELTA 12", "STEP 12", "grading line 11"),
            ("SIZE LIST", "LIST", "grading line 0"),
        ];
        for (old, new, place) in wrong {
            let faults = read(&TABLE.replacen(old, new, 1)).expect_err(new).0;
            assert!(
                faults.iter().any(|fault| fault.pointer == place),
                "{new}: {faults:?}"
            );
        }
        assert!(read("").is_err());
    }
}
