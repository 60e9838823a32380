//! A drape that begins with the shape of an earlier one (P12), or with flat panels.

use super::costs;
use super::crossings;
use super::garment::{StartPanel, StartShape};
use crate::fault::{GarmentCode, Warning};
use crate::mesh::{ClothMesh, Locator, PanelRange};
use crate::pattern::{Point2, polyline};
use crate::scene::Scene;
use crate::solver::{self, Context, Drape, SolverOptions};
use nalgebra::Vector3;

/// Depth inside the body at which an earlier shape is no start \[m\]: a body of other measures
/// moves its skin by less.
const DEEPEST: f64 = 0.03;
/// Change of a panel's width or height that is more than rounding \[m\].
const SAME: f64 = 1e-6;
/// Most that a panel may be wider or longer than the earlier one, as a share.
const MOST_SCALE: f64 = 1.25;
/// Least barycentric coordinate of a point in the earlier panel: outside of it by half a mesh edge.
const OUTSIDE: f64 = -0.5;
/// Share of the time allowed that has to be left for sewing from flat panels after all.
const ENOUGH: f64 = 0.5;

/// Drapes a scene whose panels have these names: on from `start` where that is a start and leads to
/// rest without crossings, else from its flat panels; with the warning why not from the start.
pub(super) fn drape(
    (scene, names): (&Scene, &[&str]),
    start: Option<&StartShape>,
    options: &SolverOptions,
    context: &mut Context<'_>,
) -> (Drape, Option<Warning>) {
    let Some(start) = start else {
        return (solver::drape(scene, options, context), None);
    };
    let began = (context.cpu_s)();
    let positions = positions(scene, names, start);
    let positions = positions.and_then(|positions| {
        uncrossed(scene, names, &positions, context.limits.crossing_pairs)?;
        Ok(positions)
    });
    let (reason, tried) = match positions {
        Err(reason) => (reason, None),
        Ok(positions) => {
            let drape = solver::drape_from(scene, options, &positions, context);
            let spent = (context.cpu_s)() - began;
            let has_time = options
                .time_limit_s
                .is_none_or(|limit| limit - spent > ENOUGH * limit);
            if drape.canceled {
                return (drape, None);
            }
            match failure(scene, names, &drape, context.limits.crossing_pairs) {
                None => return (drape, None),
                Some(reason) if has_time => (reason, Some(drape)),
                Some(reason) => return (drape, Some(no_time(&reason))),
            }
        }
    };
    let left = options.less_spent((context.cpu_s)() - began);
    let mut drape = solver::drape(scene, &left, context);
    if let Some(tried) = tried {
        costs::add(&mut drape.report, tried.report);
    }
    let detail =
        format!("it was sewn from flat panels, not from the shape in start_from: {reason}");
    let warning = Warning::new(GarmentCode::StartLeft, "/start_from", detail);
    (drape, Some(warning))
}

/// Returns the warning of a drape from an earlier shape that is kept for want of time.
fn no_time(reason: &str) -> Warning {
    let detail = format!(
        "{reason}; too little of the time allowed was left to sew it from flat panels: leave start_from out, or allow more time"
    );
    Warning::new(GarmentCode::StartLeft, "/start_from", detail)
}

/// Returns in words why a drape from an earlier shape is not taken, if it is not.
fn failure(scene: &Scene, names: &[&str], drape: &Drape, pairs: usize) -> Option<String> {
    if !drape.report.converged {
        return Some(format!(
            "from there it did not come to rest: {}",
            drape.report.why
        ));
    }
    uncrossed(scene, names, &drape.positions, pairs).err()
}

/// Checks that a shape does not pass through itself, where it must not.
///
/// # Errors
/// The number of crossings, in words, or that it could not be counted.
fn uncrossed(
    scene: &Scene,
    names: &[&str],
    positions: &[Vector3<f64>],
    pairs: usize,
) -> Result<(), String> {
    if !scene.self_contact {
        return Ok(());
    }
    let found = crossings::find(scene, names, positions, pairs);
    let found = found.ok_or("its crossings could not be counted")?;
    match found.cloth {
        0 => Ok(()),
        count => Err(format!("{count} pairs of triangles of cloth meet there")),
    }
}

/// Returns where an earlier shape has the vertices of a scene \[m; `#V`\].
///
/// # Errors
/// In words, what keeps it from being a start.
fn positions(
    scene: &Scene,
    names: &[&str],
    start: &StartShape,
) -> Result<Vec<Vector3<f64>>, String> {
    let mut positions = Vec::with_capacity(scene.start.len());
    for (name, range) in names.iter().zip(&scene.mesh.panels) {
        let earlier = start.panels.iter().find(|panel| panel.panel == *name);
        let earlier = earlier.ok_or_else(|| format!("it has no panel {name}"))?;
        let places = interpolated(&scene.mesh.uv[range.vertices.clone()], earlier);
        positions.extend(places.ok_or_else(|| format!("its panel {name} has another outline"))?);
    }
    let depth = |p: &Vector3<f64>| {
        let body = scene.body.as_ref();
        body.map_or(0.0, |body| -body.exact_distance(p))
    };
    let deepest = positions.iter().map(depth).fold(0.0, f64::max);
    if deepest > DEEPEST {
        let millimeters = 1e3 * deepest;
        return Err(format!("it lies {millimeters:.0} mm inside the body"));
    }
    Ok(positions)
}

/// Returns where an earlier panel has the points `uv` of the pattern; none where the panel has
/// changed too much: one of them is too far outside of it. A panel that has become a little wider
/// or longer is first scaled to the earlier size.
fn interpolated(uv: &[Point2], earlier: &StartPanel) -> Option<Vec<Vector3<f64>>> {
    let triangles = earlier.triangles.iter();
    let mesh = ClothMesh {
        uv: earlier.uv.clone(),
        triangles: triangles.map(|t| t.map(|v| v as usize)).collect(),
        panels: vec![PanelRange {
            vertices: 0..earlier.uv.len(),
            triangles: 0..earlier.triangles.len(),
            corners: vec![],
        }],
        stitches: vec![],
    };
    let locator = Locator::new(&mesh, 0);
    let scale = Scale::between(uv, &earlier.uv)?;
    let position = |p: &Point2| {
        let corners = locator.weights(scale.apply(*p))?;
        let is_inside = corners.iter().all(|(_, w)| *w >= OUTSIDE);
        let places = corners.map(|(v, w)| Vector3::from(earlier.positions[v]) * w);
        is_inside.then(|| places.iter().sum())
    };
    uv.iter().map(position).collect()
}

/// The scaling of a panel's drawing to its earlier size, along both axes.
struct Scale {
    low: Point2,
    earlier_low: Point2,
    ratio: [f64; 2],
}

impl Scale {
    /// The scaling that takes the bounding box of `uv` to that of `earlier`; none where one is much
    /// larger than the other. Where they are the same nothing is moved by rounding.
    fn between(uv: &[Point2], earlier: &[Point2]) -> Option<Self> {
        let [[low, high], [earlier_low, earlier_high]] = [uv, earlier].map(polyline::bounds);
        let mut scale = Self {
            low,
            earlier_low,
            ratio: [1.0; 2],
        };
        for k in 0..2 {
            let [length, before] = [high[k] - low[k], earlier_high[k] - earlier_low[k]];
            if (length - before).abs() >= SAME {
                scale.ratio[k] = before / length;
            }
            if (low[k] - earlier_low[k]).abs() < SAME {
                scale.earlier_low[k] = low[k];
            }
        }
        let is_near = |ratio: &f64| (1.0 / MOST_SCALE..=MOST_SCALE).contains(ratio);
        scale.ratio.iter().all(is_near).then_some(scale)
    }

    fn apply(&self, p: Point2) -> Point2 {
        [0, 1].map(|k| {
            if self.ratio[k] == 1.0 && self.low[k] == self.earlier_low[k] {
                p[k]
            } else {
                self.earlier_low[k] + (p[k] - self.low[k]) * self.ratio[k]
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rectangle in two triangles, bent up along its diagonal.
    fn earlier(width: f64, height: f64) -> StartPanel {
        StartPanel {
            panel: "front".to_owned(),
            positions: vec![
                [0.0; 3],
                [width, 0.0, 0.0],
                [width, height, 0.1],
                [0.0, height, 0.0],
            ],
            uv: vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
        }
    }

    #[test]
    fn the_same_panel_lies_where_it_lay() {
        let uv = [[0.0, 0.0], [0.4, 0.0], [0.4, 0.2], [0.0, 0.2], [0.2, 0.1]];
        let places = interpolated(&uv, &earlier(0.4, 0.2)).expect("the same outline");
        assert_eq!(places[1], Vector3::new(0.4, 0.0, 0.0));
        // Half way along the diagonal.
        assert!((places[4] - Vector3::new(0.2, 0.1, 0.05)).norm() < 1e-15);
    }

    #[test]
    fn a_wider_panel_is_scaled_and_a_much_wider_one_is_another() {
        let wider = |width: f64| [[0.0, 0.0], [width, 0.0], [width, 0.2], [0.0, 0.2]];
        let places = interpolated(&wider(0.44), &earlier(0.4, 0.2)).expect("a little wider");
        assert!((places[2] - Vector3::new(0.4, 0.2, 0.1)).norm() < 1e-12);
        assert_eq!(interpolated(&wider(0.8), &earlier(0.4, 0.2)), None);
    }

    #[test]
    fn a_panel_that_has_cloth_where_there_was_none_is_another() {
        // Of the earlier panel only the lower half is left.
        let mut half = earlier(0.4, 0.2);
        half.triangles.pop();
        let uv = [[0.0, 0.0], [0.4, 0.0], [0.4, 0.2], [0.0, 0.2]];
        assert_eq!(interpolated(&uv, &half), None);
    }
}
