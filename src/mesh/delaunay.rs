//! Constrained Delaunay triangulation of a panel, by `spade`.

use super::boundary::Boundary;
use super::check::Flaw;
use super::geometry::{self, Point};
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};
use std::collections::VecDeque;

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// A panel's boundary, triangulated and found simple.
pub(super) struct Domain {
    cdt: Cdt,
    boundary: Vec<Point>,
}

impl Domain {
    /// Checks that the boundary neither crosses nor touches itself and that holes lie inside.
    pub(super) fn new(boundary: &Boundary) -> Result<Self, Flaw> {
        let mut cdt = Cdt::new();
        for (index, &point) in boundary.points.iter().enumerate() {
            let handle = cdt
                .insert(position(point))
                .map_err(|_| Flaw::Crossing(point))?;
            if handle.index() != index {
                return Err(Flaw::Crossing(point));
            }
        }
        for [a, b] in boundary.segments() {
            let [from, to] = [a, b].map(FixedVertexHandle::from_index);
            // More than one part: it runs through a third point. None: it crosses an earlier one.
            if cdt.exists_constraint(from, to) || cdt.try_add_constraint(from, to).len() != 1 {
                let middle = geometry::lerp(boundary.points[a], boundary.points[b], 0.5);
                return Err(Flaw::Crossing(middle));
            }
        }
        check_holes(boundary)?;
        Ok(Self {
            cdt,
            boundary: boundary.points.clone(),
        })
    }

    /// Number of boundary points; they come first in every triangulation.
    pub(super) fn boundary_count(&self) -> usize {
        self.boundary.len()
    }

    /// The boundary points.
    pub(super) fn boundary(&self) -> &[Point] {
        &self.boundary
    }

    /// Triangles of the boundary points and, numbered after them, `inside`.
    /// A point of `inside` that lies on another point or outside is in no triangle.
    pub(super) fn triangles(&self, inside: &[Point]) -> Vec<[usize; 3]> {
        let mut cdt = self.cdt.clone();
        let mut numbers: Vec<usize> = (0..self.boundary.len()).collect();
        for (index, &point) in inside.iter().enumerate() {
            let inserted = cdt.insert(position(point));
            if inserted.is_ok_and(|handle| handle.index() == numbers.len()) {
                numbers.push(self.boundary.len() + index);
            }
        }
        cloth_faces(&cdt)
            .map(|face| face.map(|vertex| numbers[vertex.index()]))
            .collect()
    }
}

/// A hole outside the outline, or inside another hole, would turn what is cloth inside out.
fn check_holes(boundary: &Boundary) -> Result<(), Flaw> {
    for (index, hole) in boundary.rings[1..].iter().enumerate() {
        let first = boundary.points[hole.start];
        let others = boundary.rings.iter().filter(|ring| *ring != hole);
        let around = others.filter(|ring| contains(&boundary.points[(*ring).clone()], first));
        if around.count() != 1 {
            return Err(Flaw::StrayHole(index));
        }
    }
    Ok(())
}

/// Whether a ring goes round a point.
fn contains(ring: &[Point], p: Point) -> bool {
    let mut inside = false;
    for (i, &a) in ring.iter().enumerate() {
        let b = ring[(i + 1) % ring.len()];
        if (a[1] > p[1]) != (b[1] > p[1])
            && p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1])
        {
            inside = !inside;
        }
    }
    inside
}

/// `spade` refuses numbers that are almost zero.
fn position(point: Point) -> Point2<f64> {
    let [x, y] = point.map(|x| if x.abs() < 1e-30 { 0.0 } else { x });
    Point2::new(x, y)
}

/// The faces reached from outside across an odd number of boundary parts, counter-clockwise.
fn cloth_faces(cdt: &Cdt) -> impl Iterator<Item = [FixedVertexHandle; 3]> + '_ {
    let mut cloth: Vec<Option<bool>> = vec![None; cdt.num_all_faces()];
    let mut queue = VecDeque::new();
    for edge in cdt.convex_hull() {
        let hull = if edge.face().is_outer() {
            edge
        } else {
            edge.rev()
        };
        let face = hull.rev().face();
        if cloth[face.fix().index()].is_none() {
            cloth[face.fix().index()] = Some(hull.is_constraint_edge());
            queue.extend(face.as_inner());
        }
    }
    while let Some(face) = queue.pop_front() {
        let here = cloth[face.fix().index()] == Some(true);
        for edge in face.adjacent_edges() {
            let next = edge.rev().face();
            if let Some(inner) = next.as_inner()
                && cloth[next.fix().index()].is_none()
            {
                cloth[next.fix().index()] = Some(here != edge.is_constraint_edge());
                queue.push_back(inner);
            }
        }
    }
    cdt.inner_faces()
        .filter(move |face| cloth[face.fix().index()] == Some(true))
        .map(|face| face.vertices().map(|vertex| vertex.fix()))
}
