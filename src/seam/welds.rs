//! Seams that sew two points of one edge onto each other, through the point of cloth at which two
//! of them meet.

use super::correction::reversed_side;
use super::parity::{FaceRelation, ParityUnionFind};
use super::pleats::{self, FoldedPairs};
use super::seam_sides::{SeamSide, SeamSideEnd, SeamSides};
use super::{RoutedSeam, SeamFinding, Track};
use crate::fault::{SeamCode, Warning};
use crate::pattern::{Pattern, SeamPair};
use std::borrow::Cow;

/// Points of an edge that are sewn onto each other and lie nearer than this are not warned of
/// \[m\]: half of a usual mesh edge, up to which ends of edges are sewn onto each other too.
const APART_M: f64 = 5e-3;

/// Welds that are looked at: each costs a pass over all seams.
const MAX_WELDS: usize = 50;

/// Two points of one edge that two seams sew to the same point.
struct Weld<'a> {
    sides: [&'a SeamSide; 2],
    /// Numbers of the two points.
    nodes: [usize; 2],
    apart_m: f64,
}

impl Weld<'_> {
    fn seams(&self) -> [usize; 2] {
        self.sides.map(|side| side.seam)
    }
}

/// Warns of seams that sew points of one edge onto each other which no others do; returns those
/// that fold the cloth in the other order, in that order.
pub(super) fn warn<'a>(
    pattern: &Pattern,
    pairs: &[SeamPair],
    ordered: impl Iterator<Item = Cow<'a, RoutedSeam>>,
    folded_reversed: &FoldedPairs,
    findings: &mut [SeamFinding],
) -> Vec<SeamPair> {
    let sides = SeamSides::new(pattern, ordered);
    let mut welds = candidates(pattern, &sides);
    welds.retain(|weld| !is_sewn_by_others(&sides, weld));
    let mut corrected = vec![];
    while let Some((seam, weld)) = blamed(pairs, &welds) {
        let folds = pleats::is_folded(folded_reversed, seam);
        findings[seam].warnings.push(Warning::new(
            SeamCode::PointsWelded,
            format!("/seams/{seam}/b"),
            detail(pattern, pairs, (seam, weld), folds),
        ));
        if folds {
            corrected.push(SeamPair {
                b: reversed_side(&pairs[seam].b),
                ..pairs[seam].clone()
            });
        }
        welds.retain(|weld| !weld.seams().contains(&seam));
    }
    corrected
}

fn candidates<'a>(pattern: &Pattern, sides: &'a SeamSides) -> Vec<Weld<'a>> {
    let pairs = sides.meeting_ends().filter_map(|[(i, one), (j, other)]| {
        let both = [&sides.sides[i], &sides.sides[j]];
        let apart_m = weld_distance(pattern, both, [one, other])?;
        Some(Weld {
            sides: both,
            nodes: [one.base_node, other.base_node],
            apart_m,
        })
    });
    pairs.take(MAX_WELDS).collect()
}

/// Returns how far apart on one edge the points lie to which the cloth is sewn at the point where
/// two seams meet, if one of them covers what lies between them.
fn weld_distance(pattern: &Pattern, sides: [&SeamSide; 2], ends: [SeamSideEnd; 2]) -> Option<f64> {
    let [one, other] = sides;
    let is_on_one_edge = one.has_base_track_of(other) && one.base.edge == other.base.edge;
    let meet = ends[0].cloth_ahead != ends[1].cloth_ahead;
    let are_two_points = ends[0].base_node != ends[1].base_node;
    let is_tip = ends.iter().any(|end| end.cloth_node == end.base_node);
    if !is_on_one_edge || !meet || !are_two_points || is_tip {
        return None;
    }
    let track: Track = one.base.track;
    let panel = &pattern.panels[one.base.panel];
    let length = track.length(panel, one.base.edge);
    let between = (ends[1].base_at - ends[0].base_at) * length;
    let is_covered = (between > 0.0) == ends[0].base_ahead || (between < 0.0) == ends[1].base_ahead;
    let is_ring = track.is_closed(panel) && track.edge_count(panel) == 1;
    let apart = if is_ring {
        between.abs().min(length - between.abs())
    } else {
        between.abs()
    };
    (is_covered && apart > APART_M).then_some(apart)
}

/// Returns true if the other seams sew the two points onto each other anyway, as the ends of a band
/// that is closed to a ring.
fn is_sewn_by_others(sides: &SeamSides, weld: &Weld<'_>) -> bool {
    let mut joined = ParityUnionFind::new(sides.node_count);
    let of_weld = weld.seams();
    for side in sides
        .sides
        .iter()
        .filter(|side| !of_weld.contains(&side.seam))
    {
        for end in side.ends {
            joined.join(FaceRelation {
                ends: [end.cloth_node, end.base_node],
                same: true,
            });
        }
    }
    let [one, other] = weld.nodes.map(|node| joined.find(node).0);
    one == other
}

/// Returns the seam to warn of, with a weld of it: the one of most welds, then a layered one, then
/// the latest.
fn blamed<'a, 'b>(pairs: &[SeamPair], welds: &'b [Weld<'a>]) -> Option<(usize, &'b Weld<'a>)> {
    let count = |seam: usize| {
        let of_seam = welds.iter().filter(|weld| weld.seams().contains(&seam));
        of_seam.count()
    };
    let each = welds
        .iter()
        .flat_map(|weld| weld.seams().map(|seam| (seam, weld)));
    each.max_by_key(|&(seam, _)| (count(seam), pairs[seam].layered, seam))
}

fn detail(
    pattern: &Pattern,
    pairs: &[SeamPair],
    (seam, weld): (usize, &Weld<'_>),
    folds: bool,
) -> String {
    let [one, other] = weld.sides;
    let partner = if one.seam == seam { other } else { one };
    let panel = |index: usize| &pattern.panels[index].id;
    let with = if partner.seam == seam {
        String::new()
    } else {
        format!(" together with seam `{}`", pairs[partner.seam].id)
    };
    let fix = if folds {
        "; pick the corners of side b in the other order to fold the cloth there"
    } else {
        ""
    };
    format!(
        "seam `{}`{with} sews two points of `{}` that lie {:.0} mm apart on one edge to the same point of `{}`{fix}",
        pairs[seam].id,
        panel(one.base.panel),
        weld.apart_m * 1e3,
        panel(one.cloth.panel),
    )
}
