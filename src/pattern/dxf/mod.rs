//! DXF bytes to a pattern. The way through: bytes are told from other files ([`sniff`]), decoded ([`encoding`]), split
//! into tags ([`tags`]), sorted into blocks and entities ([`structure`]), cleaned ([`clean`]), read by the `dxf` crate
//! a thousand at a time ([`load`]), put in place ([`expand`]), joined to outlines ([`chain`]), told apart ([`sort`],
//! [`nest`]), chosen by size ([`size`]) and made into panels ([`panel`]).

mod binary;
mod chain;
mod clean;
mod encoding;
mod entity;
mod expand;
mod findings;
mod fold;
mod joint;
mod label;
mod layer;
mod load;
mod marks;
mod nest;
mod notch;
mod panel;
mod piece;
mod quantity;
mod ring;
mod size;
mod sniff;
mod sort;
mod spline;
mod structure;
mod tags;
mod units;

use self::entity::Entity;
use self::expand::Block;
use self::findings::{Findings, at_line};
use self::label::Labels;
use self::piece::Piece;
use super::polyline::bounds;
use super::{Allowance, ImportOptions, Panel, Pattern, PatternFormat, Source, copies, curve, ids};
use crate::config::Limits;
use crate::fault::{Fault, Faults};
use std::collections::BTreeMap;

/// Reads a pattern from the bytes of a DXF file.
pub(super) fn import(
    bytes: &[u8],
    options: &ImportOptions,
    limits: &Limits,
) -> Result<Pattern, Faults> {
    let mut findings = Findings::default();
    match read(bytes, options, limits, &mut findings) {
        Ok(pattern) => findings.or(pattern),
        Err(fault) => Err(findings.and(fault)),
    }
}

fn read(
    bytes: &[u8],
    options: &ImportOptions,
    limits: &Limits,
    findings: &mut Findings,
) -> Result<Pattern, Fault> {
    if bytes.len() > limits.dxf_bytes {
        return Err(Fault::new(
            "pattern/too_large",
            "line 1",
            format!(
                "the file has {} bytes; at most {} are read",
                bytes.len(),
                limits.dxf_bytes
            ),
        )
        .fix("export fewer pieces or sizes"));
    }
    sniff::refuse_other(bytes)?;
    let converted = bytes
        .strip_prefix(sniff::BINARY)
        .map(binary::to_text)
        .transpose()?;
    let text = encoding::decode(converted.as_deref().unwrap_or(bytes));
    let drawing = Drawing::read(&text, limits, findings)?;
    if let Some(last) = findings.faults.pop() {
        return Err(last);
    }
    let labels = Labels::of(drawing.model.iter());
    let units = units::of(options.units, &labels, drawing.insunits, findings);
    let sheets = expand::sheets(
        &drawing.blocks,
        &drawing.model,
        units.in_metres(),
        limits,
        findings,
    )?;
    let format = format(&drawing, &labels);
    drop(drawing);
    let pieces: Vec<Piece> = sheets
        .iter()
        .flat_map(|sheet| sort::pieces(sheet, limits.panels, findings))
        .collect();
    let chosen = size::choose(
        options.size.as_deref(),
        &labels,
        &pieces.iter().map(|p| &p.labels).collect::<Vec<_>>(),
        findings,
    )?;
    let keep = size::keep(
        &chosen,
        &pieces
            .iter()
            .map(|p| (p.name.as_str(), p.labels.get("size")))
            .collect::<Vec<_>>(),
    );
    let pieces: Vec<Piece> = pieces
        .into_iter()
        .zip(keep)
        .filter_map(|(piece, keep)| keep.then_some(piece))
        .collect();
    if pieces.is_empty() {
        return Err(findings.none_found());
    }
    if pieces.len() > limits.panels {
        return Err(nest::too_many(pieces.len(), limits.panels, pieces[0].line));
    }
    units::check(units, longest(&pieces), limits.panel_size_m, findings)?;
    let name = labels
        .get("style name")
        .map(str::to_owned)
        .or_else(|| options.name.clone())
        .unwrap_or_else(|| "pattern".to_owned());
    let mut panels = panels(&pieces, &name, limits, findings);
    let allowance = allowance(&pieces, &panels, findings);
    let mut warnings = findings.take_warnings();
    warnings.extend(copies::add_stated(&mut panels));
    Ok(Pattern {
        id: None,
        source: Source {
            format,
            units: units.name().to_owned(),
            scale_to_m: units.in_metres(),
            sample_size: chosen.chosen,
            sizes: chosen.all,
            allowance,
        },
        name: name.chars().take(limits.name_chars).collect(),
        panels,
        seams: Vec::new(),
        placements: BTreeMap::new(),
        warnings,
    })
}

/// A drawing read, in drawing units.
struct Drawing {
    insunits: Option<i32>,
    blocks: Vec<Block>,
    model: Vec<Entity>,
}

impl Drawing {
    fn read(text: &str, limits: &Limits, findings: &mut Findings) -> Result<Self, Fault> {
        let tags = tags::read(text, limits)?;
        let structure = structure::read(&tags, limits, findings)?;
        let mut points_left = limits.dxf_vertices;
        let mut entities = |records: &[structure::Record<'_, '_>]| {
            let mut found = Vec::new();
            for part in clean::parts(records) {
                let cleaned = clean::clean(part, findings);
                if !findings.refused() {
                    found.extend(load::load(&cleaned, &mut points_left, findings));
                }
            }
            found
        };
        let mut blocks = Vec::with_capacity(structure.blocks.len());
        for block in &structure.blocks {
            let name = block.head.value(2).unwrap_or_default();
            if is_space(name) {
                continue;
            }
            let coordinate = |code| {
                block
                    .head
                    .value(code)
                    .and_then(|v| v.parse().ok())
                    .filter(|v: &f64| v.is_finite())
                    .unwrap_or(0.0)
            };
            blocks.push(Block {
                name: name.to_owned(),
                base: [coordinate(10), coordinate(20)],
                line: block.head.line,
                entities: entities(&block.entities),
            });
        }
        let model = entities(&structure.entities);
        Ok(Self {
            insunits: structure.insunits,
            blocks,
            model,
        })
    }
}

/// Whether a block stands for the model or paper space, whose entities are in the ENTITIES section.
fn is_space(name: &str) -> bool {
    let name = name.to_lowercase();
    name.strip_prefix(['*', '$'])
        .is_some_and(|rest| rest.starts_with("model_space") || rest.starts_with("paper_space"))
}

/// The dialect: ASTM where it says so or uses its layers, AAMA where pieces are blocks on layer 1, else general.
fn format(drawing: &Drawing, labels: &Labels) -> PatternFormat {
    let layers = || {
        drawing
            .blocks
            .iter()
            .flat_map(|b| &b.entities)
            .map(|e| e.layer.trim().parse::<u32>().ok())
    };
    if labels.any_key("astm") || layers().any(|n| n.is_some_and(|n| n >= 80)) {
        PatternFormat::DxfAstm
    } else if layers().any(|n| n == Some(1)) {
        PatternFormat::DxfAama
    } else {
        PatternFormat::Dxf
    }
}

fn longest(pieces: &[Piece]) -> f64 {
    pieces
        .iter()
        .filter(|piece| piece.outline.chain.points.len() > 2)
        .map(|piece| {
            let [low, high] = bounds(&piece.outline.chain.points);
            (high[0] - low[0]).max(high[1] - low[1])
        })
        .fold(0.0, f64::max)
}

fn panels(pieces: &[Piece], style: &str, limits: &Limits, findings: &mut Findings) -> Vec<Panel> {
    let mut panels: Vec<Panel> = pieces
        .iter()
        .filter_map(|piece| panel::panel(piece, limits, findings))
        .collect();
    let names: Vec<String> = panels.iter().map(|panel| panel.name.clone()).collect();
    for (panel, id) in panels.iter_mut().zip(ids::from_names(&names, style)) {
        panel.id = id;
    }
    panels
}

/// Sew lines became outlines on every panel, or the file does not say. Where only some panels have one, the user is told.
fn allowance(pieces: &[Piece], panels: &[Panel], findings: &mut Findings) -> Allowance {
    let sewn = pieces
        .iter()
        .zip(panels)
        .filter(|(piece, panel)| piece.sewn || piece.sew.is_some() && !panel.cut_line.is_empty());
    match sewn.count() {
        0 => Allowance::Unknown,
        count if count == panels.len() => Allowance::SewLine,
        count => {
            let detail = format!(
                "{count} of {} panels have a sew line; the outlines of the others may include seam allowance",
                panels.len()
            );
            findings.warn("pattern/allowance_mixed", pieces[0].line, detail);
            Allowance::Unknown
        }
    }
}
