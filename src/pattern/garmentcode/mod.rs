//! `GarmentCode` specification JSON to a pattern.
//!
//! Source of the format: M. Korosteleva, O. Sorkine-Hornung, "`GarmentCode`: Programming Parametric Sewing Patterns",
//! ACM TOG 42(6), 2023, and its repository maria-korosteleva/GarmentCode, pygarment/pattern/core.py. Lengths are in
//! units of which `units_in_meter` make a metre (100: centimetres). The older short form of curvature, a list of two
//! numbers, is a quadratic curve's control point.

mod edge;
mod panel;
mod parse;
mod placement;
mod stitch;
mod value;

use self::value::{At, Findings};
use super::point::Point2;
use super::{
    Allowance, ImportOptions, Panel, Pattern, PatternFormat, RotationOrder, Source, Units, ids,
};
use crate::config::Limits;
use crate::fault::{Fault, Faults};
use serde_json::Value;
use std::collections::BTreeMap;

/// Coordinates up to this are read \[m\].
const FAR: f64 = 1e4;

/// Units per metre where the file does not say: centimetres.
const USUAL: f64 = 100.0;

/// Whether bytes are JSON rather than DXF: the first that is not blank is a brace.
pub(super) fn is_json(bytes: &[u8]) -> bool {
    let bytes = without_mark(bytes);
    bytes.iter().find(|b| !b.is_ascii_whitespace()) == Some(&b'{')
}

/// The bytes without a UTF-8 byte order mark.
fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// Reads a pattern from the bytes of a specification.
pub(super) fn import(
    bytes: &[u8],
    options: &ImportOptions,
    limits: &Limits,
) -> Result<Pattern, Faults> {
    if bytes.len() > limits.json_bytes {
        let detail = format!(
            "the file has {} bytes; at most {} are read",
            bytes.len(),
            limits.json_bytes
        );
        let fault = Fault::new("pattern/too_large", "", detail);
        return Err(fault.fix("split the garment").into());
    }
    let document = parse::parse(without_mark(bytes))?;
    let root = At::root(&document);
    if !document["pattern"]["panels"].is_object() {
        return Err(not_garmentcode(&document).into());
    }
    let mut findings = Findings::default();
    let pattern = read(&root, options, limits, &mut findings);
    let warnings = std::mem::take(&mut findings.warnings);
    Faults(findings.into_faults()).or(Pattern {
        warnings,
        ..pattern
    })
}

fn not_garmentcode(document: &Value) -> Fault {
    let fix = if document.get("panels").is_some() || document.get("seams").is_some() {
        "a Pattern or a Garment as JSON is sent to POST /v1/fits; here go DXF and GarmentCode files"
    } else {
        "upload a DXF, or a GarmentCode specification: {\"pattern\": {\"panels\": {...}, \"stitches\": [...]}}"
    };
    let detail = "the JSON is no GarmentCode specification: it has no /pattern/panels";
    Fault::new("pattern/not_garmentcode", "", detail).fix(fix)
}

/// How the numbers of a file are meant.
struct Reading<'a> {
    limits: &'a Limits,
    /// Metres per unit.
    scale: f64,
    /// Whether control points are relative to their edge.
    relative: bool,
    /// Whether the loops were drawn so that their sign states the face.
    states_faces: bool,
    /// Whether panels turn about the mean of their vertices.
    about_mean: bool,
    rotation_order: RotationOrder,
}

impl Reading<'_> {
    /// A text, cut to the length of a name.
    fn short(&self, text: &str) -> String {
        text.chars().take(self.limits.name_chars).collect()
    }

    /// A point of the plane \[m\].
    fn point(&self, at: &At<'_>, findings: &mut Findings) -> Option<Point2> {
        let point = at.numbers::<2>(findings)?.map(|c| c * self.scale);
        if point.iter().all(|c| c.abs() <= FAR) {
            return Some(point);
        }
        let detail = "a coordinate is beyond 10 km";
        findings.fault(at.wrong("pattern/not_finite", detail, "correct it"));
        None
    }
}

fn read(
    root: &At<'_>,
    options: &ImportOptions,
    limits: &Limits,
    findings: &mut Findings,
) -> Pattern {
    let parametric = [
        "parameters",
        "parameter_order",
        "constraints",
        "constraint_order",
    ];
    let known = [&["pattern", "properties"][..], &parametric].concat();
    root.fields(&known, findings);
    for name in parametric {
        let Some(at) = root.get(name) else { continue };
        let is_empty = |v: &Value| match v {
            Value::Array(items) => items.is_empty(),
            Value::Object(fields) => fields.is_empty(),
            other => other.is_null(),
        };
        if !is_empty(at.value) {
            let detail = format!("{name} are not kept: panels are read as they are drawn");
            findings.warn("pattern/parameters_ignored", &at.pointer, detail);
        }
    }
    if let Some(size) = &options.size {
        let fault = Fault::new(
            "pattern/unknown_size",
            "",
            format!("the file has no size {size:?}"),
        );
        findings.fault(fault.fix("leave size out: a GarmentCode file holds one size"));
    }
    let (reading, units) = reading(root, options, limits, findings);
    let source = Source {
        format: PatternFormat::GarmentCode,
        units,
        scale_to_m: reading.scale,
        sample_size: None,
        sizes: Vec::new(),
        allowance: Allowance::None,
    };
    let name = name(options, limits);
    let mut pattern = Pattern {
        id: None,
        name,
        source,
        panels: Vec::new(),
        seams: Vec::new(),
        placements: BTreeMap::new(),
        warnings: Vec::new(),
    };
    if let Some(at) = root.get("pattern") {
        fill(&mut pattern, &at, &reading, findings);
    }
    pattern
}

/// The name of the file without what the writer puts at its end.
fn name(options: &ImportOptions, limits: &Limits) -> String {
    let name = options.name.as_deref().unwrap_or("pattern");
    let name = name.strip_suffix("_specification").unwrap_or(name);
    name.chars().take(limits.name_chars).collect()
}

/// How the numbers are meant, and the name of their unit.
fn reading<'a>(
    root: &At<'_>,
    options: &ImportOptions,
    limits: &'a Limits,
    findings: &mut Findings,
) -> (Reading<'a>, String) {
    let properties = root.get("properties");
    if let Some(properties) = &properties {
        let known = [
            "curvature_coords",
            "normalize_panel_translation",
            "normalized_edge_loops",
            "units_in_meter",
            "original_units_in_meter",
        ];
        properties.fields(&known, findings);
    }
    let get = |name| properties.as_ref().and_then(|at| at.get(name));
    let per_metre = match get("units_in_meter") {
        Some(at) => units_in_meter(&at, findings),
        None => {
            if options.units.is_none() {
                let detail = "the file does not say its units; cm was taken (units= overrides)";
                findings.warn("pattern/units_assumed", "/properties", detail);
            }
            USUAL
        }
    };
    let relative = match get("curvature_coords") {
        Some(at) => curvature_coords(&at, findings),
        None => true,
    };
    let mut flag = |name| get(name).and_then(|at| at.flag(findings)).unwrap_or(false);
    let reading = Reading {
        limits,
        scale: options.units.map_or(1.0 / per_metre, Units::in_metres),
        relative,
        states_faces: flag("normalized_edge_loops"),
        about_mean: flag("normalize_panel_translation"),
        rotation_order: options.rotation_order,
    };
    let units = options
        .units
        .map_or_else(|| unit_name(per_metre), |units| units.name().to_owned());
    (reading, units)
}

fn unit_name(per_metre: f64) -> String {
    let known = [Units::Mm, Units::Cm, Units::M, Units::Inch];
    let found = known
        .into_iter()
        .find(|units| (units.in_metres() * per_metre - 1.0).abs() < 1e-3);
    found.map_or_else(
        || format!("1/{per_metre} m"),
        |units| units.name().to_owned(),
    )
}

fn units_in_meter(at: &At<'_>, findings: &mut Findings) -> f64 {
    let given = at.number(findings);
    let found = given.filter(|n| (1e-3..=1e6).contains(n));
    if found.is_none() && given.is_some() {
        let detail = "units_in_meter is how many units make a metre";
        findings.fault(at.wrong("pattern/field", detail, "give 100 for centimetres"));
    }
    found.unwrap_or(USUAL)
}

fn curvature_coords(at: &At<'_>, findings: &mut Findings) -> bool {
    match at.text(findings) {
        Some("absolute") => false,
        Some("relative") | None => true,
        Some(_) => {
            let detail = "curvature_coords is \"relative\" or \"absolute\"";
            findings.fault(at.wrong("pattern/field", detail, "correct it"));
            true
        }
    }
}

/// Puts panels, placements and seams into `pattern`.
fn fill(pattern: &mut Pattern, at: &At<'_>, reading: &Reading<'_>, findings: &mut Findings) {
    let known = ["panels", "stitches", "panel_order", "new_panel_order"];
    at.fields(&known, findings);
    let Some(entries) = at.get("panels").map(|panels| panels.entries(findings)) else {
        return;
    };
    let limits = reading.limits;
    let too_many = entries.len() > limits.panels;
    if too_many || entries.is_empty() {
        let detail = format!("{} panels; 1 to {} are read", entries.len(), limits.panels);
        let code = if too_many {
            "pattern/too_many_panels"
        } else {
            "pattern/no_panels"
        };
        findings.fault(Fault::new(code, "/pattern/panels", detail).fix("split the garment"));
        return;
    }
    let names: Vec<String> = entries.iter().map(|(name, _)| (*name).to_owned()).collect();
    let mut loops = stitch::Panels::new();
    let mut order: Vec<Panel> = Vec::with_capacity(entries.len());
    for ((name, at), id) in entries.iter().zip(ids::from_names(&names, &pattern.name)) {
        let mut drawn = panel::read((*name, at), reading, findings);
        if let Some(drawn) = &mut drawn {
            drawn.panel.id.clone_from(&id);
        }
        let placement = placement::read(at, drawn.as_ref(), reading, findings);
        pattern.placements.extend(placement.map(|p| (id, p)));
        order.extend(drawn.as_ref().map(|drawn| drawn.panel.clone()));
        loops.insert(name, drawn);
        if findings.points > limits.dxf_vertices {
            let detail = format!(
                "the outlines up to here have more than {} points",
                limits.dxf_vertices
            );
            findings.fault(at.wrong("pattern/too_large", detail, "split the garment"));
            return;
        }
    }
    pattern.panels = order;
    if let Some(stitches) = at.get("stitches") {
        pattern.seams = stitch::read(&stitches, &loops, limits, findings);
    }
}
