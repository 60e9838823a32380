//! The limits of the lists and texts of a garment.

use crate::config::Limits;
use crate::json::{AnyPlace, JsonBounds};

/// Triangles per vertex that a surface of cloth or a body never has more of.
const TRIANGLES_PER_VERTEX: usize = 3;

/// Returns the bounds of a garment's JSON.
pub(crate) fn garment_bounds(limits: &Limits) -> JsonBounds {
    let points = limits.panel_vertices;
    // Mirrored copies stand beside the panels that were drawn.
    let panels = 2 * limits.panels;
    let lists = [
        ("/seams", limits.seams),
        ("/seams/*/a", limits.seam_runs),
        ("/seams/*/b", limits.seam_runs),
        ("/panels", panels),
        ("/panels/*/elastic", limits.elastic_edges),
        ("/fabrics", limits.garment_fabrics),
        ("/pins", limits.pins),
        ("/maps", limits.maps),
        ("/pattern/panels", panels),
        ("/pattern/seams", limits.seams),
        ("/pattern/seams/*/a", limits.seam_runs),
        ("/pattern/seams/*/b", limits.seam_runs),
        ("/pattern/placements", panels),
        ("/pattern/panels/*/corners", points),
        ("/pattern/panels/*/edges", points),
        ("/pattern/panels/*/edges/*/points", points),
        ("/pattern/panels/*/holes", points),
        ("/pattern/panels/*/holes/*/corners", points),
        ("/pattern/panels/*/holes/*/edges", points),
        ("/pattern/panels/*/holes/*/edges/*/points", points),
        ("/pattern/panels/*/cut_line", points),
        ("/pattern/panels/*/drill_holes", points),
        ("/pattern/panels/*/notches", points),
        ("/pattern/panels/*/internal_lines", points),
        ("/pattern/panels/*/internal_lines/*", points),
        ("/avatar/body/vertices", limits.body_vertices),
        ("/avatar/body/triangles", limits.body_triangles),
        ("/over/avatar/body/vertices", limits.body_vertices),
        ("/over/avatar/body/triangles", limits.body_triangles),
        ("/over/panels/*/positions", limits.mesh_vertices),
        (
            "/over/panels/*/triangles",
            TRIANGLES_PER_VERTEX * limits.mesh_vertices,
        ),
        ("/start_from/avatar/body/vertices", limits.body_vertices),
        ("/start_from/avatar/body/triangles", limits.body_triangles),
        ("/start_from/panels", panels),
        ("/start_from/panels/*/positions", limits.mesh_vertices),
        ("/start_from/panels/*/uv", limits.mesh_vertices),
        (
            "/start_from/panels/*/triangles",
            TRIANGLES_PER_VERTEX * limits.mesh_vertices,
        ),
    ];
    JsonBounds::new(AnyPlace::of_requests(limits), lists)
}
