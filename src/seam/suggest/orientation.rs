//! Front from back and left from right, and the mirrored copies of panels that are drawn once.

use super::labeled_panel::LabeledPanel;
use super::labels::{DrawnSide, EdgeRole, FrontBack, Laterality, PanelKind};
use crate::pattern::{Face, Pattern};
use std::rc::Rc;

/// Sewn edges of panels that are forms of each other, or front and back, agree to this share.
const FORM_LENGTH_SHARE: f64 = 0.06;

/// Edges of a side panel or a leg that differ by less do not tell which lies at the side, or in
/// front.
const MIN_SHOWN_SHARE: f64 = 0.02;

/// A panel that is another form of one that is taken, both by their indices in the pattern.
#[derive(Clone, Copy, Debug)]
pub(super) struct OtherForm {
    pub(super) panel: usize,
    pub(super) of: usize,
}

/// Returns true if a panel is drawn as seen through the body: as the names of halves like it say,
/// or its file. Else backs that are drawn whole are taken to be drawn in one view with their
/// fronts, as tools that know the body write them; halves and panels drawn on the fold are pieces
/// to cut, which lie right side up.
pub(super) fn is_drawn_from_inside(
    pattern: &Pattern,
    parts: &[LabeledPanel],
    part: &LabeledPanel,
) -> bool {
    let alike = |p: &&LabeledPanel| {
        p.half
            && p.front_back == part.front_back
            && p.kind == part.kind
            && p.kind != PanelKind::Sleeve
    };
    let says = |p: &LabeledPanel| Some(p.laterality_of(outer_drawn_side(p)?) == p.laterality?);
    let (straight, turned): (Vec<bool>, Vec<bool>) = parts
        .iter()
        .filter(alike)
        .filter_map(says)
        .partition(|straight| *straight);
    if straight.len() != turned.len() {
        return turned.len() > straight.len();
    }
    let panel = &pattern.panels[part.panel];
    match panel.face {
        Some(face) => face == Face::Down,
        None => {
            let drawn_whole = !part.half || part.kind == PanelKind::Sleeve;
            part.front_back == Some(FrontBack::Back) && drawn_whole && !panel.unfolded
        }
    }
}

/// Returns the side of the drawing on which half a panel has its side edge.
pub(super) fn outer_drawn_side(part: &LabeledPanel) -> Option<DrawnSide> {
    part.segments.first().map(|s| s.drawn_side)
}

/// Gives fronts and backs to body panels whose names do not say: the deeper neck, the shorter
/// crotch is the front.
pub(super) fn assign_front_back(pattern: &Pattern, parts: &mut [LabeledPanel]) {
    back_under_yoke(parts);
    halves_and_whole(parts);
    for (kind, role, front_is_longer) in [
        (PanelKind::Bodice, EdgeRole::Neck, true),
        (PanelKind::Trouser, EdgeRole::Crotch, false),
        (PanelKind::Skirt, EdgeRole::Waist, true),
    ] {
        let unsaid: Vec<usize> = (0..parts.len())
            .filter(|i| {
                let p: &LabeledPanel = &parts[*i];
                p.kind == kind && p.front_back.is_none() && !p.features.mirrored
            })
            .collect();
        let length = |i: usize| parts[i].one_side_length(role);
        let forms = unsaid.clone();
        let unsaid = if unsaid.len() > 2 && kind != PanelKind::Skirt {
            pair_of_forms(parts, &unsaid, role)
        } else {
            unsaid
        };
        if unsaid.len() != 2 {
            continue;
        }
        let mean = unsaid.iter().map(|i| length(*i)).sum::<f64>() / unsaid.len() as f64;
        let sides: Vec<(usize, FrontBack)> = unsaid
            .iter()
            .enumerate()
            .map(|(k, i)| {
                let front = if (length(*i) - mean).abs() < 1e-6 {
                    k == 0
                } else {
                    (length(*i) > mean) == front_is_longer
                };
                (
                    *i,
                    if front {
                        FrontBack::Front
                    } else {
                        FrontBack::Back
                    },
                )
            })
            .collect();
        for (i, front_back) in &sides {
            parts[*i].front_back = Some(*front_back);
        }
        for i in forms {
            if parts[i].front_back.is_some() {
                continue;
            }
            let own = parts[i].one_side_length(role);
            let off = |j: usize| (parts[j].one_side_length(role) - own).abs();
            let nearest = sides.iter().min_by(|a, b| off(a.0).total_cmp(&off(b.0)));
            parts[i].front_back = nearest.map(|(_, front_back)| *front_back);
        }
    }
    for part in parts.iter_mut().filter(|p| p.kind == PanelKind::Yoke) {
        part.front_back = part.front_back.or(Some(FrontBack::Back));
    }
    // A mirrored copy of the file's own is what its source is.
    for i in 0..parts.len() {
        let source = pattern.panels[parts[i].panel].copy_of.as_deref();
        let source = source.and_then(|id| pattern.panel_index(id));
        let front_back = source.and_then(|at| parts.iter().find(|p| p.panel == at)?.front_back);
        parts[i].front_back = parts[i].front_back.or(front_back);
    }
}

/// Gives front and back to the panels of a bodice that no name tells of, where some of them end at
/// a yoke: those are the back.
fn back_under_yoke(parts: &mut [LabeledPanel]) {
    let is_unsaid = |p: &LabeledPanel| p.kind == PanelKind::Bodice && p.front_back.is_none();
    let under = |p: &LabeledPanel| is_unsaid(p) && p.beside == Some(PanelKind::Yoke);
    if !parts.iter().any(under) {
        return;
    }
    for part in parts.iter_mut().filter(|p| is_unsaid(p)) {
        part.front_back = Some(if part.beside == Some(PanelKind::Yoke) {
            FrontBack::Back
        } else {
            FrontBack::Front
        });
    }
}

/// Gives front and back to a bodice of two halves and one whole panel, none of which a name tells
/// of: the back has the shallower neck.
fn halves_and_whole(parts: &mut [LabeledPanel]) {
    let is_unsaid = |p: &LabeledPanel| p.kind == PanelKind::Bodice && p.front_back.is_none();
    let unsaid = (0..parts.len()).filter(|i| is_unsaid(&parts[*i]));
    let (halves, wholes): (Vec<usize>, Vec<usize>) = unsaid.partition(|i| parts[*i].half);
    let ([a, b], [whole]) = (&halves[..], &wholes[..]) else {
        return;
    };
    let neck = |i: usize| parts[i].one_side_length(EdgeRole::Neck);
    let whole_is_back = neck(*whole) < 0.5 * (neck(*a) + neck(*b));
    let (of_whole, of_halves) = if whole_is_back {
        (FrontBack::Back, FrontBack::Front)
    } else {
        (FrontBack::Front, FrontBack::Back)
    };
    parts[*whole].front_back = Some(of_whole);
    for i in [*a, *b] {
        parts[i].front_back = Some(of_halves);
    }
}

/// Returns, of several panels of one kind that could all be front or back of each other, the two
/// that differ most in `role`: the rest are other forms of these. Nothing where their sides are not
/// as long as each other.
fn pair_of_forms(parts: &[LabeledPanel], unsaid: &[usize], role: EdgeRole) -> Vec<usize> {
    let sewn = [EdgeRole::Side, EdgeRole::Shoulder, EdgeRole::Inseam];
    let is_like = |i: usize, j: usize| {
        let (a, b) = (&parts[i], &parts[j]);
        let share = |p: &LabeledPanel, role| p.mean_length(role);
        sewn.iter().all(|role| {
            let (x, y) = (share(a, *role), share(b, *role));
            (x - y).abs() <= FORM_LENGTH_SHARE * x.max(y)
        })
    };
    let first = unsaid[0];
    if !unsaid.iter().all(|i| is_like(first, *i)) {
        return vec![];
    }
    let own = |i: &usize| parts[*i].one_side_length(role);
    let by_length = |a: &&usize, b: &&usize| own(a).total_cmp(&own(b));
    let least = unsaid.iter().min_by(by_length).copied();
    let most = unsaid.iter().max_by(by_length).copied();
    let mut pair: Vec<usize> = least.into_iter().chain(most).collect();
    pair.sort_unstable();
    pair
}

/// Gives every half a side of the wearer, adding the mirrored copy of those that are drawn once. Of
/// panels that are neither drawn as a pair nor called left or right the first is taken: others are
/// other styles of the same part, which are returned with the panel that is taken in their place.
pub(super) fn assign_left_right(
    pattern: &Pattern,
    parts: &mut Vec<LabeledPanel>,
) -> Vec<OtherForm> {
    let mut forms: Vec<OtherForm> = vec![];
    let mut taken: Vec<usize> = vec![];
    let mut spare: Vec<usize> = vec![];
    for i in 0..parts.len() {
        let part = &parts[i];
        if part.laterality_named {
            continue;
        }
        let laterality = if is_drawn_once(part) {
            let first = taken
                .iter()
                .copied()
                .find(|j| is_same_part(&parts[*j], part));
            match first {
                None => Some(
                    shown_side(part)
                        .or_else(|| drawn_side_of_body(parts, part))
                        .unwrap_or_else(|| usual_side(part)),
                ),
                Some(j) if parts[j].features.is_twin(&part.features) => {
                    parts[j].laterality.map(Laterality::other)
                }
                Some(j) => {
                    spare.push(i);
                    forms.extend(is_form(&parts[j], part).then_some(OtherForm {
                        panel: part.panel,
                        of: parts[j].panel,
                    }));
                    None
                }
            }
        } else if part.half {
            outer_drawn_side(part).map(|drawn_side| part.laterality_of(drawn_side))
        } else {
            None
        };
        if laterality.is_some() {
            taken.push(i);
        }
        parts[i].laterality = laterality;
    }
    let mut at = 0;
    parts.retain(|_| {
        at += 1;
        !spare.contains(&(at - 1))
    });
    let mut copies = vec![];
    for part in parts.iter() {
        let other = part.laterality.map(Laterality::other);
        let lone =
            other.is_some() && !part.laterality_named && !parts.iter().any(|p| is_partner(p, part));
        let id = &pattern.panels[part.panel].id;
        let there = pattern
            .panels
            .iter()
            .any(|p| p.copy_of.as_ref() == Some(id));
        if lone && !there && !part.features.mirrored {
            copies.push(LabeledPanel {
                panel: part.panel + pattern.panels.len(),
                ..mirrored(part)
            });
        }
    }
    parts.extend(copies);
    forms
}

/// Returns true if a spare part could be set in where another is: as a short and a long sleeve or
/// leg.
fn is_form(taken: &LabeledPanel, spare: &LabeledPanel) -> bool {
    let joined = |p: &LabeledPanel| match p.kind {
        PanelKind::Leg => p.role_length(EdgeRole::Waist),
        _ => p.role_length(EdgeRole::Cap),
    };
    let [a, b] = [taken, spare].map(joined);
    a > 0.0 && (a - b).abs() <= FORM_LENGTH_SHARE * a.max(b)
}

/// Returns true for a part that is worn on both sides but usually drawn for one.
fn is_drawn_once(part: &LabeledPanel) -> bool {
    matches!(
        part.kind,
        PanelKind::Sleeve
            | PanelKind::UnderSleeve
            | PanelKind::Side
            | PanelKind::Leg
            | PanelKind::Cuff
            | PanelKind::ArmBand
    )
}

/// Returns the side of the wearer for which such a part is usually drawn.
fn usual_side(part: &LabeledPanel) -> Laterality {
    if part.kind == PanelKind::ArmBand {
        Laterality::Right
    } else {
        Laterality::Left
    }
}

/// Returns the side of the wearer for which a side panel is drawn between front and back: that of
/// their halves.
fn drawn_side_of_body(parts: &[LabeledPanel], part: &LabeledPanel) -> Option<Laterality> {
    if part.kind != PanelKind::Side {
        return None;
    }
    let is_half = |front_back: FrontBack, p: &LabeledPanel| {
        p.kind == PanelKind::Bodice && p.half && p.front_back == Some(front_back)
    };
    let half = |front_back: FrontBack| {
        let mut drawn = parts.iter().filter(|p| !p.features.mirrored);
        let half = drawn.find(|p| is_half(front_back, p))?;
        let shown = outer_drawn_side(half).map(|side| half.laterality_of(side));
        half.laterality.filter(|_| half.laterality_named).or(shown)
    };
    half(FrontBack::Front).or_else(|| half(FrontBack::Back))
}

/// Returns the side of the wearer that the outline of a part shows that is usually drawn for one.
fn shown_side(part: &LabeledPanel) -> Option<Laterality> {
    match part.kind {
        PanelKind::Side => shown_by_underarm(part),
        PanelKind::Leg => shorter_crotch(part).map(|front| match front {
            DrawnSide::Left => Laterality::Left,
            DrawnSide::Right => Laterality::Right,
        }),
        _ => None,
    }
}

/// Returns the side of the drawing on which the crotch of a leg in one piece is shorter, as it is
/// in front: a leg drawn hem down and face up is a left one if that is the left. Nothing for one
/// that is its own mirror image.
pub(super) fn shorter_crotch(leg: &LabeledPanel) -> Option<DrawnSide> {
    let crotch = |side| {
        let segment = leg.segment(EdgeRole::Crotch, Some(side))?;
        Some(leg.features.length(&segment.edges))
    };
    let [left, right] = [crotch(DrawnSide::Left)?, crotch(DrawnSide::Right)?];
    let is_shown = (left - right).abs() >= MIN_SHOWN_SHARE * left.max(right);
    is_shown.then_some(if left < right {
        DrawnSide::Left
    } else {
        DrawnSide::Right
    })
}

/// Returns the side of the wearer that the outline of a side panel beside the front or the back
/// shows: its edge at the side ends at the underarm, the other one above.
fn shown_by_underarm(part: &LabeledPanel) -> Option<Laterality> {
    part.front_back?;
    let [before, after] = part.beside(part.segment(EdgeRole::Hem, None)?)?;
    let [before, after] = [before, after].map(|s| part.features.length(&s.edges));
    if (before - after).abs() < MIN_SHOWN_SHARE * before.max(after) {
        return None;
    }
    // In clockwise order the edge after the hem goes up the left of the drawing.
    let first = part.first_drawn_side();
    let outer = if after < before { first } else { first.other() };
    Some(part.laterality_of(outer))
}

fn is_same_part(a: &LabeledPanel, b: &LabeledPanel) -> bool {
    a.kind == b.kind && a.of == b.of && a.front_back == b.front_back && a.half == b.half
}

fn is_partner(a: &LabeledPanel, b: &LabeledPanel) -> bool {
    is_same_part(a, b) && a.laterality == b.laterality.map(Laterality::other)
}

/// Returns the mirrored copy of a panel: the same numbers, the other side of the drawing.
pub(super) fn mirrored(part: &LabeledPanel) -> LabeledPanel {
    let mut copy = part.clone();
    copy.features = Rc::new(copy.features.reflected());
    copy.laterality = copy.laterality.map(Laterality::other);
    for segment in &mut copy.segments {
        segment.drawn_side = segment.drawn_side.other();
    }
    copy
}
