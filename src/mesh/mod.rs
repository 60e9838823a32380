//! From panels to a [`ClothMesh`]: boundary points equal on both sides of a seam, constrained Delaunay inside.

mod boundary;
mod check;
mod coarser;
mod delaunay;
mod divide;
mod geometry;
mod improve;
mod joint;
mod lattice;
mod locate;
mod morton;
mod slots;
mod stitch;

pub use coarser::{Coarser, coarser};
pub use locate::Locator;

use crate::config::Limits;
use crate::fault::{Fault, Faults};
use crate::pattern::Pattern;
use crate::progress::CancelToken;
use crate::seam::SeamSet;
use boundary::Boundary;
use check::Flaw;
use divide::Divisions;
use std::ops::Range;

/// All panels of a garment as triangles, with the stitches between them.
#[derive(Clone, Debug, PartialEq)]
pub struct ClothMesh {
    /// Rest position of each vertex in its panel's pattern coordinates \[m\]; `#V`.
    pub uv: Vec<[f64; 2]>,
    /// Vertex indices, counter-clockwise in pattern coordinates; `#T`.
    pub triangles: Vec<[usize; 3]>,
    /// The part of the mesh that each panel is, in the pattern's order.
    pub panels: Vec<PanelRange>,
    /// Point pairs that are sewn together; grouped by seam, in order along it. No vertex pair occurs twice.
    pub stitches: Vec<Stitch>,
}

/// The part of a mesh that one panel is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PanelRange {
    /// Its vertices.
    pub vertices: Range<usize>,
    /// Its triangles.
    pub triangles: Range<usize>,
    /// The vertex at each corner of the panel.
    pub corners: Vec<usize>,
}

/// One point pair of a seam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stitch {
    /// Index of the seam.
    pub seam: usize,
    /// Order of sewing, from the seam.
    pub stage: u32,
    /// Vertex on side A.
    pub a: usize,
    /// Vertex on side B.
    pub b: usize,
}

/// Meshes every panel with edges of about `edge_length` \[m\].
///
/// Every edge of an outline is divided evenly along its arc, no part longer than `edge_length`; stretches that
/// seams match get equally many parts, also through chains of seams. Internal lines that seams name are divided
/// likewise and are mesh edges; an end within 1 mm of another edge shares its vertex. Inside, an equilateral lattice is laid along
/// the longest edge, triangulated, and improved: smoothing by centroidal patches, points taken out or put in where
/// triangles are thin. Vertices of a panel are in Morton order.
///
/// # Quality guarantees
/// - Corners, ends of stretches and boundary parts are kept; no vertex is added on the boundary.
/// - A mirrored copy that is divided like its source has the mirror image of its mesh.
/// - Triangles of a panel cover exactly the polygon of its boundary points, less its holes, counter-clockwise.
/// - Same input, same mesh.
///
/// # General limitations
/// Angles are aimed at 25 degrees and more, but not guaranteed: an outline forces small ones where it turns
/// sharply, where it is narrower than the mesh edge, and where one seam side is much shorter than the other.
///
/// # Errors
/// An edge length outside `limits`, a mesh too fine for them, and every panel whose boundary points cross or
/// touch themselves or a sewn line (`/panels/<id>`); a raised `cancel` (`fit/canceled`).
///
/// # References
/// L. Chen, M. Holst, "Efficient mesh optimization schemes based on optimal Delaunay triangulations",
/// Comput. Methods Appl. Mech. Engrg. 200 (2011), doi:10.1016/j.cma.2010.11.007 (the smoothing, CPT).
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
        // A mirrored copy runs the other way round; reflected, it gets the mesh that its source has.
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

/// One panel's triangles, in its own numbering: the boundary's points first.
#[derive(Clone)]
struct PanelMesh {
    points: Vec<[f64; 2]>,
    triangles: Vec<[usize; 3]>,
}

fn mesh_panel(
    boundary: &Boundary,
    edge_length: f64,
    cancel: &CancelToken,
) -> Result<PanelMesh, Flaw> {
    let domain = delaunay::Domain::new(boundary)?;
    let clearance = geometry::SegmentGrid::new(boundary, improve::CLEARANCE * edge_length);
    let inside = lattice::points(boundary, &clearance, edge_length);
    Ok(improve::improve(&domain, &clearance, inside, cancel))
}

/// Collects the panels' meshes into one.
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
    fn add(&mut self, boundary: Boundary, panel: PanelMesh, mirrored: bool) {
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

impl ClothMesh {
    /// Area of all triangles at rest \[m²\].
    pub fn area(&self) -> f64 {
        let area = |t: &[usize; 3]| {
            let [p, q, r] = t.map(|v| self.uv[v]);
            geometry::area(p, q, r).abs()
        };
        self.triangles.iter().map(area).sum()
    }

    /// Edge length of the equilateral triangle that has the mean area of the triangles \[m\].
    pub fn mean_edge(&self) -> f64 {
        let mean = self.area() / self.triangles.len().max(1) as f64;
        (mean * 4.0 / 3.0_f64.sqrt()).sqrt()
    }
}

impl Default for ClothMesh {
    /// A mesh of nothing.
    fn default() -> Self {
        Self {
            uv: vec![],
            triangles: vec![],
            panels: vec![],
            stitches: vec![],
        }
    }
}

/// The same triangle, begun at its lowest vertex.
fn smallest_first([a, b, c]: [usize; 3]) -> [usize; 3] {
    if a < b && a < c {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}
