//! Sheets of a wrapper with the places that it puts them at: what else the wrapper holds is given
//! to the piece that it lies in.

use super::labels::{DxfLabels, is_label};
use super::sheet::DxfSheet;
use crate::fault::PatternCode;
use crate::pattern::Point2;
use crate::pattern::dxf::entity::affine::AffineMap;
use crate::pattern::dxf::entity::geometry::{DxfEntity, EntityShape};
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::polyline::bounds;

/// At most this many sheets of a wrapper are looked through for the one that a place lies in.
const COMPARED: usize = 200;

/// A sheet in the coordinates of its block, with the place at which the block is put.
pub(super) struct PlacedSheet {
    pub(super) sheet: DxfSheet,
    /// The place of its origin \[m\].
    at: Point2,
    /// The smallest and the largest coordinates of its lines where they are put \[m\].
    bounds: [Point2; 2],
}

impl PlacedSheet {
    /// Returns a sheet whose origin is put at a place.
    pub(super) fn new(sheet: DxfSheet, at: Point2) -> Self {
        let paths = sheet.entities.iter().filter_map(|e| e.shape.path());
        let points: Vec<Point2> = paths.flat_map(|path| &path.points).copied().collect();
        let moved = |p: Point2| [p[0] + at[0], p[1] + at[1]];
        Self {
            bounds: bounds(&points).map(moved),
            sheet,
            at,
        }
    }

    fn holds(&self, p: Point2) -> bool {
        let [low, high] = self.bounds;
        (0..2).all(|k| low[k] <= p[k] && p[k] <= high[k])
    }

    fn area(&self) -> f64 {
        let [low, high] = self.bounds;
        (high[0] - low[0]) * (high[1] - low[1])
    }

    /// Adds an entity that lies where the sheets are put.
    fn add(&mut self, entity: &DxfEntity) {
        let back = AffineMap::translation([-self.at[0], -self.at[1]]);
        self.sheet.entities.push(back.apply_to(entity));
    }

    fn has_labels(&self) -> bool {
        let mut entities = self.sheet.entities.iter();
        entities.any(|e| matches!(&e.shape, EntityShape::Text(_, text) if is_label(text)))
    }

    /// Returns its entities where the sheet is put.
    fn placed_entities(&self) -> Vec<DxfEntity> {
        let map = AffineMap::translation(self.at);
        self.sheet
            .entities
            .iter()
            .map(|e| map.apply_to(e))
            .collect()
    }
}

/// Makes parts of pieces of the sheets without labels that lie in another: symbols and pockets,
/// where no layer tells outlines from other lines. Each is warned about.
pub(super) fn join_parts(sheets: Vec<PlacedSheet>, findings: &mut DxfFindings) -> Vec<PlacedSheet> {
    if sheets.len() > COMPARED {
        return sheets;
    }
    let lies_in = |part: &PlacedSheet, whole: &PlacedSheet| {
        part.area() < whole.area() && part.bounds.iter().all(|p| whole.holds(*p))
    };
    let is_part =
        |part: &PlacedSheet| !part.has_labels() && sheets.iter().any(|whole| lies_in(part, whole));
    let are_parts: Vec<bool> = sheets.iter().map(is_part).collect();
    let sorted = sheets.into_iter().zip(are_parts);
    let (parts, mut wholes): (Vec<_>, Vec<_>) = sorted.partition(|(_, is_part)| *is_part);
    let mut wholes: Vec<PlacedSheet> = wholes.drain(..).map(|(whole, _)| whole).collect();
    for (part, _) in parts {
        if let Some(owner) = owner(&wholes, middle(part.bounds)) {
            let [own, whole] = [&part, &wholes[owner]].map(|placed| placed.sheet.block.as_deref());
            let detail = format!(
                "block {:?} has no label and lies in the box of {:?}; it was taken as a part of it",
                own.unwrap_or_default(),
                whole.unwrap_or_default()
            );
            findings.warn(PatternCode::BlockJoined, part.sheet.line, detail);
            for entity in part.placed_entities() {
                wholes[owner].add(&entity);
            }
        }
    }
    wholes
}

/// Gives what a wrapper holds besides its pieces to the only one, or to those that it lies in, and
/// the size that it states to all that state none. Lines that lie in none are left out, and
/// counted.
pub(super) fn give(rest: &[DxfEntity], sheets: &mut [PlacedSheet], findings: &mut DxfFindings) {
    for entity in rest {
        let place = match &entity.shape {
            EntityShape::Point(p, _) | EntityShape::Text(p, _) => Some(*p),
            EntityShape::Path(path) => Some(middle(bounds(&path.points))),
            EntityShape::Insert(_) => None,
        };
        let owner = match sheets.len() {
            1 => Some(0),
            _ => place.and_then(|p| owner(sheets, p)),
        };
        match owner {
            Some(owner) => sheets[owner].add(entity),
            None if entity.shape.path().is_some() => {
                findings.skip("line outside the pieces", entity.line);
            }
            None => {}
        }
    }
    give_size(rest, sheets);
}

/// Gives the size that a wrapper states once to its pieces that state none.
fn give_size(rest: &[DxfEntity], sheets: &mut [PlacedSheet]) {
    let states_size = |e: &&DxfEntity| DxfLabels::of(std::iter::once(*e)).get("size").is_some();
    let mut sizes = rest.iter().filter(states_size);
    let (Some(size), None) = (sizes.next(), sizes.next()) else {
        return;
    };
    for placed in sheets {
        if DxfLabels::of(placed.sheet.entities.iter())
            .get("size")
            .is_none()
        {
            placed.add(size);
        }
    }
}

/// Returns the middle of a box.
fn middle([low, high]: [Point2; 2]) -> Point2 {
    [0, 1].map(|k| 0.5 * (low[k] + high[k]))
}

/// Returns the index of the smallest sheet whose box holds a place.
fn owner(sheets: &[PlacedSheet], p: Point2) -> Option<usize> {
    let compared = sheets.iter().take(COMPARED).enumerate();
    let around = compared.filter(|(_, placed)| placed.holds(p));
    let smallest = around.min_by(|a, b| a.1.area().total_cmp(&b.1.area()));
    smallest.map(|(i, _)| i)
}
