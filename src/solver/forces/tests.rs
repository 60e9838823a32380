//! Every force against the differences of its energy, every second derivative against those of its
//! force, and closed forms.

use crate::scene::{Avatar, Body, DressForm, FiberSpring};
use crate::solver::forces::contact::{BodyContact, Facet, Friction, TipContact};
use crate::solver::forces::*;
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use std::sync::Arc;

/// Six points off a plane, the same every time.
fn points() -> Vec<Vector3<f64>> {
    let mut seed = 7_u32;
    let mut number = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1 << 24) - 0.5
    };
    let flat = [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [1.1, 1.2],
        [2.0, 0.1],
        [2.1, 1.1],
    ];
    flat.iter()
        .map(|[u, v]| Vector3::new(*u, *v, 0.0) + Vector3::new(number(), number(), number()) * 0.3)
        .collect()
}

fn dense(force: &mut dyn Potential, x: &[Vector3<f64>], hessian_modification: f64) -> DMatrix<f64> {
    let mut pairs = Vec::new();
    force.add_coupled_pairs(&mut pairs);
    let sparsity = Sparsity::from_pairs(x.len(), pairs);
    force.bind(&sparsity);
    let mut blocks = BlockMatrix::zeros(&sparsity);
    force.add_hessian(x, hessian_modification, &mut blocks);
    let mut dense = DMatrix::zeros(3 * x.len(), 3 * x.len());
    for column in 0..x.len() {
        for (row, slot) in sparsity.column(column) {
            let block: Matrix3<f64> = blocks.blocks[slot];
            dense
                .view_mut((3 * row, 3 * column), (3, 3))
                .copy_from(&block);
            dense
                .view_mut((3 * column, 3 * row), (3, 3))
                .copy_from(&block.transpose());
        }
    }
    dense
}

fn net(force: &mut dyn Potential, x: &[Vector3<f64>]) -> Vec<f64> {
    let mut f = vec![Vector3::zeros(); x.len()];
    force.add_force(x, &mut f);
    f.iter().flat_map(|v| [v.x, v.y, v.z]).collect()
}

/// Central differences with step `h` have errors of order h² times the third derivative plus
/// rounding eps |E| / h: `within` bounds both, relative to the largest number compared.
fn check_derivatives(force: &mut dyn Potential, x: &[Vector3<f64>], h: f64, within: f64) {
    let analytic = net(force, x);
    let second = dense(force, x, 0.0);
    let mut differences = (
        vec![0.0; analytic.len()],
        DMatrix::zeros(analytic.len(), analytic.len()),
    );
    for i in 0..analytic.len() {
        let moved = |by: f64| {
            let mut x = x.to_vec();
            x[i / 3][i % 3] += by;
            x
        };
        let (ahead, behind) = (moved(h), moved(-h));
        differences.0[i] = -(force.energy(&ahead) - force.energy(&behind)) / (2.0 * h);
        let (ahead, behind) = (net(force, &ahead), net(force, &behind));
        for j in 0..analytic.len() {
            differences.1[(j, i)] = -(ahead[j] - behind[j]) / (2.0 * h);
        }
    }
    let largest = analytic.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    for (a, d) in analytic.iter().zip(&differences.0) {
        assert!(
            (a - d).abs() <= within * largest,
            "{}: force {a} against {d}",
            force.kind().name()
        );
    }
    let apart = (&second - &differences.1).amax();
    assert!(
        apart <= within * second.amax().max(1e-12),
        "{}: second derivatives {apart} apart",
        force.kind().name()
    );
}

/// The convex part has no eigenvalue below rounding.
fn check_convex(force: &mut dyn Potential, x: &[Vector3<f64>]) {
    let convex = dense(force, x, 1.0);
    let lowest = convex.clone().symmetric_eigenvalues().min();
    assert!(
        lowest >= -1e-12 * convex.amax(),
        "{}: lowest eigenvalue {lowest}",
        force.kind().name()
    );
}

fn springs() -> SpringForce {
    let spring = |a, b, rest_length| Spring {
        a,
        b,
        rest_length,
        stiffness: 300.0,
    };
    // One pulled, one pressed together.
    SpringForce::new(vec![
        spring(0, 1, 0.4),
        spring(1, 3, 2.0),
        spring(2, 4, 1.0),
        spring(5, 0, 3.5),
    ])
}

fn membranes() -> ContinuumForce {
    let moduli = [900.0, 400.0, 50.0];
    let triangle = |particles, rest| MembraneTriangle::new(particles, rest, moduli).unwrap();
    let buckling = |particles, rest| triangle(particles, rest).with_buckling([0.5, 0.3], 2.0);
    ContinuumForce::new(vec![
        buckling([0, 2, 5], [[0.0, 0.0], [2.2, 0.1], [0.0, 2.1]]),
        triangle([0, 1, 2], [[0.0, 0.0], [1.2, 0.1], [0.0, 1.0]]),
        triangle([1, 3, 2], [[1.2, 0.1], [1.3, 1.4], [0.0, 1.0]]),
        triangle([1, 4, 3], [[0.0, 0.0], [0.7, 0.0], [0.1, 0.9]]),
    ])
}

/// Springs of a coarser mesh, pulled and pressed.
fn fibers() -> FiberForce {
    let fiber = |corners, weights, rest_length_m| FiberSpring {
        corners,
        weights,
        rest_length_m,
        stiffness_n_m: 200.0,
    };
    FiberForce::new(vec![
        fiber([0, 1, 2], [-0.7, 1.2, -0.5], 0.4),
        fiber([3, 4, 5], [0.3, 0.9, -1.2], 3.0),
    ])
}

/// Cloth pressed to 0.8 of its length carries the load of a strip as long as a mesh edge that has
/// buckled, and no more.
#[test]
fn a_triangle_pressed_together_carries_the_load_of_a_buckled_strip() {
    let (rigidity, edge) = (1e-5, 0.01_f64);
    let rest = [
        [0.0, 0.0],
        [edge, 0.0],
        [0.5 * edge, 0.75_f64.sqrt() * edge],
    ];
    let membrane = MembraneTriangle::new([0, 1, 2], rest, [1000.0, 1000.0, 100.0]).unwrap();
    let mut force = ContinuumForce::new(vec![membrane.with_buckling([rigidity; 2], edge)]);
    let x = rest.map(|[u, v]| Vector3::new(0.8 * u, v, 0.0));
    let mut net = [Vector3::zeros(); 3];
    force.add_force(&x, &mut net);
    // Green's strain of 0.8 is -0.18; a stress S pushes corner 1 by A S 0.8 times the gradient 1/l
    // of its shape function.
    let critical = std::f64::consts::PI.powi(2) * rigidity / (edge * edge);
    let stress = critical * (1.0 + 0.5 * (0.18 - critical / 1000.0));
    let push = membrane.area * stress * 0.8 / edge;
    assert!(
        (net[1].x / push - 1.0).abs() < 1e-12,
        "{} against {push}",
        net[1].x
    );
}

/// Two triangles that share an edge, one with a third neighbor, in a fabric stiffer along its warp.
fn patches() -> BendForce {
    let rest = [[0.0, 0.0], [1.0, 0.1], [0.1, 1.1], [1.2, 1.2], [0.9, -0.8]];
    let wing = |v: usize| Some((v, rest[v]));
    let patch = |corners: [usize; 3], wings| {
        BendPatch::new(corners, corners.map(|v| rest[v]), wings, [2e-3, 1e-3]).unwrap()
    };
    BendForce::new(vec![
        patch([0, 1, 2], [wing(3), None, wing(4)]),
        patch([1, 3, 2], [None, wing(0), None]),
    ])
}

#[test]
fn forces_are_the_gradients_of_their_energies() {
    let x = points();
    let mut forces: Vec<Box<dyn Potential>> = vec![
        Box::new(springs()),
        Box::new(membranes()),
        Box::new(fibers()),
        Box::new(patches()),
        Box::new(SewingForce::new(vec![(0, 4), (2, 5)], 1e3)),
        Box::new(Gravity {
            weight: vec![Vector3::new(0.0, -0.3, 0.1); 6],
            start: vec![Vector3::zeros(); 6],
        }),
    ];
    for force in &mut forces {
        // h = 1e-5: h² and eps / h are both about 1e-10; a margin of a hundred for the third
        // derivatives.
        check_derivatives(force.as_mut(), &x, 1e-5, 1e-8);
        check_convex(force.as_mut(), &x);
    }
}

/// Stitches shorter and longer than that at which they pull their most.
#[test]
fn stitches_pull_with_a_limited_force_below_an_upper_bound() {
    let x = points();
    let pairs = vec![(0, 4), (2, 5)];
    let lengths = pairs
        .iter()
        .map(|&(a, b): &(usize, usize)| (x[a] - x[b]).norm());
    let [least, greatest] = lengths.fold([f64::INFINITY, 0.0], |[least, most], l| {
        [least.min(l), most.max(l)]
    });
    assert!(least < greatest);
    let (stiffness, most) = (1e3, 1e3 * 0.5 * (least + greatest));
    let mut force = SewingForce::new(pairs, stiffness).with_max_force(most);
    let pull = DVector::from_vec(net(&mut force, &x));
    let of = |i: usize| pull.fixed_rows::<3>(3 * i).norm();
    assert!((of(0).max(of(2)) - most).abs() < 1e-12 * most);
    assert!((of(0).min(of(2)) - stiffness * least).abs() < 1e-12 * most);
    let second = dense(&mut force, &x, 0.0);
    let before = force.energy(&x);
    for k in 0..1000_u32 {
        let angle = |i: usize| f64::from(k) + 2.0 * i as f64;
        let step = DVector::from_fn(pull.len(), |i, _| 0.1 * angle(i).sin());
        let moved = x.iter().zip(step.as_slice().as_chunks::<3>().0);
        let moved: Vec<_> = moved.map(|(x, s)| x + Vector3::from(*s)).collect();
        let bound = before - pull.dot(&step) + 0.5 * step.dot(&(&second * &step));
        assert!(force.energy(&moved) < bound + 1e-12 * before, "{k}");
    }
}

#[test]
fn contact_and_friction_are_the_gradients_of_their_energy() {
    let avatar = Arc::new(DressForm::default().build().unwrap());
    let hip = avatar.landmarks["hip_front"];
    // Inside the layer, on its edge's far side, deep, and away.
    let mut x: Vec<_> = [
        (0.0, 1.2e-3),
        (0.03, 0.2e-3),
        (-0.05, -0.5e-3),
        (0.01, 0.02),
    ]
    .iter()
    .map(|(aside, out)| {
        let p = hip + Vector3::new(*aside, *aside, 0.05);
        let skin = avatar.nearest_point(&p);
        skin + (p - skin).normalize() * *out
    })
    .collect();
    let mut contact = BodyContact::new(Body::Avatar(avatar), 2e-3, &[1e-4; 4])
        .with_friction(Some(Friction::new(0.3, 4)));
    contact.accept(&x);
    // One sticks, the others slip: the first moves by less than the give of its spring (0.3 x 0.8
    // mm).
    x[0] += Vector3::new(5e-5, 0.0, 0.0);
    x[1] += Vector3::new(2e-3, 0.0, 0.0);
    x[2] += Vector3::new(0.0, 3e-3, 0.0);
    // The field bends on the scale of its grid, 9 mm: h = 1e-7 keeps h² d³ below 1e-10 and rounding
    // of the energy near 1e-7.
    check_derivatives(&mut contact, &x, 1e-7, 1e-5);
    check_convex(&mut contact, &x);
}

/// A triangle with corners 5 mm about a place on the skin, so far out.
fn triangle_at(avatar: &Avatar, place: &Vector3<f64>, out: f64) -> Vec<Vector3<f64>> {
    let skin = avatar.nearest_point(place);
    let normal = avatar.sample(&skin).unwrap().normal.normalize();
    let aside = normal.cross(&Vector3::y()).normalize();
    let along = normal.cross(&aside);
    [[1.0, 0.0], [-0.5, 0.8], [-0.4, -0.9]]
        .iter()
        .map(|[a, b]| skin + normal * out + (aside * *a + along * *b) * 5e-3)
        .collect()
}

#[test]
fn what_is_between_the_corners_is_kept_off_tips_and_off_nothing_else() {
    let avatar = Arc::new(DressForm::default().build().unwrap());
    // The busts of a form have a radius of some 6 cm; its hips in front are flatter.
    let tips = avatar.tips(12.0).expect("shoulders and busts");
    let facet = Facet {
        corners: [0, 1, 2],
        area: 1e-4,
    };
    let body = Body::Avatar(avatar.clone());
    let mut contact = TipContact::new(body, tips, vec![facet], 1.0);
    let x = triangle_at(&avatar, &avatar.landmarks["bust_point_l"], 0.8e-3);
    contact.accept(&x);
    assert!(contact.energy(&x) > 0.0);
    // As of the contact of particles.
    check_derivatives(&mut contact, &x, 1e-7, 1e-5);
    check_convex(&mut contact, &x);
    let x = triangle_at(&avatar, &avatar.landmarks["waist_front"], 0.8e-3);
    contact.accept(&x);
    assert_eq!(contact.energy(&x), 0.0);
}

#[test]
fn a_stretched_patch_has_no_net_force_inside_and_the_energy_of_the_continuum() {
    // A square of four triangles about a point off its middle, stretched by 3 % along warp and 1 %
    // along weft.
    let flat = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.4, 0.3]];
    let moduli = [1000.0, 300.0, 20.0];
    let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    let mut force = ContinuumForce::new(
        triangles
            .iter()
            .map(|t| MembraneTriangle::new(*t, t.map(|v| flat[v]), moduli).unwrap())
            .collect(),
    );
    let x: Vec<_> = flat
        .iter()
        .map(|[u, v]| Vector3::new(1.03 * u, 0.0, 1.01 * v))
        .collect();
    let f = net(&mut force, &x);
    // Sums of four terms of up to 30 N, rounded.
    assert!(f[12..].iter().all(|f| f.abs() < 1e-12));
    let green = |stretch: f64| 0.5 * (stretch * stretch - 1.0);
    let exact = 0.5 * (moduli[0] * green(1.03).powi(2) + moduli[1] * green(1.01).powi(2));
    assert!((force.energy(&x) - exact).abs() < 1e-13 * exact.max(1.0));
}

#[test]
fn a_bent_patch_has_the_energy_of_the_plate_whatever_its_triangles() {
    let rest = [
        [0.0, 0.0],
        [1.0, 0.1],
        [0.1, 1.1],
        [1.2, 1.0],
        [-0.9, 0.7],
        [0.7, -0.8],
    ];
    let wing = |v: usize| Some((v, rest[v]));
    let (corners, rigidity) = ([rest[0], rest[1], rest[2]], [2e-3, 5e-4]);
    let whole = BendPatch::new([0, 1, 2], corners, [wing(3), wing(4), wing(5)], rigidity).unwrap();
    let edge = BendPatch::new([0, 1, 2], corners, [wing(3), wing(4), None], rigidity).unwrap();
    let area = 0.5 * (1.0 * 1.1 - 0.1 * 0.1);
    let [bw, bf] = rigidity;
    for [warp, weft, twist] in [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.4, -0.3, 0.7],
    ] {
        let height = |[x, y]: [f64; 2]| 0.5 * warp * x * x + 0.5 * weft * y * y + twist * x * y;
        let x: Vec<_> = rest
            .map(|p| Vector3::new(p[0], p[1], height(p) + 0.3 * p[0] - 2.0))
            .to_vec();
        let exact = 0.5 * area * (bw * warp * warp + bf * weft * weft + (bw + bf) * twist * twist);
        // Some ten products of numbers of order one.
        let energy = BendForce::new(vec![whole]).energy(&x);
        assert!((energy - exact).abs() < 1e-14, "{energy} {exact}");
        // A free edge can only take energy away.
        assert!(BendForce::new(vec![edge]).energy(&x) <= exact);
    }
}

#[test]
fn a_hold_keeps_its_place_but_along_the_free_direction() {
    let x = points();
    let hold = |place: &Vector3<f64>| ParticleHold {
        place: place * 0.9,
        free: Vector3::new(0.6, 0.0, 0.8),
        stiffness: 3.0,
    };
    let mut holds = Hold::new(x.iter().map(hold).collect());
    check_derivatives(&mut holds, &x, 1e-4, 1e-7);
    check_convex(&mut holds, &x);
    let along: Vec<_> = x
        .iter()
        .map(|p| p * 0.9 + Vector3::new(0.6, 0.0, 0.8))
        .collect();
    assert!(holds.energy(&along) < 1e-24);
}
