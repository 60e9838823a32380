//! Panels to triangles: divides the boundaries, fills the panels, stitches them together.

use super::boundary::Boundary;
use super::check::{self, MeshDefect};
use super::cloth_mesh::{ClothMesh, PanelRange, smallest_first};
use super::divide::Divisions;
use super::panel_triangles::PanelTriangles;
use super::segment_grid::SegmentGrid;
use super::{delaunay, geometry, improve, lattice, morton, stitch};
use crate::config::Limits;
use crate::fault::{Fault, Faults};
use crate::pattern::Pattern;
use crate::progress::CancelToken;
use crate::seam::SeamSet;

/// Meshes every panel with edges of about `edge_length` \[m\].
///
/// Every edge of an outline is divided evenly along its arc, no part longer than `edge_length`;
/// stretches that seams match get equally many parts, also through chains of seams. Internal lines
/// that seams name are divided likewise and are mesh edges; an end within 1 mm of another edge
/// shares its vertex. Inside, an equilateral lattice is laid along the longest edge, triangulated,
/// and improved: smoothing by centroidal patches, points taken out or put in where triangles are
/// thin. Vertices of a panel are in Morton order.
///
/// # Quality guarantees
/// - Corners, ends of stretches and boundary parts are kept; no vertex is added on the boundary.
/// - A mirrored copy that is divided like its source has the mirror image of its mesh.
/// - Triangles of a panel cover exactly the polygon of its boundary points, less its holes,
///   counter-clockwise.
/// - Same input, same mesh.
///
/// # General limitations
/// Angles are aimed at 25 degrees and more, but not guaranteed: an outline forces small ones where
/// it turns sharply, where it is narrower than the mesh edge, and where one seam side is much
/// shorter than the other.
///
/// # Errors
/// An edge length outside `limits`, a mesh too fine for them, and every panel whose boundary points
/// cross or touch themselves or a sewn line (`/panels/<id>`); a raised `cancel` (`fit/canceled`).
///
/// # References
/// L. Chen, M. Holst, "Efficient mesh optimization schemes based on optimal Delaunay
/// triangulations", Comput. Methods Appl. Mech. Engrg. 200 (2011), doi:10.1016/j.cma.2010.11.007
/// (the smoothing, CPT).
pub fn triangulate(
    pattern: &Pattern,
    seams: &SeamSet,
    edge_length: f64,
    limits: &Limits,
    cancel: &CancelToken,
) -> Result<ClothMesh, Faults> {
    check::edge_length(edge_length, limits)?;
    check::outlines(pattern)?;
    let divisions = Divisions::new(pattern, &seams.seams, edge_length)?;
    check::size(pattern, &divisions, edge_length, limits)?;
    let mut builder = Builder::default();
    for (index, panel) in pattern.panels.iter().enumerate() {
        let boundary = Boundary::new(panel, &divisions.panels[index]);
        if cancel.is_canceled() {
            return Err(check::canceled().into());
        }
        // A mirrored copy runs the other way round; reflected, it gets the mesh that its source
        // has.
        let mirrored = geometry::ring_area(&boundary.points[boundary.rings[0].clone()]) > 0.0;
        let boundary = if mirrored {
            boundary.reflected()
        } else {
            boundary
        };
        match mesh_panel(&boundary, edge_length, cancel) {
            Ok(mesh) => builder.add(boundary, mesh, mirrored),
            Err(flaw) if mirrored => builder.faults.push(flaw.reflected().fault(panel)),
            Err(flaw) => builder.faults.push(flaw.fault(panel)),
        }
    }
    if cancel.is_canceled() {
        return Err(check::canceled().into());
    }
    builder.finish(seams, &divisions)
}

fn mesh_panel(
    boundary: &Boundary,
    edge_length: f64,
    cancel: &CancelToken,
) -> Result<PanelTriangles, MeshDefect> {
    let domain = delaunay::Domain::new(boundary)?;
    let clearance = SegmentGrid::new(boundary, improve::CLEARANCE * edge_length);
    let inside = lattice::points(boundary, &clearance, edge_length);
    Ok(improve::improve(&domain, &clearance, inside, cancel))
}

/// The mesh of the garment, put together panel by panel.
#[derive(Default)]
struct Builder {
    mesh: ClothMesh,
    boundaries: Vec<Boundary>,
    /// For each panel, the mesh vertex of each boundary point.
    numbers: Vec<Vec<usize>>,
    faults: Vec<Fault>,
}

impl Builder {
    /// Adds a panel; one that was meshed `mirrored` is turned back.
    fn add(&mut self, boundary: Boundary, panel: PanelTriangles, mirrored: bool) {
        let first = self.mesh.uv.len();
        let first_triangle = self.mesh.triangles.len();
        let order = morton::order(&panel.points);
        let mut number = vec![0; order.len()];
        for (place, &point) in order.iter().enumerate() {
            number[point] = first + place;
            let point = panel.points[point];
            self.mesh.uv.push(if mirrored {
                geometry::reflected(point)
            } else {
                point
            });
        }
        let turned = |[a, b, c]: [usize; 3]| if mirrored { [a, c, b] } else { [a, b, c] };
        let mut triangles: Vec<_> = panel
            .triangles
            .iter()
            .map(|t| smallest_first(turned(t.map(|v| number[v]))))
            .collect();
        triangles.sort_unstable();
        self.mesh.triangles.append(&mut triangles);
        self.mesh.panels.push(PanelRange {
            vertices: first..self.mesh.uv.len(),
            triangles: first_triangle..self.mesh.triangles.len(),
            corners: boundary.edge_starts.iter().map(|&v| number[v]).collect(),
        });
        self.numbers.push(number);
        self.boundaries.push(boundary);
    }

    fn finish(mut self, seams: &SeamSet, divisions: &Divisions) -> Result<ClothMesh, Faults> {
        if self.faults.is_empty() {
            let vertex = |panel: usize, edge: usize, part: usize| {
                self.numbers[panel][self.boundaries[panel].vertex(edge, part)]
            };
            self.mesh.stitches = stitch::stitches(&seams.seams, divisions, vertex);
        }
        Faults(self.faults).or(self.mesh)
    }
}
