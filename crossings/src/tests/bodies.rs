//! Cloth on bodies of boxes, for which all is known in whole numbers.

use super::exact;
use super::meshes::sheet;
use super::pairs::whole;
use super::random::Random;
use crate::tests::{ALL, is_clear};
use crate::winding::{is_closed, winding_number};
use crate::{
    CrossingReport, SearchLimits, SegmentSearch, Surface, TooManyPairs, find_crossings,
    find_crossings_between,
};

type Mesh = (Vec<[f32; 3]>, Vec<[u32; 3]>);
type Cuboid = [[f32; 3]; 2];

/// Returns the surface of boxes, each a closed part of it.
fn boxes(cuboids: &[Cuboid]) -> Mesh {
    let (mut positions, mut triangles) = (vec![], vec![]);
    for bounds in cuboids {
        let first = u32::try_from(positions.len()).expect("few");
        let corner = |v: usize| [0, 1, 2].map(|k| bounds[v >> k & 1][k]);
        positions.extend((0..8).map(corner));
        for [a, b, c, d] in [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ] {
            triangles.extend([[a, b, c], [a, c, d]].map(|t| t.map(|v| v + first)));
        }
    }
    (positions, triangles)
}

fn judge(cloth: &Mesh, body: &Mesh) -> CrossingReport {
    let cloth = Surface::new(&cloth.0, &cloth.1, &[]).expect("a sound mesh");
    let body = Surface::new(&body.0, &body.1, &[]).expect("a sound mesh");
    find_crossings(&cloth, Some(&body), ALL).expect("no limit")
}

/// Two boxes that overlap, one that touches a face of the first, and one apart.
const CUBOIDS: [Cuboid; 4] = [
    [[-4.0, -4.0, -4.0], [2.0, 2.0, 2.0]],
    [[0.0, -2.0, -2.0], [6.0, 4.0, 4.0]],
    [[-4.0, -4.0, -8.0], [2.0, 2.0, -4.0]],
    [[-8.0, 6.0, 6.0], [-6.0, 8.0, 8.0]],
];

/// Returns eight times the mean winding number of whole boxes around a whole point, and if it is
/// the same all around.
fn eightfold_winding(p: [f32; 3]) -> (usize, bool) {
    let around = (0..8).map(|octant: u32| {
        let near = [0, 1, 2].map(|k| p[k] + if octant >> k & 1 == 1 { 0.25 } else { -0.25 });
        let holds = |b: &Cuboid| (0..3).all(|k| b[0][k] < near[k] && near[k] < b[1][k]);
        CUBOIDS.map(|b| holds(&b))
    });
    let around: Vec<[bool; 4]> = around.collect();
    let is_off_walls = around.iter().all(|holds| *holds == around[0]);
    (
        around.iter().flatten().filter(|h| **h).count(),
        is_off_walls,
    )
}

#[test]
fn winding_numbers_of_boxes_are_those_of_the_octants_around() {
    let body = boxes(&CUBOIDS);
    let body = Surface::new(&body.0, &body.1, &[]).expect("a sound mesh");
    let mut random = Random::new(5);
    for _ in 0..3000 {
        let p = random.point(9);
        let expected = eightfold_winding(p).0 as f64 / 8.0;
        let found = winding_number(&body, &p.map(f64::from));
        assert!(
            (found - expected).abs() < 1e-12,
            "{p:?}: {found}, {expected}"
        );
    }
}

#[test]
fn vertices_inside_and_crossings_are_those_of_whole_numbers() {
    let body = boxes(&CUBOIDS);
    let mut random = Random::new(17);
    let (mut inside, mut crossing, mut buried) = (0, 0, 0);
    for extent in [3, 9] {
        for _ in 0..40 {
            let positions: Vec<_> = (0..40).map(|_| random.point(extent)).collect();
            // A strip, so that one evaluation decides for many.
            let cloth = (positions, (0..38).map(|i| [i, i + 1, i + 2]).collect());
            let report = judge(&cloth, &body);
            let is_inside = |v: u32| {
                let (winding, is_off_walls) = eightfold_winding(cloth.0[v as usize]);
                winding >= if is_off_walls { 4 } else { 8 }
            };
            let expected: Vec<u32> = (0..40).filter(|v| is_inside(*v)).collect();
            assert_eq!(report.inside, expected);
            inside += expected.len();

            let expected = meeting_pairs(&cloth, &body);
            let all = expected.len();
            let is_counted = |t: u32| !cloth.1[t as usize].into_iter().all(is_inside);
            let expected: Vec<_> = expected.into_iter().filter(|p| is_counted(p[0])).collect();
            let found: Vec<_> = report.body.kept.iter().map(|c| c.triangles).collect();
            assert_eq!(found, expected);
            crossing += found.len();
            buried += all - found.len();
        }
    }
    assert!(
        inside > 500 && crossing > 5000 && buried > 100,
        "{inside} {crossing} {buried}"
    );
}

/// A surface without an inside is met wherever triangles have a common point, be it in a body.
#[test]
fn crossings_of_two_surfaces_are_those_of_all_pairs() {
    let other = boxes(&CUBOIDS);
    let surface = Surface::new(&other.0, &other.1, &[]).expect("a sound mesh");
    let mut random = Random::new(23);
    let positions: Vec<_> = (0..200).map(|_| random.point(9)).collect();
    let cloth: Mesh = (positions, (0..198).map(|i| [i, i + 1, i + 2]).collect());
    let sheet = Surface::new(&cloth.0, &cloth.1, &[]).expect("a sound mesh");
    let found = find_crossings_between(&sheet, &surface, ALL).expect("no limit");
    let pairs: Vec<_> = found.kept.iter().map(|c| c.triangles).collect();
    assert_eq!(pairs, meeting_pairs(&cloth, &other));
    assert!(found.count == pairs.len() && found.count > 100);
    let few = SearchLimits { kept: 3, ..ALL };
    let some = find_crossings_between(&sheet, &surface, few).expect("no limit");
    assert_eq!(
        (some.count, &some.kept[..]),
        (found.count, &found.kept[..3])
    );
    let limits = SearchLimits { pairs: 3, ..ALL };
    let refused = find_crossings_between(&sheet, &surface, limits);
    assert_eq!(refused, Err(TooManyPairs));
}

/// A segment is a triangle two corners of which are one.
#[test]
fn segments_meet_what_triangles_without_area_meet() {
    let other = boxes(&CUBOIDS);
    let surface = Surface::new(&other.0, &other.1, &[]).expect("a sound mesh");
    let mut search = SegmentSearch::new(&surface, usize::MAX);
    let mut random = Random::new(29);
    let mut count = 0;
    for _ in 0..300 {
        let ends = [random.point(9), random.point(9)];
        let met = search.meeting(ends).expect("no limit");
        let met: Vec<_> = met.into_iter().map(|(t, _)| [0, t]).collect();
        let flat = (ends.to_vec(), vec![[0, 1, 1]]);
        assert_eq!(met, meeting_pairs(&flat, &other));
        count += met.len();
    }
    assert!(count > 100);
    let mut none = SegmentSearch::new(&surface, 0);
    assert_eq!(none.meeting([[-9.0; 3], [9.0; 3]]), Err(TooManyPairs));
}

/// Returns pairs of a triangle of each mesh that have a common point, by trying all.
fn meeting_pairs(cloth: &Mesh, body: &Mesh) -> Vec<[u32; 2]> {
    let corners = |mesh: &Mesh, t: u32| mesh.1[t as usize].map(|v| whole(mesh.0[v as usize]));
    let count = |mesh: &Mesh| u32::try_from(mesh.1.len()).expect("few");
    (0..count(cloth))
        .flat_map(|t| (0..count(body)).map(move |b| [t, b]))
        .filter(|[t, b]| exact::meet(&corners(cloth, *t), &corners(body, *b)))
        .collect()
}

/// Returns a sheet of small squares, tilted, about the origin.
fn tilted_sheet() -> Mesh {
    let (mut positions, triangles) = sheet(30, 0.37);
    for p in &mut positions {
        *p = [p[0] - 5.1, p[1] - 5.3, 0.3 * p[0] + 0.1 * p[1] - 2.2];
    }
    (positions, triangles)
}

#[test]
fn one_evaluation_a_part_decides_like_one_a_vertex() {
    let (cloth, body) = (tilted_sheet(), boxes(&CUBOIDS));
    let report = judge(&cloth, &body);
    let surface = Surface::new(&body.0, &body.1, &[]).expect("a sound mesh");
    let is_inside = |p: &[f32; 3]| winding_number(&surface, &p.map(f64::from)) >= 0.5;
    let expected: Vec<u32> = (0..)
        .zip(&cloth.0)
        .filter(|(_, p)| is_inside(p))
        .map(|(v, _)| v)
        .collect();
    assert_eq!(report.inside, expected);
    assert!(expected.len() > 200 && expected.len() < 700);
}

/// With a hole, winding numbers change off the surface, and each vertex is evaluated.
#[test]
fn a_body_with_a_hole_has_an_inside() {
    let cloth = tilted_sheet();
    let mut body = boxes(&CUBOIDS[..1]);
    body.1.pop();
    let surface = Surface::new(&body.0, &body.1, &[]).expect("a sound mesh");
    assert!(!is_closed(&surface));
    let is_inside = |p: &[f32; 3]| winding_number(&surface, &p.map(f64::from)) >= 0.5;
    let expected = (0..).zip(&cloth.0).filter(|(_, p)| is_inside(p));
    let expected: Vec<u32> = expected.map(|(v, _)| v).collect();
    assert_eq!(judge(&cloth, &body).inside, expected);
    assert!(expected.len() > 50);
}

/// Corners of their own for each triangle, as files have them where textures end.
#[test]
fn places_close_a_surface_not_indices() {
    let (positions, triangles) = boxes(&CUBOIDS);
    let corners = triangles.iter().flatten();
    let mut positions: Vec<_> = corners.map(|v| positions[*v as usize]).collect();
    // Both zeros are one place.
    for x in positions.iter_mut().step_by(2).flatten() {
        *x = if *x == 0.0 { -0.0 } else { *x };
    }
    let count = u32::try_from(triangles.len()).expect("few");
    let triangles: Vec<_> = (0..count).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let is_closed = |triangles| {
        let surface = Surface::new(&positions, triangles, &[]).expect("a sound mesh");
        is_closed(&surface)
    };
    assert!(is_closed(&triangles));
    assert!(!is_closed(&triangles[1..]));
}

#[test]
fn a_sheet_that_rests_on_a_box_touches_it_and_is_not_inside() {
    let body = boxes(&CUBOIDS[..1]);
    let (mut positions, triangles) = sheet(3, 1.0);
    let resting = |positions: &mut Vec<[f32; 3]>, height: f32| {
        positions.iter_mut().for_each(|p| p[2] = height);
        judge(&(positions.clone(), triangles.clone()), &body)
    };
    let touching = resting(&mut positions, 2.0);
    assert!(touching.body.count > 0 && touching.inside.is_empty());
    assert!(is_clear(&resting(&mut positions, 2.0 + f32::EPSILON * 2.0)));
    // Wholly inside, it meets nothing; the part of it beyond the box crosses its side.
    let sunk = resting(&mut positions, 2.0 - f32::EPSILON);
    assert_eq!(sunk.inside, [0, 1, 4, 5]);
    assert!(sunk.body.count > 0);
}

/// Cloth all inside, across the wall of another part of the body: no crossing of the hull.
#[test]
fn walls_inside_do_not_count() {
    let body = boxes(&CUBOIDS[..2]);
    let cloth = (
        vec![[-1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0]],
        vec![[0, 1, 2]],
    );
    assert!(!meeting_pairs(&cloth, &body).is_empty());
    let report = judge(&cloth, &body);
    assert_eq!((report.body.count, report.inside), (0, vec![0, 1, 2]));
}

/// A stitch that springs hold open across a wall: one of its ends is inside, the other is not.
#[test]
fn ends_of_an_open_stitch_are_decided_apart() {
    let triangle = |x: f32| [[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
    let positions = [triangle(1.5), triangle(2.5)].concat();
    let triangles = [[0, 1, 2], [3, 4, 5]];
    let stitches = [[0, 3], [1, 4], [2, 5]];
    let cloth = Surface::new(&positions, &triangles, &stitches).expect("a sound mesh");
    let body = boxes(&CUBOIDS[..1]);
    let body = Surface::new(&body.0, &body.1, &[]).expect("a sound mesh");
    assert_eq!(
        find_crossings(&cloth, Some(&body), ALL)
            .expect("no limit")
            .inside,
        [0, 1, 2]
    );
}

#[test]
fn angles_that_are_summed_up_count_as_pairs() {
    let positions = [[9.0, 0.0, 0.0], [9.0, 1.0, 0.0], [9.0, 0.0, 1.0]];
    let cloth = Surface::new(&positions, &[[0, 1, 2]], &[]).expect("a sound mesh");
    let body = boxes(&CUBOIDS[..1]);
    let surface = Surface::new(&body.0, &body.1, &[]).expect("a sound mesh");
    // Far off, one winding number decides for all of the triangle.
    for (pairs, is_enough) in [(body.1.len() - 1, false), (body.1.len(), true)] {
        let limits = SearchLimits { pairs, ..ALL };
        let found = find_crossings(&cloth, Some(&surface), limits);
        assert_eq!(found == Err(TooManyPairs), !is_enough);
    }
}
