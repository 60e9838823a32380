//! The way up and the way ahead of a body in a file, by its own shape: symmetry, soles, legs, feet.

use super::super::TriangleMesh;
use super::super::slice::Plane;
use nalgebra::{Matrix3, SymmetricEigen, Vector3};

/// Angle up to which an axis of the file is the body's own: which way people model \[rad\].
const SIDE_ANGLE: f64 = 0.17;
const UP_ANGLE: f64 = 0.10;
/// Angle between the longest axis and the vertical, at most \[rad\].
const LEAN: f64 = 0.45;
/// Length of the soles as a share of the height, at least.
const SOLE: f64 = 0.04;
/// Share of the odd moments by which an axis of the file may be less symmetric than the best one.
const SLACK: f64 = 0.01;
/// Shares of the height at which legs are looked for, from an end.
const LEG_HEIGHTS: [f64; 7] = [0.08, 0.12, 0.16, 0.20, 0.24, 0.28, 0.32];
/// Shares of the height of the middle of a foot, and of an ankle.
const FOOT: f64 = 0.015;
const ANKLE: f64 = 0.08;
/// Distance that the foot is ahead of the ankle, at least, as a share of the height.
const AHEAD: f64 = 0.008;

/// Axes of a body in its file, of length 1 and at right angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axes {
    pub(super) up: Vector3<f64>,
    pub(super) facing: Vector3<f64>,
    /// True if the legs told which way is up.
    pub(super) up_is_sure: bool,
    /// True if the feet told the way ahead.
    pub(super) facing_is_sure: bool,
}

impl Axes {
    /// The body's left.
    pub(super) fn left(&self) -> Vector3<f64> {
        self.up.cross(&self.facing)
    }
}

/// Finds the axes of a body, of which `up` and `facing` may be known.
pub(super) fn axes(
    surface: &TriangleMesh,
    up: Option<Vector3<f64>>,
    facing: Option<Vector3<f64>>,
) -> Axes {
    let moments = Moments::new(surface);
    let side = match (up, facing) {
        (Some(up), Some(facing)) => up.cross(&facing),
        _ => moments.side(up.or(facing)),
    };
    let line = moments.longest - side * moments.longest.dot(&side);
    let line = line
        .try_normalize(1e-9)
        .unwrap_or_else(|| any_normal(&side));
    let (up, up_is_sure) = up.map_or_else(|| way_up(surface, side, line), |up| (up, true));
    let ahead = side.cross(&up).normalize();
    let (facing, facing_is_sure) = match facing {
        Some(facing) => (facing, true),
        None => way_ahead(surface, up, ahead),
    };
    // what was found is put at right angles to what was told
    let facing = (facing - up * facing.dot(&up))
        .try_normalize(1e-9)
        .unwrap_or(ahead);
    Axes {
        up,
        facing,
        up_is_sure,
        facing_is_sure,
    }
}

/// Area-weighted moments of a surface.
struct Moments {
    samples: Vec<(Vector3<f64>, f64)>,
    principal: [Vector3<f64>; 3],
    longest: Vector3<f64>,
}

impl Moments {
    fn new(surface: &TriangleMesh) -> Self {
        let mut samples: Vec<(Vector3<f64>, f64)> = (0..surface.triangles.len())
            .map(|t| {
                let [a, b, c] = surface.corners(t);
                ((a + b + c) / 3.0, (b - a).cross(&(c - a)).norm())
            })
            .collect();
        let area: f64 = samples.iter().map(|(_, area)| area).sum();
        let middle: Vector3<f64> = samples.iter().map(|(p, area)| p * *area).sum();
        let middle = middle / area;
        for (p, weight) in &mut samples {
            *p -= middle;
            *weight /= area;
        }
        let spread: Matrix3<f64> = samples.iter().map(|(p, w)| p * p.transpose() * *w).sum();
        let axes = SymmetricEigen::new(spread);
        let mut order = [0, 1, 2];
        order.sort_by(|a, b| axes.eigenvalues[*b].total_cmp(&axes.eigenvalues[*a]));
        let principal = order.map(|k| axes.eigenvectors.column(k).into_owned());
        Self {
            samples,
            longest: principal[0],
            principal,
        }
    }

    /// The axis from side to side: that about which the two halves are alike, across `known`.
    fn side(&self, known: Option<Vector3<f64>>) -> Vector3<f64> {
        let candidates = match known {
            None => vec![self.principal[1], self.principal[2]],
            Some(known) => self.across(&known),
        };
        let best = candidates.into_iter().min_by(|a, b| {
            let [a, b] = [a, b].map(|axis| self.asymmetry(axis));
            a.total_cmp(&b)
        });
        let best = best.unwrap_or(self.principal[1]);
        let snapped = nearest_file_axis(&best);
        let is_near = snapped.angle(&best) < SIDE_ANGLE;
        let is_across = known.is_none_or(|known| known.dot(&snapped).abs() < 1e-9);
        if is_near && is_across && self.asymmetry(&snapped) < self.asymmetry(&best) + SLACK {
            snapped
        } else {
            best
        }
    }

    /// The principal axes in the plane across a direction.
    fn across(&self, known: &Vector3<f64>) -> Vec<Vector3<f64>> {
        let one = any_normal(known);
        let two = known.cross(&one);
        let (mut aa, mut ab, mut bb) = (0.0, 0.0, 0.0);
        for (p, weight) in &self.samples {
            let (a, b) = (p.dot(&one), p.dot(&two));
            aa += weight * a * a;
            ab += weight * a * b;
            bb += weight * b * b;
        }
        let angle = 0.5 * (2.0 * ab).atan2(aa - bb);
        let (sin, cos) = angle.sin_cos();
        vec![one * cos + two * sin, two * cos - one * sin]
    }

    /// Moments that are odd in an axis, which a body that is alike on both sides does not have.
    fn asymmetry(&self, axis: &Vector3<f64>) -> f64 {
        let one = any_normal(axis);
        let two = axis.cross(&one);
        let mut odd = [0.0; 4];
        let (mut size, mut own) = (0.0, 0.0);
        for (p, weight) in &self.samples {
            let [x, u, v] = [axis, &one, &two].map(|d| p.dot(d));
            for (sum, part) in odd
                .iter_mut()
                .zip([x * x * x, x * u * u, x * v * v, x * u * v])
            {
                *sum += weight * part;
            }
            size += weight * (u * u + v * v);
            own += weight * x * x;
        }
        let squares: f64 = odd.iter().map(|x| x * x).sum();
        squares.sqrt() / (own.sqrt() * (size + own))
    }
}

fn any_normal(axis: &Vector3<f64>) -> Vector3<f64> {
    let mut other = Vector3::zeros();
    other[axis.iamin()] = 1.0;
    axis.cross(&other).normalize()
}

/// The axis of the file, or its opposite, nearest to a direction.
fn nearest_file_axis(direction: &Vector3<f64>) -> Vector3<f64> {
    let k = direction.iamax();
    let mut axis = Vector3::zeros();
    axis[k] = 1.0_f64.copysign(direction[k]);
    axis
}

/// The direction from feet to head along `line`, upright on the soles, and if it is sure.
fn way_up(surface: &TriangleMesh, side: Vector3<f64>, line: Vector3<f64>) -> (Vector3<f64>, bool) {
    let [forth, back] = [1.0, -1.0].map(|sign| legs_at_end(surface, side, line * sign));
    let sign = match forth.cmp(&back) {
        std::cmp::Ordering::Greater => 1.0,
        std::cmp::Ordering::Less => -1.0,
        std::cmp::Ordering::Equal => 1.0_f64.copysign(line[line.iamax()]),
    };
    let rough = line * sign;
    let is_sure = forth != back;
    let soled = sole_normal(surface, side, rough).unwrap_or(rough);
    let snapped = nearest_file_axis(&soled);
    let reach = if soled == rough { LEAN } else { UP_ANGLE };
    let is_across = snapped.dot(&side).abs() < 1e-9;
    if is_across && snapped.angle(&soled) < reach {
        (snapped, is_sure)
    } else {
        (soled, is_sure)
    }
}

/// Number of slices near the lower end of a body in which legs show: two loops, none in the middle.
fn legs_at_end(surface: &TriangleMesh, side: Vector3<f64>, up: Vector3<f64>) -> usize {
    let [low, high] = extent(surface, &up);
    let middle = {
        let [a, b] = extent(surface, &side);
        0.5 * (a + b)
    };
    let ahead = side.cross(&up);
    let shows = |share: &&f64| {
        let plane = Plane {
            point: up * (low + **share * (high - low)) + side * middle,
            across: side,
            along: ahead,
        };
        let loops = plane.loops(surface);
        let sides = loops.iter().map(|points| {
            let x = points.iter().map(|p| p[0]);
            let least = x.clone().fold(f64::INFINITY, f64::min);
            [least, x.fold(f64::NEG_INFINITY, f64::max)]
        });
        let sides: Vec<_> = sides.collect();
        sides.iter().any(|x| x[0] > 0.0)
            && sides.iter().any(|x| x[1] < 0.0)
            && !sides.iter().any(|x| x[0] <= 0.0 && x[1] >= 0.0)
    };
    LEG_HEIGHTS.iter().filter(shows).count()
}

/// Least and largest coordinate of a surface along a direction.
pub(super) fn extent(surface: &TriangleMesh, direction: &Vector3<f64>) -> [f64; 2] {
    let along = surface.vertices.iter().map(|p| p.dot(direction));
    along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        [low.min(x), high.max(x)]
    })
}

/// The normal of the plane that the soles stand on: of the longest edge at the lower end of the
/// outline seen from the side.
fn sole_normal(
    surface: &TriangleMesh,
    side: Vector3<f64>,
    rough: Vector3<f64>,
) -> Option<Vector3<f64>> {
    let ahead = side.cross(&rough);
    let [low, high] = extent(surface, &rough);
    let mut points: Vec<[f64; 2]> = surface
        .vertices
        .iter()
        .map(|p| [p.dot(&ahead), p.dot(&rough)])
        .filter(|p| p[1] < low + 0.25 * (high - low))
        .collect();
    points.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut hull: Vec<[f64; 2]> = Vec::new();
    for p in points {
        while let [.., a, b] = hull[..]
            && (b[0] - a[0]) * (p[1] - a[1]) <= (b[1] - a[1]) * (p[0] - a[0])
        {
            hull.pop();
        }
        hull.push(p);
    }
    let edges = hull
        .windows(2)
        .map(|p| [p[1][0] - p[0][0], p[1][1] - p[0][1]]);
    let upright = edges.filter(|[x, y]| (y / x).atan().abs() < LEAN);
    let longest = upright.max_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])))?;
    let [x, y] = longest;
    (x.hypot(y) > SOLE * (high - low)).then(|| (rough * x - ahead * y).normalize())
}

/// The direction in which the feet point, `ahead` or against it, and if it is sure.
fn way_ahead(
    surface: &TriangleMesh,
    up: Vector3<f64>,
    ahead: Vector3<f64>,
) -> (Vector3<f64>, bool) {
    let [low, high] = extent(surface, &up);
    let side = up.cross(&ahead);
    let middle = |share: f64| {
        let plane = Plane {
            point: up * (low + share * (high - low)),
            across: side,
            along: ahead,
        };
        let z = plane.loops(surface).concat().into_iter().map(|p| p[1]);
        let [least, most] = z.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| {
            [low.min(z), high.max(z)]
        });
        0.5 * (least + most)
    };
    let off = (middle(FOOT) - middle(ANKLE)) / (high - low);
    if off.abs() > AHEAD {
        return (ahead * off.signum(), true);
    }
    // no feet: as the file has it, along one of its axes
    (ahead * 1.0_f64.copysign(ahead[ahead.iamax()]), false)
}
