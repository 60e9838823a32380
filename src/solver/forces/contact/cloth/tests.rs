//! Contact of two small sheets: derivatives, cut moves, untangling.

use super::*;
use crate::scene::{Analytic, Body};
use nalgebra::Matrix3;

pub(super) const THICKNESS: f64 = 1e-3;

/// A sheet of cells of 1 cm about the origin, as corners and triangles.
pub(super) fn sheet(cells: usize) -> (Vec<Vector3<f64>>, Vec<[usize; 3]>) {
    let side = cells + 1;
    let place = |k: usize| (k as f64 - 0.5 * cells as f64) * 0.01;
    let x = (0..side * side).map(|i| Vector3::new(place(i % side), place(i / side), 0.0));
    let corner = |i: usize, j: usize| j * side + i;
    let cells = (0..cells).flat_map(|j| (0..cells).map(move |i| (i, j)));
    let triangles = cells.flat_map(|(i, j)| {
        let [a, b] = [corner(i, j), corner(i + 1, j)];
        let [c, d] = [corner(i + 1, j + 1), corner(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    (x.collect(), triangles.collect())
}

/// Two sheets of so many cells, the second moved and turned, that nothing joins.
pub(super) fn two_sheets(
    cells: [usize; 2],
    place: impl Fn(Vector3<f64>) -> Vector3<f64>,
) -> (ClothSurface, Vec<Vector3<f64>>) {
    let (mut x, mut triangles) = sheet(cells[0]);
    let (other, others) = sheet(cells[1]);
    let first = x.len();
    x.extend(other.into_iter().map(place));
    triangles.extend(others.iter().map(|t| t.map(|i| i + first)));
    let edges = triangles
        .iter()
        .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let surface = ClothSurface {
        rest_edges: edges.map(|(a, b)| (a, b, 0.01)).collect(),
        triangles,
        welded: (0..x.len()).collect(),
        thickness: vec![THICKNESS; x.len()],
        fixed: vec![],
        order: None,
    };
    (surface, x)
}

/// A slight turn about a slanted axis, and a shift: no edges are parallel, and no vertex is above
/// an edge.
pub(super) fn turned(p: Vector3<f64>) -> Vector3<f64> {
    let turn = nalgebra::Rotation3::new(Vector3::new(0.004, 0.003, 0.3));
    turn * p + Vector3::new(0.0013, 0.0021, 0.0)
}

pub(super) fn contact(surface: ClothSurface) -> ClothContact {
    let area = vec![1e-4; surface.welded.len()];
    ClothContact::new(surface, area)
}

/// Edges that pierce triangles, tried one by one: the point where an edge meets a triangle's plane
/// is on the inner side of all three edges.
pub(super) fn crossings(surface: &ClothSurface, x: &[Vector3<f64>]) -> usize {
    let pierces = |[i, j]: [usize; 2], t: &[usize; 3]| {
        let [a, b, c] = t.map(|k| x[k]);
        let normal = (b - a).cross(&(c - a));
        let (from, to) = ((x[i] - a).dot(&normal), (x[j] - a).dot(&normal));
        let at = x[i] + (x[j] - x[i]) * (from / (from - to));
        let is_left =
            |p: Vector3<f64>, q: Vector3<f64>| (q - p).cross(&(at - p)).dot(&normal) >= 0.0;
        !t.contains(&i)
            && !t.contains(&j)
            && from * to <= 0.0
            && is_left(a, b)
            && is_left(b, c)
            && is_left(c, a)
    };
    let triangles = || surface.triangles.iter();
    let edges = triangles().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    edges
        .map(|edge| triangles().filter(|t| pierces(edge, t)).count())
        .sum()
}

#[test]
fn forces_are_the_slope_of_the_energy_and_the_hessian_is_that_of_the_forces() {
    let (surface, x) = two_sheets([3, 2], |p| turned(p) + Vector3::z() * 0.6 * THICKNESS);
    let mut contact = contact(surface);
    contact.accept(&x);
    assert_derivatives(&mut contact, &x);
}

/// Drawn out by less than the slip of some 30 micrometers at 100 Pa, and by more.
#[test]
fn friction_that_sticks_and_that_slips_has_the_derivatives_of_its_energy() {
    let (_, x) = two_sheets([3, 2], |p| turned(p) + Vector3::z() * 0.6 * THICKNESS);
    for shift in [5e-6, 2e-4] {
        let mut contact = rubbing(0.3);
        contact.accept(&x);
        assert_derivatives(&mut contact, &shifted(&x, shift));
    }
}

/// Two sheets of 9 and 4 cells with this coefficient of friction.
pub(super) fn rubbing(friction: f64) -> ClothContact {
    let (surface, x) = two_sheets([3, 2], turned);
    contact(surface).with_friction(Some(vec![friction; x.len()]))
}

/// The shape with the second sheet moved sideways \[m\].
pub(super) fn shifted(x: &[Vector3<f64>], by: f64) -> Vec<Vector3<f64>> {
    let move_ = Vector3::new(0.6, 0.8, 0.0) * by;
    let way = |(i, p): (usize, &Vector3<f64>)| if i < 16 { *p } else { p + move_ };
    x.iter().enumerate().map(way).collect()
}

/// Force of friction on the second sheet \[N\].
pub(super) fn held(contact: &ClothContact, x: &[Vector3<f64>]) -> Vector3<f64> {
    let mut force = vec![Vector3::zeros(); x.len()];
    let friction = contact.friction.as_ref().expect("friction");
    friction.add_force(x, &mut force);
    force[16..].iter().sum()
}

/// What was drawn out in two steps holds as in one, and turned with both sheets.
#[test]
fn friction_remembers_how_far_layers_slid_and_turns_with_them() {
    let (_, x) = two_sheets([3, 2], |p| turned(p) + Vector3::z() * 0.6 * THICKNESS);
    let far = shifted(&x, 4e-6);
    let mut once = rubbing(0.3);
    once.accept(&x);
    let at_once = held(&once, &far);
    let mut twice = rubbing(0.3);
    twice.accept(&x);
    twice.accept(&shifted(&x, 2e-6));
    twice.accept(&far);
    let in_two = held(&twice, &far);
    assert!(at_once.dot(&Vector3::new(0.6, 0.8, 0.0)) < 0.0);
    // Closest points and distances change by 4 micrometers of a millimeter at most.
    let off = (in_two - at_once).norm() / at_once.norm();
    assert!(off < 1e-2, "{in_two} {at_once}");
    let turn = nalgebra::Rotation3::new(Vector3::new(0.3, -0.8, 1.1));
    let turned: Vec<_> = far.iter().map(|p| turn * p + Vector3::x()).collect();
    twice.accept(&turned);
    let after = held(&twice, &turned);
    // Positions of 1 m are rounded by 1e-16 m, which is 1e-10 of what is drawn out.
    assert!((after - turn * in_two).norm() < 1e-8 * in_two.norm());
}

/// Pairs yield after 33 micrometers and less; those that were tied a tenth of a millimeter ago hold
/// what they can.
#[test]
fn layers_that_slid_hold_each_other_by_the_coefficient_times_the_normal_force() {
    let (_, x) = two_sheets([3, 2], |p| turned(p) + Vector3::z() * 0.6 * THICKNESS);
    let mut contact = rubbing(0.3);
    contact.accept(&x);
    let far = shifted(&x, 1e-4);
    assert!(contact.accept(&far));
    let mut held_most = 0.0;
    contact.for_each_touching(&far, |pair, proximity| {
        let pressure = respond(proximity.distance(), pair.thickness).pressure;
        held_most += 0.3 * pair.weight * pressure;
    });
    let (way, force) = (Vector3::new(0.6, 0.8, 0.0), held(&contact, &far));
    assert!(force.norm() <= held_most && force.dot(&way) < -0.9 * force.norm());
    // A pair that came up on the way, a hundredth of a cell, holds nothing yet.
    assert!(force.norm() > 0.8 * held_most, "{force} {held_most}");
}

/// Compares forces with differences of energies at `x`, and the Hessian with those of forces.
pub(super) fn assert_derivatives(contact: &mut ClothContact, x: &[Vector3<f64>]) {
    let count = x.len();
    let mut pairs = vec![];
    contact.add_coupled_pairs(&mut pairs);
    let sparsity = Sparsity::from_pairs(count, pairs);
    contact.bind(&sparsity);
    let mut hessian = BlockMatrix::zeros(&sparsity);
    contact.add_hessian(x, 0.0, &mut hessian);
    let step = 1e-8;
    let mut stiffest: f64 = 0.0;
    let forces = |contact: &mut ClothContact, x: &[Vector3<f64>]| {
        let mut force = vec![Vector3::zeros(); count];
        contact.add_force(x, &mut force);
        force
    };
    let here = forces(contact, x);
    let most = here.iter().map(Vector3::norm).fold(0.0, f64::max);
    assert!(most > 0.0);
    for i in 0..count {
        for axis in 0..3 {
            let mut moved = |by: f64| {
                let mut y = x.to_vec();
                y[i][axis] += by;
                (contact.energy(&y), forces(contact, &y))
            };
            let ((low, before), (high, after)) = (moved(-step), moved(step));
            let slope = (low - high) / (2.0 * step);
            // Differences of energies of about 1e-6 J round at 1e-22 J, over 2e-8 m.
            assert!(
                (slope - here[i][axis]).abs() < 1e-6 * most + 1e-12,
                "{slope}"
            );
            for j in 0..count {
                let change = (before[j] - after[j]) / (2.0 * step);
                let block = sparsity
                    .find(j, i)
                    .map_or(Matrix3::zeros(), |slot| hessian.get(slot));
                stiffest = stiffest.max(change.norm());
                let off = (block.column(axis) - change).norm();
                assert!(off < 1e-4 * stiffest, "{j} {i}: {off} of {stiffest}");
            }
        }
    }
}

/// Pairs that no matrix couples push back as stiffly at least.
#[test]
fn what_is_not_coupled_is_bounded_by_its_diagonal() {
    let (surface, x) = two_sheets([2, 1], |p| turned(p) + Vector3::z() * 0.6 * THICKNESS);
    let count = x.len();
    let mut contact = contact(surface);
    contact.accept(&x);
    let mut pairs = vec![];
    contact.add_coupled_pairs(&mut pairs);
    let mut product = |sparsity: &Sparsity, d: &[Vector3<f64>]| {
        contact.bind(sparsity);
        let mut hessian = BlockMatrix::zeros(sparsity);
        contact.add_hessian(&x, 1.0, &mut hessian);
        hessian.quadratic_form(sparsity, d)
    };
    let coupled = Sparsity::from_pairs(count, pairs);
    let bare = Sparsity::from_pairs(count, vec![]);
    for number in 0..count {
        let d: Vec<_> = (0..count)
            .map(|i| Vector3::new(0.1, -0.2, ((i * 7 + number * 5) % 11) as f64 - 5.0))
            .collect();
        let (exact, bound) = (product(&coupled, &d), product(&bare, &d));
        assert!(exact > 0.0 && exact <= bound, "{exact} {bound}");
    }
}

#[test]
fn a_sheet_that_is_moved_through_another_stops_before_it() {
    let (surface, x) = two_sheets([6, 3], |p| turned(p) + Vector3::z() * 0.01);
    let count = x.len();
    let first_moving = 49;
    let mut contact = contact(two_sheets([6, 3], |p| turned(p) + Vector3::z() * 0.01).0);
    let mut to = x.clone();
    for p in &mut to[first_moving..] {
        *p -= Vector3::z() * 0.03;
    }
    let straight = to.clone();
    contact.confine(&x, &mut to);
    assert_eq!(crossings(&surface, &x), 0);
    assert_eq!(crossings(&surface, &to), 0);
    for i in 0..count {
        let (moved, asked) = (to[i] - x[i], straight[i] - x[i]);
        // Along its way, by no more than it was to.
        assert!(moved.cross(&asked).norm() < 1e-15 && moved.norm() <= asked.norm());
    }
    // From above by a centimeter to the least distance that it keeps.
    let lowest = to[first_moving..].iter().map(|p| p.z).fold(1.0, f64::min);
    assert!(lowest > 0.0 && lowest < 0.005, "{lowest}");
}

#[test]
fn sheets_that_move_together_are_not_held_up() {
    let (surface, x) = two_sheets([4, 4], |p| turned(p) + Vector3::z() * 0.2 * THICKNESS);
    let mut contact = contact(surface);
    let mut to: Vec<_> = x
        .iter()
        .map(|p| p + Vector3::new(0.02, 0.01, 0.03))
        .collect();
    let straight = to.clone();
    contact.confine(&x, &mut to);
    assert_eq!(to, straight);
}

/// A corner of a sheet stuck through another one, upright and aslant.
#[test]
fn a_corner_stuck_through_a_sheet_is_pulled_out() {
    for tilt in [0.0, 0.5] {
        let stuck = |p: Vector3<f64>| {
            let on_its_corner = nalgebra::Rotation3::new(Vector3::z() * 0.8) * p;
            let upright = Vector3::new(on_its_corner.x, 0.0, on_its_corner.y + 0.008);
            let turn = nalgebra::Rotation3::new(Vector3::new(tilt, 0.1, 0.2));
            turn * upright + Vector3::new(0.001, 0.002, 0.0)
        };
        let (surface, mut x) = two_sheets([8, 2], stuck);
        assert!(crossings(&surface, &x) > 0);
        let mut contact = contact(two_sheets([8, 2], stuck).0);
        let is_fixed = vec![false; x.len()];
        assert!(contact.untangle(&mut x, &is_fixed));
        assert_eq!(crossings(&surface, &x), 0, "tilt {tilt}");
        // What was apart only just is so by a part of the thickness then.
        contact.accept(&x);
        let nearest = contact.candidates.pairs.iter().map(|pair| pair.distance);
        assert!(nearest.fold(1.0, f64::min) > 0.1 * THICKNESS);
    }
}

#[test]
fn what_is_fixed_is_not_moved_and_what_is_apart_is_left_alone() {
    let (surface, x) = two_sheets([3, 3], |p| turned(p) + Vector3::z() * 0.5 * THICKNESS);
    let mut contact = contact(surface);
    let mut apart = x.clone();
    assert!(!contact.untangle(&mut apart, &vec![false; x.len()]));
    assert_eq!(apart, x);
    let mut near = x.clone();
    near.iter_mut()
        .skip(16)
        .for_each(|p| p.z -= 0.49 * THICKNESS);
    let before = near.clone();
    contact.untangle(&mut near, &vec![true; x.len()]);
    assert_eq!(near, before);
}

/// A sheet most of which is beneath a fixed one comes out on the side of the body that its layer
/// says; by the lines in which they meet alone it goes the short way.
#[test]
fn layers_are_untangled_in_their_order() {
    let tilted = |p: Vector3<f64>| {
        let p = turned(p);
        p + Vector3::z() * (0.3 * (p.x + p.y) + 0.004)
    };
    let out = Vector3::z();
    let heights = |order: Option<[usize; 2]>| {
        let (mut surface, x) = two_sheets([8, 5], |p| tilted(p) - out * 0.002);
        let count = 81;
        let of_first = surface.triangles.iter().filter(|t| t[0] < count).count();
        let layers = order.map(|[first, second]| {
            let mut layer = vec![first; of_first];
            layer.resize(surface.triangles.len(), second);
            layer
        });
        surface.order = layers.map(|layer| LayerOrder {
            layer,
            body: Body::Analytic(Analytic::HalfSpace {
                c: [0.0, 0.0, -0.1],
                normal: [0.0, 0.0, 1.0],
            }),
        });
        let mut is_fixed = vec![true; count];
        is_fixed.resize(x.len(), false);
        let mut shape = x.clone();
        let mut contact = contact(surface);
        assert!(contact.untangle(&mut shape, &is_fixed));
        assert_eq!(shape[..count], x[..count]);
        let heights = shape[count..].iter().map(|p| p.z);
        heights.collect::<Vec<_>>()
    };
    assert!(heights(Some([0, 1])).iter().all(|z| *z > 0.0));
    assert!(heights(Some([1, 0])).iter().all(|z| *z < 0.0));
}
