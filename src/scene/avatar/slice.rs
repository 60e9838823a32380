//! Plane slices of a surface: their loops, and the girth that a tape would read.

use super::TriangleMesh;
use super::tube::Frame;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// A plane with two directions of length 1 in it, normal to each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    pub(super) point: Vector3<f64>,
    pub(super) across: Vector3<f64>,
    pub(super) along: Vector3<f64>,
}

impl Plane {
    /// The level plane at height `y`, across it x and along it z.
    fn level(y: f64) -> Self {
        Self {
            point: Vector3::new(0.0, y, 0.0),
            across: Vector3::x(),
            along: Vector3::z(),
        }
    }

    /// The plane through `point` normal to `direction`, which is of length 1.
    pub(super) fn normal_to(direction: Vector3<f64>, point: Vector3<f64>) -> Self {
        let frame = Frame::normal_to(direction, point);
        Self {
            point,
            across: frame.outward,
            along: frame.forward,
        }
    }

    /// Points of the plane in its directions \[m\]: the loops of the slice.
    pub(super) fn loops(&self, surface: &TriangleMesh) -> Vec<Vec<[f64; 2]>> {
        let normal = self.along.cross(&self.across);
        let heights: Vec<f64> = surface
            .vertices
            .iter()
            .map(|v| (v - self.point).dot(&normal))
            .collect();
        let mut next = BTreeMap::new();
        for triangle in &surface.triangles {
            // the edges that go up and down through the plane: each triangle that is crossed has
            // one of each, and a neighbor passes its edge in the other direction
            let (mut up, mut down) = (None, None);
            for k in 0..3 {
                let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
                match (heights[a] >= 0.0, heights[b] >= 0.0) {
                    (false, true) => up = Some((a, b)),
                    (true, false) => down = Some((b, a)),
                    _ => {}
                }
            }
            if let (Some(from), Some(to)) = (up, down) {
                next.insert(from, to);
            }
        }
        let mut loops = Vec::new();
        while let Some((first, mut edge)) = next.pop_first() {
            let mut points = vec![self.crossing(surface, &heights, first)];
            while edge != first {
                points.push(self.crossing(surface, &heights, edge));
                let Some(after) = next.remove(&edge) else {
                    break;
                };
                edge = after;
            }
            loops.push(points);
        }
        loops
    }

    fn crossing(
        &self,
        surface: &TriangleMesh,
        heights: &[f64],
        (a, b): (usize, usize),
    ) -> [f64; 2] {
        let s = heights[a] / (heights[a] - heights[b]);
        let [p, q] = [a, b].map(|v| surface.vertices[v] - self.point);
        [self.across, self.along].map(|d| {
            let (from, to) = (p.dot(&d), q.dot(&d));
            from + s * (to - from)
        })
    }
}

/// Returns the points of the torso in the slice at height `y`: the loops about the middle (x = 0),
/// or where none is, under the crotch, the innermost loop of each side; (x, z) \[m\].
fn torso(surface: &TriangleMesh, y: f64) -> Vec<Vec<[f64; 2]>> {
    let loops = Plane::level(y).loops(surface);
    let innermost = |side: f64| {
        let inner = |points: &Vec<[f64; 2]>| {
            let along = points.iter().map(|p| p[0] * side);
            along.fold(f64::INFINITY, f64::min)
        };
        let of_side = loops.iter().filter(|points| inner(points) > 0.0);
        of_side
            .min_by(|a, b| inner(a).total_cmp(&inner(b)))
            .cloned()
    };
    let legs: Vec<_> = [1.0, -1.0].into_iter().filter_map(innermost).collect();
    let is_middle = |points: &Vec<[f64; 2]>| {
        points.iter().any(|p| p[0] >= 0.0) && points.iter().any(|p| p[0] <= 0.0)
    };
    let middle: Vec<_> = loops.into_iter().filter(is_middle).collect();
    if middle.is_empty() { legs } else { middle }
}

/// `[[min x, max x], [min z, max z]]` of the torso at height `y`, `None` where it is not \[m\].
pub(super) fn bounds(surface: &TriangleMesh, y: f64) -> Option<[[f64; 2]; 2]> {
    let points = torso(surface, y).concat();
    let first = points.first()?;
    let mut bounds = [[first[0]; 2], [first[1]; 2]];
    for point in &points {
        for (bound, x) in bounds.iter_mut().zip(point) {
            *bound = [bound[0].min(*x), bound[1].max(*x)];
        }
    }
    Some(bounds)
}

/// z of the back and of the front of the torso in the middle (x = 0) at height `y` \[m\].
pub(super) fn middle(surface: &TriangleMesh, y: f64) -> Option<[f64; 2]> {
    let loops = torso(surface, y);
    let pieces = loops.iter().flat_map(|points| {
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next)
    });
    let crossings: Vec<f64> = pieces
        .filter(|(p, q)| (p[0] >= 0.0) != (q[0] >= 0.0))
        .map(|(p, q)| p[1] + p[0] / (p[0] - q[0]) * (q[1] - p[1]))
        .collect();
    let back = crossings.iter().copied().min_by(f64::total_cmp)?;
    Some([back, crossings.iter().copied().max_by(f64::total_cmp)?])
}

/// Girth of a tape about the torso at height `y`, `None` where it is not \[m\].
pub(super) fn girth(surface: &TriangleMesh, y: f64) -> Option<f64> {
    tape(torso(surface, y).concat())
}

/// Mean girth of a tape about each of the two legs at height `y`: the largest loop of each side
/// \[m\].
pub(super) fn leg_girth(surface: &TriangleMesh, y: f64) -> Option<f64> {
    let loops = Plane::level(y).loops(surface);
    let girths = [1.0, -1.0].map(|side| {
        let middle = |points: &Vec<[f64; 2]>| {
            let sum: f64 = points.iter().map(|p| p[0] * side).sum();
            sum / points.len() as f64
        };
        let own = loops.iter().filter(|points| middle(points) > 0.0);
        own.filter_map(|points| tape(points.clone()))
            .max_by(f64::total_cmp)
    });
    let [left, right] = girths;
    left.zip(right).map(|(left, right)| 0.5 * (left + right))
}

/// Girth of a tape about the loop of a slice that is round the point of the plane \[m\].
pub(super) fn girth_around(surface: &TriangleMesh, plane: &Plane) -> Option<f64> {
    tape(loop_around(surface, plane)?)
}

/// Returns the middle of the loop of a slice that is round the point of the plane: the centroid of
/// its area, and the girth of a tape about it \[m\].
pub(super) fn middle_around(surface: &TriangleMesh, plane: &Plane) -> Option<(Vector3<f64>, f64)> {
    let points = loop_around(surface, plane)?;
    let (mut area, mut moment) = (0.0, [0.0; 2]);
    for (p, q) in points.iter().zip(points.iter().cycle().skip(1)) {
        let cross = p[0] * q[1] - p[1] * q[0];
        area += cross;
        for k in 0..2 {
            moment[k] += cross * (p[k] + q[k]) / 3.0;
        }
    }
    let [across, along] = moment.map(|m| m / area);
    let middle = plane.point + plane.across * across + plane.along * along;
    Some((middle, tape(points)?)).filter(|_| area != 0.0)
}

fn loop_around(surface: &TriangleMesh, plane: &Plane) -> Option<Vec<[f64; 2]>> {
    let mut loops = plane.loops(surface).into_iter();
    loops.find(|points| is_around(points))
}

/// Girth of a tape about the loop round a point, normal to a direction \[m\].
pub(super) fn girth_across(
    surface: &TriangleMesh,
    point: &Vector3<f64>,
    direction: &Vector3<f64>,
) -> Option<f64> {
    let direction = direction.try_normalize(1e-9)?;
    girth_around(surface, &Plane::normal_to(direction, *point))
}

/// Returns true if a loop goes round the origin.
fn is_around(points: &[[f64; 2]]) -> bool {
    let next = points.iter().cycle().skip(1);
    let turns = points.iter().zip(next).filter(|(p, q)| {
        // its pieces that cross the half line towards the first direction
        (p[1] >= 0.0) != (q[1] >= 0.0) && {
            let s = p[1] / (p[1] - q[1]);
            p[0] + s * (q[0] - p[0]) > 0.0
        }
    });
    turns.count() % 2 == 1
}

/// Perimeter of the convex hull of points, `None` where there are none \[m\].
pub(super) fn tape(points: Vec<[f64; 2]>) -> Option<f64> {
    let hull = hull(points);
    let next = hull.iter().cycle().skip(1);
    let girth = hull
        .iter()
        .zip(next)
        .map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1]));
    (!hull.is_empty()).then(|| girth.sum())
}

/// Convex hull, counter-clockwise (A. M. Andrew, "Another efficient algorithm for convex hulls in
/// two dimensions", 1979).
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut hull = chain(points.iter());
    hull.pop();
    hull.extend(chain(points.iter().rev()));
    hull.pop();
    hull
}

fn chain<'a>(points: impl Iterator<Item = &'a [f64; 2]>) -> Vec<[f64; 2]> {
    let mut chain: Vec<[f64; 2]> = Vec::new();
    for &p in points {
        while let [.., a, b] = chain[..]
            && (b[0] - a[0]) * (p[1] - a[1]) <= (b[1] - a[1]) * (p[0] - a[0])
        {
            chain.pop();
        }
        chain.push(p);
    }
    chain
}
