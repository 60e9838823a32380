//! A drawing as its file holds it, in drawing units: the blocks, and the entities of the model
//! space.

use crate::config::Limits;
use crate::fault::Fault;
use crate::pattern::Point2;
use crate::pattern::dxf::entity::geometry::{DxfEntity, EntityShape};
use crate::pattern::dxf::entity::load::EntityLoader;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::dxf::read::records::{self, BlockRecord};
use crate::pattern::dxf::read::tags;

/// A block definition.
pub(crate) struct DxfBlock {
    /// Its name, which other blocks may have too.
    pub(crate) name: String,
    /// The point that is put at the place of an INSERT.
    pub(crate) base: Point2,
    /// The line it begins at.
    pub(crate) line: usize,
    /// Its entities.
    pub(crate) entities: Vec<DxfEntity>,
}

/// The contents of a drawing, in drawing units.
pub(crate) struct DxfDrawing {
    /// `$INSUNITS`, if the header has it.
    pub(crate) insunits: Option<i32>,
    /// The blocks, in the order of the file.
    pub(crate) blocks: Vec<DxfBlock>,
    /// The entities of the model space.
    pub(crate) model: Vec<DxfEntity>,
}

impl DxfDrawing {
    /// Parses the text of a DXF file.
    ///
    /// # Errors
    /// The fault that ends reading; of several faults of entities the last, the others are noted.
    pub(crate) fn parse(
        text: &str,
        limits: &Limits,
        findings: &mut DxfFindings,
    ) -> Result<Self, Fault> {
        let tags = tags::read(text, limits)?;
        let records = records::read(&tags, limits, findings)?;
        let mut loader = EntityLoader::new(limits, findings);
        let blocks = records
            .blocks
            .iter()
            .filter(|block| !is_space(block_name(block)))
            .map(|block| DxfBlock {
                name: block_name(block).to_owned(),
                base: [coordinate(block, 10), coordinate(block, 20)],
                line: block.head.line,
                entities: loader.load(&block.entities),
            })
            .collect();
        let model = loader.load(&records.entities);
        if let Some(last) = findings.faults.pop() {
            return Err(last);
        }
        Ok(Self {
            insunits: records.insunits,
            blocks,
            model,
        })
    }
}

impl DxfBlock {
    /// Returns the lower-case names of the blocks that this one inserts.
    pub(crate) fn inserted_names(&self) -> impl Iterator<Item = String> + '_ {
        self.entities.iter().filter_map(|e| match &e.shape {
            EntityShape::Insert(insert) => Some(insert.name.to_lowercase()),
            _ => None,
        })
    }
}

fn block_name<'a>(block: &BlockRecord<'a, '_>) -> &'a str {
    block.head.value(2).unwrap_or_default()
}

/// Returns the number with a group code of a block; 0 where it is missing or not finite.
fn coordinate(block: &BlockRecord<'_, '_>, code: i32) -> f64 {
    block
        .head
        .value(code)
        .and_then(|value| value.parse().ok())
        .filter(|value: &f64| value.is_finite())
        .unwrap_or(0.0)
}

/// Returns true if a block stands for the model or paper space, whose entities are in the ENTITIES
/// section.
fn is_space(name: &str) -> bool {
    let name = name.to_lowercase();
    name.strip_prefix(['*', '$'])
        .is_some_and(|rest| rest.starts_with("model_space") || rest.starts_with("paper_space"))
}
