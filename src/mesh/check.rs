//! Faults of meshing: what is refused before and during it, as sentences for the user.

use super::divide::Divisions;
use super::panel_division::Division;
use super::{geometry, lattice};
use crate::config::Limits;
use crate::fault::{Fault, Faults, FitCode, MeshCode};
use crate::pattern::point::Point2;
use crate::pattern::{Panel, Pattern};

/// A defect that keeps one panel from being meshed.
pub(super) enum MeshDefect {
    /// Two boundary parts cross or touch at this point.
    Crossing(Point2),
    /// A hole that is not inside the outline, by index.
    StrayHole(usize),
    /// An internal line, by index, leaves the cloth near this point.
    LineOutside(usize, Point2),
    /// An internal line, by index, crosses or touches an outline, a hole, a sewn line or itself
    /// near this point.
    LineCrossing(usize, Point2),
}

impl MeshDefect {
    /// Returns the fault of a panel with this defect.
    pub(super) fn fault(&self, panel: &Panel) -> Fault {
        let at = format!("/panels/{}", panel.id);
        let (code, what) = match self {
            Self::Crossing([x, y]) => (
                MeshCode::Crossing,
                format!(
                    "the outline of panel \"{}\" crosses or touches itself near ({x:.4}, {y:.4}) m once it is divided into mesh edges",
                    panel.name
                ),
            ),
            Self::StrayHole(hole) => (
                MeshCode::StrayHole,
                format!("hole {hole} of panel \"{}\" is not inside it", panel.name),
            ),
            Self::LineOutside(line, [x, y]) => (
                MeshCode::LineOutside,
                format!(
                    "internal line {line} of panel \"{}\" leaves the cloth near ({x:.4}, {y:.4}) m, and a seam names it",
                    panel.name
                ),
            ),
            Self::LineCrossing(line, [x, y]) => (
                MeshCode::LineCrossing,
                format!(
                    "internal line {line} of panel \"{}\", which a seam names, crosses or touches the outline, a hole, another such line or itself near ({x:.4}, {y:.4}) m",
                    panel.name
                ),
            ),
        };
        Fault::new(code, at, what).fix(match self {
            Self::Crossing(_) | Self::StrayHole(_) => {
                "mend the panel's outline in the pattern, or ask for a smaller edge_length_m"
            }
            Self::LineOutside(..) | Self::LineCrossing(..) => {
                "let the line lie inside the panel, ending inside or on the outline, or sew to another line"
            }
        })
    }

    /// Returns the same defect of a panel that was meshed as its mirror image.
    pub(super) fn reflected(mut self) -> Self {
        if let Self::Crossing(p) | Self::LineOutside(_, p) | Self::LineCrossing(_, p) = &mut self {
            *p = geometry::reflected(*p);
        }
        self
    }
}

/// The fault of a meshing that was canceled.
pub(super) fn canceled() -> Fault {
    Fault::new(FitCode::Canceled, "", "meshing was stopped on request")
}

/// Refuses a mesh edge length outside the limits.
pub(super) fn edge_length(edge_length: f64, limits: &Limits) -> Result<(), Fault> {
    let [low, high] = limits.edge_length_m;
    if (low..=high).contains(&edge_length) {
        return Ok(());
    }
    Err(Fault::new(
        MeshCode::EdgeLength,
        "/simulate/edge_length_m",
        format!("a mesh edge length of {edge_length} m is outside the limits"),
    )
    .fix(format!("ask for {low} to {high} m")))
}

/// Refuses outlines that are not rings of finite polylines, so that nothing later has to.
pub(super) fn outlines(pattern: &Pattern) -> Result<(), Faults> {
    let mut faults = Faults(vec![]);
    for panel in &pattern.panels {
        let rings = std::iter::once((&panel.corners, &panel.edges));
        let mut rings = rings.chain(panel.holes.iter().map(|hole| (&hole.corners, &hole.edges)));
        let sound = rings.all(|(corners, edges)| {
            !edges.is_empty()
                && corners.len() == edges.len()
                && edges.iter().all(|edge| geometry::is_sound(&edge.points))
        });
        if !sound {
            let what = format!("the outline of panel \"{}\" is not closed", panel.name);
            faults.0.push(
                Fault::new(MeshCode::Outline, format!("/panels/{}", panel.id), what)
                    .fix("give every edge a length and finite points, one edge per corner"),
            );
        }
    }
    faults.or(())
}

/// Estimates the vertex count before the work is begun.
pub(super) fn size(
    pattern: &Pattern,
    divisions: &Divisions,
    edge_length: f64,
    limits: &Limits,
) -> Result<(), Fault> {
    let cell = lattice::ROW * edge_length * edge_length;
    let mut count = 0.0;
    for (panel, divided) in pattern.panels.iter().zip(&divisions.panels) {
        let ring: Vec<_> = panel
            .edges
            .iter()
            .flat_map(|e| &e.points)
            .copied()
            .collect();
        count += geometry::ring_area(&ring).abs() / cell;
        #[expect(clippy::cast_precision_loss, reason = "an estimate")]
        let on_boundary = divided.divisions.iter().map(Division::count).sum::<usize>() as f64;
        count += on_boundary;
        #[expect(clippy::cast_precision_loss, reason = "an estimate")]
        let most = limits.mesh_vertices as f64;
        if count > most {
            return Err(Fault::new(
                MeshCode::TooFine,
                format!("/panels/{}", panel.id),
                format!(
                    "with mesh edges of {edge_length} m the garment needs more than {most} vertices, reached at panel \"{}\"",
                    panel.name
                ),
            )
            .fix("ask for a larger edge_length_m"));
        }
    }
    Ok(())
}
