//! Mirrored copies: the panel `sleeve~mirror` is `sleeve` reflected x -> -x.
//!
//! Corners, edges and notches keep their numbers and `cw` still means increasing index, so that the outline of a copy
//! runs counter-clockwise in its coordinates and its holes clockwise. The drawn side stays the drawn side: a copy has
//! the face that its source has.

use super::point::Point2;
use super::{Corner, Edge, Grain, Hole, Panel, Pattern, Placement, PlacementAnchor};
use crate::fault::{Fault, Warning};
use std::borrow::Cow;
use std::collections::BTreeSet;

/// What the id of a mirrored copy has after that of its source.
pub const MIRROR: &str = "~mirror";

impl Pattern {
    /// The pattern with those mirrored copies that are named: `X~mirror` for each panel X that is there and no copy
    /// itself. They come after all other panels, in the pattern's order, placed as the mirror images of their sources; names of
    /// anything else are left to others.
    pub fn with_copies<'a>(&self, names: impl IntoIterator<Item = &'a str>) -> Cow<'_, Self> {
        let wanted = names
            .into_iter()
            .filter_map(|name| name.strip_suffix(MIRROR));
        let mut wanted: BTreeSet<&str> = wanted.collect();
        for panel in &self.panels {
            wanted.remove(panel.id.strip_suffix(MIRROR).unwrap_or(""));
        }
        let sources = self.panels.iter();
        let sources = sources.filter(|p| p.copy_of.is_none() && wanted.contains(p.id.as_str()));
        let copies: Vec<Panel> = sources.map(mirrored).collect();
        if copies.is_empty() {
            return Cow::Borrowed(self);
        }
        let mut pattern = self.clone();
        for copy in &copies {
            let source = copy.copy_of.as_ref().and_then(|id| self.placements.get(id));
            let placement = source.map(|source| (copy.id.clone(), source.mirrored()));
            pattern.placements.extend(placement);
        }
        pattern.panels.extend(copies);
        Cow::Owned(pattern)
    }
}

impl Placement {
    /// The mirror image of this placement about the body's middle, for a mirrored copy.
    ///
    /// With S the reflection x -> -x, a copy's point S v goes to S (R v + t) = (S R S) S v + S t.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let [x, y, z] = self.offset_m;
        let [about_x, about_y, about_z] = self.rotate_deg;
        Self {
            at: self.at.map(|at| match at {
                PlacementAnchor::ArmLeft => PlacementAnchor::ArmRight,
                PlacementAnchor::ArmRight => PlacementAnchor::ArmLeft,
                PlacementAnchor::ArmLeftFront => PlacementAnchor::ArmRightFront,
                PlacementAnchor::ArmRightFront => PlacementAnchor::ArmLeftFront,
                PlacementAnchor::ArmLeftBack => PlacementAnchor::ArmRightBack,
                PlacementAnchor::ArmRightBack => PlacementAnchor::ArmLeftBack,
                other => other,
            }),
            up_deg: self.up_deg.map(|angle| 180.0 - angle),
            offset_m: [-x, y, z],
            rotate_deg: [about_x, -about_y, -about_z],
            wrap: self.wrap,
        }
    }
}

/// Adds the copies that the file itself asks for by its quantities, and warns where it does not say whether pieces are
/// a mirrored pair.
pub(super) fn add_stated(panels: &mut Vec<Panel>) -> Vec<Warning> {
    let stated = |panel: &&Panel| panel.quantity.is_some_and(|quantity| quantity.right > 0);
    let copies: Vec<Panel> = panels.iter().filter(stated).map(mirrored).collect();
    let unclear = panels.iter().enumerate().filter(|(_, panel)| {
        let several = panel.quantity.is_some_and(|q| q.left > 1 && q.right == 0);
        several && !panel.unfolded
    });
    let warnings = unclear.map(|(i, panel)| {
        let count = panel.quantity.map_or(0, |quantity| quantity.left);
        let id = &panel.id;
        let detail = format!(
            "{count} of {id:?} are cut, and the file does not say whether they are a mirrored pair; \
             {id}{MIRROR} in a seam is the mirrored one"
        );
        Warning::new("pattern/quantity", format!("/panels/{i}/quantity"), detail)
    });
    let warnings = warnings.collect();
    panels.extend(copies);
    warnings
}

/// The mirrored copy of a panel.
pub(super) fn mirrored(source: &Panel) -> Panel {
    let line = |points: &Vec<Point2>| points.iter().copied().map(reflected).collect();
    let edges = |edges: &[Edge]| {
        let edge = |edge: &Edge| Edge {
            points: line(&edge.points),
            ..edge.clone()
        };
        edges.iter().map(edge).collect()
    };
    let corners = |corners: &[Corner]| {
        let corner = |corner: &Corner| Corner {
            x: reflected([corner.x, corner.y])[0],
            ..*corner
        };
        corners.iter().map(corner).collect()
    };
    let hole = |hole: &Hole| Hole {
        corners: corners(&hole.corners),
        edges: edges(&hole.edges),
    };
    let grain = source.grain.map(|grain| Grain {
        angle_deg: (180.0 - grain.angle_deg).rem_euclid(180.0),
    });
    Panel {
        id: format!("{}{MIRROR}", source.id),
        copy_of: Some(source.id.clone()),
        quantity: None,
        corners: corners(&source.corners),
        edges: edges(&source.edges),
        holes: source.holes.iter().map(hole).collect(),
        cut_line: line(&source.cut_line),
        drill_holes: line(&source.drill_holes),
        grain,
        internal_lines: source.internal_lines.iter().map(line).collect(),
        ..source.clone()
    }
}

/// A point reflected; 0 stays 0.
fn reflected([x, y]: Point2) -> Point2 {
    [0.0 - x, y]
}

/// Where two panels differ: the field. Coordinates are compared to `within` \[m\]; lengths and areas, which follow from
/// them, are not.
pub(super) fn difference(a: &Panel, b: &Panel, within: f64) -> Option<&'static str> {
    let near = |a: &Point2, b: &Point2| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= within);
    let line = |a: &Vec<Point2>, b: &Vec<Point2>| {
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(a, b))
    };
    let edges = |a: &[Edge], b: &[Edge]| {
        let same = |(a, b): (&Edge, &Edge)| line(&a.points, &b.points) && a.label == b.label;
        a.len() == b.len() && a.iter().zip(b).all(same)
    };
    let holes = a.holes.iter().zip(&b.holes);
    let lines = a.internal_lines.iter().zip(&b.internal_lines);
    let angle = |panel: &Panel| panel.grain.map(|grain| grain.angle_deg);
    let turn = match (angle(a), angle(b)) {
        (Some(a), Some(b)) => (a - b + 90.0).rem_euclid(180.0) - 90.0,
        (None, None) => 0.0,
        _ => f64::INFINITY,
    };
    let same = [
        ("edges", edges(&a.edges, &b.edges)),
        (
            "holes",
            a.holes.len() == b.holes.len()
                && holes.into_iter().all(|(a, b)| edges(&a.edges, &b.edges)),
        ),
        ("cut_line", line(&a.cut_line, &b.cut_line)),
        ("drill_holes", line(&a.drill_holes, &b.drill_holes)),
        ("notches", a.notches == b.notches),
        ("grain", turn.abs() <= 1e-6),
        (
            "internal_lines",
            a.internal_lines.len() == b.internal_lines.len()
                && lines.into_iter().all(|(a, b)| line(a, b)),
        ),
        ("face", a.face == b.face),
        ("label", a.label == b.label),
        ("unfolded", a.unfolded == b.unfolded),
    ];
    same.into_iter()
        .find_map(|(field, same)| (!same).then_some(field))
}

/// Checks the copies of a pattern and makes each the exact image of its source: a copy is named after its source and
/// is its mirror image to `within` \[m\], which is how JSON writers round.
pub(super) fn verify(pattern: &mut Pattern, within: f64) -> Vec<Fault> {
    let mut faults = Vec::new();
    for i in 0..pattern.panels.len() {
        let panel = &pattern.panels[i];
        let mut wrong = |field: &str, code: &str, detail: String, fix: String| {
            let at = format!("/panels/{i}/{field}");
            faults.push(Fault::new(code, at, detail).fix(fix));
        };
        let Some(of) = &panel.copy_of else {
            if panel.id.ends_with(MIRROR) {
                let detail = format!("ids that end in {MIRROR} are those of mirrored copies");
                let fix = "give copy_of, or another id".to_owned();
                wrong("id", "pattern/id", detail, fix);
            }
            continue;
        };
        let source = pattern.panels.iter().find(|panel| panel.id == *of);
        let Some(source) = source.filter(|source| source.copy_of.is_none()) else {
            let detail = format!("there is no panel {of:?} to be a copy of");
            let fix = "name a panel of this pattern that is no copy".to_owned();
            wrong("copy_of", "pattern/unknown_panel", detail, fix);
            continue;
        };
        let image = mirrored(source);
        if panel.id != image.id {
            let detail = format!("the mirrored copy of {of:?} has the id {:?}", image.id);
            wrong("id", "pattern/id", detail, "use it".to_owned());
        } else if let Some(field) = difference(panel, &image, within) {
            let detail = format!("it is not that of {of:?} reflected x -> -x");
            let fix = format!("leave the panel out: naming {:?} makes it", image.id);
            wrong(field, "pattern/not_mirrored", detail, fix);
        } else {
            let name = panel.name.clone();
            pattern.panels[i] = Panel { name, ..image };
        }
    }
    faults
}
