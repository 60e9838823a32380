//! Outlines that are open where another piece draws the edge that closes them.

use super::chain::PathChain;
use super::lines::SheetLines;
use crate::fault::PatternCode;
use crate::pattern::Point2;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::point::distance;
use crate::pattern::polyline::{PolylineFoot, contains, nearest, segments, signed_area};

/// Ends this near to a line lie on it \[m\].
const ON: f64 = 2e-4;

/// A piece encloses at least this area \[m²\]: less is a line drawn beside another piece.
const LEAST_AREA: f64 = 0.02;

/// At most this many open lines of a sheet are looked at.
const MOST: usize = 200;

/// Closes the open outlines of a sheet that end on closed ones beside them. Each is warned about.
pub(super) fn close(lines: &mut SheetLines, findings: &mut DxfFindings) {
    if lines.boundary.iter().any(|chain| chain.closed) {
        close_beside(&mut lines.boundary, findings);
    } else {
        close_beside(&mut lines.general, findings);
    }
}

/// Returns the ends of an open line that bends and whose ends lie apart.
pub(super) fn ends(chain: &PathChain) -> Option<[Point2; 2]> {
    let ends = [*chain.points.first()?, *chain.points.last()?];
    let is_line = chain.points.len() > 2 && distance(ends[0], ends[1]) > ON;
    is_line.then_some(ends)
}

fn close_beside(chains: &mut [PathChain], findings: &mut DxfFindings) {
    let open: Vec<usize> = (0..chains.len()).filter(|i| !chains[*i].closed).collect();
    for i in open.into_iter().take(MOST) {
        let closed = chains.iter().filter(|other| other.closed);
        let found = closed.filter_map(|other| shared(&chains[i], other)).next();
        if let Some(edge) = found {
            let chain = &mut chains[i];
            chain.path_end.extend(vec![false; edge.len()]);
            chain.sampled.extend(vec![false; edge.len()]);
            chain.points.extend(edge);
            chain.closed = true;
            let detail = "an outline is open where another one lies beside it, and was closed along the edge that both share (outlines=lines keeps it as a line)";
            findings.warn(PatternCode::SharedEdge, chain.line, detail);
        }
    }
}

/// Returns the points of a closed line, between those where an open one outside of it ends, that
/// close it to an outline of its own.
fn shared(open: &PathChain, closed: &PathChain) -> Option<Vec<Point2>> {
    let [head, tail] = ends(open)?;
    let ring = &closed.points;
    let middle = open.points[open.points.len() / 2];
    if contains(ring, middle) {
        return None;
    }
    let foot = |p: Point2| nearest(segments(ring), p).filter(|foot| foot.distance <= ON);
    let (from, to) = (foot(tail)?, foot(head)?);
    let mut edges = [way(ring, from, to, [tail, head]), {
        let mut back = way(ring, to, from, [head, tail]);
        back.reverse();
        back
    }];
    let area = |edge: &[Point2]| signed_area(&[&open.points, edge].concat()).abs();
    edges.sort_by(|a, b| area(a).total_cmp(&area(b)));
    let [edge, _] = edges;
    (area(&edge) >= LEAST_AREA).then_some(edge)
}

/// Returns the points of a ring from one foot on to another, without those at the ends themselves.
fn way(ring: &[Point2], from: PolylineFoot, to: PolylineFoot, ends: [Point2; 2]) -> Vec<Point2> {
    let n = ring.len();
    let mut steps = (to.segment + n - from.segment) % n;
    if steps == 0 && to.at < from.at {
        steps = n;
    }
    let points = (1..=steps).map(|k| ring[(from.segment + k) % n]);
    let is_between = |p: &Point2| ends.iter().all(|end| distance(*end, *p) > ON);
    points.filter(is_between).collect()
}
