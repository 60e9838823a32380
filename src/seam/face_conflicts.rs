//! Panels whose stated faces contradict seams that agree among themselves.

use super::Face;
use super::context::SeamCheckContext;
use super::cycle::{FaceConstraint, contradictions_without};
use super::faces;
use super::parity::ParityUnionFind;
use super::twist_fault::TwistFault;
use crate::fault::{Fault, SeamCode, pointer_token, quoted_list};
use std::collections::{BTreeMap, BTreeSet};

/// Panels with stated faces in one connected part of a garment, in two groups: within each the
/// seams agree with what was stated.
#[derive(Default)]
struct PanelComponent {
    groups: [Vec<usize>; 2],
    contradictory: bool,
}

/// Returns one fault for each part of the garment in which turning the faces of the fewest panels
/// makes all seams right.
///
/// A part is left to the search for cycles where its seams contradict one another without any face
/// stated, and where a single seam is enough to blame. Stated faces of the panels to be turned are
/// removed from `constraints`.
pub(super) fn find(
    context: &SeamCheckContext<'_>,
    stated: &[Option<Face>],
    constraints: &mut Vec<FaceConstraint>,
) -> Vec<TwistFault> {
    let mut found = vec![];
    for component in components(stated, constraints).into_values() {
        let turned = panels_to_turn(context, &component.groups);
        if component.contradictory || turned.is_empty() {
            continue;
        }
        let of_component: BTreeSet<usize> = component.groups.concat().into_iter().collect();
        if one_seam_is_to_blame(stated.len(), constraints, &of_component) {
            continue;
        }
        let Some(seam) = first_seam_at(turned, constraints) else {
            continue;
        };
        found.push(TwistFault {
            seam,
            fault: fault(context, stated, turned),
            corrected: None,
        });
        constraints.retain(|constraint| {
            constraint.seam.is_some() || !turned.contains(&constraint.relation.ends[0])
        });
    }
    found
}

fn components(
    stated: &[Option<Face>],
    constraints: &[FaceConstraint],
) -> BTreeMap<usize, PanelComponent> {
    let mut parity = ParityUnionFind::new(stated.len() + 1);
    let seams = || {
        constraints
            .iter()
            .filter(|constraint| constraint.seam.is_some())
    };
    let wrong: Vec<usize> = seams()
        .filter(|constraint| !parity.join(constraint.relation))
        .map(|constraint| constraint.relation.ends[0])
        .collect();
    let mut components: BTreeMap<usize, PanelComponent> = BTreeMap::new();
    for (panel, face) in stated.iter().enumerate() {
        let Some(face) = face else { continue };
        let (head, same) = parity.find(panel);
        let group = usize::from(same == (*face == Face::Up));
        components.entry(head).or_default().groups[group].push(panel);
    }
    for panel in wrong {
        if let Some(component) = components.get_mut(&parity.find(panel).0) {
            component.contradictory = true;
        }
    }
    components
}

/// Returns the smaller group; of two alike the one with fewer fronts, then the one whose first
/// panel comes later.
fn panels_to_turn<'a>(context: &SeamCheckContext<'_>, groups: &'a [Vec<usize>; 2]) -> &'a [usize] {
    let rank = |group: &Vec<usize>| {
        let is_front = |panel: &&usize| faces::is_front(context.pattern, **panel);
        let fronts = group.iter().filter(is_front).count();
        (
            group.len(),
            fronts,
            usize::MAX - group.first().unwrap_or(&0),
        )
    };
    let smaller = groups.iter().min_by_key(|group| rank(group));
    smaller.map_or(&[], Vec::as_slice)
}

/// Returns true if without one of the seams the faces stated for these panels contradict nothing.
fn one_seam_is_to_blame(
    panels: usize,
    constraints: &[FaceConstraint],
    of_component: &BTreeSet<usize>,
) -> bool {
    let is_relevant = |constraint: &FaceConstraint| {
        constraint.seam.is_some() || of_component.contains(&constraint.relation.ends[0])
    };
    let constraints: Vec<FaceConstraint> =
        constraints.iter().copied().filter(is_relevant).collect();
    let (now, _) = contradictions_without(&constraints, panels + 1, |_| false);
    let seams: BTreeSet<usize> = constraints
        .iter()
        .filter_map(|constraint| constraint.seam)
        .collect();
    let (others, _) = contradictions_without(&constraints, panels + 1, |constraint| {
        constraint.seam.is_none()
    });
    seams.into_iter().any(|seam| {
        let (left, _) = contradictions_without(&constraints, panels + 1, |constraint| {
            constraint.seam == Some(seam)
        });
        left <= others && left < now
    })
}

fn first_seam_at(panels: &[usize], constraints: &[FaceConstraint]) -> Option<usize> {
    let touching = constraints.iter().filter(|constraint| {
        constraint
            .relation
            .ends
            .iter()
            .any(|end| panels.contains(end))
    });
    touching.filter_map(|constraint| constraint.seam).min()
}

fn fault(context: &SeamCheckContext<'_>, stated: &[Option<Face>], turned: &[usize]) -> Fault {
    let id = |panel: &usize| &context.pattern.panels[*panel].id;
    let names = quoted_list(turned.iter().map(id));
    let [to_down, to_up] = [Face::Up, Face::Down].map(|face| {
        let panels = turned.iter().filter(|panel| stated[**panel] == Some(face));
        quoted_list(panels.map(id))
    });
    let set = [(to_down, "down"), (to_up, "up")]
        .into_iter()
        .filter(|(names, _)| !names.is_empty())
        .map(|(names, face)| format!("set `face` of {names} to `{face}`"))
        .collect::<Vec<_>>()
        .join(", and ");
    let first = turned.first().map_or("", |panel| id(panel));
    let pointer = format!("/panels/{}/face", pointer_token(first));
    let detail = format!(
        "the faces stated for {names} contradict the seams, which would sew the outer side of the cloth to the inner one there; the seams agree with each other and with the other faces"
    );
    Fault::new(SeamCode::Twisted, pointer, detail).fix(format!("{set}, or to `auto`"))
}
