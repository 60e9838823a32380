//! The pairs that may meet, of two small sheets.

use super::candidates::{Candidates, FeaturePair};
use super::confine::confine;
use super::proximity::Features;
use super::surface::ContactSurface;
use super::swept_boxes::SweptMotion;
use super::tests::{THICKNESS, turned, two_sheets};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Particles of the first of two sheets of 9 and 4 cells a side.
const FIRST: usize = 100;

fn motion<'a>(from: &'a [Vector3<f64>], to: &'a [Vector3<f64>]) -> SweptMotion<'a> {
    SweptMotion {
        from,
        to,
        slack: 1e-3,
    }
}

fn corners(pairs: &[FeaturePair]) -> Vec<[usize; 4]> {
    let mut corners: Vec<_> = pairs.iter().map(|pair| pair.corners).collect();
    corners.sort_unstable();
    corners
}

/// Two sheets half a thickness apart, of 9 and 4 cells a side.
fn near_sheets() -> (ContactSurface, Vec<Vector3<f64>>) {
    let (surface, x) = two_sheets([9, 4], |p| turned(p) + Vector3::z() * 0.5 * THICKNESS);
    (ContactSurface::new(surface), x)
}

#[test]
fn candidates_do_not_depend_on_what_was_looked_at_before() {
    let (surface, x) = two_sheets([4, 3], |p| turned(p) + Vector3::z() * 0.3 * THICKNESS);
    let surface = ContactSurface::new(surface);
    let mut far = x.clone();
    far.iter_mut().for_each(|p| *p *= 3.0);
    let mut candidates = Candidates::default();
    candidates.rebuild(&surface, &motion(&far, &x));
    candidates.rebuild(&surface, &motion(&x, &x));
    let mut again = Candidates::default();
    again.rebuild(&surface, &motion(&x, &x));
    assert_eq!(corners(&candidates.pairs), corners(&again.pairs));
    // Nothing is left to the cutting of moves where no move is asked for.
    let mut to = x.clone();
    confine(
        &again,
        &(0..again.pairs.len()).collect::<Vec<_>>(),
        &x,
        &mut to,
    );
    assert_eq!(to, x);
}

/// One particle in seven wanders out of its box again and again, each at its own time, and some
/// far; the others drift within theirs. Sheets may pass through each other here.
#[test]
fn candidates_of_updated_boxes_are_all_that_may_meet() {
    let (surface, first) = near_sheets();
    let at = |step: usize| -> Vec<Vector3<f64>> {
        let move_ = |(i, p): (usize, &Vector3<f64>)| {
            let turn = TAU * (step as f64 / 17.0 + i as f64 / 5.0);
            let far = if i % 21 == 0 && step % 9 == 4 {
                8e-3
            } else {
                0.0
            };
            let height = if i % 7 == 0 { 2e-3 + far } else { 2e-4 };
            p + Vector3::new(1e-4, 1e-4, height) * turn.sin()
        };
        first.iter().enumerate().map(move_).collect()
    };
    let mut candidates = Candidates::default();
    let (mut stayed_and_touch, mut touch) = (0, 0);
    for step in 0..60 {
        let (from, to) = (at(step), at(step + 1));
        let motion = motion(&from, &to);
        let mut stayed = candidates.pairs.len();
        if !(candidates.cover(&from) && candidates.cover(&to)) {
            stayed = candidates.update(&surface, &motion);
        }
        assert!(candidates.cover(&from) && candidates.cover(&to));
        let mut whole = Candidates::default();
        whole.rebuild(&surface, &motion);
        let known = corners(&candidates.pairs);
        // Boxes are not those that all particles would get now, so only what touches on the way is
        // sure to be a pair of both.
        for share in [0.0, 0.5, 1.0] {
            let x = from.iter().zip(&to).map(|(a, b)| a.lerp(b, share));
            let x: Vec<_> = x.collect();
            let touches = |pair: &&FeaturePair| pair.proximity(&x).distance() < pair.thickness;
            for pair in whole.pairs.iter().filter(touches) {
                assert!(known.binary_search(&pair.corners).is_ok(), "step {step}");
                touch += 1;
            }
            stayed_and_touch += candidates.pairs[..stayed].iter().filter(touches).count();
            // Distances are bounded by how far the corners are from where they were taken.
            let moved = candidates.moved(&x);
            for pair in &candidates.pairs {
                let least = pair.distance - pair.approach(&moved);
                assert!(pair.proximity(&x).distance() >= least - 1e-15);
            }
        }
    }
    assert!(touch > 0 && stayed_and_touch > 0);
}

/// A vertex on a triangle of the other sheet is on neither side of it; once it is off, it must not
/// pass through, although it did not leave its box.
#[test]
fn features_that_met_are_a_pair_once_they_are_apart() {
    let (surface, first) = two_sheets([6, 3], turned);
    let surface = ContactSurface::new(surface);
    let vertex = first.len() - 1;
    let on = |height: f64| {
        let mut x = first.clone();
        x[vertex].z = height;
        x
    };
    let mut candidates = Candidates::default();
    let over = on(0.2 * THICKNESS);
    candidates.update(&surface, &motion(&over, &over));
    // The triangle that is right beneath.
    let beneath = candidates.pairs.iter().find(|pair| {
        let is_vertex = pair.features == Features::VertexTriangle && pair.corners[0] == vertex;
        is_vertex && (pair.distance - 0.2 * THICKNESS).abs() < 1e-12
    });
    let beneath = beneath.expect("the sheets lie on each other").corners;
    let is_pair = |found: &Candidates| corners(&found.pairs).binary_search(&beneath).is_ok();
    let met = on(0.0);
    candidates.update(&surface, &motion(&met, &met));
    assert!(!is_pair(&candidates));
    let mut off = over;
    // Something else leaves its box, which is what has pairs looked for.
    off[0].z += 3.0 * THICKNESS;
    assert!(candidates.update(&surface, &motion(&off, &off)) > 0);
    assert!(is_pair(&candidates));
    // A pair that comes to meet is left out again.
    off[1].z += 3.0 * THICKNESS;
    off[vertex].z = 0.0;
    candidates.update(&surface, &motion(&off, &off));
    assert!(!is_pair(&candidates));
}

/// Two fixed layers lie on the first sheet, and a vertex of it on one of them.
#[test]
fn fixed_cloth_is_no_pair_with_itself() {
    let place = |p: Vector3<f64>| turned(p) + Vector3::z() * 0.5 * THICKNESS;
    let (mut surface, mut x) = two_sheets([9, 4], place);
    let count = x.len() - FIRST;
    let second = surface.triangles.iter().filter(|t| t[0] >= FIRST);
    let third: Vec<_> = second.map(|t| t.map(|i| i + count)).collect();
    surface.triangles.extend(third);
    for i in FIRST..FIRST + count {
        x.push(x[i] + Vector3::z() * 0.3 * THICKNESS);
        surface.welded.push(i + count);
        surface.thickness.push(THICKNESS);
    }
    surface.fixed = x[FIRST..].to_vec();
    let surface = ContactSurface::new(surface);
    let mut candidates = Candidates::default();
    candidates.update(&surface, &motion(&x, &x));
    x[44] = (x[FIRST + 12] + x[FIRST + 13] + x[FIRST + 18]) / 3.0;
    for _ in 0..3 {
        // A corner of the first sheet leaves its boxes.
        x[0].z += 5.0 * THICKNESS;
        assert!(candidates.update(&surface, &motion(&x, &x)) > 0);
        let moves = |pair: &FeaturePair| pair.corners.iter().any(|&i| i < FIRST);
        assert!(candidates.pairs.iter().all(moves));
    }
}

/// Where cloth is crumpled to a point, more pairs may meet than are kept.
#[test]
fn pairs_beyond_the_limit_are_sought_again() {
    let (surface, first) = near_sheets();
    let crumpled: Vec<_> = first.iter().map(|p| p * 0.01).collect();
    let mut candidates = Candidates::default();
    candidates.rebuild(&surface, &motion(&crumpled, &crumpled));
    let kept = candidates.pairs.len();
    let mut x = crumpled.clone();
    x[0].z += 5.0 * THICKNESS;
    // One particle alone would not have all pairs sought.
    assert_eq!(candidates.update(&surface, &motion(&x, &x)), 0);
    let mut spread = Candidates::default();
    spread.rebuild(&surface, &motion(&first, &first));
    assert!(spread.update(&surface, &motion(&first, &first)) > 0);
    assert!(kept > spread.pairs.len());
}
