//! A drape that begins with the shape of an earlier one (P12), or with flat panels.

use super::garment::{StartPanel, StartShape};
use crate::fault::{GarmentCode, Warning};
use crate::mesh::{ClothMesh, Locator, PanelRange};
use crate::pattern::{Point2, polyline};
use crate::scene::Scene;
use crate::solver::{self, Context, Drape, SolverOptions, StartedFrom};
use nalgebra::Vector3;

/// Depth inside the body at which an earlier shape is no start \[m\]: a body of other measures
/// moves its skin by less.
const DEEPEST: f64 = 0.03;
/// Change of a panel's width or height that is more than rounding \[m\].
const SAME: f64 = 1e-6;

/// Drapes a scene whose panels have these names: on from `start` where that leads to rest, else
/// from its flat panels; with the warning why not from the start.
pub(super) fn drape(
    (scene, names): (&Scene, &[&str]),
    start: Option<&StartShape>,
    options: &SolverOptions,
    context: &mut Context<'_>,
) -> (Drape, Option<Warning>) {
    let Some(start) = start else {
        return (solver::drape(scene, options, context), None);
    };
    let reason = match positions(scene, names, start) {
        Ok(positions) => {
            let mut drape = solver::drape_from(scene, options, &positions, context);
            if drape.report.converged || drape.canceled || options.time_limit_s.is_some() {
                drape.report.started_from = Some(StartedFrom {
                    energy_j: start.energy_j,
                });
                return (drape, None);
            }
            format!("from there it did not come to rest: {}", drape.report.why)
        }
        Err(reason) => reason,
    };
    let detail =
        format!("it was sewn from flat panels, not from the shape in start_from: {reason}");
    let warning = Warning::new(GarmentCode::StartLeft, "/start_from", detail);
    (solver::drape(scene, options, context), Some(warning))
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
        let carried = carried(&scene.mesh.uv[range.vertices.clone()], earlier);
        positions.extend(carried.ok_or_else(|| format!("its panel {name} has another outline"))?);
    }
    let depth = |p: &Vector3<f64>| {
        scene
            .body
            .as_ref()
            .map_or(0.0, |body| -body.exact_distance(p))
    };
    let deepest = positions.iter().map(depth).fold(0.0, f64::max);
    if deepest > DEEPEST {
        let millimeters = 1e3 * deepest;
        return Err(format!(
            "it lies {millimeters:.0} mm inside the body, which is another one"
        ));
    }
    Ok(positions)
}

/// Returns where an earlier panel has the points `uv` of the pattern; none where one of them is too
/// far from it. A panel that has become wider or longer is first brought to the earlier size.
fn carried(uv: &[Point2], earlier: &StartPanel) -> Option<Vec<Vector3<f64>>> {
    let mesh = ClothMesh {
        uv: earlier.uv.clone(),
        triangles: earlier
            .triangles
            .iter()
            .map(|t| t.map(|v| v as usize))
            .collect(),
        panels: vec![PanelRange {
            vertices: 0..earlier.uv.len(),
            triangles: 0..earlier.triangles.len(),
            corners: vec![],
        }],
        stitches: vec![],
    };
    let locator = Locator::new(&mesh, 0);
    let [low, high] = polyline::bounds(uv);
    let [earlier_low, earlier_high] = polyline::bounds(&earlier.uv);
    let brought = |p: &Point2| {
        [0, 1].map(|k| {
            let [length, earlier] = [high[k] - low[k], earlier_high[k] - earlier_low[k]];
            let is_same = (low[k] - earlier_low[k]).abs() < SAME && (length - earlier).abs() < SAME;
            if is_same || length <= 0.0 {
                p[k]
            } else {
                earlier_low[k] + (p[k] - low[k]) * (earlier / length)
            }
        })
    };
    let position = |p: &Point2| {
        let corners = locator.weights(brought(p))?;
        let places = corners.map(|(v, w)| Vector3::from(earlier.positions[v]) * w);
        Some(places.iter().sum())
    };
    uv.iter().map(position).collect()
}
