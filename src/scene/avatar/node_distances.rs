//! Distances of a surface at the nodes of a lattice, found from node to node.
//!
//! Near the surface each triangle is compared with the nodes about it, which is exact. From there
//! on, in the order of their distances, nodes hand their nearest triangle on to their neighbors,
//! and each goes on to adjacent triangles while these are nearer. A search of the whole surface
//! for each node would take ten times as long. Where two parts of the surface are equally near, a
//! node may be handed the triangle of the other one: it then is too far by less than the part of a
//! spacing by which the nodes around it differ.

use super::TriangleMesh;
use super::exact::ExactDistance;
use super::lattice::Lattice;
use super::tree::{Feature, nearest_in_triangle};
use nalgebra::Vector3;

/// Buckets of the queue in a spacing.
const BUCKETS: f64 = 4.0;
/// No triangle.
const NONE: u32 = u32::MAX;

/// Distances in the making.
struct Front<'a> {
    lattice: &'a Lattice,
    surface: &'a TriangleMesh,
    exact: &'a ExactDistance,
    /// Distance, squared \[m²\].
    squared: Vec<f64>,
    /// The triangle that has it.
    triangle: Vec<u32>,
    state: Vec<State>,
    /// Nodes by their distance.
    queue: Vec<Vec<u32>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Waiting,
    Outside,
    Inside,
}

/// Returns the signed distance at each node \[m\]: all inside and up to `limit` outside, infinite
/// beyond.
pub(super) fn node_distances(
    lattice: &Lattice,
    (surface, exact): (&TriangleMesh, &ExactDistance),
    limit: f64,
) -> Vec<f64> {
    let mut front = Front {
        lattice,
        surface,
        exact,
        squared: vec![f64::INFINITY; lattice.len()],
        triangle: vec![NONE; lattice.len()],
        state: vec![State::Waiting; lattice.len()],
        queue: Vec::new(),
    };
    for t in 0..surface.triangles.len() {
        front.seed(t);
    }
    front.start();
    front.advance(limit);
    let nodes = front.squared.iter().zip(&front.state);
    nodes
        .map(|(squared, state)| match state {
            State::Waiting => f64::INFINITY,
            State::Outside => squared.sqrt(),
            State::Inside => -squared.sqrt(),
        })
        .collect()
}

impl Front<'_> {
    /// Offers a triangle to the nodes within a spacing of its plane and its box.
    fn seed(&mut self, t: usize) {
        let corners = self.surface.corners(t);
        let h = self.lattice.spacing;
        let normal = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
        let length = normal.norm();
        let steep = normal.iamax();
        let [one, two] = [(steep + 1) % 3, (steep + 2) % 3];
        let range = |axis: usize| {
            let along = corners.map(|c| c[axis]);
            let low = along.iter().copied().fold(f64::INFINITY, f64::min);
            let high = along.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            [low - h, high + h]
        };
        let bounds = range(steep);
        // nodes are within a spacing of the plane if they are so far from it along the axis
        let slack = h * length / normal[steep].abs();
        for i in self.between(one, range(one)) {
            for j in self.between(two, range(two)) {
                let mut node = [0; 3];
                (node[one], node[two]) = (i, j);
                let place = self.lattice.place(node);
                let off = place - corners[0];
                let on_plane = corners[0][steep]
                    - (off[one] * normal[one] + off[two] * normal[two]) / normal[steep];
                let span = [
                    bounds[0].max(on_plane - slack),
                    bounds[1].min(on_plane + slack),
                ];
                for k in self.between(steep, span) {
                    node[steep] = k;
                    let place = self.lattice.place(node);
                    let (point, _) = nearest_in_triangle(&place, &corners);
                    let squared = (place - point).norm_squared();
                    let index = self.lattice.index(node);
                    if squared <= h * h && squared < self.squared[index] {
                        self.squared[index] = squared;
                        self.triangle[index] = index32(t);
                    }
                }
            }
        }
    }

    /// Numbers of the nodes along an axis between two places \[m\].
    fn between(&self, axis: usize, [low, high]: [f64; 2]) -> std::ops::Range<usize> {
        let number = |x: f64| (x - self.lattice.origin[axis]) / self.lattice.spacing;
        let (first, last) = (number(low).ceil().max(0.0), number(high).floor() + 1.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "within the lattice, which pads the surface"
        )]
        let range = first as usize..(last.max(0.0) as usize).min(self.lattice.size[axis]);
        range
    }

    /// Tells the sides of the nodes near the surface, and queues them.
    fn start(&mut self) {
        for index in 0..self.squared.len() {
            let t = self.triangle[index];
            if t == NONE {
                continue;
            }
            let place = self.lattice.place(self.lattice.node(index));
            let corners = self.surface.corners(t as usize);
            let (point, feature) = nearest_in_triangle(&place, &corners);
            let inside = self.exact.is_inside(&place, (t as usize, feature, point));
            self.state[index] = if inside {
                State::Inside
            } else {
                State::Outside
            };
            self.queue(index, 0);
        }
    }

    fn queue(&mut self, index: usize, least: usize) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "distances in a box over a share of its spacing"
        )]
        let bucket = (self.squared[index].sqrt() * BUCKETS / self.lattice.spacing) as usize;
        let bucket = bucket.max(least);
        if self.queue.len() <= bucket {
            self.queue.resize_with(bucket + 1, Vec::new);
        }
        self.queue[bucket].push(index32(index));
    }

    fn advance(&mut self, limit: f64) {
        let mut done = vec![false; self.squared.len()];
        let mut bucket = 0;
        while bucket < self.queue.len() {
            // nodes may be added to the bucket at hand
            while let Some(index) = self.queue[bucket].pop() {
                let index = index as usize;
                if std::mem::replace(&mut done[index], true) {
                    continue;
                }
                self.climb(index);
                let is_far = self.squared[index] > limit * limit;
                if is_far && self.state[index] == State::Outside {
                    continue;
                }
                self.hand_on(index, bucket, &done);
            }
            bucket += 1;
        }
    }

    /// Goes on to adjacent triangles while they are nearer: to those beyond the edges, and where a
    /// corner is nearest, to all around it. Triangles of a hull have no neighbors: all are
    /// searched.
    fn climb(&mut self, index: usize) {
        let place = self.lattice.place(self.lattice.node(index));
        if self.exact.is_hull() {
            let nearer = self.exact.nearer_on_hull(&place, self.squared[index]);
            if let Some((t, squared)) = nearer {
                self.squared[index] = squared;
                self.triangle[index] = index32(t);
            }
            return;
        }
        loop {
            let current = self.triangle[index] as usize;
            let (_, feature) = nearest_in_triangle(&place, &self.surface.corners(current));
            if let Feature::Corner(corner) = feature {
                self.offer_around(index, &place, (current, corner));
            } else {
                for next in self.exact.neighbors(current) {
                    self.offer(index, &place, next);
                }
            }
            if self.triangle[index] as usize == current {
                return;
            }
        }
    }

    fn offer_around(
        &mut self,
        index: usize,
        place: &Vector3<f64>,
        (first, corner): (usize, usize),
    ) {
        let vertex = self.surface.triangles[first][corner];
        let mut edge = corner;
        let mut triangle = first;
        loop {
            // beyond the edge from the vertex, whose next edge from the vertex is another one
            triangle = self.exact.neighbors(triangle)[edge];
            if triangle == first {
                return;
            }
            self.offer(index, place, triangle);
            let corners = self.surface.triangles[triangle];
            edge = corners.iter().position(|v| *v == vertex).unwrap_or(0);
        }
    }

    fn offer(&mut self, index: usize, place: &Vector3<f64>, t: usize) -> bool {
        let (point, _) = nearest_in_triangle(place, &self.surface.corners(t));
        let squared = (place - point).norm_squared();
        let is_nearer = squared < self.squared[index];
        if is_nearer {
            self.squared[index] = squared;
            self.triangle[index] = index32(t);
        }
        is_nearer
    }

    fn hand_on(&mut self, index: usize, bucket: usize, done: &[bool]) {
        let node = self.lattice.node(index);
        let triangle = self.triangle[index];
        for axis in 0..3 {
            for step in [usize::MAX, 1] {
                let mut next = node;
                next[axis] = node[axis].wrapping_add(step);
                if next[axis] >= self.lattice.size[axis] {
                    continue;
                }
                let other = self.lattice.index(next);
                if done[other] || self.triangle[other] == triangle {
                    continue;
                }
                let place = self.lattice.place(next);
                if self.offer(other, &place, triangle as usize) {
                    // further than a spacing from the surface, neighbors are on one side
                    if self.state[other] == State::Waiting {
                        self.state[other] = self.state[index];
                    }
                    self.queue(other, bucket);
                }
            }
        }
    }
}

/// An index of a node or a triangle, of which there are some millions at most.
fn index32(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(NONE)
}

#[cfg(test)]
mod tests {
    use super::super::{DressForm, Limbs};
    use super::*;

    /// Exact up to a spacing from the surface, where only rounding may differ. Further away a node
    /// where two parts of the surface are about equally near may have the other one; along a piece
    /// of lattice distances change by a spacing at most, and so does the difference of the two.
    #[test]
    fn distances_are_those_of_a_search_of_the_whole_surface() {
        let form = DressForm {
            limbs: Some(Limbs {
                arms: true,
                legs: true,
            }),
            ..DressForm::default()
        };
        let surface = form.build().expect("size M").surface;
        let exact = ExactDistance::new(&surface);
        let [lower, upper] = exact.bounds();
        let spacing = 0.009;
        #[expect(clippy::cast_possible_truncation, reason = "a few hundred")]
        let size = ((upper - lower) / spacing).map(|n| n as usize + 9);
        let lattice = Lattice {
            origin: lower.add_scalar(-4.0 * spacing),
            spacing,
            size: size.into(),
        };
        let found = node_distances(&lattice, (&surface, &exact), 0.08);
        let mut sum = 0.0;
        let mut count = 0.0;
        for (index, distance) in found.iter().enumerate().step_by(101) {
            let truth = exact.signed(&lattice.place(lattice.node(index)));
            if distance.is_infinite() {
                assert!(truth > 0.08 - spacing, "{truth}");
                continue;
            }
            let error = distance.abs() - truth.abs();
            let bound = if truth.abs() < spacing {
                1e-12
            } else {
                spacing
            };
            assert!((-1e-12..bound).contains(&error), "{error} at {truth}");
            assert!(distance * truth >= 0.0);
            sum += error;
            count += 1.0;
        }
        assert!(
            count > 1e3 && sum / count < 1e-5,
            "{} of {count}",
            sum / count
        );
    }
}
