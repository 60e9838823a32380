//! Bands that no name tells of: what each goes round is the opening that it fits in length.

use super::labeled_panel::{LabeledPanel, RoleSegment};
use super::labels::{DrawnSide, EdgeRole, FrontBack, Laterality, PanelKind};

/// Bands may be shorter than the opening, to be stretched on or gathered to, and longer, to lie
/// over each other, as shares of its length.
const NECK: [f64; 2] = [0.70, 1.08];
/// Where the front opens nothing is stretched on.
const OPEN_NECK: [f64; 2] = [0.92, 1.08];
const WAIST: [f64; 2] = [0.78, 1.12];
const HEM: [f64; 2] = [0.70, 1.05];
const CUFF: [f64; 2] = [0.55, 1.05];
/// A strip over the head is as long as the edges beside it.
const STRIP: [f64; 2] = [0.985, 1.015];

/// Opposite edges of a rectangle agree to this share, and turn less than this \[rad\].
const RECTANGLE_SHARE: f64 = 0.02;
const MAX_CURL_RAD: f64 = 0.1;

/// Tells waistbands and cuffs from neck bands among the bands that no name tells of, and takes
/// those away that fit nowhere.
pub(super) fn assign_openings(parts: &mut Vec<LabeledPanel>) {
    let openings = openings(parts);
    let has_bodice = parts.iter().any(|p| p.kind == PanelKind::Bodice);
    for part in parts.iter_mut().filter(|p| is_rectangle(p)) {
        let unnamed_skirt = part.kind == PanelKind::Skirt && !part.kind_named && has_bodice;
        if part.kind == PanelKind::Cuff || unnamed_skirt && is_band(part, &openings) {
            label_long_edges(part, &openings);
        }
        if unnamed_skirt && is_band(part, &openings) {
            part.kind = PanelKind::NeckBand;
            part.front_back = None;
        }
    }
    let bands: Vec<usize> = (0..parts.len())
        .filter(|i| parts[*i].kind == PanelKind::NeckBand && !parts[*i].kind_named)
        .collect();
    let mut lost = vec![];
    for (i, kind) in shared_out(parts, &openings, &bands) {
        match kind {
            Some(kind) => parts[i].kind = kind,
            None => lost.push(i),
        }
    }
    if assign_halves(parts, &openings, &lost) || openings.is_empty() {
        return;
    }
    let mut at = 0..;
    parts.retain(|_| at.next().is_none_or(|i| !lost.contains(&i)));
}

/// An opening by the kind of the band that goes round it, with its length \[m\] and the shares of
/// that which a band may have.
type BandOpening = (PanelKind, f64, [f64; 2]);

fn openings(parts: &[LabeledPanel]) -> Vec<BandOpening> {
    let is_open = |p: &LabeledPanel| {
        p.kind == PanelKind::Bodice && p.front_back == Some(FrontBack::Front) && p.half
    };
    let neck = if parts.iter().any(is_open) {
        OPEN_NECK
    } else {
        NECK
    };
    let sleeved = parts.iter().any(|p| p.kind == PanelKind::Sleeve);
    let all = [
        (PanelKind::NeckBand, PanelKind::Bodice, EdgeRole::Neck, neck),
        (
            PanelKind::ArmBand,
            PanelKind::Bodice,
            EdgeRole::Armhole,
            NECK,
        ),
        (PanelKind::Waistband, PanelKind::Bodice, EdgeRole::Hem, HEM),
        (
            PanelKind::Waistband,
            PanelKind::Skirt,
            EdgeRole::Waist,
            WAIST,
        ),
        (
            PanelKind::Waistband,
            PanelKind::Trouser,
            EdgeRole::Waist,
            WAIST,
        ),
        (PanelKind::Waistband, PanelKind::Leg, EdgeRole::Waist, WAIST),
        (PanelKind::Cuff, PanelKind::Sleeve, EdgeRole::Hem, CUFF),
        (PanelKind::Hood, PanelKind::Hood, EdgeRole::Center, STRIP),
    ];
    let found = all.iter().filter_map(|(band, host, role, shares)| {
        let around = if *host == PanelKind::Hood {
            let half = parts.iter().find(|p| p.kind == *host && p.half)?;
            half.role_length(*role)
        } else if *host == PanelKind::Leg {
            let leg = parts.iter().find(|p| p.kind == *host)?;
            2.0 * leg.role_length(*role)
        } else if *host == PanelKind::Sleeve {
            let sleeve = parts.iter().find(|p| p.kind == *host && !p.half)?;
            sleeve.role_length(*role)
        } else if *role == EdgeRole::Armhole {
            let free = if sleeved { 0.0 } else { 0.5 };
            free * around(parts, *host, *role)
        } else if *role == EdgeRole::Neck {
            around(parts, *host, *role) + sleeve_necks(parts)
        } else {
            around(parts, *host, *role)
        };
        (around > 0.0).then_some((*band, around, *shares))
    });
    found.collect()
}

/// Returns the part that raglan sleeves have of the neck \[m\], a sleeve that is drawn once counted
/// twice.
fn sleeve_necks(parts: &[LabeledPanel]) -> f64 {
    let sleeves = || parts.iter().filter(|p| p.kind == PanelKind::Sleeve);
    let first = sleeves()
        .next()
        .map_or(0.0, |p| p.role_length(EdgeRole::Neck));
    2.0 * first
}

/// Returns the length of a role all round the body, halves that are drawn once counted twice.
fn around(parts: &[LabeledPanel], kind: PanelKind, role: EdgeRole) -> f64 {
    let of = |part: &&LabeledPanel| part.kind == kind;
    let length = |part: &LabeledPanel| {
        let twin = |other: &&LabeledPanel| {
            other.panel != part.panel && other.half && other.front_back == part.front_back
        };
        let drawn_once = part.half && !parts.iter().filter(of).any(|p| twin(&p));
        part.role_length(role) * if drawn_once { 2.0 } else { 1.0 }
    };
    let mut seen = vec![];
    let mut sum = 0.0;
    for part in parts.iter().filter(of) {
        // Of several forms of one panel the first counts.
        let key = (part.front_back, part.laterality, part.half);
        if part.front_back.is_none() || part.half || !seen.contains(&key) {
            sum += length(part);
        }
        seen.push(key);
    }
    sum
}

/// Returns the length of the longer edge of a band \[m\].
fn long_edge(band: &LabeledPanel) -> f64 {
    let long = band.segments_of(EdgeRole::Long);
    let lengths = long.map(|s| band.features.length(&s.edges));
    lengths.fold(0.0, f64::max)
}

/// Returns the kind of the band that an edge of this length fits best.
fn best_fit(openings: &[BandOpening], length: f64) -> Option<PanelKind> {
    let fits = openings
        .iter()
        .filter(|(_, around, [least, most])| (least * around..=most * around).contains(&length));
    let best = fits.min_by(|a, b| {
        let off = |o: &BandOpening| (length / o.1).ln().abs();
        off(a).total_cmp(&off(b))
    });
    best.map(|(kind, ..)| *kind)
}

/// Returns the kind of each band: the closest fits first, each opening given to one band and its
/// twins. A band that fits none that is left is another form of one that does.
fn shared_out(
    parts: &[LabeledPanel],
    openings: &[BandOpening],
    bands: &[usize],
) -> Vec<(usize, Option<PanelKind>)> {
    let mut fits: Vec<(f64, usize, usize)> = vec![];
    for i in bands {
        for (k, opening) in openings.iter().enumerate() {
            let long = long_edge(&parts[*i]);
            if best_fit(&[*opening], long).is_some() {
                fits.push(((long / opening.1).ln().abs(), *i, k));
            }
        }
    }
    fits.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut taken: Vec<(usize, usize)> = vec![];
    for (_, i, k) in fits {
        let is_twin = |j: usize| parts[i].features.is_twin(&parts[j].features);
        let of_others = |(j, other): &(usize, usize)| *other == k && !is_twin(*j);
        // Of bands for neck and armholes the two that are alike go round the armholes.
        let alike = bands.iter().any(|j| *j != i && is_twin(*j));
        let armholes = openings.iter().any(|o| o.0 == PanelKind::ArmBand);
        if alike && armholes && openings[k].0 == PanelKind::NeckBand {
            continue;
        }
        if !taken.iter().any(|(j, _)| *j == i) && !taken.iter().any(of_others) {
            taken.push((i, k));
        }
    }
    let kind = |i: usize| {
        let own = taken.iter().find(|(j, _)| *j == i);
        let own = own.map(|(_, k)| openings[*k].0);
        own.or_else(|| best_fit(openings, long_edge(&parts[i])))
    };
    bands.iter().map(|i| (*i, kind(*i))).collect()
}

/// Makes waistbands of the two bands that fit no opening alone, where they fit one together;
/// returns true if they do.
fn assign_halves(parts: &mut [LabeledPanel], openings: &[BandOpening], lost: &[usize]) -> bool {
    let [a, b] = *lost else { return false };
    let together = long_edge(&parts[a]) + long_edge(&parts[b]);
    let waists = openings.iter().copied();
    let waists: Vec<BandOpening> = waists
        .filter(|(kind, ..)| *kind == PanelKind::Waistband)
        .collect();
    if best_fit(&waists, together).is_none() {
        return false;
    }
    for (i, laterality) in [(a, Laterality::Left), (b, Laterality::Right)] {
        parts[i].kind = PanelKind::Waistband;
        parts[i].laterality = Some(laterality);
        parts[i].laterality_named = true;
    }
    true
}

/// Returns true for a panel of four straight edges, opposite ones as long as each other.
pub(super) fn is_rectangle(part: &LabeledPanel) -> bool {
    let [a, b, c, d] = part.features.ring[..] else {
        return false;
    };
    let edge = |i: usize| part.features.edges[i];
    let alike = |a: usize, b: usize| {
        let (a, b) = (edge(a).length, edge(b).length);
        (a - b).abs() <= RECTANGLE_SHARE * a.max(b)
    };
    let straight = [a, b, c, d].iter().all(|e| edge(*e).curl < MAX_CURL_RAD);
    straight && alike(a, c) && alike(b, d)
}

/// Returns true if one of the edges of a rectangle goes round an opening.
fn is_band(part: &LabeledPanel, openings: &[BandOpening]) -> bool {
    let mut lengths = part.features.edges.iter().map(|e| e.length);
    lengths.any(|length| best_fit(openings, length).is_some())
}

/// Gives the edges of a rectangle the roles of a band: long are those that fit an opening of its
/// kind, or any, best; else the longer ones.
fn label_long_edges(part: &mut LabeledPanel, openings: &[BandOpening]) {
    let own = |(kind, ..): &&BandOpening| part.kind == PanelKind::Skirt || *kind == part.kind;
    let own: Vec<BandOpening> = openings.iter().filter(own).copied().collect();
    let ring = part.features.ring.clone();
    let length = |k: usize| part.features.edges[ring[k]].length;
    let fits = [0, 1].map(|k| best_fit(&own, length(k)).is_some());
    let first_is_long = if fits[0] == fits[1] {
        length(0) >= length(1)
    } else {
        fits[0]
    };
    let role = |k: usize| {
        if k.is_multiple_of(2) == first_is_long {
            EdgeRole::Long
        } else {
            EdgeRole::End
        }
    };
    part.segments = (0..ring.len())
        .map(|k| RoleSegment {
            role: role(k),
            drawn_side: if k < 2 {
                DrawnSide::Left
            } else {
                DrawnSide::Right
            },
            edges: vec![ring[k]],
            before: role(k + 1),
        })
        .collect();
}
