//! A smooth signed distance: the tricubic spline through exact distances on a grid.

use super::exact::ExactDistance;
use super::spline::{bends, interpolate, pivots, slopes, weights};
use nalgebra::{Matrix3, Vector3};

/// Spacing of the grid \[m\]: about the mesh edges of a body, so that its facets are not resolved
/// but smoothed.
const SPACING: f64 = 0.009;
/// Most nodes; a body that would need more gets a wider spacing.
const NODES: f64 = 1.0e6;
/// Nodes beyond the reach on each side: there the free ends of the spline are felt by less than
/// 0.268^4 = 0.5 %.
const MARGIN: f64 = 4.0;

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

/// Coefficients of the spline. C2, so that a Newton method sees no kinks; exact at the nodes.
#[derive(Clone, Debug)]
pub(super) struct DistanceField {
    origin: Vector3<f64>,
    spacing: f64,
    reach: f64,
    /// Nodes along x, y, z.
    size: [usize; 3],
    /// Along z fastest, along x slowest \[m\].
    coefficients: Vec<f64>,
}

/// A point in its cell: index of the first of its 4 x 4 x 4 coefficients, and where it is in the
/// cell, 0 to 1.
struct Cell {
    first: usize,
    at: [f64; 3],
}

impl DistanceField {
    /// The field about a surface up to `reach` outside \[m\].
    pub(super) fn new(exact: &ExactDistance, reach: f64) -> Self {
        let mut field = Self::layout(exact.bounds(), reach);
        field.fill(exact);
        field.prefilter();
        field
    }

    fn layout([lower, upper]: [Vector3<f64>; 2], reach: f64) -> Self {
        let nodes = |spacing: f64| {
            let pad = 2.0 * (reach + MARGIN * spacing);
            (upper - lower).map(|width| ((width + pad) / spacing).ceil() + 1.0)
        };
        let mut spacing = SPACING;
        while nodes(spacing).product() > NODES {
            spacing *= 1.05;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "whole, positive and below NODES"
        )]
        let size: [usize; 3] = nodes(spacing).map(|n| n as usize).into();
        Self {
            origin: lower.add_scalar(-reach - MARGIN * spacing),
            spacing,
            reach,
            size,
            coefficients: vec![0.0; size.iter().product()],
        }
    }

    fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.size[1] + j) * self.size[2] + k
    }

    /// Exact distances at the nodes; each search begins with the nearest point of the node before.
    fn fill(&mut self, exact: &ExactDistance) {
        let mut column = exact.nearest(&self.origin);
        for i in 0..self.size[0] {
            for j in 0..self.size[1] {
                let mut near = column;
                for k in 0..self.size[2] {
                    let node = Vector3::new(i as f64, j as f64, k as f64) * self.spacing;
                    let at = self.index([i, j, k]);
                    self.coefficients[at] = exact.signed_near(&(self.origin + node), &mut near);
                    if k == 0 {
                        column = near;
                    }
                }
            }
        }
    }

    fn prefilter(&mut self) {
        let strides = [self.size[1] * self.size[2], self.size[2], 1];
        for axis in 0..3 {
            let (one, two) = ((axis + 1) % 3, (axis + 2) % 3);
            let pivots = pivots(self.size[axis]);
            for i in 0..self.size[one] {
                for j in 0..self.size[two] {
                    let start = i * strides[one] + j * strides[two];
                    interpolate(&mut self.coefficients, (start, strides[axis]), &pivots);
                }
            }
        }
    }

    fn cell(&self, p: &Vector3<f64>) -> Option<Cell> {
        let mut first = [0; 3];
        let mut at = [0.0; 3];
        for axis in 0..3 {
            let u = (p[axis] - self.origin[axis]) / self.spacing;
            if !(1.0..(self.size[axis] - 2) as f64).contains(&u) {
                return None;
            }
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "rounds down a number within the size of the grid"
            )]
            let node = u as usize;
            first[axis] = node - 1;
            at[axis] = u - node as f64;
        }
        let first = self.index(first);
        Some(Cell { first, at })
    }

    /// The four coefficients along z of line (i, j) of a cell.
    fn line(&self, first: usize, i: usize, j: usize) -> &[f64; 4] {
        let start = first + (i * self.size[1] + j) * self.size[2];
        self.coefficients[start..]
            .first_chunk()
            .expect("a cell has two nodes beyond it on each axis")
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
        let (one, two) = (1.0 / self.spacing, 1.0 / (self.spacing * self.spacing));
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

fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])
}
