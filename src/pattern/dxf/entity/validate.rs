//! Checks of records before the `dxf` crate reads them: numbers, and group codes that belong
//! together.

use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::findings::{DxfFindings, at_line, excerpt};
use crate::pattern::dxf::read::records::EntityRecord;
use crate::pattern::dxf::read::tags::DxfTag;

/// Returns the number of tags with a group code.
pub(super) fn count(record: &EntityRecord<'_, '_>, code: i32) -> usize {
    record.tags.iter().filter(|tag| tag.code == code).count()
}

/// Checks that a value that must be a number is one, is finite and fits.
pub(super) fn check_value(tag: &DxfTag<'_>) -> Result<(), Fault> {
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
                PatternCode::NotFinite,
                at_line(line),
                format!("{:?} is not a finite number", excerpt(tag.value)),
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
        PatternCode::BadNumber,
        at_line(line),
        format!("{:?} stands where {wanted} must", excerpt(value)),
    )
    .fix(fix)
}

/// Checks that an entity has its coordinates once: the crate would take a missing one for 0, and of
/// two records that ran into one, the last of each value.
pub(super) fn check_place(kind: &str, record: &EntityRecord<'_, '_>) -> Result<(), Fault> {
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

/// Checks that every vertex of a LWPOLYLINE has x and y, in this order.
pub(super) fn check_lwpolyline(
    record: &EntityRecord<'_, '_>,
    findings: &mut DxfFindings,
) -> Result<(), Fault> {
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
            PatternCode::VertexCount,
            record.line,
            format!(
                "a LWPOLYLINE says that it has {} vertices and has {x_count}",
                excerpt(claimed)
            ),
        );
    }
    Ok(())
}

/// Checks that degree, knots and control points of a SPLINE go together.
pub(super) fn check_spline(record: &EntityRecord<'_, '_>) -> Result<(), Fault> {
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
        PatternCode::MalformedEntity,
        at_line(line),
        format!("{kind}: {what}"),
    )
    .fix("export the file again, or draw this curve anew")
}
