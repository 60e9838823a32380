//! Every decision about two triangles, against the rules in whole numbers.

use super::exact::{self, Whole};
use super::random::Random;
use crate::tests::ALL;
use crate::{Surface, find_crossings};

/// Two triangles among up to six vertices.
struct Pair {
    positions: Vec<[f32; 3]>,
    triangles: [[u32; 3]; 2],
}

impl Pair {
    /// Returns two triangles that share `shared` vertices, at random corners.
    fn new(
        random: &mut Random,
        shared: u32,
        mut point: impl FnMut(&mut Random) -> [f32; 3],
    ) -> Self {
        let positions = (0..6 - shared).map(|_| point(random)).collect();
        let mut rotate = |[a, b, c]: [u32; 3]| {
            let turned = [
                [a, b, c],
                [b, c, a],
                [c, a, b],
                [a, c, b],
                [c, b, a],
                [b, a, c],
            ];
            turned[usize::try_from(random.below(6)).expect("small")]
        };
        let second = [0, 1, 2].map(|i| if i < shared { i } else { i + 3 - shared });
        Self {
            positions,
            triangles: [rotate([0, 1, 2]), rotate(second)],
        }
    }

    fn corners(&self, scale: f32) -> [[Whole; 3]; 2] {
        self.triangles
            .map(|t| t.map(|v| whole(self.positions[v as usize].map(|x| x / scale))))
    }

    fn crosses(&self) -> bool {
        let surface = Surface::new(&self.positions, &self.triangles, &[]).expect("finite");
        find_crossings(&surface, None, ALL)
            .expect("no limit")
            .cloth
            .count
            == 1
    }
}

/// Returns a point's coordinates, which are whole numbers.
pub(crate) fn whole(point: [f32; 3]) -> Whole {
    #[expect(clippy::cast_possible_truncation, reason = "whole and below 2²⁴")]
    point.map(|x| x as i128)
}

/// Compares `count` pairs for each number of shared vertices; returns how many of each crossed.
fn compare(count: usize, scale: f32, mut point: impl FnMut(&mut Random) -> [f32; 3]) -> [usize; 4] {
    let mut random = Random::new(7);
    [0, 1, 2, 3].map(|shared| {
        let mut crossed = 0;
        for _ in 0..count {
            let pair = Pair::new(&mut random, shared, &mut point);
            let expected = exact::cross_by_rule(pair.corners(scale), pair.triangles);
            assert_eq!(
                pair.crosses(),
                expected,
                "{:?} {:?}",
                pair.positions,
                pair.triangles
            );
            crossed += usize::from(expected);
        }
        crossed
    })
}

/// On a grid so small that most pairs touch, are in one plane or have no area.
#[test]
fn degenerate_pairs_cross_by_the_rules() {
    for extent in [1, 2, 4] {
        let crossed = compare(6000, 1.0, |random| random.point(extent));
        assert!(crossed.iter().all(|count| *count > 50), "{crossed:?}");
        assert!(
            crossed[..3].iter().all(|count| *count < 5500),
            "{crossed:?}"
        );
    }
}

#[test]
fn pairs_in_one_plane_cross_by_the_rules() {
    for axis in 0..3 {
        let crossed = compare(3000, 1.0, |random| {
            let mut point = random.point(5);
            point[axis] = 3.0;
            point
        });
        assert!(crossed.iter().all(|count| *count > 300), "{crossed:?}");
    }
}

/// In a plane aslant and at most one unit of single precision beside it, where rounded orientations
/// have any sign.
#[test]
fn pairs_almost_in_one_plane_cross_by_the_rules() {
    for off in [0, 1] {
        let crossed = compare(6000, 1.0, |random| almost_in_plane(random, off));
        assert!(crossed[0] > 300 && crossed[1] > 300, "{crossed:?}");
        assert!(crossed[0] < 5500 && crossed[1] < 5500, "{crossed:?}");
    }
}

/// Returns a point of a plane with whole coordinates of up to 23 bits, moved by up to `off`.
fn almost_in_plane(random: &mut Random, off: i64) -> [f32; 3] {
    let [u, v] = [[70_001, 32_003, -51_001], [-25_013, 60_013, 33_023]];
    let (i, j) = (random.integer(40), random.integer(40));
    [0, 1, 2].map(|k| (1_000_003 + i * u[k] + j * v[k] + random.integer(off)) as f32)
}

/// From subnormal numbers to some that can hardly be squared.
#[test]
fn scale_does_not_matter() {
    for exponent in [-149, -130, -60, 80, 103] {
        // 2^-149 as a product: a power below the normal numbers is not surely exact.
        let scale = 2.0_f32.powi(exponent / 2) * 2.0_f32.powi(exponent - exponent / 2);
        let crossed = compare(1000, scale, |random| {
            almost_in_plane(random, 1).map(|x| x * scale)
        });
        assert!(crossed[0] > 50 && crossed[0] < 950, "{crossed:?}");
    }
}

/// Places are within the boxes of both triangles, unless they are in one plane.
#[test]
fn marked_points_are_on_both_triangles() {
    let mut random = Random::new(3);
    let mut count = 0;
    for _ in 0..5000 {
        let pair = Pair::new(&mut random, 0, |random| random.point(1_000_000));
        let surface = Surface::new(&pair.positions, &pair.triangles, &[]).expect("finite");
        for crossing in find_crossings(&surface, None, ALL)
            .expect("no limit")
            .cloth
            .kept
        {
            count += 1;
            assert_eq!(crossing.triangles, [0, 1]);
            for corners in pair.corners(1.0) {
                assert_in_box(crossing.point, corners);
            }
        }
    }
    assert!(count > 200);
}

fn assert_in_box(point: [f64; 3], corners: [Whole; 3]) {
    for k in 0..3 {
        let [a, b, c] = corners.map(|p| p[k] as f64);
        assert!(a.min(b).min(c) - 1e-6 <= point[k], "{point:?} {corners:?}");
        assert!(point[k] <= a.max(b).max(c) + 1e-6, "{point:?} {corners:?}");
    }
}
