//! Fixed cloth against cloth that moves.

use super::tests::*;
use super::*;
use nalgebra::Matrix3;

/// A second sheet that is fixed acts on the first as one that moves and happens to rest.
#[test]
fn fixed_cloth_acts_as_cloth_that_rests() {
    let place = |p: Vector3<f64>| turned(p) + Vector3::z() * 0.6 * THICKNESS;
    let (surface, x) = two_sheets([3, 2], place);
    let count = 16;
    let mut free = contact(surface);
    let (mut surface, _) = two_sheets([3, 2], place);
    surface.fixed = x[count..].to_vec();
    let mut beside = contact(surface);
    free.accept(&x);
    beside.accept(&x[..count]);
    assert_acts_alike(&mut beside, &mut free, &x, count);

    // The first sheet does not get through the second.
    let through = Vector3::z() * 10.0 * THICKNESS;
    let mut to: Vec<_> = x[..count].iter().map(|p| p + through).collect();
    beside.confine(&x[..count], &mut to);
    assert!(
        to.iter()
            .zip(&x)
            .any(|(end, from)| (end - from).norm() < through.norm())
    );
    let (surface, _) = two_sheets([3, 2], place);
    assert_eq!(crossings(&surface, &[&to, &x[count..]].concat()), 0);
}

/// Friction too, by the smaller coefficient at each place: less and more than what ties hold.
#[test]
fn fixed_cloth_holds_as_cloth_that_rests() {
    let place = |p: Vector3<f64>| turned(p) + Vector3::z() * 0.6 * THICKNESS;
    let (_, x) = two_sheets([3, 2], place);
    let count = 16;
    let coefficient = |i: usize| {
        if i < count {
            0.3
        } else {
            0.05 * (i - count) as f64
        }
    };
    let rubbing = |fixed: &[Vector3<f64>]| {
        let (mut surface, _) = two_sheets([3, 2], place);
        surface.fixed = fixed.to_vec();
        contact(surface).with_friction(Some((0..x.len()).map(coefficient).collect()))
    };
    let (mut free, mut beside) = (rubbing(&[]), rubbing(&x[count..]));
    free.accept(&x);
    beside.accept(&x[..count]);
    for by in [5e-6, 2e-4] {
        let mut moved = x.clone();
        let shift = Vector3::new(0.6, 0.8, 0.0) * by;
        moved[..count].iter_mut().for_each(|p| *p += shift);
        assert_acts_alike(&mut beside, &mut free, &moved, count);
        let mut alone = rubbing(&[]);
        alone.accept(&moved);
        let held = free.energy(&moved) - alone.energy(&moved);
        assert!(held > 0.0, "{held}");
        // What slipped is remembered alike.
        assert_eq!(free.accept(&moved), beside.accept(&moved[..count]));
        assert_acts_alike(&mut beside, &mut free, &moved, count);
    }
}

/// Compares energy, forces and Hessian of contact of which the vertices from `count` on are fixed
/// with those of contact of which they are free, at `x`.
fn assert_acts_alike(
    beside: &mut ClothContact,
    free: &mut ClothContact,
    x: &[Vector3<f64>],
    count: usize,
) {
    assert!(free.energy(x) > 0.0);
    // The pairs come in another order, so sums round otherwise.
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs().max(1e-12);
    assert!(near(beside.energy(&x[..count]), free.energy(x)));
    let (mut all, mut part) = (
        vec![Vector3::zeros(); x.len()],
        vec![Vector3::zeros(); count],
    );
    free.add_force(x, &mut all);
    beside.add_force(&x[..count], &mut part);
    for (a, b) in part.iter().zip(&all) {
        assert!((a - b).norm() <= 1e-12 * b.norm().max(1e-9), "{a} {b}");
    }
    let hessian = |contact: &mut ClothContact, x: &[Vector3<f64>]| {
        let mut pairs = vec![];
        contact.add_coupled_pairs(&mut pairs);
        let sparsity = Sparsity::from_pairs(x.len(), pairs);
        contact.bind(&sparsity);
        let mut hessian = BlockMatrix::zeros(&sparsity);
        contact.add_hessian(x, 0.0, &mut hessian);
        let blocks = (0..count).flat_map(|i| (0..=i).map(move |j| (i, j)));
        let block = |(i, j)| {
            sparsity
                .find(i, j)
                .map_or(Matrix3::zeros(), |s| hessian.get(s))
        };
        blocks.map(block).collect::<Vec<_>>()
    };
    let whole = hessian(free, x);
    let stiffest = whole.iter().map(Matrix3::norm).fold(0.0, f64::max);
    for (a, b) in hessian(beside, &x[..count]).iter().zip(&whole) {
        assert!((a - b).norm() <= 1e-12 * stiffest, "{a} {b}");
    }
}
