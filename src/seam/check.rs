//! The check itself: each seam on its own, then all of them together.

use super::coloring::FaceColorer;
use super::context::SeamCheckContext;
use super::faces::{self, FaceColoring, ReversalReason, SeamRelations};
use super::outside::{self, TurnedPart};
use super::reversal::{self, ReversalDetector};
use super::run_resolver::RunResolver;
use super::{
    Face, FaceRequest, RoutedSeam, Seam, SeamCheck, SeamCheckInput, SeamFinding, SeamSet,
    StartPositions, Stretch, division_count, ease, overlap, pleats, twist, welds,
};
use crate::config::Limits;
use crate::fault::{Fault, Faults, SeamCode, Warning};
use crate::pattern::{Pattern, SeamPair};
use std::collections::{BTreeMap, BTreeSet};

/// Checks `pairs` against `pattern`; nothing is known of where panels start.
///
/// See [`check_placed`] and [`SeamCheckInput`].
///
/// # Errors
/// Every fault of every seam at once, in the second part.
pub fn check(
    pattern: &Pattern,
    pairs: &[SeamPair],
    faces: &BTreeMap<String, FaceRequest>,
    edge_length: f64,
    limits: &Limits,
) -> (SeamCheck, Result<SeamSet, Faults>) {
    let input = SeamCheckInput {
        pattern,
        pairs,
        faces,
        edge_length,
        limits,
    };
    check_placed(&input, &|_, _, _| None)
}

/// Checks seams against a pattern whose panels start as `starts` says.
///
/// Pointers are `/seams/<i>/...`, or `/panels/<id>/face` where stated faces are the trouble. The
/// findings always cover every seam; the [`SeamSet`] is there only when all are right. The order of
/// `pairs` and which side of a pair is A change neither what is right nor the faces found. Where
/// faces cannot tell the order of a seam, the start of its panels does: an `auto` seam is turned by
/// it, one as picked is warned of (`seam/likely_reversed`).
///
/// # Errors
/// Every fault of every seam at once, in the second part.
pub fn check_placed(
    input: &SeamCheckInput<'_>,
    starts: StartPositions<'_>,
) -> (SeamCheck, Result<SeamSet, Faults>) {
    let &SeamCheckInput {
        pattern,
        pairs,
        faces,
        edge_length,
        limits,
    } = input;
    let mut findings: Vec<_> = pairs
        .iter()
        .map(|pair| SeamFinding::blank(&pair.id))
        .collect();
    let stated = faces::stated(pattern, faces);
    let fronts_first = faces::fronts_first(pattern);
    if pairs.len() > limits.seams {
        findings[limits.seams]
            .errors
            .push(too_many(pairs.len(), limits.seams));
        let colorer = FaceColorer {
            leads: &fronts_first,
            shorter_order: &|_, _| None,
        };
        let set = SeamSet {
            seams: vec![],
            faces: colorer.color(&stated, &[]).faces,
        };
        return answer(pattern, findings, set, vec![]);
    }
    find_duplicate_ids(pairs, &mut findings);
    let (seams, mut corrected) = route(pattern, pairs, &mut findings);
    for (seam, fault) in overlap::find_faults(pattern, pairs, &seams) {
        findings[seam].errors.push(fault);
    }
    let folded = pleats::find(pattern, pairs, &seams);
    let folded_reversed = pleats::find_reversed(pattern, pairs, &seams, &folded);
    let relations: Vec<_> = seams
        .iter()
        .map(|seam| {
            let folded = [&folded, &folded_reversed];
            SeamRelations::new(pattern, &pairs[seam.index], seam, folded)
        })
        .collect();
    let context = SeamCheckContext {
        pattern,
        pairs,
        seams: &seams,
        relations: &relations,
        starts,
    };
    let mut leads = fronts_first;
    let (coloring, turned) = color(&context, &stated, &mut leads);
    let detector = ReversalDetector {
        context: &context,
        stated: &stated,
        leads: &leads,
    };
    for twist in twist::find(&context, &stated, &coloring) {
        findings[twist.seam].errors.push(twist.fault);
        corrected.extend(twist.corrected);
    }
    corrected.extend(detector.warn(&coloring, &mut findings));
    let ordered = seams.iter().map(|seam| coloring.ordered(seam));
    let mended = welds::warn(pattern, pairs, ordered, &folded_reversed, &mut findings);
    let is_new = |pair: &SeamPair| corrected.iter().all(|other| other.id != pair.id);
    let mended: Vec<SeamPair> = mended.into_iter().filter(is_new).collect();
    corrected.extend(mended);
    record_coloring(&coloring, &relations, &mut findings);
    let edge_length = edge_length
        .max(limits.edge_length_m[0])
        .min(limits.edge_length_m[1]);
    let sewn = seams.iter().map(|seam| {
        let seam = coloring.ordered(seam);
        sew(pattern, pairs, &seam, edge_length, &mut findings)
    });
    let set = SeamSet {
        seams: sewn.collect(),
        faces: coloring.faces.clone(),
    };
    let (mut check, set) = answer(pattern, findings, set, corrected);
    check.warnings = loose_panels(pattern, pairs);
    let turned = turned.iter();
    check
        .warnings
        .extend(turned.map(|part| outside::warning(pattern, part, &coloring.faces)));
    (check, set)
}

/// Colors the panels by stated faces, seams and start positions; returns too which parts are worn
/// the other way round than `leads` say, and changes those to it.
///
/// Where a part is turned over, the order of its `auto` seams is judged once more.
fn color(
    context: &SeamCheckContext<'_>,
    stated: &[Option<Face>],
    leads: &mut [(usize, Face)],
) -> (FaceColoring, Vec<TurnedPart>) {
    let shorter_order = |implied: &SeamRelations<'_>, faces: &[Vec<Face>; 2]| {
        let mut seams = context.seams.iter();
        let seam = seams.find(|seam| seam.index == implied.seam)?;
        reversal::shorter_order(context.pattern, seam, faces, context.starts)
    };
    let color = |leads: &[(usize, Face)]| {
        let colorer = FaceColorer {
            leads,
            shorter_order: &shorter_order,
        };
        colorer.color(stated, context.relations)
    };
    let coloring = color(leads);
    let turned = outside::turned(context, stated, &coloring);
    if turned.is_empty() {
        return (coloring, turned);
    }
    let over = turned.iter().flat_map(|part| part.panels.iter().copied());
    let faces = outside::turned_over(&coloring.faces, &over.collect::<Vec<_>>());
    for (panel, face) in leads.iter_mut() {
        *face = faces[*panel];
    }
    (color(leads), turned)
}

fn too_many(count: usize, most: usize) -> Fault {
    Fault::new(
        SeamCode::TooMany,
        "/seams",
        format!("{count} seams are more than the {most} that one garment may have"),
    )
    .fix("join seams that go on along neighbouring edges into lists of runs, or split the garment")
}

fn find_duplicate_ids(pairs: &[SeamPair], findings: &mut [SeamFinding]) {
    let mut first: BTreeMap<&str, usize> = BTreeMap::new();
    for (i, pair) in pairs.iter().enumerate() {
        let earlier = *first.entry(&pair.id).or_insert(i);
        if earlier != i {
            findings[i].errors.push(
                Fault::new(
                    SeamCode::DuplicateId,
                    format!("/seams/{i}/id"),
                    format!("seam {i} is named `{}` like seam {earlier}", pair.id),
                )
                .fix("give each seam a name of its own"),
            );
        }
    }
}

/// Routes every seam; those with faults get them written into their findings and are left out.
/// The second part holds those of them that can be corrected, corrected.
fn route(
    pattern: &Pattern,
    pairs: &[SeamPair],
    findings: &mut [SeamFinding],
) -> (Vec<RoutedSeam>, Vec<SeamPair>) {
    let mut resolver = RunResolver::new(pattern);
    let mut seams = vec![];
    let mut corrected = vec![];
    for (index, pair) in pairs.iter().enumerate() {
        let finding = &mut findings[index];
        let a = resolver.side(&pair.a, &format!("/seams/{index}/a"));
        let b = resolver.side(&pair.b, &format!("/seams/{index}/b"));
        match (a, b) {
            (Ok(a), Ok(b)) => {
                let seam = RoutedSeam {
                    index,
                    sides: [a, b],
                };
                [finding.length_a_m, finding.length_b_m] = seam.lengths(pattern);
                ease::record_ease(finding, pair, &format!("/seams/{index}"));
                seams.push(seam);
            }
            (a, b) => {
                let mut mended = pair.clone();
                let mut all = true;
                for (refused, side) in [(a.err(), &mut mended.a), (b.err(), &mut mended.b)] {
                    let Some(refused) = refused else { continue };
                    finding.errors.extend(refused.faults);
                    match refused.corrected {
                        Some(corrected) => *side = corrected,
                        None => all = false,
                    }
                }
                corrected.extend(all.then_some(mended));
            }
        }
    }
    (seams, corrected)
}

/// Writes into the findings which seams were reversed and why, and which twist.
fn record_coloring(
    coloring: &FaceColoring,
    relations: &[SeamRelations<'_>],
    findings: &mut [SeamFinding],
) {
    for implied in relations {
        let seam = implied.seam;
        let (id, finding) = (&implied.pair.id, &mut findings[seam]);
        if let Some(reason) = coloring.reversed.get(&seam) {
            finding.reversed = true;
            let reason = match reason {
                ReversalReason::Twisted => "as picked the garment would be twisted",
                ReversalReason::UpsideDown => {
                    "as picked the upper end of one side would meet the lower end of the other"
                }
                ReversalReason::Folds => "only so it folds the cloth over",
                ReversalReason::Notches => "as picked fewer notches would meet",
                ReversalReason::FarApart => {
                    "as picked its two sides would start far from each other"
                }
            };
            let detail = format!("side b of seam `{id}` is sewn in the other order: {reason}");
            finding.warnings.push(Warning::new(
                SeamCode::Reversed,
                format!("/seams/{seam}/b"),
                detail,
            ));
        }
        if coloring.twists_allowed.contains(&seam) {
            let detail =
                format!("seam `{id}` makes the surface one-sided, as `allow_twist` allows");
            finding.warnings.push(Warning::new(
                SeamCode::TwistAllowed,
                format!("/seams/{seam}"),
                detail,
            ));
        }
    }
}

/// Returns the seam as it is sewn, with its stitch count and directions written into its finding.
fn sew(
    pattern: &Pattern,
    pairs: &[SeamPair],
    seam: &RoutedSeam,
    edge_length: f64,
    findings: &mut [SeamFinding],
) -> Seam {
    let (pair, finding) = (&pairs[seam.index], &mut findings[seam.index]);
    let matched = seam.matched(pattern);
    let [a, b] = &seam.sides;
    finding.direction_a = a.first().map(|run| run.direction);
    finding.direction_b = b.first().map(|run| run.direction);
    finding.notches = seam.marks(pattern);
    finding.stitch_count = stitch_count(pattern, &matched, edge_length);
    Seam {
        id: pair.id.clone(),
        stage: pair.stage,
        matched,
    }
}

/// Counts point pairs along matched stretches: one more than mesh edges, less one where the seam is
/// closed, and less each end at which a panel meets itself (the tip of a dart).
fn stitch_count(pattern: &Pattern, matched: &[[Stretch; 2]], edge_length: f64) -> usize {
    let divisions: usize = matched
        .iter()
        .map(|[a, b]| division_count(a.length(pattern), b.length(pattern), edge_length))
        .fold(0, usize::saturating_add);
    let (Some(first), Some(last)) = (matched.first(), matched.last()) else {
        return 0;
    };
    let point = |s: &Stretch, at: f64| {
        let panel = &pattern.panels[s.panel];
        let on_next = at >= 1.0 && s.track.is_closed(panel);
        let (edge, at) = if on_next {
            ((s.edge + 1) % s.track.edge_count(panel), 0.0)
        } else {
            (s.edge, at)
        };
        (s.panel, s.track, edge, at)
    };
    let start = first.map(|s| point(&s, s.from));
    let end = last.map(|s| point(&s, s.to));
    let closed = start == end;
    let tips = [start, end].iter().filter(|[a, b]| a == b).count();
    (divisions + 1)
        .saturating_sub(usize::from(closed))
        .saturating_sub(tips)
}

fn answer(
    pattern: &Pattern,
    mut findings: Vec<SeamFinding>,
    set: SeamSet,
    corrected: Vec<SeamPair>,
) -> (SeamCheck, Result<SeamSet, Faults>) {
    for finding in &mut findings {
        finding.ok = finding.errors.is_empty();
    }
    let faults: Vec<Fault> = findings
        .iter()
        .flat_map(|finding| finding.errors.clone())
        .collect();
    let ids = pattern.panels.iter().map(|panel| panel.id.clone());
    let check = SeamCheck {
        ok: faults.is_empty(),
        faces: ids.zip(set.faces.iter().copied()).collect(),
        warnings: vec![],
        seams: findings,
        corrected,
    };
    (check, Faults(faults).or(set))
}

fn loose_panels(pattern: &Pattern, pairs: &[SeamPair]) -> Vec<Warning> {
    let named: BTreeSet<&str> = pairs
        .iter()
        .flat_map(|pair| pair.a.runs().iter().chain(pair.b.runs()))
        .map(|run| run.panel.as_str())
        .collect();
    let loose = pattern
        .panels
        .iter()
        .filter(|panel| !named.contains(panel.id.as_str()));
    loose
        .map(|panel| {
            let detail = format!("panel `{}` is sewn to nothing", panel.id);
            Warning::new(SeamCode::LoosePanel, "/seams", detail)
        })
        .collect()
}
