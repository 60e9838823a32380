//! Point location: the triangle of a mesh that a point of the pattern lies in.

use super::cloth_mesh::ClothMesh;
use super::geometry::area;
use crate::pattern::point::Point2;
use std::collections::BTreeMap;

/// Most cells along the bounding box of a triangle: those of a mesh are much alike, those of a file
/// need not be.
const MOST_CELLS: f64 = 16.0;

/// The triangles of one panel, ready to be searched.
#[derive(Debug)]
pub struct Locator<'a> {
    mesh: &'a ClothMesh,
    /// Triangles whose bounding box meets each cell.
    cells: BTreeMap<[i64; 2], Vec<usize>>,
    /// Side of a cell \[m\].
    side: f64,
}

impl<'a> Locator<'a> {
    /// The triangles of panel `panel`.
    ///
    /// # Panics
    /// If there is no such panel.
    pub fn new(mesh: &'a ClothMesh, panel: usize) -> Self {
        let triangles = mesh.panels[panel].triangles.clone();
        let boxes: Vec<[Point2; 2]> = triangles.clone().map(|t| bounds(mesh, t)).collect();
        let widths = boxes.iter().map(|[l, h]| (h[0] - l[0]).max(h[1] - l[1]));
        let [sum, largest] = widths.fold([0.0, 0.0_f64], |[sum, largest], width| {
            [sum + width, largest.max(width)]
        });
        let mean = sum / boxes.len().max(1) as f64;
        let side = mean.max(largest / MOST_CELLS).max(1e-6);
        let mut locator = Self {
            mesh,
            cells: BTreeMap::new(),
            side,
        };
        for (triangle, [low, high]) in triangles.zip(boxes) {
            let ([i0, j0], [i1, j1]) = (locator.cell(low), locator.cell(high));
            for cell in (i0..=i1).flat_map(|i| (j0..=j1).map(move |j| [i, j])) {
                locator.cells.entry(cell).or_default().push(triangle);
            }
        }
        locator
    }

    /// The corners of the triangle that `point` lies in, or of the nearest one within a cell or
    /// two, with its barycentric coordinates; `None` if none is so near.
    pub fn weights(&self, point: Point2) -> Option<[(usize, f64); 3]> {
        let [i, j] = self.cell(point);
        // An outline of longer edges cuts corners off, so a point may lie outside of it.
        (0..=2).find_map(|reach| {
            let around =
                (i - reach..=i + reach).flat_map(|i| (j - reach..=j + reach).map(move |j| [i, j]));
            let near = around.filter_map(|cell| self.cells.get(&cell)).flatten();
            let weighed = near.map(|&t| {
                let corners = self.mesh.triangles[t];
                (
                    corners,
                    barycentric(point, corners.map(|v| self.mesh.uv[v])),
                )
            });
            // A triangle without area holds no point.
            let weighed = weighed.filter(|(_, w)| w.iter().all(|w| w.is_finite()));
            let least = |w: &[f64; 3]| w.iter().copied().fold(f64::INFINITY, f64::min);
            let best = weighed.max_by(|(_, p), (_, q)| least(p).total_cmp(&least(q)))?;
            Some([0, 1, 2].map(|k| (best.0[k], best.1[k])))
        })
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "panels are a few meters long and cells are not below a micrometer"
    )]
    fn cell(&self, point: Point2) -> [i64; 2] {
        point.map(|c| (c / self.side).floor() as i64)
    }
}

fn bounds(mesh: &ClothMesh, triangle: usize) -> [Point2; 2] {
    let corners = mesh.triangles[triangle].map(|v| mesh.uv[v]);
    let fold = |f: fn(f64, f64) -> f64, from: f64| {
        [0, 1].map(|axis| corners.iter().map(|c| c[axis]).fold(from, f))
    };
    [
        fold(f64::min, f64::INFINITY),
        fold(f64::max, f64::NEG_INFINITY),
    ]
}

/// Barycentric coordinates of `p`; they add up to 1.
pub(super) fn barycentric(p: Point2, [a, b, c]: [Point2; 3]) -> [f64; 3] {
    let whole = area(a, b, c);
    [
        area(p, b, c) / whole,
        area(a, p, c) / whole,
        area(a, b, p) / whole,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::PanelRange;

    /// A unit square in four triangles round its middle.
    fn square() -> ClothMesh {
        ClothMesh {
            uv: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]],
            triangles: vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [0, 4, 3]],
            panels: vec![PanelRange {
                vertices: 0..5,
                triangles: 0..4,
                corners: vec![0, 1, 2, 3],
            }],
            stitches: vec![],
        }
    }

    #[test]
    fn linear_functions_are_found_again_everywhere() {
        let mesh = square();
        let locator = Locator::new(&mesh, 0);
        for point in [
            [0.1, 0.05],
            [0.5, 0.5],
            [0.93, 0.4],
            [0.3, 1.02],
            [0.0, 0.0],
        ] {
            let weights = locator.weights(point).expect("in or near the square");
            for axis in 0..2 {
                let found: f64 = weights.iter().map(|(v, w)| w * mesh.uv[*v][axis]).sum();
                assert!((found - point[axis]).abs() < 1e-14, "{point:?}: {found}");
            }
        }
        assert!(locator.weights([9.0, 0.0]).is_none());
    }
}
