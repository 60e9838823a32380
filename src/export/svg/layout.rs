//! The places of panels on the sheet: side by side in rows, none over another, true to each other
//! in size.

use crate::pattern::point::Point2;
use crate::pattern::polyline::bounds;
use crate::pattern::{Edge, Panel};

/// Wanted width of a sheet over its height.
const SHAPE: f64 = 1.6;

/// Size of a figure over the width of the sheet: such that it can be read where the sheet fills a
/// screen.
const FIGURE: f64 = 1.0 / 115.0;

/// A panel's coordinates on the sheet: in millimeters, y down, the upper left corner of its box at
/// the origin.
pub(super) struct PanelSketch {
    scale: f64,
    low: Point2,
    high: Point2,
}

impl PanelSketch {
    /// Returns the sketch that everything that a panel has fits into.
    pub(super) fn of(panel: &Panel) -> Self {
        let edges = panel.edges.iter().flat_map(|edge: &Edge| &edge.points);
        let inner = panel.internal_lines.iter().flatten();
        let all = edges.chain(&panel.cut_line).chain(&panel.drill_holes);
        let all: Vec<Point2> = all.chain(inner).copied().collect();
        let [low, high] = if all.is_empty() {
            [[0.0; 2]; 2]
        } else {
            bounds(&all)
        };
        Self {
            scale: 1e3,
            low,
            high,
        }
    }

    /// Returns a point of the pattern on the sketch.
    pub(super) fn point(&self, p: Point2) -> Point2 {
        [
            self.scale * (p[0] - self.low[0]),
            self.scale * (self.high[1] - p[1]),
        ]
    }

    /// Returns points of the pattern on the sketch.
    pub(super) fn points(&self, points: &[Point2]) -> Vec<Point2> {
        points.iter().map(|p| self.point(*p)).collect()
    }

    /// Returns width and height.
    pub(super) fn size(&self) -> Point2 {
        [0, 1].map(|k| self.scale * (self.high[k] - self.low[k]))
    }
}

/// A sheet with a place for each box.
pub(super) struct SheetLayout {
    /// Width and height.
    pub(super) size: Point2,
    /// The upper left corner of each box.
    pub(super) places: Vec<Point2>,
}

/// Returns the size of figures on a sheet of boxes of these sizes.
pub(super) fn figure(boxes: &[Point2]) -> f64 {
    let area: f64 = boxes.iter().map(|[w, h]| w * h).sum();
    let widest = boxes.iter().map(|b| b[0]).fold(0.0, f64::max);
    // Rows and gaps leave about a third of a sheet empty.
    let width = (1.5 * SHAPE * area).sqrt().max(widest);
    (FIGURE * width).max(0.5)
}

/// Lays boxes in rows, the highest first, with `gap` between and around them.
pub(super) fn sheet(boxes: &[Point2], gap: f64) -> SheetLayout {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|a, b| boxes[*b][1].total_cmp(&boxes[*a][1]).then(a.cmp(b)));
    let widest = boxes.iter().map(|b| b[0] + 2.0 * gap).fold(0.0, f64::max);
    let long: f64 = boxes.iter().map(|b| b[0] + gap).sum::<f64>() + gap;
    // Of some widths between that of one column and that of one row, the one that gives the wanted
    // shape best.
    let tries = (0..=60).map(|i| widest + (long - widest) * f64::from(i) / 60.0);
    let off = |sheet: &SheetLayout| (sheet.size[0] / sheet.size[1] / SHAPE).ln().abs();
    tries
        .map(|width| rows(boxes, &order, gap, width + 1e-6))
        .min_by(|a, b| off(a).total_cmp(&off(b)))
        .unwrap_or(SheetLayout {
            size: [2.0 * gap; 2],
            places: Vec::new(),
        })
}

fn rows(boxes: &[Point2], order: &[usize], gap: f64, width: f64) -> SheetLayout {
    let mut places = vec![[0.0; 2]; boxes.len()];
    let (mut at, mut height, mut right) = ([gap, gap], 0.0_f64, 0.0_f64);
    for &i in order {
        let [w, h] = boxes[i];
        if at[0] > gap && at[0] + w + gap > width {
            at = [gap, at[1] + height + gap];
            height = 0.0;
        }
        places[i] = at;
        at[0] += w + gap;
        right = right.max(at[0]);
        height = height.max(h);
    }
    SheetLayout {
        size: [right.max(2.0 * gap), at[1] + height + gap],
        places,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_lie_apart_within_the_sheet() {
        let boxes: Vec<Point2> = (0..23)
            .map(|i| {
                let i = f64::from(i);
                [20.0 + (7.0 * i) % 90.0, 15.0 + (13.0 * i) % 140.0]
            })
            .collect();
        let found = sheet(&boxes, 5.0);
        for (i, (a, s)) in found.places.iter().zip(&boxes).enumerate() {
            for k in 0..2 {
                assert!(a[k] >= 5.0 && a[k] + s[k] <= found.size[k] - 5.0 + 1e-9);
            }
            for (b, t) in found.places[..i].iter().zip(&boxes) {
                let apart = (0..2).any(|k| a[k] + s[k] + 4.9 < b[k] || b[k] + t[k] + 4.9 < a[k]);
                assert!(apart, "{a:?} {b:?}");
            }
        }
        let shape = found.size[0] / found.size[1];
        assert!((1.0..2.5).contains(&shape), "{shape}");
    }

    #[test]
    fn a_sheet_of_nothing_has_a_size() {
        let found = sheet(&[], 5.0);
        assert!(found.size.iter().all(|s| *s > 0.0));
    }
}
