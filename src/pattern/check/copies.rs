//! The mirrored copies of a pattern that came as JSON.

use crate::fault::{Fault, PatternCode};
use crate::pattern::mirror::{MIRROR, mirrored};
use crate::pattern::{Edge, Panel, Pattern, Point2};

/// Checks the copies of a pattern and makes each the exact image of its source: a copy is named
/// after its source and is its mirror image to `tolerance` \[m\], which is how JSON writers round.
pub(super) fn check_copies(pattern: &mut Pattern, tolerance: f64) -> Vec<Fault> {
    let mut faults = Vec::new();
    for i in 0..pattern.panels.len() {
        let panel = &pattern.panels[i];
        if panel.copy_of.is_none() && !panel.id.ends_with(MIRROR) {
            continue;
        }
        match exact_image(pattern, panel, tolerance) {
            Ok(image) => pattern.panels[i] = image,
            Err(fault) => {
                let pointer = format!("/panels/{i}/{}", fault.pointer);
                faults.push(Fault { pointer, ..fault });
            }
        }
    }
    faults
}

/// Returns the exact image for a copy, under its own name; the pointer of a fault is the field.
fn exact_image(pattern: &Pattern, copy: &Panel, tolerance: f64) -> Result<Panel, Fault> {
    let Some(of) = &copy.copy_of else {
        let detail = format!("ids that end in {MIRROR} are those of mirrored copies");
        return Err(Fault::new(PatternCode::Id, "id", detail).fix("give copy_of, or another id"));
    };
    let source = pattern.panels.iter().find(|panel| panel.id == *of);
    let Some(source) = source.filter(|source| source.copy_of.is_none()) else {
        let detail = format!("there is no panel {of:?} to be a copy of");
        let fault = Fault::new(PatternCode::UnknownPanel, "copy_of", detail);
        return Err(fault.fix("name a panel of this pattern that is no copy"));
    };
    let image = mirrored(source);
    if copy.id != image.id {
        let detail = format!("the mirrored copy of {of:?} has the id {:?}", image.id);
        return Err(Fault::new(PatternCode::Id, "id", detail).fix("use it"));
    }
    if let Some(field) = difference(copy, &image, tolerance) {
        let detail = format!("it is not that of {of:?} reflected x -> -x");
        let fix = format!("leave the panel out: naming {:?} makes it", image.id);
        return Err(Fault::new(PatternCode::NotMirrored, field, detail).fix(fix));
    }
    let name = copy.name.clone();
    Ok(Panel { name, ..image })
}

/// Returns the first field in which two panels differ. Coordinates are compared to `tolerance`
/// \[m\]; lengths and areas, which follow from them, are not.
fn difference(a: &Panel, b: &Panel, tolerance: f64) -> Option<&'static str> {
    let is_line = |a: &Vec<Point2>, b: &Vec<Point2>| is_same_line(a, b, tolerance);
    let is_outline = |a: &[Edge], b: &[Edge]| {
        is_same_list(a, b, |a, b| {
            is_line(&a.points, &b.points) && a.label == b.label
        })
    };
    let is_same = [
        ("edges", is_outline(&a.edges, &b.edges)),
        (
            "holes",
            is_same_list(&a.holes, &b.holes, |a, b| is_outline(&a.edges, &b.edges)),
        ),
        ("cut_line", is_line(&a.cut_line, &b.cut_line)),
        ("drill_holes", is_line(&a.drill_holes, &b.drill_holes)),
        ("notches", a.notches == b.notches),
        ("grain", turn_of_grain(a, b).abs() <= 1e-6),
        (
            "internal_lines",
            is_same_list(&a.internal_lines, &b.internal_lines, is_line),
        ),
        ("face", a.face == b.face),
        ("label", a.label == b.label),
        ("unfolded", a.unfolded == b.unfolded),
    ];
    is_same
        .into_iter()
        .find_map(|(field, is_same)| (!is_same).then_some(field))
}

fn is_same_list<T>(a: &[T], b: &[T], is_same: impl Fn(&T, &T) -> bool) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_same(a, b))
}

fn is_same_line(a: &[Point2], b: &[Point2], tolerance: f64) -> bool {
    let is_near = |a: &f64, b: &f64| (a - b).abs() <= tolerance;
    is_same_list(a, b, |a, b| is_same_list(a, b, is_near))
}

/// Returns the angle between two grain lines \[degrees\]; infinite where only one panel has one.
fn turn_of_grain(a: &Panel, b: &Panel) -> f64 {
    let angle = |panel: &Panel| panel.grain.map(|grain| grain.angle_deg);
    match (angle(a), angle(b)) {
        (Some(a), Some(b)) => (a - b + 90.0).rem_euclid(180.0) - 90.0,
        (None, None) => 0.0,
        _ => f64::INFINITY,
    }
}
