//! Tags to records: the header's variables, the blocks kept one by one (never by name), and the entities.

use super::Findings;
use super::tags::{Tag, Tags, shown};
use crate::config::Limits;
use crate::fault::Fault;

/// One entity as the file has it: `code 0`, its kind, and the tags up to the next `code 0`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record<'a, 't> {
    /// `LINE`, `VERTEX`, in the file's case.
    pub(super) kind: &'a str,
    /// The line it begins at.
    pub(super) line: usize,
    /// Its tags, without the one that opens it.
    pub(super) tags: &'t [Tag<'a>],
}

impl<'a> Record<'a, '_> {
    /// The first value with this code.
    pub(super) fn value(&self, code: i32) -> Option<&'a str> {
        self.tags
            .iter()
            .find(|tag| tag.code == code)
            .map(|tag| tag.value)
    }
}

/// One block definition.
pub(super) struct BlockRecord<'a, 't> {
    /// Its own record.
    pub(super) head: Record<'a, 't>,
    /// The entities between BLOCK and ENDBLK.
    pub(super) entities: Vec<Record<'a, 't>>,
}

/// The parts of a file that a pattern is read from.
#[derive(Default)]
pub(super) struct Structure<'a, 't> {
    /// `$INSUNITS`, if the header has it.
    pub(super) insunits: Option<i32>,
    /// Every block, in file order, those with equal names too.
    pub(super) blocks: Vec<BlockRecord<'a, 't>>,
    /// The entities of the model space.
    pub(super) entities: Vec<Record<'a, 't>>,
}

/// Sorts the tags of a file into its structure.
///
/// # Errors
/// A file that is cut off, that does not begin with a section, or that has more entities than `limits` allow.
pub(super) fn read<'a, 't>(
    file: &'t Tags<'a>,
    limits: &Limits,
    findings: &mut Findings,
) -> Result<Structure<'a, 't>, Fault> {
    let tags = &file.tags[..];
    if !tags.first().is_some_and(|tag| tag.opens("SECTION")) {
        return Err(super::sniff::not_dxf(
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
    let structure = sections(&records, findings);
    let entities = structure.entities.len()
        + structure
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
    Ok(structure)
}

fn too_many(what: &str, count: usize, limit: usize) -> Fault {
    Fault::new(
        "pattern/too_large",
        "line 1",
        format!("the file has {count} {what}; at most {limit} are read"),
    )
    .fix("export fewer pieces or sizes, or fewer points to a curve")
}

/// A file that ends inside a section was cut off; one that only lacks its EOF is whole.
fn check_end(file: &Tags<'_>, findings: &mut Findings) -> Result<(), Fault> {
    let last_line = file.tags.last().map_or(1, |tag| tag.line);
    if file.tags.iter().any(|tag| tag.opens("EOF")) {
        if let Some(line) = file.dangling {
            findings.warn(
                "pattern/dangling_line",
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
            "pattern/truncated",
            format!("line {last_line}"),
            "the file ends inside a section: it was cut off",
        )
        .fix("export or upload it again"));
    }
    findings.warn("pattern/no_eof", last_line, "the file ends without EOF");
    Ok(())
}

fn records<'a, 't>(tags: &'t [Tag<'a>]) -> Vec<Record<'a, 't>> {
    let mut starts: Vec<usize> = (0..tags.len()).filter(|i| tags[*i].code == 0).collect();
    starts.push(tags.len());
    starts
        .windows(2)
        .map(|pair| Record {
            kind: tags[pair[0]].value,
            line: tags[pair[0]].line,
            tags: &tags[pair[0] + 1..pair[1]],
        })
        .collect()
}

fn sections<'a, 't>(records: &[Record<'a, 't>], findings: &mut Findings) -> Structure<'a, 't> {
    let mut found = Structure::default();
    let mut section = String::new();
    let mut block: Option<BlockRecord<'a, 't>> = None;
    for record in records {
        match record.kind.to_ascii_uppercase().as_str() {
            "SECTION" => {
                if !section.is_empty() {
                    findings.warn(
                        "pattern/no_endsec",
                        record.line,
                        format!("section {section} has no ENDSEC"),
                    );
                }
                section = record.value(2).unwrap_or_default().to_ascii_uppercase();
                let known = NO_ENTITIES.contains(&section.as_str());
                if !known && !matches!(section.as_str(), "BLOCKS" | "ENTITIES") {
                    findings.warn(
                        "pattern/unknown_section",
                        record.line,
                        format!("what section {:?} holds is not read", shown(&section)),
                    );
                }
                if section == "HEADER" {
                    found.insunits = header_number(record.tags, "$INSUNITS");
                }
            }
            "ENDSEC" => section.clear(),
            "EOF" => {
                if !section.is_empty() {
                    findings.warn(
                        "pattern/no_endsec",
                        record.line,
                        format!("section {section} has no ENDSEC"),
                    );
                }
                break;
            }
            "BLOCK" if section == "BLOCKS" => {
                found.blocks.extend(block.take());
                block = Some(BlockRecord {
                    head: *record,
                    entities: Vec::new(),
                });
            }
            "ENDBLK" => found.blocks.extend(block.take()),
            _ => match &mut block {
                Some(open) if section == "BLOCKS" => open.entities.push(*record),
                _ if section == "ENTITIES" => found.entities.push(*record),
                _ if NO_ENTITIES.contains(&section.as_str()) => {}
                _ => {
                    let place = if section.is_empty() {
                        "section"
                    } else {
                        "block"
                    };
                    let what = format!("{} outside any {place}", record.kind);
                    findings.left_out(&what, record.line);
                }
            },
        }
    }
    found.blocks.extend(block);
    found
}

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

fn header_number(tags: &[Tag<'_>], name: &str) -> Option<i32> {
    let at = tags
        .iter()
        .position(|tag| tag.code == 9 && tag.value.eq_ignore_ascii_case(name))?;
    tags.get(at + 1)?.value.parse().ok()
}
