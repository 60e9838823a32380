//! The `dxf` crate at work: some entities at a time, each counted when it comes back.

use super::convert::convert;
use super::geometry::DxfEntity;
use super::polyline::too_many_points;
use super::sanitize::{self, ExpectedEntity, SanitizedEntities};
use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::findings::{DxfFindings, at_line};
use crate::pattern::dxf::read::records::EntityRecord;
use dxf::Drawing;
use dxf::entities::EntityType;

/// A reader of entities that stops at the limit on points.
pub(crate) struct EntityLoader<'f> {
    points_left: usize,
    findings: &'f mut DxfFindings,
}

impl<'f> EntityLoader<'f> {
    /// Returns a loader of a whole drawing.
    pub(crate) fn new(limits: &Limits, findings: &'f mut DxfFindings) -> Self {
        Self {
            points_left: limits.dxf_vertices,
            findings,
        }
    }

    /// Loads the entities of some records. After a fault records are only checked.
    pub(crate) fn load(&mut self, records: &[EntityRecord<'_, '_>]) -> Vec<DxfEntity> {
        let mut entities = Vec::new();
        for batch in sanitize::batches(records) {
            let sanitized = sanitize::sanitize(batch, self.findings);
            if !self.findings.has_faults() {
                entities.extend(self.load_batch(&sanitized));
            }
        }
        entities
    }

    /// Loads a batch. A difference between what the file holds and what the crate gives back is a
    /// fault at the first entity concerned.
    fn load_batch(&mut self, batch: &SanitizedEntities) -> Vec<DxfEntity> {
        let Some(first) = batch.expected.first() else {
            return Vec::new();
        };
        let loaded = Drawing::load_with_encoding(&mut batch.text.as_bytes(), encoding_rs::UTF_8);
        let drawing = match loaded {
            Ok(drawing) => drawing,
            Err(error) => {
                let detail = format!("the entities from here on cannot be read: {error}");
                let fault = Fault::new(PatternCode::Unreadable, at_line(first.line), detail);
                self.findings.faults.push(fault);
                return Vec::new();
            }
        };
        let mut found = drawing.entities();
        let mut entities = Vec::with_capacity(batch.expected.len());
        for expected in &batch.expected {
            let entity = found.next();
            let Some(entity) = entity.filter(|e| came_back(expected, &e.specific)) else {
                self.findings.faults.push(lost(expected));
                return entities;
            };
            match convert(
                &entity.specific,
                expected.line,
                self.points_left,
                self.findings,
            ) {
                Ok(Some(shape)) => {
                    let Some(left) = self.points_left.checked_sub(shape.point_count()) else {
                        self.findings.faults.push(too_many_points(expected.line));
                        return Vec::new();
                    };
                    self.points_left = left;
                    entities.push(DxfEntity {
                        layer: entity.common.layer.clone(),
                        line: expected.line,
                        shape,
                    });
                }
                Ok(None) => {}
                Err(fault) => self.findings.faults.push(fault),
            }
        }
        entities
    }
}

/// Returns true if an entity of the crate is the expected one, with all its vertices.
fn came_back(expected: &ExpectedEntity, found: &EntityType) -> bool {
    match found {
        EntityType::Line(_) => expected.kind == "LINE",
        EntityType::ModelPoint(_) => expected.kind == "POINT",
        EntityType::Text(_) => expected.kind == "TEXT",
        EntityType::MText(_) => expected.kind == "MTEXT",
        EntityType::Polyline(p) => {
            expected.kind == "POLYLINE" && p.vertices().count() == expected.vertices
        }
        EntityType::LwPolyline(p) => {
            expected.kind == "LWPOLYLINE" && p.vertices.len() == expected.vertices
        }
        EntityType::Arc(_) => expected.kind == "ARC",
        EntityType::Circle(_) => expected.kind == "CIRCLE",
        EntityType::Ellipse(_) => expected.kind == "ELLIPSE",
        EntityType::Spline(_) => expected.kind == "SPLINE",
        EntityType::Insert(_) => expected.kind == "INSERT",
        _ => false,
    }
}

fn lost(expected: &ExpectedEntity) -> Fault {
    let kind = expected.kind;
    let detail = format!("the {kind} that begins here could not be read whole");
    Fault::new(PatternCode::LostEntity, at_line(expected.line), detail)
        .fix("export the file again, or report this file")
}
