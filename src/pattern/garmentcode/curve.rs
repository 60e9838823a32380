//! An edge of a specification: straight, a Bézier curve or an arc, as a polyline.
//!
//! A relative control point (x, y) of an edge from `a` to `b` is `a + x e + y (-e_y, e_x)` with e =
//! b - a. An arc is [radius, large, right] as in SVG: `right` where it lies to the right of the way
//! from `a` to `b` (the smaller one). Source: `GarmentCode`, pygarment/garmentcode/edge.py and
//! pygarment/pattern/utils.py.

use super::super::bspline::BSpline;
use super::super::curve;
use super::super::point::{Point2, distance, sub};
use super::findings::SpecFindings;
use super::node::JsonNode;
use crate::fault::PatternCode;

/// A chord may be longer than the diameter of its arc by this share: writers round.
const ROUNDING: f64 = 1e-6;

/// The course of an edge from one end to the other.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum EdgeCurve {
    /// Straight.
    Line,
    /// A Bézier curve with one or two control points, relative to the edge or in the panel's
    /// coordinates.
    Bezier {
        controls: Vec<Point2>,
        relative: bool,
    },
    /// An arc of a circle.
    Arc {
        radius: f64,
        large: bool,
        right: bool,
    },
}

impl EdgeCurve {
    /// Reads the curvature of an edge. `relative`: control points are relative to their edge.
    pub(super) fn read(
        node: &JsonNode<'_>,
        relative: bool,
        findings: &mut SpecFindings,
    ) -> Option<Self> {
        if node.value.is_array() {
            let controls = vec![node.numbers::<2>(findings)?];
            return Some(Self::Bezier { controls, relative });
        }
        node.fields(&["type", "params"], findings)?;
        let kind = node.require("type", findings);
        let params = node.require("params", findings);
        let (kind, params) = (kind?, params?);
        match kind.text(findings)? {
            "circle" => Self::read_arc(&params, findings),
            "quadratic" => Self::read_bezier(&params, 1, relative, findings),
            "cubic" => Self::read_bezier(&params, 2, relative, findings),
            _ => {
                let detail = format!("{} is not a kind of curve", kind.value);
                let fix = "the kinds are quadratic, cubic and circle";
                findings.fault(kind.fault(PatternCode::Field, detail, fix));
                None
            }
        }
    }

    /// Reads `count` control points.
    fn read_bezier(
        params: &JsonNode<'_>,
        count: usize,
        relative: bool,
        findings: &mut SpecFindings,
    ) -> Option<Self> {
        let items = params.items(2, findings)?;
        if items.len() != count {
            let detail = format!("{} control points where {count} are needed", items.len());
            findings.fault(params.fault(
                PatternCode::Field,
                detail,
                "one for quadratic, two for cubic",
            ));
            return None;
        }
        let points = items.iter().map(|item| item.numbers::<2>(findings));
        let points: Vec<Option<Point2>> = points.collect();
        let controls = points.into_iter().collect::<Option<Vec<Point2>>>()?;
        Some(Self::Bezier { controls, relative })
    }

    /// Reads radius, size and side of an arc.
    fn read_arc(params: &JsonNode<'_>, findings: &mut SpecFindings) -> Option<Self> {
        let items = params.items(3, findings)?;
        let [radius, large, right] = items.as_slice() else {
            let detail = format!("{} parameters where 3 are needed", items.len());
            let fix = "give [radius, large arc, right]";
            findings.fault(params.fault(PatternCode::Field, detail, fix));
            return None;
        };
        let given = radius.number(findings);
        let flags = [large.flag(findings), right.flag(findings)];
        let size = given.filter(|r| *r > 0.0);
        if size.is_none() && given.is_some() {
            let detail = "the radius of an arc is above 0";
            findings.fault(radius.fault(PatternCode::Field, detail, "correct it"));
        }
        Some(Self::Arc {
            radius: size?,
            large: flags[0]?,
            right: flags[1]?,
        })
    }

    /// Returns the same in meters: radii and absolute points are in units of the file.
    pub(super) fn scaled(mut self, scale: f64) -> Self {
        match &mut self {
            Self::Bezier {
                controls,
                relative: false,
            } => controls.iter_mut().flatten().for_each(|c| *c *= scale),
            Self::Arc { radius, .. } => *radius *= scale,
            Self::Line | Self::Bezier { .. } => {}
        }
        self
    }

    /// Returns the polyline from `a` to `b`, both included, no point twice in a row; `None` where
    /// no such arc exists.
    pub(super) fn points(&self, a: Point2, b: Point2) -> Option<Vec<Point2>> {
        let mut points = match self {
            Self::Line => vec![a, b],
            Self::Bezier { controls, relative } => {
                let at = |p: &Point2| if *relative { absolute(a, b, *p) } else { *p };
                bezier_points(a, b, controls.iter().map(at).collect())
            }
            Self::Arc {
                radius,
                large,
                right,
            } => {
                let bulge = bulge_of(distance(a, b), *radius, *large)?;
                let mut points = curve::bulge(a, b, if *right { bulge } else { -bulge });
                points.push(b);
                points
            }
        };
        points.dedup();
        Some(points)
    }
}

/// Returns the panel's coordinates of a point relative to the edge from `a` to `b`.
fn absolute(a: Point2, b: Point2, [x, y]: Point2) -> Point2 {
    let e = sub(b, a);
    [a[0] + x * e[0] - y * e[1], a[1] + x * e[1] + y * e[0]]
}

/// Returns the points of a Bézier curve, both ends included.
fn bezier_points(a: Point2, b: Point2, between: Vec<Point2>) -> Vec<Point2> {
    let controls = [vec![a], between, vec![b]].concat();
    let degree = controls.len() - 1;
    let knots: Vec<f64> = (0..2 * controls.len())
        .map(|i| if i < controls.len() { 0.0 } else { 1.0 })
        .collect();
    let spline = BSpline {
        degree,
        knots: &knots,
        controls: &controls,
        weights: &[],
    };
    let mut points = spline.points(usize::MAX);
    let last = points.len() - 1;
    (points[0], points[last]) = (a, b);
    points
}

/// Returns the tangent of a quarter of the sweep of an arc over a chord: twice its height over the
/// chord.
fn bulge_of(chord: f64, radius: f64, large: bool) -> Option<f64> {
    let half = 0.5 * chord;
    if half > radius * (1.0 + ROUNDING) || half == 0.0 {
        return None;
    }
    let to_center = (radius * radius - half * half).max(0.0).sqrt();
    // The height of the small arc is half² / (radius + to_center): no digits are lost to a
    // difference.
    let height = if large {
        radius + to_center
    } else {
        half * half / (radius + to_center)
    };
    Some(height / half)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::polyline::length;
    use std::f64::consts::PI;

    const A: Point2 = [1.0, 2.0];
    const B: Point2 = [1.0, 4.0];

    fn arc(radius: f64, large: bool, right: bool) -> EdgeCurve {
        EdgeCurve::Arc {
            radius,
            large,
            right,
        }
    }

    #[test]
    fn arcs_have_the_length_and_the_side_that_their_parameters_say() {
        // A chord of 2 in a circle of radius 2 / sqrt(2) sees a right angle.
        let radius = 2.0_f64.sqrt();
        for (large, turn) in [(false, 0.5 * PI), (true, 1.5 * PI)] {
            for (right, sign) in [(true, 1.0), (false, -1.0)] {
                let points = arc(radius, large, right).points(A, B).expect("it exists");
                assert!((length(&points) / (radius * turn) - 1.0).abs() < 1.3e-5);
                // Right of a way upwards is +x.
                let middle = points[points.len() / 2];
                assert!(sign * (middle[0] - 1.0) > 0.0, "{middle:?}");
                assert_eq!((points[0], points[points.len() - 1]), (A, B));
            }
        }
        assert_eq!(arc(0.9, false, true).points(A, B), None);
    }

    #[test]
    fn relative_control_points_lie_along_and_left_of_the_edge() {
        assert_eq!(absolute(A, B, [0.5, 0.25]), [0.5, 3.0]);
        let relative = EdgeCurve::Bezier {
            controls: vec![[0.5, 0.25]],
            relative: true,
        };
        let given = EdgeCurve::Bezier {
            controls: vec![[0.5, 3.0]],
            relative: false,
        };
        let points = relative.points(A, B).expect("a curve");
        assert_eq!(Some(&points), given.points(A, B).as_ref());
        // At half of the way: (a + 2 c + b) / 4.
        assert!(points.contains(&[0.75, 3.0]), "{points:?}");
    }

    #[test]
    fn cubic_edge_matches_its_polynomial() {
        let cubic = EdgeCurve::Bezier {
            controls: vec![[0.2, 0.4], [0.9, -0.1]],
            relative: true,
        };
        let points = cubic.points([0.0, 0.0], [1.0, 0.0]).expect("a curve");
        let at = |t: f64| {
            let s = 1.0 - t;
            [
                3.0 * s * s * t * 0.2 + 3.0 * s * t * t * 0.9 + t * t * t,
                3.0 * s * s * t * 0.4 - 3.0 * s * t * t * 0.1,
            ]
        };
        // Points lie at binary fractions, at least four of them, most where it bends most.
        let on =
            |point: &Point2| (0..=256).any(|i| distance(*point, at(f64::from(i) / 256.0)) < 1e-12);
        assert!(points.len() > 4 && points.iter().all(on));
    }
}
