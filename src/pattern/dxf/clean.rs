//! The entities of one block as text that the `dxf` crate reads whole: only known kinds, only known group codes,
//! only finite numbers. The crate takes an error inside an entity for the end of it and says nothing, so what must
//! come back is counted here.

use super::structure::Record;
use super::tags::{Tag, shown};
use super::{Findings, at_line};
use crate::fault::Fault;
use std::fmt::Write;

/// An entity that the crate must give back.
#[derive(Debug, PartialEq)]
pub(super) struct Expected {
    /// Its kind as the crate names it.
    pub(super) kind: &'static str,
    /// The line it begins at.
    pub(super) line: usize,
    /// How many vertices it has (polylines only).
    pub(super) vertices: usize,
}

/// Text for the crate, and what must come back.
#[derive(Default)]
pub(super) struct Cleaned {
    /// An ENTITIES section and nothing else.
    pub(super) text: String,
    /// Its entities, in order.
    pub(super) expected: Vec<Expected>,
}

/// What is kept of each kind of entity: its group codes. Layer (8) is kept of all.
const KINDS: [(&str, &[i32]); 12] = [
    ("LINE", &[10, 20, 30, 11, 21, 31]),
    ("POINT", &[10, 20, 30]),
    ("TEXT", &[1, 10, 20, 30]),
    ("MTEXT", &[1, 3, 10, 20, 30]),
    ("POLYLINE", &[70, 210, 220, 230]),
    ("VERTEX", &[10, 20, 30, 42, 70]),
    ("LWPOLYLINE", &[70, 10, 20, 42, 210, 220, 230]),
    ("ARC", &[10, 20, 30, 40, 50, 51, 210, 220, 230]),
    ("CIRCLE", &[10, 20, 30, 40, 210, 220, 230]),
    (
        "ELLIPSE",
        &[10, 20, 30, 11, 21, 31, 40, 41, 42, 210, 220, 230],
    ),
    (
        "SPLINE",
        &[
            70, 71, 40, 41, 10, 20, 11, 21, 12, 22, 32, 13, 23, 33, 210, 220, 230,
        ],
    ),
    (
        "INSERT",
        &[2, 10, 20, 30, 41, 42, 43, 44, 45, 50, 70, 71, 210, 220, 230],
    ),
];

/// The crate takes about 800 bytes for an entity: it is given this many at a time.
const PART: usize = 1000;

/// Parts of a list of records, polylines whole.
pub(super) fn parts<'r, 'a, 't>(
    mut records: &'r [Record<'a, 't>],
) -> impl Iterator<Item = &'r [Record<'a, 't>]> {
    let goes_on =
        |kind: &str| kind.eq_ignore_ascii_case("POLYLINE") || kind.eq_ignore_ascii_case("VERTEX");
    std::iter::from_fn(move || {
        let ends = |i: &usize| *i == records.len() || !goes_on(records[*i - 1].kind);
        let end = (PART.min(records.len())..=records.len())
            .find(|i| *i == 0 || ends(i))
            .unwrap_or(0);
        let (part, rest) = records.split_at(end);
        records = rest;
        (!part.is_empty()).then_some(part)
    })
}

/// Writes `records` for the crate. Kinds that hold no pattern geometry are left out with one warning a kind.
pub(super) fn clean(records: &[Record<'_, '_>], findings: &mut Findings) -> Cleaned {
    let mut out = Cleaned {
        text: "0\nSECTION\n2\nENTITIES\n".to_owned(),
        ..Cleaned::default()
    };
    let mut polyline = false;
    for record in records {
        let kind = record.kind.to_ascii_uppercase();
        if polyline && kind != "VERTEX" {
            out.text.push_str("0\nSEQEND\n");
            polyline = false;
            if kind != "SEQEND" {
                findings.warn("pattern/no_seqend", record.line, "a POLYLINE has no SEQEND");
            }
        }
        let Some((kind, codes)) = kept(&kind) else {
            if kind != "SEQEND" {
                findings.left_out(&kind, record.line);
            }
            continue;
        };
        if record.value(67) == Some("1") {
            findings.left_out("paper space entity", record.line);
            continue;
        }
        if kind == "VERTEX" && !polyline {
            findings.left_out("VERTEX outside a POLYLINE", record.line);
            continue;
        }
        polyline |= kind == "POLYLINE";
        if let Err(fault) = out.write(kind, codes, record, findings) {
            findings.faults.push(fault);
        }
    }
    if polyline {
        out.text.push_str("0\nSEQEND\n");
    }
    out.text.push_str("0\nENDSEC\n0\nEOF\n");
    out
}

/// The kind under which an entity is read, with its codes. Attributes are read as text.
fn kept(kind: &str) -> Option<(&'static str, &'static [i32])> {
    let kind = if matches!(kind, "ATTRIB" | "ATTDEF") {
        "TEXT"
    } else {
        kind
    };
    KINDS.iter().find(|(name, _)| *name == kind).copied()
}

impl Cleaned {
    fn write(
        &mut self,
        kind: &'static str,
        codes: &[i32],
        record: &Record<'_, '_>,
        findings: &mut Findings,
    ) -> Result<(), Fault> {
        match kind {
            "LWPOLYLINE" => check_lwpolyline(record, findings)?,
            "SPLINE" => check_spline(record)?,
            _ => check_place(kind, record)?,
        }
        self.pair(0, kind);
        if kind == "POLYLINE" {
            self.pair(66, "1");
        }
        for tag in record.tags {
            if tag.code == 8 || codes.contains(&tag.code) {
                check_value(tag)?;
                self.pair(tag.code, tag.value);
                // The crate makes points of a spline only where they have a z.
                if kind == "SPLINE" && matches!(tag.code, 20 | 21) {
                    self.pair(tag.code + 10, "0");
                }
            }
        }
        match (kind, self.expected.last_mut()) {
            ("VERTEX", Some(polyline)) => polyline.vertices += 1,
            _ => {
                let vertices = if kind == "LWPOLYLINE" {
                    count(record, 10)
                } else {
                    0
                };
                self.expected.push(Expected {
                    kind,
                    line: record.line,
                    vertices,
                });
            }
        }
        Ok(())
    }

    fn pair(&mut self, code: i32, value: &str) {
        writeln!(self.text, "{code}\n{value}").expect("writing to a String cannot fail");
    }
}

fn count(record: &Record<'_, '_>, code: i32) -> usize {
    record.tags.iter().filter(|tag| tag.code == code).count()
}

/// Refuses a number that is none, is not finite, or does not fit.
fn check_value(tag: &Tag<'_>) -> Result<(), Fault> {
    let line = tag.line + 1;
    match tag.code {
        1..=9 => Ok(()),
        60..=79 => match tag.value.parse::<i16>() {
            Ok(_) => Ok(()),
            Err(_) => Err(bad_number(line, tag.value, "a whole number")),
        },
        _ => match tag.value.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(()),
            Ok(_) => Err(Fault::new(
                "pattern/not_finite",
                at_line(line),
                format!("{:?} is not a finite number", shown(tag.value)),
            )
            .fix("correct the coordinate in the CAD program and export again")),
            Err(_) => Err(bad_number(line, tag.value, "a number")),
        },
    }
}

fn bad_number(line: usize, value: &str, wanted: &str) -> Fault {
    let fix = if value.contains(',') {
        "export with a decimal point instead of a decimal comma"
    } else {
        "export the file again; this line is damaged"
    };
    Fault::new(
        "pattern/bad_number",
        at_line(line),
        format!("{:?} stands where {wanted} must", shown(value)),
    )
    .fix(fix)
}

/// What has a place has it once: the crate would take a missing coordinate for 0, and of two records that ran into one,
/// the last of each value.
fn check_place(kind: &str, record: &Record<'_, '_>) -> Result<(), Fault> {
    let needed: &[i32] = match kind {
        "LINE" | "ELLIPSE" => &[10, 20, 11, 21],
        "POINT" | "VERTEX" | "ARC" | "CIRCLE" => &[10, 20],
        _ => &[],
    };
    let refuse = |code: i32, what: &str| {
        let what = format!("group code {code} {what}");
        Err(malformed(record.line, kind, &what))
    };
    if let Some(code) = needed.iter().find(|code| count(record, **code) == 0) {
        return refuse(*code, "is missing");
    }
    let once = [2, 10, 20, 11, 21].into_iter();
    let mut once = once.filter(|code| *code != 2 || kind == "INSERT");
    match once.find(|code| count(record, *code) > 1) {
        Some(code) => refuse(code, "is given twice"),
        None => Ok(()),
    }
}

fn check_lwpolyline(record: &Record<'_, '_>, findings: &mut Findings) -> Result<(), Fault> {
    let mut in_vertex = false;
    let mut x_count = 0;
    for tag in record.tags {
        in_vertex |= tag.code == 10;
        x_count += usize::from(tag.code == 10);
        if matches!(tag.code, 20 | 42) && !in_vertex {
            return Err(malformed(tag.line, "LWPOLYLINE", "a vertex has y before x"));
        }
    }
    if x_count != count(record, 20) {
        return Err(malformed(
            record.line,
            "LWPOLYLINE",
            "a vertex lacks x or y",
        ));
    }
    if let Some(claimed) = record.value(90).filter(|v| v.parse() != Ok(x_count)) {
        findings.warn(
            "pattern/vertex_count",
            record.line,
            format!(
                "a LWPOLYLINE says that it has {} vertices and has {x_count}",
                shown(claimed)
            ),
        );
    }
    Ok(())
}

fn check_spline(record: &Record<'_, '_>) -> Result<(), Fault> {
    for (x, y) in [(10, 20), (11, 21)] {
        if count(record, x) != count(record, y) {
            return Err(malformed(record.line, "SPLINE", "a point lacks x or y"));
        }
    }
    let (controls, knots) = (count(record, 10), count(record, 40));
    let degree = record
        .value(71)
        .and_then(|v| v.parse::<usize>().ok())
        .unwrap_or(3);
    if !(1..=11).contains(&degree) {
        return Err(malformed(
            record.line,
            "SPLINE",
            &format!("its degree is {degree}"),
        ));
    }
    if controls > 0 && (controls <= degree || knots != controls + degree + 1) {
        return Err(malformed(
            record.line,
            "SPLINE",
            &format!(
                "degree {degree} and {controls} control points need {} knots, it has {knots}",
                controls + degree + 1
            ),
        ));
    }
    Ok(())
}

fn malformed(line: usize, kind: &str, what: &str) -> Fault {
    Fault::new(
        "pattern/malformed_entity",
        at_line(line),
        format!("{kind}: {what}"),
    )
    .fix("export the file again, or draw this curve anew")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cleaned(body: &str) -> (Cleaned, Findings) {
        let text = format!("0\nSECTION\n2\nENTITIES\n{body}0\nENDSEC\n0\nEOF\n");
        let limits = crate::config::Limits::default();
        let tags = super::super::tags::read(&text, &limits).expect("tags");
        let mut findings = Findings::default();
        let structure =
            super::super::structure::read(&tags, &limits, &mut findings).expect("structure");
        let out = clean(&structure.entities, &mut findings);
        (out, findings)
    }

    #[test]
    fn unknown_group_codes_are_taken_out() {
        let (out, findings) =
            cleaned("0\nPOLYLINE\n8\n1\n250\n2\n70\n1\n0\nVERTEX\n10\n1\n20\n2\n0\nSEQEND\n");
        assert!(!out.text.contains("250"));
        assert_eq!(
            out.expected,
            [Expected {
                kind: "POLYLINE",
                line: 5,
                vertices: 1
            }]
        );
        assert!(findings.faults.is_empty() && findings.warnings.is_empty());
    }

    #[test]
    fn number_that_is_none_names_its_line() {
        let (_, findings) = cleaned("0\nPOINT\n10\n1\n20\nabc\n");
        assert_eq!(findings.faults[0].pointer, "line 10");
        assert_eq!(findings.faults[0].code, "pattern/bad_number");
    }

    #[test]
    fn missing_seqend_is_added() {
        let (out, findings) =
            cleaned("0\nPOLYLINE\n0\nVERTEX\n10\n1\n20\n2\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n1\n");
        assert_eq!(out.expected.len(), 2);
        assert_eq!(findings.warnings[0].code, "pattern/no_seqend");
        assert_eq!(out.text.matches("SEQEND").count(), 1);
    }
}
