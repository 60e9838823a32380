//! Meshes: all pairs found, stitches honored, faults counted.

use super::exact;
use super::pairs::whole;
use super::random::Random;
use crate::tests::{ALL, is_clear};
use crate::weld::weld;
use crate::{CrossingReport, SearchLimits, Surface, TooManyPairs, find_crossings};

fn judge(positions: &[[f32; 3]], triangles: &[[u32; 3]], stitches: &[[u32; 2]]) -> CrossingReport {
    let surface = Surface::new(positions, triangles, stitches).expect("a sound mesh");
    find_crossings(&surface, None, ALL).expect("no limit")
}

/// Returns the pairs of triangles that cross, by trying all.
fn try_all(positions: &[[f32; 3]], triangles: &[[u32; 3]], stitches: &[[u32; 2]]) -> Vec<[u32; 2]> {
    let welded = weld(positions.len(), stitches);
    let (mut pairs, count) = (vec![], triangles.len());
    for (i, j) in (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j))) {
        let both = [triangles[i], triangles[j]];
        let corners = both.map(|t| t.map(|v| whole(positions[v as usize])));
        if exact::cross_by_rule(corners, both.map(|t| t.map(|v| welded[v as usize]))) {
            pairs.push([i, j].map(|k| u32::try_from(k).expect("few")));
        }
    }
    pairs
}

/// Random triangles, with vertices in common, stitched at random and partly without area.
#[test]
fn crossings_of_meshes_are_those_of_all_pairs() {
    let mut random = Random::new(11);
    for extent in [2, 5, 20, 1_000_000] {
        let positions: Vec<_> = (0..60).map(|_| random.point(extent)).collect();
        let vertex = |random: &mut Random| u32::try_from(random.below(60)).expect("small");
        let triangles: Vec<_> = (0..150)
            .map(|_| [(); 3].map(|()| vertex(&mut random)))
            .collect();
        let stitches: Vec<_> = (0..12)
            .map(|_| [(); 2].map(|()| vertex(&mut random)))
            .collect();
        let report = judge(&positions, &triangles, &stitches);
        let mut found: Vec<_> = report.cloth.kept.iter().map(|c| c.triangles).collect();
        found.sort_unstable();
        let expected = try_all(&positions, &triangles, &stitches);
        assert_eq!(found, expected, "extent {extent}");
        assert_eq!(report.cloth.count, expected.len());
        assert!(expected.len() > 100);

        let welded = weld(60, &stitches);
        let degenerate = (0..).zip(&triangles).filter(|(_, t)| {
            let names = t.map(|v| welded[v as usize]);
            exact::is_degenerate(t.map(|v| whole(positions[v as usize])), names)
        });
        let degenerate: Vec<u32> = degenerate.map(|(t, _)| t).collect();
        assert_eq!(report.degenerate, degenerate);
        assert!(!degenerate.is_empty());
    }
}

/// Returns a sheet of `count` by `count` squares of side `side`, two triangles each.
pub(crate) fn sheet(count: u32, side: f32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let grid = || (0..=count).flat_map(|j| (0..=count).map(move |i| (i, j)));
    let positions = grid().map(|(i, j)| [i as f32 * side, j as f32 * side, 0.0]);
    let squares = grid().filter(|(i, j)| *i < count && *j < count);
    let triangles = squares.flat_map(|(i, j)| {
        let v = j * (count + 1) + i;
        let w = v + count + 1;
        [[v, v + 1, w + 1], [v, w + 1, w]]
    });
    (positions.collect(), triangles.collect())
}

#[test]
fn a_sheet_is_clear_and_a_sheet_folded_flat_is_not() {
    let (mut positions, triangles) = sheet(8, 0.1);
    assert!(is_clear(&judge(&positions, &triangles, &[])));
    // Over a diagonal of the squares, so that every triangle lies on another one.
    for p in &mut positions {
        if p[1] > p[0] {
            *p = [p[1], p[0], 0.0];
        }
    }
    let report = judge(&positions, &triangles, &[]);
    let on_itself = |t: u32| report.cloth.kept.iter().any(|c| c.triangles.contains(&t));
    assert!((0..128).all(on_itself));
    // A hair apart they do not meet, though those along the fold still share edges.
    for (v, p) in (0_u32..).zip(&mut positions) {
        if v / 9 > v % 9 {
            p[2] = 1e-6;
        }
    }
    assert!(is_clear(&judge(&positions, &triangles, &[])));
}

/// Two triangles on both sides of a seam that springs hold open by `gap`, or overlapping by it.
fn seam(gap: f32, third: [f32; 3]) -> ([[f32; 3]; 6], [[u32; 3]; 2]) {
    let left = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.5, 0.0]];
    let right = [[gap, 0.0, 0.0], [gap, 1.0, 0.0], third];
    (
        [left, right].concat().try_into().expect("six"),
        [[0, 1, 2], [3, 5, 4]],
    )
}

const SEAM: [[u32; 2]; 2] = [[0, 3], [1, 4]];

#[test]
fn a_seam_held_by_springs_may_overlap_by_its_gap() {
    for gap in [-1e-3, 0.0, 1e-3] {
        let (positions, triangles) = seam(gap, [1.0, 0.5, 0.0]);
        assert!(is_clear(&judge(&positions, &triangles, &SEAM)), "{gap}");
        let unstitched = judge(&positions, &triangles, &[]);
        assert_eq!(unstitched.cloth.count, usize::from(gap <= 0.0), "{gap}");
    }
}

#[test]
fn a_seam_folded_flat_crosses() {
    for gap in [-1e-3, 0.0, 1e-3] {
        let (positions, triangles) = seam(gap, [-1.5, 0.5, 0.0]);
        assert_eq!(judge(&positions, &triangles, &SEAM).cloth.count, 1, "{gap}");
        let (positions, triangles) = seam(gap, [-1.5, 0.5, 1e-6]);
        assert!(is_clear(&judge(&positions, &triangles, &SEAM)), "{gap}");
    }
}

#[test]
fn equal_places_without_a_stitch_are_not_one_vertex() {
    let (positions, triangles) = seam(0.0, [1.0, 0.5, 0.0]);
    assert_eq!(judge(&positions, &triangles, &SEAM[..1]).cloth.count, 1);
    assert!(is_clear(&judge(&positions, &triangles, &SEAM)));
}

#[test]
fn a_triangle_on_its_copy_crosses() {
    let (positions, _) = seam(0.0, [-1.0, 0.5, 0.0]);
    let stitches = [[0, 3], [1, 4], [2, 5]];
    for second in [[3, 4, 5], [5, 4, 3]] {
        let report = judge(&positions, &[[0, 1, 2], second], &stitches);
        assert_eq!(report.cloth.count, 1);
    }
}

#[test]
fn triangles_without_area_are_counted_and_cross_others() {
    let positions = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.25, 0.25, -1.0],
        [0.25, 0.25, 0.5],
        [0.25, 0.25, 1.0],
    ];
    let report = judge(
        &positions,
        &[[0, 1, 2], [3, 4, 5], [3, 3, 4], [0, 0, 4]],
        &[],
    );
    assert_eq!(report.degenerate, [1, 2, 3]);
    let pairs: Vec<_> = report.cloth.kept.iter().map(|c| c.triangles).collect();
    assert_eq!(pairs, [[0, 1], [0, 2]]);
    // Two corners of one vertex: no area is left when the seam closes.
    let report = judge(&positions, &[[0, 1, 2]], &[[1, 2]]);
    assert_eq!(report.degenerate, [0]);
}

#[test]
fn all_cloth_at_one_point_is_degenerate_at_once() {
    let (mut positions, triangles) = sheet(300, 0.0);
    positions[7][0] = 1.0;
    let report = judge(&positions, &triangles, &[]);
    assert_eq!(report.degenerate.len(), triangles.len());
    assert_eq!(report.cloth.count, 0);
}

#[test]
fn all_are_counted_and_few_kept() {
    let (positions, mut triangles) = sheet(4, 1.0);
    triangles.extend_from_within(..);
    let surface = Surface::new(&positions, &triangles, &[]).expect("a sound mesh");
    let all = find_crossings(&surface, None, ALL).expect("no limit").cloth;
    for limit in [0, 1, 7] {
        let some = find_crossings(&surface, None, SearchLimits { kept: limit, ..ALL })
            .expect("no limit of pairs")
            .cloth;
        assert_eq!(some.count, all.count);
        assert_eq!(some.kept, all.kept[..limit]);
    }
    assert_eq!(all.kept.len(), all.count);
}

#[test]
fn nothing_is_clear() {
    assert!(is_clear(&judge(&[], &[], &[])));
}

#[test]
fn crumpled_cloth_ends_at_the_limit_of_pairs() {
    // Every triangle reaches from one end of the heap to the other, so that all boxes overlap.
    let (mut positions, triangles) = sheet(30, 1.0);
    for (i, position) in positions.iter_mut().enumerate() {
        *position = [(i % 2) as f32, (i / 2 % 2) as f32, (i % 3) as f32];
    }
    let surface = Surface::new(&positions, &triangles, &[]).expect("a sound mesh");
    let limits = SearchLimits {
        kept: 0,
        pairs: 20 * triangles.len(),
    };
    assert_eq!(find_crossings(&surface, None, limits), Err(TooManyPairs));
    // A flat sheet of as many needs no more than some neighbors of each.
    let (positions, triangles) = sheet(30, 1.0);
    let surface = Surface::new(&positions, &triangles, &[]).expect("a sound mesh");
    assert!(find_crossings(&surface, None, limits).is_ok());
}
