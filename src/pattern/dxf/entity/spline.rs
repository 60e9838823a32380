//! Splines of a DXF as polylines: by control points, else through fit points.

use super::fit_spline;
use super::geometry::EntityPath;
use super::plane::xy;
use crate::fault::{Fault, PatternCode};
use crate::pattern::Point2;
use crate::pattern::bspline::BSpline;
use crate::pattern::dxf::findings::at_line;

/// Returns a spline of the crate as a path; where it has more than `most` points, it ends early.
///
/// # Errors
/// Numbers that make no spline.
pub(super) fn path(
    s: &dxf::entities::Spline,
    line: usize,
    most: usize,
) -> Result<EntityPath, Fault> {
    let refuse = |what: &str| refuse(line, what);
    let degree = usize::try_from(s.degree_of_curve)
        .map_err(|_| refuse("the spline's degree is negative"))?;
    let controls: Vec<Point2> = s.control_points.iter().map(xy).collect();
    if controls.is_empty() {
        let fit: Vec<Point2> = s.fit_points.iter().map(xy).collect();
        if fit.len() < 2 {
            return Err(refuse(
                "the spline has neither control points nor fit points",
            ));
        }
        let tangents = [&s.start_tangent, &s.end_tangent].map(xy);
        let is_closed = s.flags & 1 == 1;
        let points = fit_spline::through(&fit, is_closed, tangents, most);
        return Ok(EntityPath::curve(points));
    }
    if degree == 0 || controls.len() <= degree || s.knot_values.len() != controls.len() + degree + 1
    {
        return Err(refuse(
            "the spline's degree, knots and control points do not go together",
        ));
    }
    if s.knot_values.windows(2).any(|w| w[1] < w[0])
        || s.knot_values[degree] >= s.knot_values[controls.len()]
    {
        return Err(refuse("the spline's knots fall"));
    }
    if !s.weight_values.is_empty() && s.weight_values.len() != controls.len()
        || s.weight_values.iter().any(|w| *w <= 0.0)
    {
        return Err(refuse(
            "the spline's weights are not positive, one to a control point",
        ));
    }
    let curve = BSpline {
        degree,
        knots: &s.knot_values,
        controls: &controls,
        weights: &s.weight_values,
    };
    Ok(EntityPath::curve(curve.points(most)))
}

fn refuse(line: usize, what: &str) -> Fault {
    Fault::new(PatternCode::Spline, at_line(line), what.to_owned())
        .fix("export curves as polylines, or draw this one anew")
}
