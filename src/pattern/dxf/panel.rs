//! Pieces to panels: the outline chosen, unfolded, checked, cut into edges, with its marks put on.

use super::chain::Chain;
use super::fold::Fold;
use super::notch;
use super::piece::Piece;
use super::ring::Ring;
use super::{Findings, at_line};
use crate::config::Limits;
use crate::fault::Fault;
use crate::pattern::assemble;
use crate::pattern::point::{Point2, cross, distance, sub};
use crate::pattern::polyline::{bounds, crossing, segments, signed_area};
use crate::pattern::{Grain, Hole, Panel};

/// Makes a panel of a piece. What keeps it from being one becomes a fault at its line.
pub(super) fn panel(piece: &Piece, limits: &Limits, findings: &mut Findings) -> Option<Panel> {
    let drawn = checked_ring(piece, &piece.outline.chain, limits, findings)?;
    let sew = piece
        .sew
        .as_ref()
        .and_then(|sew| sew_ring(piece, sew, limits, findings));
    let fold = fold(piece, &drawn, findings);
    let whole = |ring: &Ring| {
        fold.and_then(|fold| fold.unfold(ring))
            .unwrap_or_else(|| ring.clone())
    };
    let cut = whole(&drawn);
    let ring = sew
        .as_ref()
        .map_or_else(|| cut.clone(), whole)
        .into_clockwise();
    if let Some(place) = crossing(&ring.points) {
        findings.faults.push(crosses(piece, place));
        return None;
    }
    let outline = assemble::outline(&ring.points, &ring.corner);
    let holes = holes(piece, fold, limits, findings);
    let hole_area: f64 = holes
        .iter()
        .map(|hole| signed_area(&assemble::ring(&hole.edges)))
        .sum();
    Some(Panel {
        id: String::new(),
        name: piece.name.chars().take(limits.name_chars).collect(),
        label: None,
        face: None,
        area_m2: signed_area(&ring.points).abs() - hole_area.abs(),
        perimeter_m: outline.edges.iter().map(|edge| edge.length_m).sum(),
        drawn_area_m2: signed_area(&drawn.points).abs(),
        unfolded: fold.is_some(),
        copy_of: None,
        quantity: piece.labels.quantity(),
        notches: notch::notches(piece, &outline, fold, findings),
        corners: outline.corners,
        edges: outline.edges,
        holes,
        cut_line: if sew.is_some() {
            cut.points
        } else {
            drawn_cut_line(piece, fold)
        },
        drill_holes: doubled(piece.marks.drills.clone(), fold),
        grain: grain(piece, findings),
        internal_lines: internal_lines(piece, sew.is_some(), fold),
    })
}

/// The fold line that the outline is to be unfolded about, if it has one.
fn fold(piece: &Piece, drawn: &Ring, findings: &mut Findings) -> Option<Fold> {
    let lines = &piece.marks.folds;
    let found = lines
        .iter()
        .filter_map(|line| Fold::new(*line))
        .find(|fold| fold.unfold(drawn).is_some());
    if found.is_none() && !lines.is_empty() {
        findings.warn(
            "pattern/fold_ignored",
            piece.line,
            format!(
                "the fold line of {:?} is not an edge of it; the piece was not unfolded",
                piece.name
            ),
        );
    }
    found
}

fn refuse(piece: &Piece, code: &str, detail: &str, fix: &str) -> Fault {
    Fault::new(
        code,
        at_line(piece.line),
        format!("the piece {:?} {detail}", piece.name),
    )
    .fix(fix)
}

fn crosses(piece: &Piece, [x, y]: Point2) -> Fault {
    refuse(
        piece,
        "pattern/self_intersecting",
        &format!(
            "has an outline that crosses or touches itself at ({:.4}, {:.4}) m",
            x, y
        ),
        "mend the outline in the CAD program",
    )
}

/// The ring of an outline that has an area and a size within the limits.
fn checked_ring(
    piece: &Piece,
    chain: &Chain,
    limits: &Limits,
    findings: &mut Findings,
) -> Option<Ring> {
    if let Some(gap) = chain.repaired {
        let detail = format!(
            "a gap of {:.3} mm in the outline of {:?} was closed",
            1000.0 * gap,
            piece.name
        );
        findings.warn("pattern/gap_closed", chain.line, detail);
    }
    match ring(piece, chain, limits) {
        Ok(ring) => Some(ring),
        Err(fault) => {
            findings.faults.push(fault);
            None
        }
    }
}

fn ring(piece: &Piece, chain: &Chain, limits: &Limits) -> Result<Ring, Fault> {
    let no_area = || {
        refuse(
            piece,
            "pattern/no_area",
            "has no area",
            "delete it, or draw its outline anew",
        )
    };
    if chain.points.len() > limits.panel_vertices {
        let detail = format!(
            "has {} outline points; at most {} are read",
            chain.points.len(),
            limits.panel_vertices
        );
        return Err(refuse(
            piece,
            "pattern/too_large",
            &detail,
            "export curves with fewer points",
        ));
    }
    if chain.points.len() < 3 {
        return Err(no_area());
    }
    let [low, high] = bounds(&chain.points);
    let side = (high[0] - low[0]).max(high[1] - low[1]);
    let [least, most] = limits.panel_size_m;
    if !(least..=most).contains(&side) {
        let detail = format!("is {side:.3e} m long; sizes from {least} to {most} m are read");
        let fix = "say the units of the file with units=mm|cm|m|inch, or mend the drawing";
        return Err(refuse(piece, "pattern/implausible_size", &detail, fix));
    }
    let ring = Ring::new(chain, &piece.marks.turns);
    if swept_area(&ring.points) < 1e-6 * side * side {
        return Err(no_area());
    }
    Ok(ring)
}

/// The areas of the triangles from the first point to each segment, none taken from another: 0 only where all points
/// lie on one line.
fn swept_area(ring: &[Point2]) -> f64 {
    segments(ring)
        .map(|(a, b)| 0.5 * cross(sub(a, ring[0]), sub(b, ring[0])).abs())
        .sum()
}

/// The sew line as an outline; one that is open along a fold is closed there.
fn sew_ring(piece: &Piece, sew: &Chain, limits: &Limits, findings: &mut Findings) -> Option<Ring> {
    let on_fold = |p: Point2| {
        piece
            .marks
            .folds
            .iter()
            .filter_map(|line| Fold::new(*line))
            .any(|fold| fold.side(p).abs() < 2e-4)
    };
    let ends = [*sew.points.first()?, *sew.points.last()?];
    if sew.closed || ends.into_iter().all(on_fold) && distance(ends[0], ends[1]) > 0.0 {
        return checked_ring(piece, sew, limits, findings);
    }
    findings.warn(
        "pattern/open_sew_line",
        sew.line,
        format!(
            "the sew line of {:?} does not close; its outline is the cut line",
            piece.name
        ),
    );
    None
}

fn doubled(mut points: Vec<Point2>, fold: Option<Fold>) -> Vec<Point2> {
    if let Some(fold) = fold {
        fold.double(&mut points);
    }
    points
}

/// The cut line drawn about a sewn outline; an open one is unfolded like the piece.
fn drawn_cut_line(piece: &Piece, fold: Option<Fold>) -> Vec<Point2> {
    let Some(cut) = &piece.cut else {
        return Vec::new();
    };
    let mut line = cut.points.clone();
    if let Some(fold) = fold.filter(|_| !cut.closed) {
        line.extend(cut.points.iter().rev().map(|p| fold.mirror(*p)));
    }
    line
}

/// The direction of the longest grain line; another that is half as long or longer (no arrow head) and runs otherwise
/// is warned about.
fn grain(piece: &Piece, findings: &mut Findings) -> Option<Grain> {
    let lines = &piece.marks.grains;
    let long = |line: &[Point2; 2]| distance(line[0], line[1]);
    let longest = lines.iter().max_by(|a, b| long(a).total_cmp(&long(b)))?;
    let [a, b] = *longest;
    let along = sub(b, a);
    let differs = |line: &&[Point2; 2]| {
        let way = sub(line[1], line[0]);
        long(line) >= 0.5 * long(longest)
            && cross(along, way).abs() > 0.02 * long(line) * long(longest)
    };
    if lines.iter().any(|line| differs(&line)) {
        findings.warn(
            "pattern/grain_ignored",
            piece.line,
            format!(
                "{:?} has grain lines in several directions; the longest was taken",
                piece.name
            ),
        );
    }
    let angle_deg = (b[1] - a[1])
        .atan2(b[0] - a[0])
        .to_degrees()
        .rem_euclid(180.0);
    Some(Grain {
        angle_deg: if angle_deg >= 180.0 { 0.0 } else { angle_deg },
    })
}

fn holes(piece: &Piece, fold: Option<Fold>, limits: &Limits, findings: &mut Findings) -> Vec<Hole> {
    let mut holes = Vec::new();
    for chain in &piece.cutouts {
        let Some(ring) = checked_ring(piece, chain, limits, findings) else {
            continue;
        };
        let image = fold.map(|fold| Ring {
            points: ring.points.iter().map(|p| fold.mirror(*p)).collect(),
            corner: ring.corner.clone(),
        });
        for ring in [Some(ring), image].into_iter().flatten() {
            if let Some(place) = crossing(&ring.points) {
                findings.faults.push(crosses(piece, place));
                continue;
            }
            let mut ring = ring.into_clockwise();
            ring.points[1..].reverse();
            ring.corner[1..].reverse();
            let outline = assemble::outline(&ring.points, &ring.corner);
            holes.push(Hole {
                corners: outline.corners,
                edges: outline.edges,
            });
        }
    }
    holes
}

fn internal_lines(piece: &Piece, sewn: bool, fold: Option<Fold>) -> Vec<Vec<Point2>> {
    let unused_sew = piece.sew.iter().filter(|_| !sewn);
    let second_cut = piece.cut.iter().filter(|_| sewn);
    let mut lines: Vec<Vec<Point2>> = Vec::new();
    for chain in piece.internal.iter().chain(unused_sew).chain(second_cut) {
        let mut line = chain.points.clone();
        line.extend(chain.points.first().filter(|_| chain.closed));
        if line.len() > 1 {
            lines.push(line);
        }
    }
    if let Some(fold) = fold {
        let images: Vec<Vec<Point2>> = lines
            .iter()
            .map(|line| line.iter().map(|p| fold.mirror(*p)).collect())
            .collect();
        lines.extend(images);
    }
    lines
}
