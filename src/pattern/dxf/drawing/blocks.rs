//! Blocks put in place: every INSERT of the model space becomes a sheet of its own, in meters.
//!
//! Blocks keep their own coordinates: an INSERT turns, scales and mirrors them but does not move
//! them, so that a layout on a marker has no effect. Blocks with an outline that nothing inserts
//! are taken too (AAMA pieces live in blocks). Nothing is expanded beyond the limits, so that a
//! block that inserts itself, deep nesting and huge arrays end early.

use super::contents::{DxfBlock, DxfDrawing};
use super::layers::{LayerRole, role};
use super::sheet::DxfSheet;
use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::Units;
use crate::pattern::dxf::entity::affine::AffineMap;
use crate::pattern::dxf::entity::geometry::{BlockInsert, DxfEntity, EntityShape};
use crate::pattern::dxf::findings::{DxfFindings, at_line};
use std::collections::{BTreeMap, BTreeSet};

/// Returns all sheets of a drawing.
///
/// # Errors
/// Blocks that are nested too deeply, or more entities and points than are read.
pub(crate) fn place(
    drawing: &DxfDrawing,
    unit: Units,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Result<Vec<DxfSheet>, Fault> {
    let to_meters = AffineMap::scale([unit.in_meters(); 2]);
    let mut placer = BlockPlacer::new(&drawing.blocks, to_meters, limits, findings);
    let mut sheets = placer.inserted(&drawing.model)?;
    sheets.extend(placer.not_inserted()?);
    sheets.extend(loose_entities(&drawing.model, &to_meters));
    for sheet in &mut sheets {
        sheet.move_near_origin(findings);
        sheet.drop_far(findings);
    }
    Ok(sheets)
}

/// Returns the sheet of what lies loose in the model space, if there is a line in it.
fn loose_entities(model: &[DxfEntity], to_meters: &AffineMap) -> Option<DxfSheet> {
    let entities: Vec<DxfEntity> = model
        .iter()
        .filter(|e| !matches!(e.shape, EntityShape::Insert(_)))
        .map(|e| to_meters.apply_to(e))
        .collect();
    entities
        .iter()
        .any(|e| e.shape.path().is_some())
        .then(|| DxfSheet {
            block: None,
            line: entities[0].line,
            entities,
        })
}

/// The state of putting the blocks of a drawing in place.
struct BlockPlacer<'a> {
    blocks: &'a [DxfBlock],
    to_meters: AffineMap,
    /// Indices of the blocks with a name (lower case), in the order of the file.
    by_name: BTreeMap<String, Vec<usize>>,
    /// Number of INSERTs of the model space with a name so far.
    insert_counts: BTreeMap<String, usize>,
    /// The blocks that the model space inserts.
    used: BTreeSet<usize>,
    /// Number of points and entities that may still be put in.
    budget: usize,
    limits: &'a Limits,
    findings: &'a mut DxfFindings,
}

impl<'a> BlockPlacer<'a> {
    fn new(
        blocks: &'a [DxfBlock],
        to_meters: AffineMap,
        limits: &'a Limits,
        findings: &'a mut DxfFindings,
    ) -> Self {
        let mut by_name: BTreeMap<String, Vec<usize>> = BTreeMap::new();
        for (i, block) in blocks.iter().enumerate() {
            by_name
                .entry(block.name.to_lowercase())
                .or_default()
                .push(i);
        }
        Self {
            blocks,
            to_meters,
            by_name,
            insert_counts: BTreeMap::new(),
            used: BTreeSet::new(),
            budget: limits.dxf_entities + limits.dxf_vertices,
            limits,
            findings,
        }
    }

    /// Returns the sheets of the INSERTs of the model space.
    fn inserted(&mut self, model: &[DxfEntity]) -> Result<Vec<DxfSheet>, Fault> {
        let mut sheets = Vec::new();
        for entity in model {
            let EntityShape::Insert(insert) = &entity.shape else {
                continue;
            };
            let name = insert.name.to_lowercase();
            let nth = self.insert_counts.get(&name).copied().unwrap_or(0);
            let Some(index) = self.find(insert, nth, entity.line) else {
                continue;
            };
            self.insert_counts.insert(name, nth + 1);
            self.used.insert(index);
            sheets.extend(self.place_insert(index, insert, entity.line)?);
        }
        Ok(sheets)
    }

    /// Returns the sheets of the pieces that nothing inserts, each with a warning.
    fn not_inserted(&mut self) -> Result<Vec<DxfSheet>, Fault> {
        let mut sheets = Vec::new();
        let nested = self.blocks.iter().flat_map(DxfBlock::inserted_names);
        let nested: BTreeSet<String> = nested.collect();
        for (index, block) in self.blocks.iter().enumerate() {
            let name = block.name.to_lowercase();
            if self.used.contains(&index) || nested.contains(&name) {
                continue;
            }
            if is_piece(block) {
                let detail = format!(
                    "block {:?} is a piece but is not inserted; it was taken all the same",
                    block.name
                );
                let code = PatternCode::BlockNotInserted;
                self.findings.warn(code, block.line, detail);
                let map = self.to_meters;
                sheets.push(self.sheet(index, &map)?);
            } else if self.insert_counts.contains_key(&name) {
                let kind = "entity of a block that has the name of another";
                self.findings
                    .skip_many(kind, block.line, block.entities.len());
            }
        }
        Ok(sheets)
    }

    /// Returns the block of the `nth` INSERT of a name: the `nth` block of that name, or the last.
    fn find(&mut self, insert: &BlockInsert, nth: usize, line: usize) -> Option<usize> {
        let same = self.by_name.get(&insert.name.to_lowercase());
        let found = same.and_then(|list| list.get(nth).or(list.last())).copied();
        if found.is_none() {
            let name = &insert.name;
            let detail = format!("the block {name:?} that is inserted here is not in the file");
            self.findings.warn(PatternCode::MissingBlock, line, detail);
        }
        found
    }

    /// Returns the sheets of one INSERT of the model space, one to a cell of its array.
    fn place_insert(
        &mut self,
        index: usize,
        insert: &BlockInsert,
        line: usize,
    ) -> Result<Vec<DxfSheet>, Fault> {
        self.spend(insert.cell_count(), line)?;
        let base = self.blocks[index].base;
        insert
            .cells()
            .map(|cell| {
                let map = AffineMap::of_insert(insert, base, cell);
                let map = self.to_meters.after(&map).without_shift();
                self.sheet(index, &map)
            })
            .collect()
    }

    /// Returns the sheet of a block put through `map`.
    fn sheet(&mut self, index: usize, map: &AffineMap) -> Result<DxfSheet, Fault> {
        let mut entities = Vec::new();
        self.expand(index, map, 0, &mut entities)?;
        Ok(DxfSheet {
            block: Some(self.blocks[index].name.clone()),
            line: self.blocks[index].line,
            entities,
        })
    }

    /// Adds a block's entities put through `map` to `out`, those of blocks inside it too.
    fn expand(
        &mut self,
        index: usize,
        map: &AffineMap,
        depth: usize,
        out: &mut Vec<DxfEntity>,
    ) -> Result<(), Fault> {
        let block = &self.blocks[index];
        if depth > self.limits.dxf_nesting {
            return Err(self.nested_too_deep(block.line));
        }
        for entity in &block.entities {
            let EntityShape::Insert(insert) = &entity.shape else {
                self.spend(entity.shape.point_count(), entity.line)?;
                out.push(map.apply_to(entity));
                continue;
            };
            let Some(inner) = self.find(insert, 0, entity.line) else {
                continue;
            };
            self.spend(insert.cell_count(), entity.line)?;
            for cell in insert.cells() {
                let base = self.blocks[inner].base;
                let map = map.after(&AffineMap::of_insert(insert, base, cell));
                self.expand(inner, &map, depth + 1, out)?;
            }
        }
        Ok(())
    }

    fn nested_too_deep(&self, line: usize) -> Fault {
        let detail = format!(
            "blocks are nested more than {} deep, or a block inserts itself",
            self.limits.dxf_nesting
        );
        Fault::new(PatternCode::Nesting, at_line(line), detail)
            .fix("explode the blocks in the CAD program")
    }

    /// Takes `count` points and entities from the budget.
    fn spend(&mut self, count: usize, line: usize) -> Result<(), Fault> {
        let Some(left) = self.budget.checked_sub(count) else {
            let detail = format!(
                "with all blocks put in, the drawing has more than {} entities and points",
                self.limits.dxf_entities + self.limits.dxf_vertices
            );
            return Err(Fault::new(PatternCode::TooLarge, at_line(line), detail)
                .fix("explode the blocks, or delete the ones that are not pieces"));
        };
        self.budget = left;
        Ok(())
    }
}

/// Returns true if a block has a line on the boundary layer.
fn is_piece(block: &DxfBlock) -> bool {
    let mut entities = block.entities.iter();
    entities.any(|e| e.shape.path().is_some() && role(&e.layer) == LayerRole::Boundary)
}
