//! Blocks put in place: every INSERT of the model space becomes a sheet of its own, in meters.
//!
//! Blocks keep their own coordinates: an INSERT turns, scales and mirrors them but does not move
//! them, so that a layout on a marker has no effect. Blocks with an outline that nothing inserts
//! are taken too (AAMA pieces live in blocks). Nothing is expanded beyond the limits, so that a
//! block that inserts itself, deep nesting and huge arrays end early. Pieces that a wrapper puts
//! together, at any depth, are taken as if the model space inserted each of them.

use super::block_index::{BlockIndex, OutlineRank};
use super::contents::{DxfBlock, DxfDrawing};
use super::labels::DxfLabels;
use super::layers::{LayerRole, role};
use super::placed_sheet::{PlacedSheet, give, join_parts};
use super::sheet::DxfSheet;
use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::Units;
use crate::pattern::dxf::entity::affine::AffineMap;
use crate::pattern::dxf::entity::geometry::{BlockInsert, DxfEntity, EntityShape};
use crate::pattern::dxf::findings::{DxfFindings, at_line};
use std::collections::{BTreeMap, BTreeSet};

/// A sheet counts as this many entities: what it takes of itself.
const SHEET_COST: usize = 8;

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
    let mut placer = BlockPlacer::new(&drawing.blocks, unit, limits, findings);
    let mut sheets = placer.inserted(&drawing.model)?;
    sheets.extend(placer.not_inserted()?);
    sheets.extend(loose_entities(&drawing.model, &to_meters));
    for sheet in &mut sheets {
        sheet.move_near_origin(findings);
        sheet.drop_far(findings);
    }
    Ok(sheets)
}

/// Returns the labels of a whole file: the texts of the model space, and those of wrappers.
pub(crate) fn file_labels(drawing: &DxfDrawing, limits: &Limits) -> DxfLabels {
    let index = BlockIndex::new(&drawing.blocks, limits.dxf_nesting);
    let wrappers = index.wrappers().flat_map(|block| &block.entities);
    DxfLabels::of(drawing.model.iter().chain(wrappers))
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
            linear: AffineMap::scale([1.0; 2]),
            entities,
        })
}

/// The state of putting the blocks of a drawing in place.
struct BlockPlacer<'a> {
    blocks: &'a [DxfBlock],
    to_meters: AffineMap,
    from_meters: AffineMap,
    index: BlockIndex<'a>,
    /// Number of INSERTs of the model space and of wrappers with a name so far.
    insert_counts: BTreeMap<String, usize>,
    /// The blocks that the model space or a wrapper inserts.
    used: BTreeSet<usize>,
    /// Number of points and entities that may still be put in.
    budget: usize,
    limits: &'a Limits,
    findings: &'a mut DxfFindings,
}

impl<'a> BlockPlacer<'a> {
    fn new(
        blocks: &'a [DxfBlock],
        unit: Units,
        limits: &'a Limits,
        findings: &'a mut DxfFindings,
    ) -> Self {
        Self {
            blocks,
            to_meters: AffineMap::scale([unit.in_meters(); 2]),
            from_meters: AffineMap::scale([1.0 / unit.in_meters(); 2]),
            index: BlockIndex::new(blocks, limits.dxf_nesting),
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
            let to_meters = self.to_meters;
            let placed = self.place_insert(insert, &to_meters, entity.line, 0)?;
            sheets.extend(placed.into_iter().map(|placed| placed.sheet));
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
            let is_piece = is_piece(block);
            let wrapped = self.index.wrapped_rank(index);
            if is_piece || wrapped == Some(OutlineRank::Boundary) {
                let is = if is_piece {
                    "is a piece"
                } else {
                    "holds pieces"
                };
                let detail = format!(
                    "block {:?} {is} but is not inserted; it was taken all the same",
                    block.name
                );
                let code = PatternCode::BlockNotInserted;
                self.findings.warn(code, block.line, detail);
                let map = self.to_meters;
                let placed = self.place_block(index, &map, 0)?;
                sheets.extend(placed.into_iter().map(|placed| placed.sheet));
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
        let found = self.index.find(&insert.name, nth);
        if found.is_none() {
            let name = &insert.name;
            let detail = format!("the block {name:?} that is inserted here is not in the file");
            self.findings.warn(PatternCode::MissingBlock, line, detail);
        }
        found
    }

    /// Returns the sheets of one INSERT of the model space or of a wrapper put through `map`, one
    /// to a piece and a cell of its array.
    fn place_insert(
        &mut self,
        insert: &BlockInsert,
        map: &AffineMap,
        line: usize,
        depth: usize,
    ) -> Result<Vec<PlacedSheet>, Fault> {
        let name = insert.name.to_lowercase();
        let nth = self.insert_counts.get(&name).copied().unwrap_or(0);
        let Some(index) = self.find(insert, nth, line) else {
            return Ok(Vec::new());
        };
        self.insert_counts.insert(name, nth + 1);
        self.used.insert(index);
        self.spend(insert.cell_count(), line)?;
        let base = self.blocks[index].base;
        let mut placed = Vec::new();
        for cell in insert.cells() {
            let map = map.after(&AffineMap::of_insert(insert, base, cell));
            placed.extend(self.place_block(index, &map, depth)?);
        }
        Ok(placed)
    }

    /// Returns the sheet of a block put through `map`, or those that a wrapper holds.
    fn place_block(
        &mut self,
        index: usize,
        map: &AffineMap,
        depth: usize,
    ) -> Result<Vec<PlacedSheet>, Fault> {
        if let Some(rank) = self.index.wrapped_rank(index) {
            return self.unwrap(index, rank, map, depth);
        }
        self.spend(SHEET_COST, self.blocks[index].line)?;
        let mut entities = Vec::new();
        self.expand(index, &map.without_shift(), depth, &mut entities)?;
        let sheet = DxfSheet {
            block: Some(self.blocks[index].name.clone()),
            line: self.blocks[index].line,
            linear: self.from_meters.after(&map.without_shift()),
            entities,
        };
        Ok(vec![PlacedSheet::new(sheet, map.apply([0.0, 0.0]))])
    }

    /// Returns the sheets of the pieces of a rank that a wrapper puts together. What else it holds
    /// goes to the pieces that it lies in.
    fn unwrap(
        &mut self,
        index: usize,
        rank: OutlineRank,
        map: &AffineMap,
        depth: usize,
    ) -> Result<Vec<PlacedSheet>, Fault> {
        let block = &self.blocks[index];
        self.check_depth(depth, block.line)?;
        let (mut sheets, mut rest) = (Vec::new(), Vec::new());
        for entity in &block.entities {
            let is_piece = |insert: &BlockInsert| {
                let inner = self.index.find(&insert.name, 0);
                inner.and_then(|inner| self.index.rank(inner)) == Some(rank)
            };
            match &entity.shape {
                EntityShape::Insert(insert) if is_piece(insert) => {
                    sheets.extend(self.place_insert(insert, map, entity.line, depth + 1)?);
                }
                _ => self.expand_entity(entity, map, depth, &mut rest)?,
            }
        }
        if rank == OutlineRank::General {
            sheets = join_parts(sheets, self.findings);
        }
        give(&rest, &mut sheets, self.findings);
        Ok(sheets)
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
        self.check_depth(depth, block.line)?;
        for entity in &block.entities {
            self.expand_entity(entity, map, depth, out)?;
        }
        Ok(())
    }

    /// Adds an entity of a block put through `map` to `out`; for an INSERT, what it puts in.
    fn expand_entity(
        &mut self,
        entity: &DxfEntity,
        map: &AffineMap,
        depth: usize,
        out: &mut Vec<DxfEntity>,
    ) -> Result<(), Fault> {
        let EntityShape::Insert(insert) = &entity.shape else {
            self.spend(entity.shape.point_count(), entity.line)?;
            out.push(map.apply_to(entity));
            return Ok(());
        };
        let Some(inner) = self.find(insert, 0, entity.line) else {
            return Ok(());
        };
        self.spend(insert.cell_count(), entity.line)?;
        for cell in insert.cells() {
            let base = self.blocks[inner].base;
            let map = map.after(&AffineMap::of_insert(insert, base, cell));
            self.expand(inner, &map, depth + 1, out)?;
        }
        Ok(())
    }

    /// Checks that a block is not nested too deep.
    fn check_depth(&self, depth: usize, line: usize) -> Result<(), Fault> {
        if depth <= self.limits.dxf_nesting {
            return Ok(());
        }
        let detail = format!(
            "blocks are nested more than {} deep, or a block inserts itself",
            self.limits.dxf_nesting
        );
        Err(Fault::new(PatternCode::Nesting, at_line(line), detail)
            .fix("explode the blocks in the CAD program"))
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
