//! From the smooth torso to triangles: rings of vertices, denser where the surface bends, and the
//! strips between.

use super::TriangleMesh;
use super::torso::{BUST_ANGLE, SEAT_ANGLE, Torso};
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI};

/// Longest and shortest mesh edge of a form in size M \[m\]; others in proportion, so that all have
/// about as many.
const EDGE: [f64; 2] = [0.012, 0.004];
/// Largest distance of a chord below its arc, likewise \[m\].
const SAG: f64 = 0.000_15;
/// Samples of the profiles that the heights of the rings are found from.
const SAMPLES: usize = 2000;
/// Polar angles of those profiles: front, bust, side, seat, back \[rad\].
const PROFILES: [f64; 5] = [0.0, BUST_ANGLE, FRAC_PI_2, SEAT_ANGLE, PI];

/// Meshes a torso: closed, two-sided, symmetric in x.
pub(super) fn mesh(torso: &Torso) -> TriangleMesh {
    let pole = |t: f64| {
        let [y, z] = torso.middle(t);
        vec![Vector3::new(0.0, y, z)]
    };
    let size = torso.size();
    let mut halves = vec![pole(0.0)];
    for t in heights(torso, size) {
        let section = torso.section(t);
        let half = section.half();
        let marks = spread(&densities(&half, size));
        halves.push(
            marks
                .iter()
                .map(|&mark| {
                    let [x, z] = between(&half, mark);
                    Vector3::new(x, section.y, z)
                })
                .collect(),
        );
    }
    halves.push(pole(Torso::END));
    mirrored(&halves)
}

/// Parameters of the rings, poles left out.
pub(super) fn heights(torso: &Torso, size: f64) -> Vec<f64> {
    let step = Torso::END / SAMPLES as f64;
    let sections: Vec<_> = (1..SAMPLES)
        .map(|i| torso.section(i as f64 * step))
        .collect();
    let mut density = vec![0.0_f64; sections.len() - 1];
    for angle in PROFILES {
        let profile: Vec<_> = sections
            .iter()
            .map(|section| {
                let [x, z] = section.point(angle);
                [x * angle.sin() + z * angle.cos(), section.y]
            })
            .collect();
        for (most, here) in density.iter_mut().zip(densities(&profile, size)) {
            *most = most.max(here);
        }
    }
    // the first ring stands one edge from the pole
    let marks = spread(&density);
    marks.iter().map(|mark| (1.0 + mark) * step).collect()
}

/// Returns the number of edges that each piece of a polyline is worth on a form `size` times as
/// large as size M.
pub(super) fn densities(points: &[[f64; 2]], size: f64) -> Vec<f64> {
    let pieces: Vec<[f64; 2]> = points
        .windows(2)
        .map(|p| [p[1][0] - p[0][0], p[1][1] - p[0][1]])
        .collect();
    let turn = |a: &[f64; 2], b: &[f64; 2]| {
        (a[0] * b[1] - a[1] * b[0])
            .atan2(a[0] * b[0] + a[1] * b[1])
            .abs()
    };
    (0..pieces.len())
        .map(|i| {
            let length = pieces[i][0].hypot(pieces[i][1]);
            let before = turn(&pieces[i.saturating_sub(1)], &pieces[i]);
            let after = turn(&pieces[i], &pieces[(i + 1).min(pieces.len() - 1)]);
            // a chord c of a circle of radius R = 1/curvature stays c^2 / 8R below it
            let curvature = 0.5 * (before + after) / length.max(1e-9);
            let edge = (8.0 * SAG * size / curvature.max(1e-9)).sqrt();
            length / edge.clamp(size * EDGE[1], size * EDGE[0])
        })
        .collect()
}

/// Marks along a polyline, in pieces and fractions of them, between which it is worth one edge or a
/// little less.
pub(super) fn spread(density: &[f64]) -> Vec<f64> {
    let total: f64 = density.iter().sum();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few hundred at most: lengths of a body over EDGE"
    )]
    let count = total.ceil().max(3.0) as usize;
    let mut marks = Vec::with_capacity(count + 1);
    let mut sum = 0.0;
    for (i, here) in density.iter().enumerate() {
        while marks.len() < count && sum + here > marks.len() as f64 * total / count as f64 {
            let rest = marks.len() as f64 * total / count as f64 - sum;
            marks.push(i as f64 + (rest / here).max(0.0));
        }
        sum += here;
    }
    marks.push(density.len() as f64);
    marks
}

pub(super) fn between(points: &[[f64; 2]], mark: f64) -> [f64; 2] {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 0 to the number of points"
    )]
    let i = (mark as usize).min(points.len() - 2);
    let s = mark - i as f64;
    [0, 1].map(|k| (1.0 - s) * points[i][k] + s * points[i + 1][k])
}

/// Both halves of a stack of half rings, each from the front (x = 0) over the left to the back (x =
/// 0).
fn mirrored(halves: &[Vec<Vector3<f64>>]) -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    let mut rings = Vec::new();
    for half in halves {
        let mut ring = [Vec::new(), Vec::new()];
        for (i, point) in half.iter().enumerate() {
            ring[0].push(mesh.vertices.len());
            ring[1].push(mesh.vertices.len());
            mesh.vertices.push(*point);
            if i > 0 && i + 1 < half.len() {
                ring[1][i] += 1;
                mesh.vertices.push(Vector3::new(-point.x, point.y, point.z));
            }
        }
        rings.push(ring);
    }
    for pair in rings.windows(2) {
        let [above, below] = [&pair[0], &pair[1]];
        mesh.triangles.extend(strip(&above[0], &below[0]));
        let right = strip(&above[1], &below[1]);
        mesh.triangles.extend(right.map(|[a, b, c]| [a, c, b]));
    }
    mesh
}

/// Triangles between two rows of vertices that need not have the same number of them.
fn strip(above: &[usize], below: &[usize]) -> impl Iterator<Item = [usize; 3]> {
    let (mut i, mut j) = (0, 0);
    std::iter::from_fn(move || {
        // go on along the row whose next vertex comes first, as shares of the rows
        let (next_above, next_below) = ((i + 1) * (below.len() - 1), (j + 1) * (above.len() - 1));
        let along_above = j + 1 == below.len() || (i + 1 < above.len() && next_above < next_below);
        if along_above {
            i += 1;
            (i < above.len()).then(|| [above[i - 1], below[j], above[i]])
        } else {
            j += 1;
            Some([above[i], below[j - 1], below[j]])
        }
    })
}
