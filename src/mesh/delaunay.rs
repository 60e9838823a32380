//! Constrained Delaunay triangulation of a panel, by `spade`.

use super::boundary::Boundary;
use super::check::MeshDefect;
use crate::pattern::point::{self, Point2};
use spade::handles::{DirectedEdgeHandle, FixedVertexHandle};
use spade::{CdtEdge, ConstrainedDelaunayTriangulation, PositionInTriangulation, Triangulation};
use std::collections::{BTreeSet, VecDeque};

type Cdt = ConstrainedDelaunayTriangulation<spade::Point2<f64>>;

/// A panel's boundary and sewn lines, triangulated and found simple.
pub(super) struct Domain {
    cdt: Cdt,
    boundary: Vec<Point2>,
    /// Mesh edges along rings and lines, the lower point first.
    fixed: BTreeSet<[usize; 2]>,
    lines: BTreeSet<[usize; 2]>,
}

impl Domain {
    /// Checks that the boundary neither crosses nor touches itself, that holes lie inside, and
    /// lines on cloth.
    pub(super) fn new(boundary: &Boundary) -> Result<Self, MeshDefect> {
        let mut domain = Self {
            cdt: Cdt::new(),
            boundary: boundary.points.clone(),
            fixed: boundary.segments().map(sorted).collect(),
            lines: boundary.line_segments().map(|(_, s)| sorted(s)).collect(),
        };
        domain.add_rings(boundary)?;
        check_holes(boundary)?;
        domain.add_lines(boundary)?;
        Ok(domain)
    }

    fn add_rings(&mut self, boundary: &Boundary) -> Result<(), MeshDefect> {
        let points = &boundary.points[..boundary.ring_point_count()];
        for (index, &point) in points.iter().enumerate() {
            let handle = self.cdt.insert(position(point));
            let handle = handle.map_err(|_| MeshDefect::Crossing(point))?;
            if handle.index() != index {
                return Err(MeshDefect::Crossing(point));
            }
        }
        for segment in boundary.ring_segments() {
            if !self.constrain(segment) {
                return Err(MeshDefect::Crossing(self.middle(segment)));
            }
        }
        Ok(())
    }

    fn add_lines(&mut self, boundary: &Boundary) -> Result<(), MeshDefect> {
        let mut next = boundary.ring_point_count();
        for (line, segment) in boundary.line_segments() {
            // Points are numbered in the order in which segments come to them, so each is new but
            // those at joints.
            for end in segment {
                if end == next {
                    self.add_line_point(line, end)?;
                    next += 1;
                }
            }
        }
        for (line, segment) in boundary.line_segments() {
            if !self.constrain(segment) {
                return Err(MeshDefect::LineCrossing(line, self.middle(segment)));
            }
        }
        let cloth = self.cloth(&self.cdt);
        for (line, segment) in boundary.line_segments() {
            let [from, to] = segment.map(FixedVertexHandle::from_index);
            let edge = self.cdt.get_edge_from_neighbors(from, to);
            let inside = edge.is_some_and(|edge| {
                let faces = [edge.face(), edge.rev().face()];
                faces.iter().all(|face| cloth[face.fix().index()])
            });
            if !inside {
                return Err(MeshDefect::LineOutside(line, self.middle(segment)));
            }
        }
        Ok(())
    }

    fn add_line_point(&mut self, line: usize, index: usize) -> Result<(), MeshDefect> {
        let point = self.boundary[index];
        match self.cdt.locate(position(point)) {
            PositionInTriangulation::OutsideOfConvexHull(_) => {
                return Err(MeshDefect::LineOutside(line, point));
            }
            PositionInTriangulation::OnEdge(edge)
                if self.cdt.is_constraint_edge(edge.as_undirected()) =>
            {
                return Err(MeshDefect::LineCrossing(line, point));
            }
            _ => {}
        }
        match self.cdt.insert(position(point)) {
            Ok(handle) if handle.index() == index => Ok(()),
            _ => Err(MeshDefect::LineCrossing(line, point)),
        }
    }

    /// Makes two points an edge; `false` if that runs through a third point or crosses an edge made
    /// before.
    fn constrain(&mut self, segment: [usize; 2]) -> bool {
        let [from, to] = segment.map(FixedVertexHandle::from_index);
        !self.cdt.exists_constraint(from, to) && self.cdt.try_add_constraint(from, to).len() == 1
    }

    fn middle(&self, [a, b]: [usize; 2]) -> Point2 {
        point::lerp(self.boundary[a], self.boundary[b], 0.5)
    }

    /// Number of points on rings and lines; they come first in every triangulation.
    pub(super) fn boundary_count(&self) -> usize {
        self.boundary.len()
    }

    /// The points on rings and lines.
    pub(super) fn boundary(&self) -> &[Point2] {
        &self.boundary
    }

    /// Returns true if two points are neighbors on a ring or a line.
    pub(super) fn is_fixed(&self, a: usize, b: usize) -> bool {
        self.fixed.contains(&sorted([a, b]))
    }

    /// Triangles of the boundary points and, numbered after them, `inside`.
    /// A point of `inside` that lies on another point or outside is in no triangle.
    pub(super) fn triangles(&self, inside: &[Point2]) -> Vec<[usize; 3]> {
        let mut cdt = self.cdt.clone();
        let mut numbers: Vec<usize> = (0..self.boundary.len()).collect();
        for (index, &point) in inside.iter().enumerate() {
            let inserted = cdt.insert(position(point));
            if inserted.is_ok_and(|handle| handle.index() == numbers.len()) {
                numbers.push(self.boundary.len() + index);
            }
        }
        let cloth = self.cloth(&cdt);
        cdt.inner_faces()
            .filter(|face| cloth[face.fix().index()])
            .map(|face| face.vertices().map(|vertex| numbers[vertex.fix().index()]))
            .collect()
    }

    /// By index of the face: whether it is reached from outside across an odd number of boundary
    /// parts.
    fn cloth(&self, cdt: &Cdt) -> Vec<bool> {
        let is_boundary =
            |edge: DirectedEdgeHandle<'_, spade::Point2<f64>, (), CdtEdge<()>, ()>| {
                let ends = [edge.from(), edge.to()].map(|vertex| vertex.fix().index());
                edge.is_constraint_edge() && !self.lines.contains(&sorted(ends))
            };
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
                cloth[face.fix().index()] = Some(is_boundary(hull));
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
                    cloth[next.fix().index()] = Some(here != is_boundary(edge));
                    queue.push_back(inner);
                }
            }
        }
        cloth.into_iter().map(|cloth| cloth == Some(true)).collect()
    }
}

fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

/// A hole outside the outline, or inside another hole, would turn what is cloth inside out.
fn check_holes(boundary: &Boundary) -> Result<(), MeshDefect> {
    for (index, hole) in boundary.rings[1..].iter().enumerate() {
        let first = boundary.points[hole.start];
        let others = boundary.rings.iter().filter(|ring| *ring != hole);
        let around = others.filter(|ring| contains(&boundary.points[(*ring).clone()], first));
        if around.count() != 1 {
            return Err(MeshDefect::StrayHole(index));
        }
    }
    Ok(())
}

/// Returns true if a ring goes round a point.
fn contains(ring: &[Point2], p: Point2) -> bool {
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
fn position(point: Point2) -> spade::Point2<f64> {
    let [x, y] = point.map(|x| if x.abs() < 1e-30 { 0.0 } else { x });
    spade::Point2::new(x, y)
}
