//! A sheet: entities that belong together, in meters and near the origin.

use crate::fault::PatternCode;
use crate::pattern::Point2;
use crate::pattern::dxf::entity::affine::AffineMap;
use crate::pattern::dxf::entity::geometry::{DxfEntity, EntityShape};
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::point::is_readable;
use crate::pattern::polyline::bounds;

/// Coordinates up to this keep 10 um in single precision \[m\].
const NEAR: f64 = 100.0;

/// Entities that belong together: one block put in, or what lies loose in the model space. Meters.
pub(crate) struct DxfSheet {
    /// Name of the block, `None` for the model space.
    pub(crate) block: Option<String>,
    /// The line it begins at.
    pub(crate) line: usize,
    /// The linear part of the map by which it was put in: rotation, mirroring and scale, without
    /// its units.
    pub(crate) linear: AffineMap,
    /// Its entities, without inserts.
    pub(crate) entities: Vec<DxfEntity>,
}

impl DxfSheet {
    /// Moves a sheet that lies far from the origin to it: coordinates of single precision would
    /// blur it later.
    pub(crate) fn move_near_origin(&mut self, findings: &mut DxfFindings) {
        let paths = self.entities.iter().filter_map(|e| e.shape.path());
        let points: Vec<Point2> = paths.flat_map(|path| &path.points).copied().collect();
        let [low, high] = bounds(&points);
        if points.is_empty() || low.into_iter().chain(high).all(|c| c.abs() <= NEAR) {
            return;
        }
        let map = AffineMap::translation([-low[0], -low[1]]);
        self.entities = self.entities.iter().map(|e| map.apply_to(e)).collect();
        let detail = format!(
            "the drawing lies at ({:.4e}, {:.4e}) m and was moved to the origin",
            low[0], low[1]
        );
        findings.warn(PatternCode::Moved, self.line, detail);
    }

    /// Leaves out entities that lie farther away than any pattern: a slip of a digit. Where all
    /// lines do, the units are wrong, and none is left out.
    pub(crate) fn drop_far(&mut self, findings: &mut DxfFindings) {
        let mut paths = self.entities.iter().filter_map(|e| e.shape.path());
        if !paths.any(|path| path.points.iter().all(|p| is_readable(*p))) {
            return;
        }
        self.entities.retain(|entity| {
            let keep = match &entity.shape {
                EntityShape::Path(path) => path.points.iter().all(|p| is_readable(*p)),
                EntityShape::Point(p, _) => is_readable(*p),
                EntityShape::Text(..) | EntityShape::Insert(_) => true,
            };
            if !keep {
                findings.skip("entity beyond 10 km", entity.line);
            }
            keep
        });
    }
}
