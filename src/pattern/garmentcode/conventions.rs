//! The meaning of the numbers of a specification, from its properties and the options of the
//! import.

use super::findings::SpecFindings;
use super::node::JsonNode;
use crate::config::Limits;
use crate::fault::PatternCode;
use crate::pattern::point::is_readable;
use crate::pattern::{ImportOptions, Point2, RotationOrder, Units};

/// Units per meter where the file does not say: centimeters.
const USUAL: f64 = 100.0;

/// The meaning of the numbers of a file.
pub(super) struct Conventions<'a> {
    pub(super) limits: &'a Limits,
    /// Meters per unit.
    pub(super) scale: f64,
    /// True if control points are relative to their edge.
    pub(super) relative: bool,
    /// True if the loops were drawn so that their sign states the face.
    pub(super) states_faces: bool,
    /// True if panels turn about the mean of their vertices.
    pub(super) about_mean: bool,
    pub(super) rotation_order: RotationOrder,
}

impl Conventions<'_> {
    /// Returns a text, cut to the length of a name.
    pub(super) fn short(&self, text: &str) -> String {
        text.chars().take(self.limits.name_chars).collect()
    }

    /// Reads the label of an object; `None` where it is empty.
    pub(super) fn label(&self, node: &JsonNode<'_>, findings: &mut SpecFindings) -> Option<String> {
        let text = node.get("label")?.text(findings)?;
        (!text.is_empty()).then(|| self.short(text))
    }

    /// Reads a point of the plane \[m\].
    pub(super) fn point(&self, node: &JsonNode<'_>, findings: &mut SpecFindings) -> Option<Point2> {
        let point = node.numbers::<2>(findings)?.map(|c| c * self.scale);
        if is_readable(point) {
            return Some(point);
        }
        let detail = "a coordinate is beyond 10 km";
        findings.fault(node.fault(PatternCode::NotFinite, detail, "correct it"));
        None
    }
}

/// Reads the meaning of the numbers, and the name of their unit.
pub(super) fn read<'a>(
    root: &JsonNode<'_>,
    options: &ImportOptions,
    limits: &'a Limits,
    findings: &mut SpecFindings,
) -> (Conventions<'a>, String) {
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
    let get = |name| properties.as_ref().and_then(|node| node.get(name));
    let per_meter = match get("units_in_meter") {
        Some(node) => units_in_meter(&node, findings),
        None => {
            if options.units.is_none() {
                let detail = "the file does not say its units; cm was taken (units= overrides)";
                findings.warn(PatternCode::UnitsAssumed, "/properties", detail);
            }
            USUAL
        }
    };
    let relative = match get("curvature_coords") {
        Some(node) => curvature_coords(&node, findings),
        None => true,
    };
    let mut flag = |name| {
        get(name)
            .and_then(|node| node.flag(findings))
            .unwrap_or(false)
    };
    let conventions = Conventions {
        limits,
        scale: options.units.map_or(1.0 / per_meter, Units::in_meters),
        relative,
        states_faces: flag("normalized_edge_loops"),
        about_mean: flag("normalize_panel_translation"),
        rotation_order: options.rotation_order,
    };
    let units = options
        .units
        .map_or_else(|| unit_name(per_meter), |units| units.name().to_owned());
    (conventions, units)
}

/// Returns the name of a unit of which `per_meter` make a meter.
fn unit_name(per_meter: f64) -> String {
    let known = [Units::Mm, Units::Cm, Units::M, Units::Inch];
    let found = known
        .into_iter()
        .find(|units| (units.in_meters() * per_meter - 1.0).abs() < 1e-3);
    found.map_or_else(
        || format!("1/{per_meter} m"),
        |units| units.name().to_owned(),
    )
}

/// Reads the number of units that make a meter.
fn units_in_meter(node: &JsonNode<'_>, findings: &mut SpecFindings) -> f64 {
    let given = node.number(findings);
    let found = given.filter(|n| (1e-3..=1e6).contains(n));
    if found.is_none() && given.is_some() {
        let detail = "units_in_meter is how many units make a meter";
        findings.fault(node.fault(PatternCode::Field, detail, "give 100 for centimeters"));
    }
    found.unwrap_or(USUAL)
}

/// Reads the frame of control points; true if it is that of their edge.
fn curvature_coords(node: &JsonNode<'_>, findings: &mut SpecFindings) -> bool {
    match node.text(findings) {
        Some("absolute") => false,
        Some("relative") | None => true,
        Some(_) => {
            let detail = "curvature_coords is \"relative\" or \"absolute\"";
            findings.fault(node.fault(PatternCode::Field, detail, "correct it"));
            true
        }
    }
}
