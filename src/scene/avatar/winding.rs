//! Winding numbers of a closed surface, which may cross itself.

use super::TriangleMesh;
use nalgebra::Vector3;

/// Width of a column \[m\]: about the edges of a body's triangles.
const WIDTH: f64 = 0.006;
/// Most columns along an axis.
const COLUMNS: usize = 4_096;

/// Triangles by the upright columns that they are in.
///
/// The winding number at a point is the signed count of the triangles above it: one that faces up
/// is left by the upward ray, one that faces down is entered. Each edge is on one side of the ray
/// for both its triangles, also where rounding decides, so that the count is exact for a closed
/// surface, but for points on it (A. Jacobson et al., "Robust inside-outside segmentation using
/// generalized winding numbers", ACM TOG 32(4), 2013, whose number this is where it is whole).
#[derive(Clone, Debug)]
pub(super) struct Winding {
    surface: TriangleMesh,
    /// Least x and z \[m\].
    origin: [f64; 2],
    size: [usize; 2],
    /// First entry of each column, and the end.
    first: Vec<usize>,
    /// Triangles of all columns.
    triangles: Vec<u32>,
}

impl Winding {
    /// For a closed surface, all of whose triangles have one sense.
    pub(super) fn new(surface: &TriangleMesh) -> Self {
        let bounds = |axis: usize| {
            let x = surface.vertices.iter().map(|p| p[axis]);
            x.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
                [low.min(x), high.max(x)]
            })
        };
        let (x, z) = (bounds(0), bounds(2));
        let mut winding = Self {
            surface: surface.clone(),
            origin: [x[0], z[0]],
            size: [x, z].map(|[low, high]| column((high - low) / WIDTH).min(COLUMNS - 1) + 1),
            first: Vec::new(),
            triangles: Vec::new(),
        };
        let mut entries = Vec::new();
        for t in 0..surface.triangles.len() {
            let corners = surface.corners(t);
            let [low, high] = [f64::min, f64::max].map(|choose| {
                let corner = corners[0].zip_map(&corners[1], choose);
                winding.columns(&corner.zip_map(&corners[2], choose))
            });
            for i in low[0]..=high[0] {
                for j in low[1]..=high[1] {
                    entries.push((i * winding.size[1] + j, u32::try_from(t).unwrap_or(0)));
                }
            }
        }
        entries.sort_unstable();
        winding.first = vec![0; winding.size[0] * winding.size[1] + 1];
        for (place, _) in &entries {
            winding.first[place + 1] += 1;
        }
        for k in 1..winding.first.len() {
            winding.first[k] += winding.first[k - 1];
        }
        winding.triangles = entries.into_iter().map(|(_, t)| t).collect();
        winding
    }

    /// The column of a point along x and z, the nearest one if it is beside all.
    fn columns(&self, p: &Vector3<f64>) -> [usize; 2] {
        [0, 1].map(|k| {
            let x = [p.x, p.z][k];
            column((x - self.origin[k]) / WIDTH).min(self.size[k] - 1)
        })
    }

    /// Times that the surface goes round `p`: 0 outside of it.
    pub(super) fn number(&self, p: &Vector3<f64>) -> i32 {
        let [i, j] = self.columns(p);
        let place = i * self.size[1] + j;
        let own = &self.triangles[self.first[place]..self.first[place + 1]];
        own.iter().map(|t| self.above(*t as usize, p)).sum()
    }

    /// 1 or -1 for a triangle above `p` that faces up or down, else 0.
    fn above(&self, t: usize, p: &Vector3<f64>) -> i32 {
        let [a, b, c] = self.surface.triangles[t];
        let left = [(a, b), (b, c), (c, a)].map(|(a, b)| self.is_left(a, b, p));
        if left[0] != left[1] || left[1] != left[2] {
            return 0;
        }
        let [a, b, c] = self.surface.corners(t);
        let normal = (b - a).cross(&(c - a));
        // the height of its plane above the point, times the upward part of the normal
        let over = normal.dot(&(a - p));
        if over * normal.y <= 0.0 {
            return 0;
        }
        // to the left in (x, z) is clockwise seen from above
        if left[0] { -1 } else { 1 }
    }

    /// Returns true if `p` is to the left of the line from vertex `a` to `b`, seen along y, decided
    /// once for both directions.
    fn is_left(&self, a: usize, b: usize, p: &Vector3<f64>) -> bool {
        let [low, high] = [a.min(b), a.max(b)].map(|v| self.surface.vertices[v]);
        let along = high - low;
        let to = p - low;
        (along.x * to.z - along.z * to.x >= 0.0) == (a < b)
    }
}

/// The whole number below `x`, 0 for what is less.
fn column(x: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to a range of whole numbers"
    )]
    let column = x.clamp(0.0, 1e9) as usize;
    column
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of a cube of side 1 at `offset`, as triangles that face outward.
    fn cube(offset: f64) -> TriangleMesh {
        let vertices = (0..8)
            .map(|k| Vector3::from_fn(|axis, _| f64::from((k >> axis) & 1) + offset))
            .collect();
        let faces = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let triangles = faces
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect();
        TriangleMesh {
            vertices,
            triangles,
        }
    }

    #[test]
    fn two_cubes_go_round_their_common_part_twice() {
        let mut both = cube(0.0);
        let second = cube(0.5);
        both.vertices.extend(second.vertices);
        let triangles = second.triangles.iter().map(|t| t.map(|v| v + 8));
        both.triangles.extend(triangles);
        assert!((both.volume() - 2.0).abs() < 1e-12);
        let winding = Winding::new(&both);
        // on edges and diagonals seen from above as well
        for (x, number) in [
            (-0.1, 0),
            (0.25, 1),
            (0.5 + 1e-9, 2),
            (0.75, 2),
            (1.25, 1),
            (1.6, 0),
        ] {
            assert_eq!(winding.number(&Vector3::new(x, x, x)), number, "{x}");
        }
    }
}
