//! Panels whose stated faces contradict seams that agree among themselves.

use super::Face;
use super::correct::Request;
use super::cycle::Tied;
use super::faces;
use super::parity::Parity;
use super::twist::{Twist, listed, without};
use crate::fault::Fault;
use std::collections::{BTreeMap, BTreeSet};

/// Panels of one part of a garment whose faces were stated, in two camps: within a camp the seams agree with what was stated.
#[derive(Default)]
struct Part {
    camps: [Vec<usize>; 2],
    contradictory: bool,
}

/// One fault for each part of the garment in which turning the faces of the fewest panels makes all seams right.
///
/// A part is left to the search for cycles where its seams contradict one another without any face stated, and where a
/// single seam is enough to blame. What was stated of the panels to be turned is taken out of `ties`.
pub(super) fn find(
    request: &Request<'_>,
    stated: &[Option<Face>],
    ties: &mut Vec<Tied>,
) -> Vec<Twist> {
    let mut found = vec![];
    for part in parts(stated, ties).into_values() {
        let turned = turned(request, &part.camps);
        if part.contradictory || turned.is_empty() {
            continue;
        }
        let of_part: BTreeSet<usize> = part.camps.concat().into_iter().collect();
        if one_seam_is_to_blame(stated.len(), ties, &of_part) {
            continue;
        }
        let Some(seam) = first_seam_at(turned, ties) else {
            continue;
        };
        found.push(Twist {
            seam,
            fault: fault(request, stated, turned),
            corrected: None,
        });
        ties.retain(|tie| tie.seam.is_some() || !turned.contains(&tie.link.ends[0]));
    }
    found
}

fn parts(stated: &[Option<Face>], ties: &[Tied]) -> BTreeMap<usize, Part> {
    let mut parity = Parity::new(stated.len() + 1);
    let seams = || ties.iter().filter(|tie| tie.seam.is_some());
    let wrong: Vec<usize> = seams()
        .filter(|tie| !parity.join(tie.link))
        .map(|tie| tie.link.ends[0])
        .collect();
    let mut parts: BTreeMap<usize, Part> = BTreeMap::new();
    for (panel, face) in stated.iter().enumerate() {
        let Some(face) = face else { continue };
        let (head, same) = parity.find(panel);
        let camp = usize::from(same == (*face == Face::Up));
        parts.entry(head).or_default().camps[camp].push(panel);
    }
    for panel in wrong {
        if let Some(part) = parts.get_mut(&parity.find(panel).0) {
            part.contradictory = true;
        }
    }
    parts
}

/// The smaller camp; of two alike the one with fewer fronts, then the one whose first panel comes later.
fn turned<'a>(request: &Request<'_>, camps: &'a [Vec<usize>; 2]) -> &'a [usize] {
    let rank = |camp: &Vec<usize>| {
        let is_front = |panel: &&usize| faces::is_front(request.pattern, **panel);
        let fronts = camp.iter().filter(is_front).count();
        (camp.len(), fronts, usize::MAX - camp.first().unwrap_or(&0))
    };
    let smaller = camps.iter().min_by_key(|camp| rank(camp));
    smaller.map_or(&[], Vec::as_slice)
}

/// Whether without one of the seams what was stated of these panels contradicts nothing.
fn one_seam_is_to_blame(panels: usize, ties: &[Tied], of_part: &BTreeSet<usize>) -> bool {
    let mine = |tie: &Tied| tie.seam.is_some() || of_part.contains(&tie.link.ends[0]);
    let ties: Vec<Tied> = ties.iter().copied().filter(mine).collect();
    let (now, _) = without(&ties, panels + 1, |_| false);
    let seams: BTreeSet<usize> = ties.iter().filter_map(|tie| tie.seam).collect();
    let (others, _) = without(&ties, panels + 1, |tie| tie.seam.is_none());
    seams.into_iter().any(|seam| {
        let (left, _) = without(&ties, panels + 1, |tie| tie.seam == Some(seam));
        left <= others && left < now
    })
}

fn first_seam_at(panels: &[usize], ties: &[Tied]) -> Option<usize> {
    let touching = ties
        .iter()
        .filter(|tie| tie.link.ends.iter().any(|end| panels.contains(end)));
    touching.filter_map(|tie| tie.seam).min()
}

fn fault(request: &Request<'_>, stated: &[Option<Face>], turned: &[usize]) -> Fault {
    let id = |panel: &usize| &request.pattern.panels[*panel].id;
    let names = listed(turned.iter().map(id));
    let [to_down, to_up] = [Face::Up, Face::Down].map(|face| {
        let panels = turned.iter().filter(|panel| stated[**panel] == Some(face));
        listed(panels.map(id))
    });
    let set = [(to_down, "down"), (to_up, "up")]
        .into_iter()
        .filter(|(names, _)| !names.is_empty())
        .map(|(names, face)| format!("set `face` of {names} to `{face}`"))
        .collect::<Vec<_>>()
        .join(", and ");
    let first = turned.first().map_or("", |panel| id(panel));
    let pointer = format!(
        "/panels/{}/face",
        first.replace('~', "~0").replace('/', "~1")
    );
    let detail = format!(
        "the faces stated for {names} contradict the seams, which would sew the outer side of the cloth to the inner one there; the seams agree with each other and with the other faces"
    );
    Fault::new("seam/twisted", pointer, detail).fix(format!("{set}, or to `auto`"))
}
