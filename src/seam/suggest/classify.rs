//! From panels to pieces: what each panel is, by its name and by its look.

use super::doubts::{unlikely, unusual, upright};
use super::piece::{Kind, Lateral, Piece};
use super::shape::Shape;
use super::{choose, looks, sides, template, words};
use crate::pattern::Pattern;
use std::rc::Rc;

/// Kinds that a panel may be whose name says only front or back, or nothing.
pub(super) const BODY: [Kind; 3] = [Kind::Bodice, Kind::Skirt, Kind::Trouser];
const ANY: [Kind; 5] = [
    Kind::Bodice,
    Kind::Skirt,
    Kind::Trouser,
    Kind::Sleeve,
    Kind::NeckBand,
];
/// What a panel without a telling name may be where other panels of the pattern have one.
const EXTRA: [Kind; 2] = [Kind::Sleeve, Kind::NeckBand];
/// What a panel without a telling name must look like at least: mean misfit of a role.
const RECOGNISED: f64 = 2.5;
/// The same for its size: side of the square of its area \[m\].
const SMALLEST: f64 = 0.08;
/// How many readings of a panel are weighed.
const KEPT: usize = 16;

/// The pieces of a pattern.
pub(super) fn pieces(pattern: &Pattern) -> Vec<Piece> {
    let names: Vec<&str> = pattern.panels.iter().map(|p| p.name.as_str()).collect();
    let common = words::common_start(&names);
    let shared = words::shared(&names);
    let said: Vec<words::Said> = pattern
        .panels
        .iter()
        .map(|panel| {
            let name = if panel.name.is_empty() {
                &panel.id
            } else {
                &panel.name
            };
            let code = panel.name.get(common..).unwrap_or_default();
            let mut said = words::said(name, code, &shared);
            if panel.copy_of.is_some() {
                said.lateral = said.lateral.map(Lateral::other);
            }
            said
        })
        .collect();
    let slits = said.iter().any(|s| s.kind == Some(Kind::Godet));
    let telling = said
        .iter()
        .any(|s| s.which.is_some() || s.kind.is_some_and(|kind| BODY.contains(&kind)));
    let candidates: Vec<Vec<Piece>> = (0..names.len())
        .map(|index| {
            let panel = &pattern.panels[index];
            let said = &said[index];
            candidates(
                index,
                Rc::new(Shape::of(panel, slits)),
                said,
                (upright(panel), telling),
            )
        })
        .collect();
    let mut pieces = choose::together(candidates);
    sides::tell_front_from_back(pattern, &mut pieces);
    let turned: Vec<bool> = pieces
        .iter()
        .map(|p| sides::is_turned(pattern, &pieces, p))
        .collect();
    for (piece, turned) in pieces.iter_mut().zip(turned) {
        piece.turned = turned;
    }
    sides::tell_left_from_right(pattern, &mut pieces);
    pieces
}

/// What a panel may be, the likeliest first.
fn candidates(
    panel: usize,
    shape: Rc<Shape>,
    said: &words::Said,
    (upright, telling): (Option<bool>, bool),
) -> Vec<Piece> {
    let kinds: Vec<Kind> = match (said.kind, said.which) {
        (Some(kind), _) => vec![kind],
        (None, Some(_)) => BODY.to_vec(),
        (None, None) if telling => EXTRA.to_vec(),
        (None, None) => ANY.to_vec(),
    };
    let named = said.kind.is_some() || said.which.is_some();
    let symmetric = shape.is_symmetric();
    let mut found: Vec<Piece> = vec![];
    for kind in kinds {
        for template in looks::of(kind) {
            let unlikely = template.rare + unlikely(kind, template.half, said, symmetric);
            for divided in template::divide(&shape, &template).into_iter().take(KEPT) {
                let mut piece = Piece {
                    panel,
                    kind,
                    of: said.of.clone(),
                    number: said.number,
                    which: said.which,
                    lateral: said.lateral,
                    lateral_said: said.lateral.is_some(),
                    half: template.half,
                    turned: false,
                    shape: Rc::clone(&shape),
                    segments: divided.segments,
                    cost: divided.cost + unlikely,
                    named,
                    kind_said: said.kind.is_some(),
                };
                piece.cost += unusual(&piece, upright);
                found.push(piece);
            }
        }
    }
    let large = shape.size >= SMALLEST;
    found.retain(|piece| named || large && piece.cost < RECOGNISED);
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found.truncate(KEPT);
    found
}
