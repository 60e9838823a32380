//! A smooth signed distance: the tricubic spline through exact distances on a grid.

use super::TriangleMesh;
use super::enclose::enclose;
use super::exact::ExactDistance;
use super::lattice::Lattice;
use super::node_distances::node_distances;
use super::spline::{bends, interpolate, pivots, slopes, weights};
use nalgebra::{Matrix3, Vector3};

/// Most nodes of the box about a body; one that would need more gets a wider spacing.
const NODES: f64 = 5.0e6;
/// Nodes beyond the reach on each side: there the free ends of the spline are felt by less than
/// 0.268^4 = 0.5 %.
const MARGIN: f64 = 4.0;
/// Spacings beyond the reach within which nodes are computed: the coefficients about a point are up
/// to 2 sqrt(3) away from it, and the ends of the spline two more.
const COMPUTED: f64 = 5.5;
/// Cells along an edge of a brick, and coefficients: one more before and two behind.
const CELLS: usize = 8;
const SIDE: usize = CELLS + 3;
/// Brick that is not there.
const NONE: u32 = u32::MAX;

/// The signed distance of a body at a point, with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodySample {
    /// Negative inside \[m\].
    pub distance: f64,
    /// Gradient of the distance: the outward normal, of length about 1.
    pub normal: Vector3<f64>,
    /// Second derivative \[1/m\].
    pub curvature: Matrix3<f64>,
}

/// Coefficients of the spline. C2, so that a Newton method sees no kinks; exact at the nodes. Kept
/// in bricks, only where the body or its reach is.
#[derive(Clone, Debug)]
pub(super) struct DistanceField {
    lattice: Lattice,
    reach: f64,
    /// Bricks along y and z.
    across: [usize; 2],
    /// First coefficient of each brick over the size of one, along z fastest, or `NONE`.
    bricks: Vec<u32>,
    /// `SIDE` x `SIDE` x `SIDE` of each brick, along z fastest, along x slowest \[m\].
    coefficients: Vec<f64>,
}

/// A point in its cell: index of the first of its 4 x 4 x 4 coefficients, and where it is in the
/// cell, 0 to 1.
struct Cell {
    first: usize,
    at: [f64; 3],
}

impl DistanceField {
    /// The field about a surface up to `reach` outside, on a grid of this `spacing` \[m\], lowered
    /// where the surface would stand out of it.
    pub(super) fn new(
        (surface, exact): (&TriangleMesh, &ExactDistance),
        reach: f64,
        spacing: f64,
    ) -> Self {
        let lattice = layout(exact.bounds(), reach, spacing);
        let limit = reach + COMPUTED * lattice.spacing;
        let mut nodes = node_distances(&lattice, (surface, exact), limit);
        let offered = lattice.spacing.mul_add(1.8, reach);
        let near: Vec<bool> = nodes.iter().map(|distance| *distance <= offered).collect();
        prefilter(&lattice, &mut nodes);
        enclose(&lattice, &mut nodes, surface);
        let mut field = Self {
            across: [1, 2].map(|axis| lattice.size[axis].div_ceil(CELLS)),
            bricks: Vec::new(),
            coefficients: Vec::new(),
            lattice,
            reach,
        };
        field.keep(&nodes, &near, limit);
        field
    }

    /// Keeps the bricks that have a node near the body; nodes that were not computed are beyond
    /// `limit`.
    fn keep(&mut self, nodes: &[f64], near: &[bool], limit: f64) {
        let size = self.lattice.size;
        let count = size.map(|n| n.div_ceil(CELLS));
        let mut kept = 0;
        for brick in 0..count.iter().product() {
            let first = [
                brick / (count[1] * count[2]) * CELLS,
                brick / count[2] % count[1] * CELLS,
                brick % count[2] * CELLS,
            ];
            let is_near = rows(first, CELLS + 1, size).any(|row| near[row].contains(&true));
            if !is_near {
                self.bricks.push(NONE);
                continue;
            }
            self.bricks.push(kept);
            kept += 1;
            for i in 0..SIDE {
                for j in 0..SIDE {
                    for k in 0..SIDE {
                        let node = [first[0] + i, first[1] + j, first[2] + k];
                        let is_in = (0..3).all(|a| (1..=size[a]).contains(&node[a]));
                        let value = if is_in {
                            nodes[self.lattice.index(node.map(|n| n - 1))].min(limit)
                        } else {
                            limit
                        };
                        self.coefficients.push(value);
                    }
                }
            }
        }
    }

    fn cell(&self, p: &Vector3<f64>) -> Option<Cell> {
        let mut brick = [0; 3];
        let mut first = [0; 3];
        let mut at = [0.0; 3];
        for axis in 0..3 {
            let u = (p[axis] - self.lattice.origin[axis]) / self.lattice.spacing;
            if !(1.0..(self.lattice.size[axis] - 2) as f64).contains(&u) {
                return None;
            }
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "rounds down a number within the size of the grid"
            )]
            let node = u as usize;
            brick[axis] = node / CELLS;
            first[axis] = node % CELLS;
            at[axis] = u - node as f64;
        }
        let brick = (brick[0] * self.across[0] + brick[1]) * self.across[1] + brick[2];
        let brick = self.bricks[brick];
        let first = (first[0] * SIDE + first[1]) * SIDE + first[2];
        (brick != NONE).then(|| Cell {
            first: brick as usize * (SIDE * SIDE * SIDE) + first,
            at,
        })
    }

    /// The four coefficients along z of line (i, j) of a cell.
    fn line(&self, first: usize, i: usize, j: usize) -> &[f64; 4] {
        let start = first + (i * SIDE + j) * SIDE;
        self.coefficients[start..]
            .first_chunk()
            .expect("a brick has coefficients beyond its cells")
    }

    /// The distance \[m\], or `None` outside the grid or further than the reach.
    pub(super) fn distance(&self, p: &Vector3<f64>) -> Option<f64> {
        let Cell { first, at } = self.cell(p)?;
        let [x, y, z] = at.map(weights);
        let mut distance = 0.0;
        for (i, x) in x.iter().enumerate() {
            for (j, y) in y.iter().enumerate() {
                distance += x * y * dot(self.line(first, i, j), &z);
            }
        }
        (distance <= self.reach).then_some(distance)
    }

    /// Distance, gradient and second derivative, or `None` outside the grid or further than the
    /// reach.
    pub(super) fn sample(&self, p: &Vector3<f64>) -> Option<BodySample> {
        let Cell { first, at } = self.cell(p)?;
        let [x, y, z] = at.map(|t| [weights(t), slopes(t), bends(t)]);
        // f and its derivatives by y and z, then those of them that are derived by x once or twice
        let (mut f, mut fx, mut fxx) = ([0.0; 6], [0.0; 3], 0.0);
        for (i, ((value, slope), bend)) in x[0].iter().zip(&x[1]).zip(&x[2]).enumerate() {
            let plane = self.plane(first, i, (&y, &z));
            for (sum, part) in f.iter_mut().zip(plane) {
                *sum += value * part;
            }
            for (sum, part) in fx.iter_mut().zip(plane) {
                *sum += slope * part;
            }
            fxx += bend * plane[0];
        }
        if f[0] > self.reach {
            return None;
        }
        let spacing = self.lattice.spacing;
        let (one, two) = (1.0 / spacing, 1.0 / (spacing * spacing));
        let [value, fy, fz, fyy, fyz, fzz] = f;
        let [fx, fxy, fxz] = fx;
        Some(BodySample {
            distance: value,
            normal: Vector3::new(fx, fy, fz) * one,
            curvature: Matrix3::new(fxx, fxy, fxz, fxy, fyy, fyz, fxz, fyz, fzz) * two,
        })
    }

    /// Sums over the 4 x 4 coefficients of plane `i`: value, y, z, yy, yz, zz.
    fn plane(&self, first: usize, i: usize, (y, z): (&[[f64; 4]; 3], &[[f64; 4]; 3])) -> [f64; 6] {
        let mut sums = [0.0; 6];
        for (j, ((y0, y1), y2)) in y[0].iter().zip(&y[1]).zip(&y[2]).enumerate() {
            let line = self.line(first, i, j);
            let [value, slope, bend] = [0, 1, 2].map(|order| dot(line, &z[order]));
            sums[0] += y0 * value;
            sums[1] += y1 * value;
            sums[2] += y0 * slope;
            sums[3] += y2 * value;
            sums[4] += y1 * slope;
            sums[5] += y0 * bend;
        }
        sums
    }
}

fn layout([lower, upper]: [Vector3<f64>; 2], reach: f64, finest: f64) -> Lattice {
    let nodes = |spacing: f64| {
        let pad = 2.0 * (reach + MARGIN * spacing);
        (upper - lower).map(|width| ((width + pad) / spacing).ceil() + 1.0)
    };
    let mut spacing = finest;
    while nodes(spacing).product() > NODES {
        spacing *= 1.05;
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "whole, positive and below NODES"
    )]
    let size: [usize; 3] = nodes(spacing).map(|n| n as usize).into();
    Lattice {
        origin: lower.add_scalar(-reach - MARGIN * spacing),
        spacing,
        size,
    }
}

/// Ranges of the nodes, along z, in the cube of `width` nodes from `first` on.
fn rows(
    first: [usize; 3],
    width: usize,
    size: [usize; 3],
) -> impl Iterator<Item = std::ops::Range<usize>> {
    let last = [0, 1, 2].map(|axis| (first[axis] + width).min(size[axis]));
    (first[0]..last[0]).flat_map(move |i| {
        (first[1]..last[1]).map(move |j| {
            let row = (i * size[1] + j) * size[2];
            row + first[2]..row + last[2]
        })
    })
}

/// Distances to coefficients, along each axis in turn, on the runs of nodes that were computed.
fn prefilter(lattice: &Lattice, nodes: &mut [f64]) {
    let size = lattice.size;
    let strides = [size[1] * size[2], size[2], 1];
    let pivots = pivots(size.iter().copied().max().unwrap_or(0));
    for line in nodes.chunks_exact_mut(size[2]) {
        interpolate_runs(line, &pivots);
    }
    for (axis, other) in [(1, 0), (0, 1)] {
        let mut lines = vec![0.0; LANES * size[axis]];
        for i in 0..size[other] {
            for first in (0..size[2]).step_by(LANES) {
                // lines that lie side by side in memory are fetched together
                let lanes = LANES.min(size[2] - first);
                let start = i * strides[other] + first;
                for n in 0..size[axis] {
                    let row = start + n * strides[axis];
                    for (lane, value) in nodes[row..row + lanes].iter().enumerate() {
                        lines[lane * size[axis] + n] = *value;
                    }
                }
                for line in lines.chunks_exact_mut(size[axis]).take(lanes) {
                    interpolate_runs(line, &pivots);
                }
                for n in 0..size[axis] {
                    let row = start + n * strides[axis];
                    for (lane, value) in nodes[row..row + lanes].iter_mut().enumerate() {
                        *value = lines[lane * size[axis] + n];
                    }
                }
            }
        }
    }
}

/// Lines that are filtered together: as many values as are fetched from memory together.
const LANES: usize = 8;

fn interpolate_runs(line: &mut [f64], pivots: &[f64]) {
    for run in line.split_mut(|value| value.is_infinite()) {
        interpolate(run, pivots);
    }
}

fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])
}
