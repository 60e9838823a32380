//! Panels that are their own mirror image: turned over, they make the same garment.
#![allow(
    dead_code,
    reason = "each test program takes this file in as its own and uses some of it"
)]

use seamster::pattern::Panel;

/// How near mirrored points must be \[m\].
const NEAR: f64 = 2e-3;
/// Points round an outline that are compared.
const POINTS: usize = 40;

/// For a symmetric panel: the number c, so that the way s along its outline from corner 0 mirrors to c - s \[m\].
pub(crate) fn axis(panel: &Panel) -> Option<f64> {
    let around: f64 = panel.edges.iter().map(|e| e.length_m).sum();
    let mut starts: Vec<f64> = vec![];
    let mut so_far = 0.0;
    for edge in &panel.edges {
        starts.extend([2.0 * so_far, 2.0 * so_far + edge.length_m]);
        so_far += edge.length_m;
    }
    let spots: Vec<f64> = (0..POINTS)
        .map(|k| around * k as f64 / POINTS as f64)
        .collect();
    let at = |s: f64| point(panel, s.rem_euclid(around));
    starts.into_iter().find(|c| {
        spots.iter().enumerate().all(|(i, s)| {
            spots[..i].iter().all(|t| {
                let (a, b) = (distance(at(*s), at(*t)), distance(at(c - s), at(c - t)));
                (a - b).abs() < NEAR
            })
        })
    })
}

/// The point so far along the outline.
fn point(panel: &Panel, mut s: f64) -> [f64; 2] {
    for pair in panel.edges.iter().flat_map(|e| e.points.windows(2)) {
        let long = distance(pair[0], pair[1]);
        if s <= long && long > 0.0 {
            let t = s / long;
            return [0, 1].map(|k| pair[0][k] + t * (pair[1][k] - pair[0][k]));
        }
        s -= long;
    }
    panel.edges[0].points[0]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
