//! `GarmentCode` specification JSON to a pattern.
//!
//! Source of the format: M. Korosteleva, O. Sorkine-Hornung, "`GarmentCode`: Programming Parametric
//! Sewing Patterns", ACM TOG 42(6), 2023, and its repository maria-korosteleva/GarmentCode,
//! pygarment/pattern/core.py. Lengths are in units of which `units_in_meter` make a meter (100:
//! centimeters). The older short form of curvature, a list of two numbers, is a quadratic curve's
//! control point.

mod conventions;
mod curve;
mod edge;
mod findings;
mod node;
mod panel;
mod parse;
mod placement;
mod rotation;
mod stitches;

pub(crate) use self::rotation::matrix as rotation_matrix;
pub(crate) use self::stitches::{is_gathered, seam_id};

use self::conventions::Conventions;
use self::findings::SpecFindings;
use self::node::JsonNode;
use super::{Allowance, ImportOptions, Panel, Pattern, PatternFormat, Source, ids};
use crate::config::Limits;
use crate::fault::{Fault, Faults, PatternCode};
use crate::json::{AnyPlace, JsonBounds, measure};
use serde_json::Value;
use std::collections::BTreeMap;

/// Fields of a specification that describe its parameters.
const PARAMETRIC: [&str; 4] = [
    "parameters",
    "parameter_order",
    "constraints",
    "constraint_order",
];

/// Share of the memory for JSON that the file of one pattern may take: they are small.
const MEMORY_SHARE: usize = 4;

/// Returns true if bytes are JSON rather than DXF: the first that is not blank is a brace.
pub(super) fn is_json(bytes: &[u8]) -> bool {
    let bytes = without_mark(bytes);
    bytes.iter().find(|b| !b.is_ascii_whitespace()) == Some(&b'{')
}

/// Returns true if bytes are JSON that has panels where a specification has them.
pub(super) fn is_specification(bytes: &[u8]) -> bool {
    let document = serde_json::from_slice::<Value>(without_mark(bytes));
    document.is_ok_and(|document| document["pattern"]["panels"].is_object())
}

/// Returns the bytes without a UTF-8 byte order mark.
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
        let fault = Fault::new(PatternCode::TooLarge, "", detail);
        return Err(fault.fix("split the garment").into());
    }
    let bytes = without_mark(bytes);
    check_size(bytes, limits)?;
    let document = parse::parse(bytes)?;
    let root = JsonNode::root(&document);
    if !document["pattern"]["panels"].is_object() {
        return Err(not_garmentcode(&document).into());
    }
    let mut findings = SpecFindings::default();
    let pattern = read(&root, options, limits, &mut findings);
    let warnings = std::mem::take(&mut findings.warnings);
    Faults(findings.into_faults()).or(Pattern {
        warnings,
        ..pattern
    })
}

/// Checks the lists and texts of a file before it is read.
fn check_size(bytes: &[u8], limits: &Limits) -> Result<(), Faults> {
    let elsewhere = AnyPlace {
        memory: limits.json_memory_bytes / MEMORY_SHARE,
        ..AnyPlace::of_requests(limits)
    };
    // What is a little over its limit is read and told as a fault of the pattern.
    let panels = ("/pattern/panels", 2 * limits.panels);
    let points = ("/pattern/panels/*/vertices", 2 * limits.panel_vertices);
    let edges = ("/pattern/panels/*/edges", 2 * limits.panel_vertices);
    let size = measure(bytes, &JsonBounds::new(elsewhere, [panels, points, edges]));
    Faults(size.faults).or(())
}

fn not_garmentcode(document: &Value) -> Fault {
    let fix = if document.get("panels").is_some() || document.get("seams").is_some() {
        "a Pattern or a Garment as JSON is sent to POST /v1/fits; here go DXF and GarmentCode files"
    } else {
        "upload a DXF, or a GarmentCode specification: {\"pattern\": {\"panels\": {...}, \"stitches\": [...]}}"
    };
    let detail = "the JSON is no GarmentCode specification: it has no /pattern/panels";
    Fault::new(PatternCode::NotGarmentcode, "", detail).fix(fix)
}

/// Reads a specification as far as it goes; its faults are added to `findings`.
fn read(
    root: &JsonNode<'_>,
    options: &ImportOptions,
    limits: &Limits,
    findings: &mut SpecFindings,
) -> Pattern {
    let known = [&["pattern", "properties"][..], &PARAMETRIC].concat();
    root.fields(&known, findings);
    warn_of_parameters(root, findings);
    if let Some(size) = &options.size {
        let detail = format!("the file has no size {size:?}");
        let fault = Fault::new(PatternCode::UnknownSize, "", detail);
        findings.fault(fault.fix("leave size out: a GarmentCode file holds one size"));
    }
    let (conventions, units) = conventions::read(root, options, limits, findings);
    let source = Source {
        format: PatternFormat::GarmentCode,
        units,
        scale_to_m: conventions.scale,
        sample_size: None,
        sizes: Vec::new(),
        allowance: Allowance::None,
    };
    let mut pattern = Pattern {
        id: None,
        name: name(options, limits),
        source,
        panels: Vec::new(),
        seams: Vec::new(),
        placements: BTreeMap::new(),
        warnings: Vec::new(),
    };
    if let Some(node) = root.get("pattern") {
        add_panels(&mut pattern, &node, &conventions, findings);
    }
    pattern
}

/// Warns of parameters, which are not kept.
fn warn_of_parameters(root: &JsonNode<'_>, findings: &mut SpecFindings) {
    for name in PARAMETRIC {
        let Some(node) = root.get(name) else { continue };
        let is_empty = match node.value {
            Value::Array(items) => items.is_empty(),
            Value::Object(fields) => fields.is_empty(),
            other => other.is_null(),
        };
        if !is_empty {
            let detail = format!("{name} are not kept: panels are read as they are drawn");
            findings.warn(PatternCode::ParametersIgnored, &node.pointer, detail);
        }
    }
}

/// Returns the name of the file without the suffix that its writer adds.
fn name(options: &ImportOptions, limits: &Limits) -> String {
    let name = options.name.as_deref().unwrap_or("pattern");
    let name = name.strip_suffix("_specification").unwrap_or(name);
    name.chars().take(limits.name_chars).collect()
}

/// Adds panels, placements and seams to `pattern`.
fn add_panels(
    pattern: &mut Pattern,
    node: &JsonNode<'_>,
    conventions: &Conventions<'_>,
    findings: &mut SpecFindings,
) {
    let known = ["panels", "stitches", "panel_order", "new_panel_order"];
    node.fields(&known, findings);
    let Some(entries) = node.get("panels").map(|panels| panels.entries(findings)) else {
        return;
    };
    let limits = conventions.limits;
    if let Err(fault) = check_panel_count(entries.len(), limits) {
        findings.fault(fault);
        return;
    }
    let names: Vec<String> = entries.iter().map(|(name, _)| (*name).to_owned()).collect();
    let mut drawn_panels = stitches::DrawnPanels::new();
    let mut panels: Vec<Panel> = Vec::with_capacity(entries.len());
    for ((name, node), id) in entries.iter().zip(ids::from_names(&names, &pattern.name)) {
        let mut drawn = panel::read((*name, node), conventions, findings);
        if let Some(drawn) = &mut drawn {
            drawn.panel.id.clone_from(&id);
        }
        let placement = placement::read(node, drawn.as_ref(), conventions, findings);
        pattern.placements.extend(placement.map(|p| (id, p)));
        panels.extend(drawn.as_ref().map(|drawn| drawn.panel.clone()));
        drawn_panels.insert(name, drawn);
        if findings.points > limits.dxf_vertices {
            let detail = format!(
                "the outlines up to here have more than {} points",
                limits.dxf_vertices
            );
            findings.fault(node.fault(PatternCode::TooLarge, detail, "split the garment"));
            return;
        }
    }
    pattern.panels = panels;
    if let Some(stitches) = node.get("stitches") {
        pattern.seams = stitches::read(&stitches, &drawn_panels, limits, findings);
    }
}

fn check_panel_count(count: usize, limits: &Limits) -> Result<(), Fault> {
    let code = match count {
        0 => PatternCode::NoPanels,
        count if count > limits.panels => PatternCode::TooManyPanels,
        _ => return Ok(()),
    };
    let detail = format!("{count} panels; 1 to {} are read", limits.panels);
    Err(Fault::new(code, "/pattern/panels", detail).fix("split the garment"))
}
