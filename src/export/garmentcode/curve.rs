//! The course of an edge between its ends, as a specification writes it.

use super::numbers::neat;
use crate::pattern::point::{Point2, cross, dot, sub};
use serde_json::{Value, json};

/// The course of an edge from one end to the other.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum EdgeCurve {
    /// Straight.
    Line,
    /// A Bézier curve with one or two control points between its ends \[m\].
    Bezier(Vec<Point2>),
    /// An arc of a circle.
    Arc {
        /// Its radius \[m\].
        radius: f64,
        /// True if it is more than half of its circle.
        large: bool,
        /// True if it runs counter-clockwise: the smaller one lies to the right of the way.
        right: bool,
    },
}

impl EdgeCurve {
    /// Returns the `curvature` of an edge between two points; `None` of a straight one. `scale`:
    /// meters of a unit.
    pub(super) fn written(&self, [a, b]: [Point2; 2], scale: f64) -> Option<Value> {
        match self {
            Self::Line => None,
            Self::Bezier(controls) => {
                let kind = if controls.len() == 1 {
                    "quadratic"
                } else {
                    "cubic"
                };
                let params = controls.iter().map(|p| relative(a, b, *p).map(neat));
                let params: Vec<[f64; 2]> = params.collect();
                Some(json!({"type": kind, "params": params}))
            }
            Self::Arc {
                radius,
                large,
                right,
            } => {
                let params = (neat(radius / scale), u8::from(*large), u8::from(*right));
                Some(json!({"type": "circle", "params": params}))
            }
        }
    }
}

/// Returns a point relative to the edge from `a` to `b`: along it, and to the left of it.
fn relative(a: Point2, b: Point2, p: Point2) -> Point2 {
    let (e, d) = (sub(b, a), sub(p, a));
    let square = dot(e, e);
    [dot(d, e) / square, cross(e, d) / square]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_points_are_written_relative_to_their_edge() {
        let ends = [[1.0, 2.0], [1.0, 4.0]];
        let curve = EdgeCurve::Bezier(vec![[0.5, 3.0]]);
        assert_eq!(
            curve.written(ends, 0.01),
            Some(json!({"type": "quadratic", "params": [[0.5, 0.25]]}))
        );
        let arc = EdgeCurve::Arc {
            radius: 2.0,
            large: false,
            right: true,
        };
        assert_eq!(
            arc.written(ends, 0.01),
            Some(json!({"type": "circle", "params": [200.0, 0, 1]}))
        );
        assert_eq!(EdgeCurve::Line.written(ends, 0.01), None);
    }
}
