//! Tags to records: a variable of the header, the blocks one by one (never by name), and the
//! entities.

use super::tags::{DxfTag, DxfTags};
use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::findings::{DxfFindings, excerpt};

/// Sections without anything to draw.
const NO_ENTITIES: [&str; 7] = [
    "HEADER",
    "CLASSES",
    "TABLES",
    "OBJECTS",
    "THUMBNAILIMAGE",
    "ACDSDATA",
    "ACDS",
];

/// An entity as the file has it: `code 0`, its kind, and the tags up to the next `code 0`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EntityRecord<'a, 't> {
    /// `LINE`, `VERTEX`, in the file's case.
    pub(crate) kind: &'a str,
    /// The line it begins at.
    pub(crate) line: usize,
    /// Its tags, without the one that opens it.
    pub(crate) tags: &'t [DxfTag<'a>],
}

impl<'a> EntityRecord<'a, '_> {
    /// Returns the first value with a group code.
    pub(crate) fn value(&self, code: i32) -> Option<&'a str> {
        self.tags
            .iter()
            .find(|tag| tag.code == code)
            .map(|tag| tag.value)
    }
}

/// One block definition.
pub(crate) struct BlockRecord<'a, 't> {
    /// Its own record.
    pub(crate) head: EntityRecord<'a, 't>,
    /// The entities between BLOCK and ENDBLK.
    pub(crate) entities: Vec<EntityRecord<'a, 't>>,
}

/// The parts of a file that a pattern is read from.
#[derive(Default)]
pub(crate) struct DxfRecords<'a, 't> {
    /// `$INSUNITS`, if the header has it.
    pub(crate) insunits: Option<i32>,
    /// Every block, in file order, those with equal names too.
    pub(crate) blocks: Vec<BlockRecord<'a, 't>>,
    /// The entities of the model space.
    pub(crate) entities: Vec<EntityRecord<'a, 't>>,
}

/// Sorts the tags of a file into records.
///
/// # Errors
/// A file that is cut off, that does not begin with a section, or that has more entities than
/// `limits` allow.
pub(crate) fn read<'a, 't>(
    file: &'t DxfTags<'a>,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Result<DxfRecords<'a, 't>, Fault> {
    let tags = &file.tags[..];
    if !tags.first().is_some_and(|tag| tag.opens("SECTION")) {
        return Err(super::file_type::not_dxf(
            "the file does not begin with a SECTION",
            "upload a DXF file",
        ));
    }
    check_end(file, findings)?;
    let records = records(tags);
    if records.len() > limits.dxf_entities + limits.dxf_vertices {
        return Err(too_many(
            "entities and vertices",
            records.len(),
            limits.dxf_entities + limits.dxf_vertices,
        ));
    }
    let sorted = RecordSorter::default().sort(&records, findings);
    let entities = sorted.entities.len()
        + sorted
            .blocks
            .iter()
            .map(|b| b.entities.len())
            .sum::<usize>();
    let vertices = records
        .iter()
        .filter(|r| r.kind.eq_ignore_ascii_case("VERTEX"))
        .count();
    if entities - vertices.min(entities) > limits.dxf_entities {
        return Err(too_many(
            "entities",
            entities - vertices,
            limits.dxf_entities,
        ));
    }
    if vertices > limits.dxf_vertices {
        return Err(too_many("vertices", vertices, limits.dxf_vertices));
    }
    Ok(sorted)
}

fn too_many(what: &str, count: usize, limit: usize) -> Fault {
    Fault::new(
        PatternCode::TooLarge,
        "line 1",
        format!("the file has {count} {what}; at most {limit} are read"),
    )
    .fix("export fewer pieces or sizes, or fewer points to a curve")
}

/// Checks the end of a file: one that ends inside a section was cut off, one that only lacks its
/// EOF is whole.
fn check_end(file: &DxfTags<'_>, findings: &mut DxfFindings) -> Result<(), Fault> {
    let last_line = file.tags.last().map_or(1, |tag| tag.line);
    if file.tags.iter().any(|tag| tag.opens("EOF")) {
        if let Some(line) = file.dangling {
            findings.warn(
                PatternCode::DanglingLine,
                line,
                "a group code stands at the end without its value",
            );
        }
        return Ok(());
    }
    let open = file
        .tags
        .iter()
        .rfind(|tag| tag.opens("SECTION") || tag.opens("ENDSEC"));
    if open.is_some_and(|tag| tag.opens("SECTION")) || file.dangling.is_some() {
        return Err(Fault::new(
            PatternCode::Truncated,
            format!("line {last_line}"),
            "the file ends inside a section: it was cut off",
        )
        .fix("export or upload it again"));
    }
    findings.warn(PatternCode::NoEof, last_line, "the file ends without EOF");
    Ok(())
}

/// Splits tags into records, at each group code 0.
fn records<'a, 't>(tags: &'t [DxfTag<'a>]) -> Vec<EntityRecord<'a, 't>> {
    let mut starts: Vec<usize> = (0..tags.len()).filter(|i| tags[*i].code == 0).collect();
    starts.push(tags.len());
    starts
        .windows(2)
        .map(|pair| EntityRecord {
            kind: tags[pair[0]].value,
            line: tags[pair[0]].line,
            tags: &tags[pair[0] + 1..pair[1]],
        })
        .collect()
}

/// The state of sorting records into sections.
#[derive(Default)]
struct RecordSorter<'a, 't> {
    found: DxfRecords<'a, 't>,
    /// Name of the open section, upper case; empty between sections.
    section: String,
    /// The open block.
    block: Option<BlockRecord<'a, 't>>,
}

impl<'a, 't> RecordSorter<'a, 't> {
    /// Sorts the records of a file; those that belong nowhere are counted as left out.
    fn sort(
        mut self,
        records: &[EntityRecord<'a, 't>],
        findings: &mut DxfFindings,
    ) -> DxfRecords<'a, 't> {
        for record in records {
            match record.kind.to_ascii_uppercase().as_str() {
                "SECTION" => self.open_section(record, findings),
                "ENDSEC" => self.section.clear(),
                "EOF" => {
                    self.warn_if_open(record.line, findings);
                    break;
                }
                "BLOCK" if self.section == "BLOCKS" => {
                    self.found.blocks.extend(self.block.take());
                    self.block = Some(BlockRecord {
                        head: *record,
                        entities: Vec::new(),
                    });
                }
                "ENDBLK" => self.found.blocks.extend(self.block.take()),
                _ => self.add_entity(record, findings),
            }
        }
        self.found.blocks.extend(self.block);
        self.found
    }

    fn open_section(&mut self, record: &EntityRecord<'a, 't>, findings: &mut DxfFindings) {
        self.warn_if_open(record.line, findings);
        self.section = record.value(2).unwrap_or_default().to_ascii_uppercase();
        if !self.is_without_entities() && !matches!(self.section.as_str(), "BLOCKS" | "ENTITIES") {
            let name = excerpt(&self.section);
            let detail = format!("what section {name:?} holds is not read");
            findings.warn(PatternCode::UnknownSection, record.line, detail);
        }
        if self.section == "HEADER" {
            self.found.insunits = header_number(record.tags, "$INSUNITS");
        }
    }

    fn warn_if_open(&self, line: usize, findings: &mut DxfFindings) {
        if !self.section.is_empty() {
            let detail = format!("section {} has no ENDSEC", self.section);
            findings.warn(PatternCode::NoEndsec, line, detail);
        }
    }

    fn is_without_entities(&self) -> bool {
        NO_ENTITIES.contains(&self.section.as_str())
    }

    fn add_entity(&mut self, record: &EntityRecord<'a, 't>, findings: &mut DxfFindings) {
        let is_without_entities = self.is_without_entities();
        match &mut self.block {
            Some(open) if self.section == "BLOCKS" => open.entities.push(*record),
            _ if self.section == "ENTITIES" => self.found.entities.push(*record),
            _ if is_without_entities => {}
            _ => {
                let place = if self.section.is_empty() {
                    "section"
                } else {
                    "block"
                };
                let kind = format!("{} outside any {place}", record.kind);
                findings.skip(&kind, record.line);
            }
        }
    }
}

/// Returns the number that follows a variable of the header.
fn header_number(tags: &[DxfTag<'_>], name: &str) -> Option<i32> {
    let at = tags
        .iter()
        .position(|tag| tag.code == 9 && tag.value.eq_ignore_ascii_case(name))?;
    tags.get(at + 1)?.value.parse().ok()
}
