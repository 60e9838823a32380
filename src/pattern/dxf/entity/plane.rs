//! The drawing plane: entities that lie in it, and those that are seen from above or behind.

use crate::fault::{Fault, PatternCode};
use crate::pattern::Point2;
use crate::pattern::dxf::findings::{DxfFindings, at_line};
use dxf::{Point, Vector};

/// Returns a point of the crate as seen from above.
pub(super) fn xy(p: &Point) -> Point2 {
    [p.x, p.y]
}

/// Notes an entity with points that do not lie in the drawing plane; they are seen from above.
pub(super) fn note_projected(points: &[&Point], line: usize, findings: &mut DxfFindings) {
    if points.iter().any(|p| p.z != 0.0) {
        findings.note_projected(line);
    }
}

/// Returns true if an entity with this normal is seen from behind.
///
/// # Errors
/// A normal that is not that of the drawing plane.
pub(super) fn is_seen_from_behind(normal: &Vector, line: usize) -> Result<bool, Fault> {
    if normal.x.abs() > 1e-6 || normal.y.abs() > 1e-6 || normal.z == 0.0 {
        let detail = "an entity does not lie in the drawing plane";
        return Err(Fault::new(PatternCode::NotFlat, at_line(line), detail)
            .fix("flatten the drawing in the CAD program"));
    }
    Ok(normal.z < 0.0)
}
