//! The pairs that may meet, of two small sheets.

use super::candidates::{Candidates, FeaturePair};
use super::confine::confine;
use super::proximity::Features;
use super::ranges::Way;
use super::surface::ContactSurface;
use super::tests::{THICKNESS, turned, two_sheets};
use nalgebra::Vector3;

fn way<'a>(from: &'a [Vector3<f64>], to: &'a [Vector3<f64>]) -> Way<'a> {
    Way {
        from,
        to,
        slack: 1e-3,
    }
}

fn corners(found: &Candidates) -> Vec<[usize; 4]> {
    let mut corners: Vec<_> = found.pairs.iter().map(|pair| pair.corners).collect();
    corners.sort_unstable();
    corners
}

#[test]
fn candidates_do_not_depend_on_what_was_looked_at_before() {
    let (surface, x) = two_sheets([4, 3], |p| turned(p) + Vector3::z() * 0.3 * THICKNESS);
    let surface = ContactSurface::new(surface);
    let mut far = x.clone();
    far.iter_mut().for_each(|p| *p *= 3.0);
    let mut candidates = Candidates::default();
    candidates.find(&surface, &way(&far, &x));
    candidates.find(&surface, &way(&x, &x));
    let mut again = Candidates::default();
    again.find(&surface, &way(&x, &x));
    assert_eq!(corners(&candidates), corners(&again));
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

/// Some particles of two sheets wander, others stay where they are.
#[test]
fn candidates_that_follow_some_particles_are_all_that_may_meet() {
    let (surface, first) = two_sheets([9, 4], |p| turned(p) + Vector3::z() * 3.0 * THICKNESS);
    let surface = ContactSurface::new(surface);
    let mut followed = Candidates::default();
    assert_eq!(followed.follow(&surface, &way(&first, &first)), 0);
    let mut x = first.clone();
    let mut has_stayed = false;
    for step in 0..40 {
        let to = x.iter().enumerate().map(|(i, p)| match i % 11 {
            // One in eleven comes nearer to the other sheet and leaves it again.
            0 => p + Vector3::new(0.0, 0.0, 0.4e-3 * f64::from(step % 8 - 4)),
            _ => *p,
        });
        let to: Vec<_> = to.collect();
        if !(followed.cover(&x) && followed.cover(&to)) {
            has_stayed |= followed.follow(&surface, &way(&x, &to)) > 0;
        }
        assert!(followed.cover(&x) && followed.cover(&to));
        // Boxes are not those that all particles would get now, so only what touches is sure to be
        // a pair of both.
        let touches = |pair: &&FeaturePair| pair.proximity(&to).distance() < pair.thickness;
        let mut whole = Candidates::default();
        whole.find(&surface, &way(&x, &to));
        let known = corners(&followed);
        for pair in whole.pairs.iter().filter(touches) {
            assert!(known.binary_search(&pair.corners).is_ok(), "step {step}");
        }
        // Distances are bounded by how far the corners have moved.
        let moved = followed.moved(&to);
        for pair in &followed.pairs {
            let least = pair.distance - pair.approach(&moved);
            assert!(pair.proximity(&to).distance() >= least - 1e-15);
        }
        x = to;
    }
    assert!(has_stayed);
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
    candidates.follow(&surface, &way(&over, &over));
    // The triangle that is right beneath.
    let beneath = candidates.pairs.iter().find(|pair| {
        let is_vertex = pair.features == Features::VertexTriangle && pair.corners[0] == vertex;
        is_vertex && (pair.distance - 0.2 * THICKNESS).abs() < 1e-12
    });
    let beneath = beneath.expect("the sheets lie on each other").corners;
    let is_pair = |found: &Candidates| corners(found).binary_search(&beneath).is_ok();
    let mut met = on(0.0);
    candidates.follow(&surface, &way(&met, &met));
    assert!(!is_pair(&candidates));
    let mut off = over;
    // Something else leaves its box, which is what has pairs looked for.
    for x in [&mut met, &mut off] {
        x[0].z += 3.0 * THICKNESS;
    }
    assert!(candidates.follow(&surface, &way(&off, &off)) > 0);
    assert!(is_pair(&candidates));
    // A pair that comes to meet is left out again.
    off[1].z += 3.0 * THICKNESS;
    off[vertex].z = 0.0;
    candidates.follow(&surface, &way(&off, &off));
    assert!(!is_pair(&candidates));
}
