//! The closed lines of a piece as rings: within the limits, and simple.

use super::chain::PathChain;
use super::corners::CorneredRing;
use super::dxf_piece::DxfPiece;
use super::gap::closed_in_words;
use super::loops::{self, CutLoop};
use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::crossing::crossing;
use crate::pattern::dxf::findings::{DxfFindings, at_line};
use crate::pattern::point::{Point2, cross, distance, sub};
use crate::pattern::polyline::{longest_side, segments};

/// A piece whose triangles sweep less than this share of its length squared has no area.
const LEAST_SWEPT: f64 = 1e-6;

/// The part of a piece that a ring is the outline of.
#[derive(Clone, Copy)]
pub(super) enum RingOf<'a> {
    /// The whole piece.
    Piece(&'a DxfPiece),
    /// A hole in it that begins at a line.
    Hole(&'a DxfPiece, usize),
}

/// Returns the ring of a line that has an area and a size within the limits; else adds a fault.
pub(super) fn checked(
    part: RingOf<'_>,
    chain: &PathChain,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Option<CorneredRing> {
    let whose = format!("the outline of {}", part.name());
    if let Some(detail) = closed_in_words(&chain.gaps, &whose) {
        findings.warn(PatternCode::GapClosed, chain.line, detail);
    }
    match ring(part, chain, limits) {
        Ok(ring) => Some(ring),
        Err(fault) => {
            findings.leave_out(fault, part.entity_count());
            None
        }
    }
}

/// Returns the sew line as an outline; one that is open along a fold is closed there. Another open
/// one is warned about.
pub(super) fn of_sew_line(
    piece: &DxfPiece,
    sew: &PathChain,
    limits: &Limits,
    findings: &mut DxfFindings,
) -> Option<CorneredRing> {
    let ends = [*sew.points.first()?, *sew.points.last()?];
    let folds = piece.fold_lines();
    let is_on_fold = |p: Point2| folds.iter().any(|fold| fold.contains(p));
    if sew.closed || ends.into_iter().all(is_on_fold) && distance(ends[0], ends[1]) > 0.0 {
        return checked(RingOf::Piece(piece), sew, limits, findings);
    }
    let detail = format!(
        "the sew line of {:?} does not close; its outline is the cut line",
        piece.name
    );
    findings.warn(PatternCode::OpenSewLine, sew.line, detail);
    None
}

/// Returns a ring without the small loops in which it crosses itself, each of which is warned
/// about; one that crosses itself otherwise is left out with its piece.
pub(super) fn simple(
    part: RingOf<'_>,
    ring: CorneredRing,
    findings: &mut DxfFindings,
) -> Option<CorneredRing> {
    let (ring, cut) = loops::cut_off(ring);
    if let Some([x, y]) = crossing(&ring.points) {
        let detail = format!("has an outline that crosses or touches itself at ({x:.4}, {y:.4}) m");
        let fix = "mend the outline in the CAD program";
        let fault = part.refuse(PatternCode::SelfIntersecting, &detail, fix);
        findings.leave_out(fault, part.entity_count());
        return None;
    }
    for CutLoop { point, length } in cut {
        let detail = format!(
            "the outline of {} crosses itself at ({:.4}, {:.4}) m; the loop of {:.1} mm there is cut off (strict=true refuses such files)",
            part.name(),
            point[0],
            point[1],
            1000.0 * length
        );
        findings.mend(PatternCode::LoopCutOff, part.line(), detail);
    }
    Some(ring)
}

fn ring(part: RingOf<'_>, chain: &PathChain, limits: &Limits) -> Result<CorneredRing, Fault> {
    let count = chain.points.len();
    if count > limits.panel_vertices {
        let detail = format!(
            "has {count} outline points; at most {} are read",
            limits.panel_vertices
        );
        let fix = "export curves with fewer points";
        return Err(part.refuse(PatternCode::TooLarge, &detail, fix));
    }
    if count < 3 {
        return Err(no_area(part));
    }
    let side = longest_side(&chain.points);
    let [least, most] = limits.panel_size_m;
    if !(least..=most).contains(&side) {
        let detail = format!("is {side:.3e} m long; sizes from {least} to {most} m are read");
        let fix = "say the units of the file with units=mm|cm|m|inch, or mend the drawing";
        return Err(part.refuse(PatternCode::ImplausibleSize, &detail, fix));
    }
    let ring = CorneredRing::new(chain, &part.piece().marks.turns);
    if swept_area(&ring.points) < LEAST_SWEPT * side * side {
        return Err(no_area(part));
    }
    Ok(ring)
}

fn no_area(part: RingOf<'_>) -> Fault {
    let fix = "delete it, or draw its outline anew";
    part.refuse(PatternCode::NoArea, "has no area", fix)
}

impl<'a> RingOf<'a> {
    fn piece(self) -> &'a DxfPiece {
        match self {
            Self::Piece(piece) | Self::Hole(piece, _) => piece,
        }
    }

    fn name(self) -> String {
        match self {
            Self::Piece(piece) => format!("{:?}", piece.name),
            Self::Hole(piece, _) => format!("a hole of {:?}", piece.name),
        }
    }

    fn line(self) -> usize {
        match self {
            Self::Piece(piece) => piece.line,
            Self::Hole(_, line) => line,
        }
    }

    /// Returns the number of entities that go with it.
    fn entity_count(self) -> usize {
        match self {
            Self::Piece(piece) => piece.entity_count(),
            Self::Hole(..) => 1,
        }
    }

    fn refuse(self, code: PatternCode, detail: &str, fix: &str) -> Fault {
        let whose = match self {
            Self::Piece(_) => "the piece ",
            Self::Hole(..) => "",
        };
        let detail = format!("{whose}{} {detail}", self.name());
        Fault::new(code, at_line(self.line()), detail).fix(fix)
    }
}

/// Returns the sum of the areas of the triangles from the first point to each segment, none taken
/// from another: 0 only where all points lie on one line.
fn swept_area(ring: &[Point2]) -> f64 {
    segments(ring)
        .map(|(a, b)| 0.5 * cross(sub(a, ring[0]), sub(b, ring[0])).abs())
        .sum()
}
