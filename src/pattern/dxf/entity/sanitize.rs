//! Records as text that the `dxf` crate reads whole: only known kinds, only known group codes, only
//! finite numbers. The crate takes an error inside an entity for the end of it and says nothing, so
//! that the entities that must come back are counted here.

use super::validate::{check_lwpolyline, check_place, check_spline, check_value, count};
use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::dxf::read::records::EntityRecord;
use std::fmt::Write;

/// An entity that the crate must give back.
#[derive(Debug, PartialEq)]
pub(super) struct ExpectedEntity {
    /// Its kind as the crate names it.
    pub(super) kind: &'static str,
    /// The line it begins at.
    pub(super) line: usize,
    /// Number of its vertices (polylines only).
    pub(super) vertices: usize,
}

/// Text for the crate, and the entities that must come back.
#[derive(Default)]
pub(super) struct SanitizedEntities {
    /// An ENTITIES section and nothing else.
    pub(super) text: String,
    /// Its entities, in order.
    pub(super) expected: Vec<ExpectedEntity>,
}

/// The group codes that are kept of each kind of entity. Layer (8) is kept of all.
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

/// Number of entities that the crate is given at a time: it takes about 800 bytes for one.
const BATCH: usize = 1000;

/// Splits a list of records into batches, polylines whole.
pub(super) fn batches<'r, 'a, 't>(
    mut records: &'r [EntityRecord<'a, 't>],
) -> impl Iterator<Item = &'r [EntityRecord<'a, 't>]> {
    let is_of_polyline =
        |kind: &str| kind.eq_ignore_ascii_case("POLYLINE") || kind.eq_ignore_ascii_case("VERTEX");
    std::iter::from_fn(move || {
        let ends = |i: &usize| *i == records.len() || !is_of_polyline(records[*i - 1].kind);
        let end = (BATCH.min(records.len())..=records.len())
            .find(|i| *i == 0 || ends(i))
            .unwrap_or(0);
        let (part, rest) = records.split_at(end);
        records = rest;
        (!part.is_empty()).then_some(part)
    })
}

/// Writes `records` for the crate. Kinds that hold no pattern geometry are left out, with one
/// warning a kind.
pub(super) fn sanitize(
    records: &[EntityRecord<'_, '_>],
    findings: &mut DxfFindings,
) -> SanitizedEntities {
    let mut out = SanitizedEntities {
        text: "0\nSECTION\n2\nENTITIES\n".to_owned(),
        ..SanitizedEntities::default()
    };
    let mut in_polyline = false;
    for record in records {
        let kind = record.kind.to_ascii_uppercase();
        if in_polyline && kind != "VERTEX" {
            out.text.push_str("0\nSEQEND\n");
            in_polyline = false;
            if kind != "SEQEND" {
                findings.warn(
                    PatternCode::NoSeqend,
                    record.line,
                    "a POLYLINE has no SEQEND",
                );
            }
        }
        let Some((kind, codes)) = kept(&kind) else {
            if kind != "SEQEND" {
                findings.skip(&kind, record.line);
            }
            continue;
        };
        if record.value(67) == Some("1") {
            findings.skip("paper space entity", record.line);
            continue;
        }
        if kind == "VERTEX" && !in_polyline {
            findings.skip("VERTEX outside a POLYLINE", record.line);
            continue;
        }
        in_polyline |= kind == "POLYLINE";
        if let Err(fault) = out.write(kind, codes, record, findings) {
            findings.faults.push(fault);
        }
    }
    if in_polyline {
        out.text.push_str("0\nSEQEND\n");
    }
    out.text.push_str("0\nENDSEC\n0\nEOF\n");
    out
}

/// Returns the kind under which an entity is read, with its codes. Attributes are read as text.
fn kept(kind: &str) -> Option<(&'static str, &'static [i32])> {
    let kind = if matches!(kind, "ATTRIB" | "ATTDEF") {
        "TEXT"
    } else {
        kind
    };
    KINDS.iter().find(|(name, _)| *name == kind).copied()
}

impl SanitizedEntities {
    /// Adds a record with its known group codes.
    fn write(
        &mut self,
        kind: &'static str,
        codes: &[i32],
        record: &EntityRecord<'_, '_>,
        findings: &mut DxfFindings,
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
                self.expected.push(ExpectedEntity {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::dxf::read::{records, tags};

    fn sanitized(body: &str) -> (SanitizedEntities, DxfFindings) {
        let text = format!("0\nSECTION\n2\nENTITIES\n{body}0\nENDSEC\n0\nEOF\n");
        let limits = crate::config::Limits::default();
        let tags = tags::read(&text, &limits).expect("tags");
        let mut findings = DxfFindings::default();
        let records = records::read(&tags, &limits, &mut findings).expect("records");
        let out = sanitize(&records.entities, &mut findings);
        (out, findings)
    }

    #[test]
    fn unknown_group_codes_are_taken_out() {
        let (out, findings) =
            sanitized("0\nPOLYLINE\n8\n1\n250\n2\n70\n1\n0\nVERTEX\n10\n1\n20\n2\n0\nSEQEND\n");
        assert!(!out.text.contains("250"));
        assert_eq!(
            out.expected,
            [ExpectedEntity {
                kind: "POLYLINE",
                line: 5,
                vertices: 1
            }]
        );
        assert!(findings.faults.is_empty() && findings.warnings.is_empty());
    }

    #[test]
    fn number_that_is_none_names_its_line() {
        let (_, findings) = sanitized("0\nPOINT\n10\n1\n20\nabc\n");
        assert_eq!(findings.faults[0].pointer, "line 10");
        assert_eq!(findings.faults[0].code, "pattern/bad_number");
    }

    #[test]
    fn missing_seqend_is_added() {
        let (out, findings) = sanitized(
            "0\nPOLYLINE\n0\nVERTEX\n10\n1\n20\n2\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n1\n",
        );
        assert_eq!(out.expected.len(), 2);
        assert_eq!(findings.warnings[0].code, "pattern/no_seqend");
        assert_eq!(out.text.matches("SEQEND").count(), 1);
    }
}
