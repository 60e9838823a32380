//! Blocks put in place: every INSERT of the model space becomes a sheet of its own, in metres. Nothing is expanded
//! beyond the limits, so a block that inserts itself, deep nesting and huge arrays end early.

use super::entity::{Entity, Insert, Map, Shape};
use super::layer::{Role, role};
use super::{Findings, at_line};
use crate::config::Limits;
use crate::fault::Fault;
use crate::pattern::Point2;
use crate::pattern::polyline::bounds;
use std::collections::{BTreeMap, BTreeSet};

/// A block definition as read.
pub(super) struct Block {
    /// Its name, which other blocks may have too.
    pub(super) name: String,
    /// The point that is put where an INSERT says.
    pub(super) base: Point2,
    /// The line it begins at.
    pub(super) line: usize,
    /// What it holds.
    pub(super) entities: Vec<Entity>,
}

/// Entities that belong together: one block put in, or what lies loose in the model space. Metres.
pub(super) struct Sheet {
    /// Name of the block, `None` for the model space.
    pub(super) block: Option<String>,
    /// The line it begins at.
    pub(super) line: usize,
    /// What it holds, without inserts.
    pub(super) entities: Vec<Entity>,
}

/// All sheets of a drawing.
///
/// Blocks keep their own coordinates: an INSERT turns, scales and mirrors them but does not shift them, so a layout
/// on a marker has no effect. Blocks with an outline that nothing inserts are taken too (AAMA pieces live in blocks).
pub(super) fn sheets(
    blocks: &[Block],
    model: &[Entity],
    scale: f64,
    limits: &Limits,
    findings: &mut Findings,
) -> Result<Vec<Sheet>, Fault> {
    let mut by_name: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (i, block) in blocks.iter().enumerate() {
        by_name
            .entry(block.name.to_lowercase())
            .or_default()
            .push(i);
    }
    let mut expander = Expander {
        blocks,
        by_name,
        left: limits.dxf_entities + limits.dxf_vertices,
        limits,
        findings,
    };
    let mut sheets = Vec::new();
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let mut used = BTreeSet::new();
    for entity in model {
        let Shape::Insert(insert) = &entity.shape else {
            continue;
        };
        let nth = seen.entry(insert.name.to_lowercase()).or_insert(0);
        let Some(index) = expander.find(insert, *nth, entity.line) else {
            continue;
        };
        *nth += 1;
        used.insert(index);
        sheets.extend(expander.top(index, insert, entity.line, scale)?);
    }
    let nested: BTreeSet<String> = blocks.iter().flat_map(|b| inserted(&b.entities)).collect();
    for (index, block) in blocks.iter().enumerate() {
        let is_piece = block
            .entities
            .iter()
            .any(|e| matches!(e.shape, Shape::Path(_)) && role(&e.layer) == Role::Boundary);
        if used.contains(&index) || nested.contains(&block.name.to_lowercase()) {
            continue;
        }
        if !is_piece {
            if seen.contains_key(&block.name.to_lowercase()) {
                let what = "entity of a block that has the name of another";
                let count = block.entities.len();
                expander.findings.left_out_many(what, block.line, count);
            }
            continue;
        }
        expander.findings.warn(
            "pattern/block_not_inserted",
            block.line,
            format!(
                "block {:?} is a piece but is not inserted; it was taken all the same",
                block.name
            ),
        );
        let mut entities = Vec::new();
        expander.put(index, &Map::scale(scale), 0, &mut entities)?;
        sheets.push(Sheet {
            block: Some(block.name.clone()),
            line: block.line,
            entities,
        });
    }
    let loose: Vec<Entity> = model
        .iter()
        .filter(|e| !matches!(e.shape, Shape::Insert(_)))
        .map(|e| Map::scale(scale).entity(e))
        .collect();
    if loose.iter().any(|e| matches!(e.shape, Shape::Path(_))) {
        sheets.push(Sheet {
            block: None,
            line: loose[0].line,
            entities: loose,
        });
    }
    for sheet in &mut sheets {
        sheet.bring_near(findings);
        sheet.drop_far(findings);
    }
    Ok(sheets)
}

impl Sheet {
    /// Shifts what lies far from the origin to it: coordinates of single precision would blur it later.
    fn bring_near(&mut self, findings: &mut Findings) {
        /// Coordinates up to this keep 10 um in single precision \[m\].
        const FAR: f64 = 100.0;
        let points: Vec<Point2> = self
            .entities
            .iter()
            .filter_map(|e| {
                if let Shape::Path(path) = &e.shape {
                    Some(&path.points)
                } else {
                    None
                }
            })
            .flatten()
            .copied()
            .collect();
        let [low, high] = bounds(&points);
        if points.is_empty() || low.into_iter().chain(high).all(|c| c.abs() <= FAR) {
            return;
        }
        let map = Map::shift([-low[0], -low[1]]);
        self.entities = self.entities.iter().map(|e| map.entity(e)).collect();
        findings.warn(
            "pattern/moved",
            self.line,
            format!(
                "the drawing lies at ({:.4e}, {:.4e}) m and was moved to the origin",
                low[0], low[1]
            ),
        );
    }
}

impl Sheet {
    /// Leaves out what lies farther away than any pattern: a slip of a digit. Where all lines do, the units are wrong.
    fn drop_far(&mut self, findings: &mut Findings) {
        /// As far as the check of patterns goes \[m\].
        const FARTHEST: f64 = 1e4;
        let near = |p: &Point2| p.iter().all(|c| c.abs() <= FARTHEST);
        let some_near = self.entities.iter().any(|entity| match &entity.shape {
            Shape::Path(path) => path.points.iter().all(near),
            _ => false,
        });
        if !some_near {
            return;
        }
        self.entities.retain(|entity| {
            let is_near = match &entity.shape {
                Shape::Path(path) => path.points.iter().all(near),
                Shape::Point(p, _) => near(p),
                Shape::Text(..) | Shape::Insert(_) => true,
            };
            if !is_near {
                findings.left_out("entity beyond 10 km", entity.line);
            }
            is_near
        });
    }
}

fn inserted(entities: &[Entity]) -> impl Iterator<Item = String> + '_ {
    entities.iter().filter_map(|e| match &e.shape {
        Shape::Insert(insert) => Some(insert.name.to_lowercase()),
        _ => None,
    })
}

struct Expander<'a> {
    blocks: &'a [Block],
    by_name: BTreeMap<String, Vec<usize>>,
    /// How many more points and entities may be put in.
    left: usize,
    limits: &'a Limits,
    findings: &'a mut Findings,
}

impl Expander<'_> {
    /// The block for the `nth` INSERT of a name: the `nth` block of that name, or the last.
    fn find(&mut self, insert: &Insert, nth: usize, line: usize) -> Option<usize> {
        let same = self.by_name.get(&insert.name.to_lowercase());
        let found = same.and_then(|list| list.get(nth).or(list.last())).copied();
        if found.is_none() {
            self.findings.warn(
                "pattern/missing_block",
                line,
                format!(
                    "the block {:?} that is inserted here is not in the file",
                    insert.name
                ),
            );
        }
        found
    }

    /// The sheets of one INSERT of the model space, one to a cell of its array.
    fn top(
        &mut self,
        index: usize,
        insert: &Insert,
        line: usize,
        scale: f64,
    ) -> Result<Vec<Sheet>, Fault> {
        let mut sheets = Vec::new();
        self.spend(insert.cells(), line)?;
        for row in 0..insert.count[1] {
            for column in 0..insert.count[0] {
                let mut map =
                    Map::scale(scale).after(&insert.map(self.blocks[index].base, column, row));
                map.t = [0.0, 0.0];
                let mut entities = Vec::new();
                self.put(index, &map, 0, &mut entities)?;
                sheets.push(Sheet {
                    block: Some(self.blocks[index].name.clone()),
                    line: self.blocks[index].line,
                    entities,
                });
            }
        }
        Ok(sheets)
    }

    /// Puts a block's entities through `map` into `out`, those of blocks inside it too.
    fn put(
        &mut self,
        index: usize,
        map: &Map,
        depth: usize,
        out: &mut Vec<Entity>,
    ) -> Result<(), Fault> {
        let block = &self.blocks[index];
        if depth > self.limits.dxf_nesting {
            return Err(Fault::new(
                "pattern/nesting",
                at_line(block.line),
                format!(
                    "blocks are nested more than {} deep, or a block inserts itself",
                    self.limits.dxf_nesting
                ),
            )
            .fix("explode the blocks in the CAD program"));
        }
        for entity in &block.entities {
            let Shape::Insert(insert) = &entity.shape else {
                let points = if let Shape::Path(path) = &entity.shape {
                    path.points.len()
                } else {
                    1
                };
                self.spend(points, entity.line)?;
                out.push(map.entity(entity));
                continue;
            };
            let Some(inner) = self.find(insert, 0, entity.line) else {
                continue;
            };
            self.spend(insert.cells(), entity.line)?;
            for row in 0..insert.count[1] {
                for column in 0..insert.count[0] {
                    let map = map.after(&insert.map(self.blocks[inner].base, column, row));
                    self.put(inner, &map, depth + 1, out)?;
                }
            }
        }
        Ok(())
    }

    fn spend(&mut self, count: usize, line: usize) -> Result<(), Fault> {
        match self.left.checked_sub(count) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => Err(Fault::new(
                "pattern/too_large",
                at_line(line),
                format!(
                    "with all blocks put in, the drawing has more than {} entities and points",
                    self.limits.dxf_entities + self.limits.dxf_vertices
                ),
            )
            .fix("explode the blocks, or delete the ones that are not pieces")),
        }
    }
}
