//! Forms against their measurements; distances against closed forms and against the triangles.

use super::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::LazyLock;

static FORM: LazyLock<Avatar> = LazyLock::new(|| DressForm::default().build().expect("size M"));

/// A sphere of unit edges, by halving the edges of an octahedron `levels` times and putting the
/// points on the sphere.
fn sphere(radius: f64, levels: usize) -> TriangleMesh {
    let count = 1 << levels;
    let mut mesh = TriangleMesh::default();
    let mut ids = BTreeMap::new();
    for octant in 0..8_usize {
        let sign = |k: usize| if octant >> k & 1 == 0 { 1 } else { -1 };
        let mut vertex = |i: i32, j: i32| {
            let key = [sign(0) * i, sign(1) * j, sign(2) * (count - i - j)];
            *ids.entry(key).or_insert_with(|| {
                let p = Vector3::from(key.map(f64::from)).normalize() * radius;
                mesh.vertices.push(p);
                mesh.vertices.len() - 1
            })
        };
        let outward = sign(0) * sign(1) * sign(2) > 0;
        for i in 0..count {
            for j in 0..count - i {
                let mut add = |[a, b, c]: [usize; 3]| {
                    mesh.triangles
                        .push(if outward { [a, b, c] } else { [a, c, b] });
                };
                let corner = [vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)];
                add(corner);
                if i + j + 1 < count {
                    add([corner[1], vertex(i + 1, j + 1), corner[2]]);
                }
            }
        }
    }
    mesh
}

/// Facets on a turn of a capsule.
const FACETS: usize = 64;

/// A cylinder along y with half spheres on its ends, of planar facets between `FACETS` meridians.
fn capsule(radius: f64, length: f64) -> TriangleMesh {
    let step = TAU / FACETS as f64;
    let mut mesh = TriangleMesh::default();
    let rows = FACETS / 2;
    for row in 1..=rows {
        // as many rows above the cylinder as below, the equator twice
        let above = row <= rows / 2;
        let latitude = FRAC_PI_2 - step * (if above { row } else { row - 1 }) as f64;
        let shift = if above { 0.5 } else { -0.5 } * length;
        for turn in 0..FACETS {
            let (sin, cos) = (step * turn as f64).sin_cos();
            let around = Vector3::new(sin * latitude.cos(), latitude.sin(), cos * latitude.cos());
            let up = Vector3::new(0.0, shift, 0.0);
            mesh.vertices.push(around * radius + up);
        }
    }
    let (top, bottom) = (mesh.vertices.len(), mesh.vertices.len() + 1);
    let pole = Vector3::new(0.0, radius + 0.5 * length, 0.0);
    mesh.vertices.extend([pole, -pole]);
    for turn in 0..FACETS {
        let next = (turn + 1) % FACETS;
        mesh.triangles.push([top, turn, next]);
        for row in 1..rows {
            let (above, below) = ((row - 1) * FACETS, row * FACETS);
            mesh.triangles
                .push([above + turn, below + turn, below + next]);
            mesh.triangles
                .push([above + turn, below + next, above + next]);
        }
        let last = (rows - 1) * FACETS;
        mesh.triangles.push([last + turn, bottom, last + next]);
    }
    mesh
}

/// Points spread over a box about the origin by the golden ratio's higher relatives (R3 sequence,
/// M. Roberts 2018).
fn points(count: usize, half: Vector3<f64>) -> impl Iterator<Item = Vector3<f64>> {
    let steps = [0.819_172_513, 0.671_043_607, 0.549_700_478];
    (1..=count).map(move |i| {
        let share = Vector3::from(steps.map(|s: f64| 2.0 * (i as f64 * s).fract() - 1.0));
        half.component_mul(&share)
    })
}

fn of(surface: TriangleMesh) -> Avatar {
    Avatar::from_surface("test", surface, BTreeMap::new()).expect("closed")
}

fn codes(surface: TriangleMesh) -> Vec<String> {
    let faults = Avatar::from_surface("test", surface, BTreeMap::new()).expect_err("refused");
    faults.0.into_iter().map(|f| f.code.to_string()).collect()
}

/// Facets of edge e lie within e²/(6 R) of a sphere (circumradius of a facet squared over 2 R, R0²
/// <= e²/3).
fn facet_depth(mesh: &TriangleMesh, radius: f64) -> f64 {
    let longest = (0..mesh.triangles.len())
        .map(|t| {
            let [a, b, c] = mesh.corners(t);
            (b - a).norm().max((c - b).norm()).max((a - c).norm())
        })
        .fold(0.0, f64::max);
    longest * longest / (6.0 * radius)
}

#[test]
fn exact_distance_of_a_sphere_is_the_closed_form() {
    let mesh = sphere(0.1, 4);
    let depth = facet_depth(&mesh, 0.1);
    let avatar = of(mesh);
    for p in points(2000, Vector3::repeat(0.2)) {
        let error = avatar.exact_distance(&p) - (p.norm() - 0.1);
        assert!((-1e-12..=depth).contains(&error), "{error} at {p}");
    }
}

#[test]
fn exact_distance_of_a_capsule_is_the_closed_form() {
    // a facet is seen from the axis under angles a, b: its plane is r cos(a/2) cos(b/2) away
    let half = PI / FACETS as f64;
    let depth = 0.06 * (1.0 - half.cos() * half.cos()) + 1e-12;
    let avatar = of(capsule(0.06, 0.2));
    for p in points(2000, Vector3::new(0.1, 0.2, 0.1)) {
        let axis = Vector3::new(0.0, p.y.clamp(-0.1, 0.1), 0.0);
        let error = avatar.exact_distance(&p) - ((p - axis).norm() - 0.06);
        assert!((-1e-12..=depth).contains(&error), "{error} at {p}");
    }
}

#[test]
fn nearest_point_is_that_of_brute_force() {
    let avatar = of(capsule(0.06, 0.2));
    let dense: Vec<_> = (0..avatar.surface.triangles.len())
        .map(|t| of_one(avatar.surface.corners(t)))
        .collect();
    for p in points(200, Vector3::new(0.15, 0.25, 0.15)) {
        let brute = dense
            .iter()
            .map(|tree| (tree.nearest(&p, f64::INFINITY).expect("finite").point - p).norm())
            .fold(f64::INFINITY, f64::min);
        assert_eq!((avatar.nearest_point(&p) - p).norm(), brute);
    }
}

fn of_one(corners: [Vector3<f64>; 3]) -> tree::Tree {
    tree::Tree::new(&TriangleMesh {
        vertices: corners.to_vec(),
        triangles: vec![[0, 1, 2]],
    })
}

/// Distance d of a sphere has derivatives of order 4 below 15 / r³; a cubic spline through values
/// spaced h errs by at most 5/384 h⁴ of those on each axis, plus what the facets add.
#[test]
fn smooth_distance_of_a_sphere_is_the_closed_form() {
    let mesh = sphere(0.1, 5);
    let depth = facet_depth(&mesh, 0.1);
    let avatar = of(mesh);
    let spline = 3.0 * 5.0 / 384.0 * 0.009_f64.powi(4) * 15.0 / 0.08_f64.powi(3);
    for p in points(4000, Vector3::repeat(0.14)) {
        let distance = p.norm() - 0.1;
        if distance.abs() < 0.02 {
            let sample = avatar.sample(&p).expect("near");
            let error = (sample.distance - distance).abs();
            // the interpolation of the facets' own depth can overshoot it by the spline's norm,
            // 1.549 an axis
            assert!(error < spline + 1.549_f64.powi(3) * depth, "{error} at {p}");
        }
    }
}

#[test]
fn smooth_distance_of_the_form_is_near_the_exact_one() {
    // a fold of angle a between facets is a kink a |x| / 2, which a spline of spacing h cannot
    // follow closer than a h / 4
    let widest = widest_fold(&FORM.surface);
    let bound = 0.25 * widest * 0.009;
    assert!(bound < 1e-3, "{widest}");
    for t in 0..FORM.surface.triangles.len() {
        let [a, b, c] = FORM.surface.corners(t);
        let normal = (b - a).cross(&(c - a)).normalize();
        // not deeper than the rim of the neck is round: distances have kinks of their own there
        for depth in [-0.01, -0.003, 0.0, 0.005, 0.02] {
            let p = (a + b + c) / 3.0 + normal * depth;
            let sample = FORM.sample(&p).expect("within reach");
            let error = (sample.distance - FORM.exact_distance(&p)).abs();
            assert!(error < bound, "{error} at {p}, {depth}");
            // the same sum in another order
            assert!((sample.distance - FORM.distance(&p)).abs() < 1e-14);
        }
    }
}

fn widest_fold(surface: &TriangleMesh) -> f64 {
    let mut sides = BTreeMap::new();
    let mut widest = 0.0_f64;
    for (t, &[i, j, k]) in surface.triangles.iter().enumerate() {
        let [a, b, c] = surface.corners(t);
        let normal = (b - a).cross(&(c - a));
        for (from, to) in [(i, j), (j, k), (k, i)] {
            if let Some(other) = sides.insert((from.min(to), from.max(to)), normal) {
                widest = widest.max(normal.angle(&other));
            }
        }
    }
    widest
}

/// Central differences err by h² f''' / 6 and by rounding, eps f / h: 1e-6 of the size of the
/// result, at h = 1e-5 m with third derivatives up to 1e3 /m².
#[test]
fn gradient_and_hessian_are_those_of_the_distance() {
    let h = 1e-5;
    for (i, v) in FORM.surface.vertices.iter().enumerate().step_by(37) {
        let p = v + Vector3::new(0.003, -0.002, 0.001) * (i % 5) as f64;
        let Some(sample) = FORM.sample(&p) else {
            continue;
        };
        for axis in 0..3 {
            let step = Vector3::ith(axis, h);
            let (Some(up), Some(down)) = (FORM.sample(&(p + step)), FORM.sample(&(p - step)))
            else {
                continue;
            };
            let slope = (up.distance - down.distance) / (2.0 * h);
            assert!((slope - sample.normal[axis]).abs() < 1e-6, "{slope} at {p}");
            let bend = (up.normal - down.normal) / (2.0 * h);
            let error = (bend - sample.curvature.column(axis)).norm();
            assert!(
                error < 1e-6 * sample.curvature.norm().max(100.0),
                "{error} at {p}"
            );
        }
        assert_eq!(sample.curvature, sample.curvature.transpose());
    }
}

#[test]
fn distance_is_offered_to_the_reach_and_not_beyond() {
    let avatar = of(sphere(0.1, 3));
    let at = |r: f64| avatar.sample(&(Vector3::new(0.6, 0.64, 0.48) * r));
    assert!(at(0.135).is_some());
    assert!(at(0.145).is_none());
    assert!(at(1e300).is_none() && at(f64::NAN).is_none() && at(f64::INFINITY).is_none());
    assert!(at(0.0).is_some_and(|centre| centre.distance < -0.09));
    assert!(avatar.distance(&Vector3::repeat(9.0)).is_infinite());
}

#[test]
fn surfaces_that_are_none_are_refused() {
    let good = sphere(0.1, 1);
    assert_eq!(codes(TriangleMesh::default()), ["avatar/empty"]);
    let mut open = good.clone();
    open.triangles.pop();
    assert_eq!(codes(open), ["avatar/open"]);
    let mut turned = good.clone();
    turned.triangles[0].swap(1, 2);
    assert_eq!(codes(turned), ["avatar/not_manifold", "avatar/open"]);
    let mut inside_out = good.clone();
    inside_out.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    assert_eq!(codes(inside_out), ["avatar/inside_out"]);
    let mut astray = good.clone();
    astray.vertices[3].x = f64::NAN;
    astray.triangles[2][1] = 10_000;
    assert_eq!(codes(astray), ["avatar/vertex", "avatar/index"]);
    let mut flat = good;
    let [a, b, _] = flat.triangles[0];
    flat.vertices[a] = flat.vertices[b];
    assert!(codes(flat).contains(&"avatar/degenerate".to_owned()));
}

#[test]
fn girth_of_a_sphere_is_that_of_its_circle() {
    let mesh = sphere(0.1, 5);
    let depth = facet_depth(&mesh, 0.1);
    let avatar = of(mesh);
    let circle = TAU * (0.01_f64 - 0.0009).sqrt();
    let girth = avatar.girth_at(0.03).expect("a slice");
    assert!((0.0..4.0 * PI * depth).contains(&(circle - girth)));
    assert!(avatar.girth_at(0.2).is_none() && avatar.girth_at(f64::NAN).is_none());
    let [[left, right], _] = avatar.section_bounds(1e-9).expect("a slice");
    assert!((right - left - 0.2).abs() < 2.0 * depth);
}

/// Two balls of 10 cm whose middles are 12 cm apart: their walls inside do not count.
#[test]
fn distances_of_a_surface_that_crosses_itself_are_those_of_its_outside() {
    let (radius, half) = (0.1, 0.06);
    let mut both = sphere(radius, 5);
    let count = both.vertices.len();
    let right = both.clone();
    both.vertices.iter_mut().for_each(|p| p.x -= half);
    both.vertices
        .extend(right.vertices.iter().map(|p| p + Vector3::x() * half));
    let triangles = right.triangles.iter().map(|t| t.map(|v| v + count));
    both.triangles.extend(triangles);
    let avatar = Avatar::from_crossing_surface("balls", both, BTreeMap::new()).expect("closed");
    assert!(avatar.crosses_itself());
    let to_left = |p: &Vector3<f64>| (p + Vector3::x() * half).norm() - radius;
    let to_right = |p: &Vector3<f64>| (p - Vector3::x() * half).norm() - radius;
    // chords of a quarter in 32 parts, the longest up to 1.6 times the mean: 8 mm
    let slack = 0.008_f64.powi(2) / (8.0 * radius) * 2.0;
    for (x, y) in [
        (-0.2, 0.0),
        (0.0, 0.12),
        (0.03, 0.1),
        (0.17, 0.02),
        (0.0, 0.09),
    ] {
        let p = Vector3::new(x, y, 0.004);
        let truth = to_left(&p).min(to_right(&p));
        let off = avatar.exact_distance(&p) - truth;
        assert!(off.abs() < slack, "{off} at {p}");
        let smooth = avatar.distance(&p);
        if smooth.is_finite() && truth > 0.01 {
            assert!((smooth - truth).abs() < 1e-3, "{smooth} {truth} at {p}");
        }
    }
    // in the middle of both, the nearest place is the circle where they meet
    let crease = -(radius * radius - half * half).sqrt();
    let found = avatar.exact_distance(&Vector3::zeros());
    assert!((found - crease).abs() < 1e-3, "{found} {crease}");
    // beside the middle, where the distance has a tip, it is smooth: one point of it is nearest
    let beside = Vector3::y() * 0.03;
    let smooth = avatar.distance(&beside);
    assert!((smooth - crease - 0.03).abs() < 1e-3, "{smooth} {crease}");
}
