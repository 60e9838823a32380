//! Sentences on all that a pattern holds and its specification cannot say.

use super::super::counted::counted;
use super::fit::MOST_FITTED;
use super::panel::DrawnPanel;
use super::stitch::stored_edge;
use crate::pattern::{Panel, Pattern, SeamPair, Side};
use crate::pattern::{is_gathered, polyline, seam_id};

/// Counts of what a specification leaves out.
pub(super) struct LeftOut {
    /// Seams that are no stitches.
    pub(super) seams: usize,
    /// Placements about a body.
    pub(super) placements: usize,
    /// Seams that are stitches but have a stage, lie over others or may twist.
    special: usize,
    /// Stitches whose gathers are read again as the lengths of their edges say.
    gathers: usize,
    /// Stitches that are read again under other ids.
    ids: usize,
    /// True if the pattern has too many points for curves.
    pub(super) is_sparing: bool,
    others: Vec<Option<String>>,
}

impl LeftOut {
    /// Looks at a pattern whose panels are written under `names`, as `drawn`.
    pub(super) fn of(pattern: &Pattern, names: &[String], drawn: &[DrawnPanel]) -> Self {
        let panels = &pattern.panels;
        let sum = |count: fn(&Panel) -> usize| panels.iter().map(count).sum::<usize>();
        let has_face = panels.iter().any(|panel| panel.face.is_some());
        let of_no_face = panels
            .iter()
            .filter(|panel| has_face && panel.face.is_none());
        let renamed = panels
            .iter()
            .zip(names)
            .filter(|(panel, name)| panel.name != **name);
        let deviation = drawn
            .iter()
            .map(|drawn| drawn.deviation)
            .fold(0.0, f64::max);
        let with = |is_so: fn(&Panel) -> bool| panels.iter().filter(|panel| is_so(panel)).count();
        let others = vec![
            counted(sum(|panel| panel.notches.len()), "notch", "notches"),
            counted(
                with(|panel| panel.grain.is_some()),
                "grain line",
                "grain lines",
            ),
            counted(sum(|panel| panel.holes.len()), "hole", "holes"),
            counted(
                sum(|panel| panel.internal_lines.len()),
                "line on the cloth",
                "lines on the cloth",
            ),
            counted(
                sum(|panel| panel.drill_holes.len()),
                "drill hole",
                "drill holes",
            ),
            counted(
                with(|panel| !panel.cut_line.is_empty()),
                "cut line",
                "cut lines",
            ),
            counted(
                with(|panel| panel.quantity.is_some()),
                "quantity",
                "quantities",
            ),
            counted(
                with(|panel| panel.copy_of.is_some()),
                "mirrored copy is a panel of its own",
                "mirrored copies are panels of their own",
            ),
            counted(
                renamed.count(),
                "panel has another name, so that no two are equal",
                "panels have other names, so that no two are equal",
            ),
            counted(
                of_no_face.count(),
                "panel of unknown face is taken to be drawn from outside",
                "panels of unknown face are taken to be drawn from outside",
            ),
            counted(
                drawn.iter().map(DrawnPanel::divided_count).sum(),
                "edge is written as several, with more corners: no one curve follows it",
                "edges are written as several, with more corners: no one curve follows them",
            ),
            (deviation > 1e-6).then(|| {
                format!(
                    "edges are written as curves, up to {:.3} mm from the lines drawn",
                    1e3 * deviation
                )
            }),
        ];
        Self {
            seams: 0,
            placements: 0,
            special: 0,
            gathers: 0,
            ids: 0,
            is_sparing: false,
            others,
        }
    }

    /// Looks at a seam that is stitch `index` of the file.
    pub(super) fn add_stitch(&mut self, seam: &SeamPair, pattern: &Pattern, index: usize) {
        let [a, b] = [&seam.a, &seam.b].map(|side| length(side, pattern));
        self.special += usize::from(seam.stage > 0 || seam.layered || seam.allow_twist);
        self.gathers += usize::from(seam.gather != is_gathered(a, b));
        self.ids += usize::from(seam.id != seam_id(index));
    }

    /// Returns the sentences.
    pub(super) fn sentences(self) -> Vec<String> {
        let all = [
            counted(
                self.seams,
                "seam is not of two whole edges in the order picked",
                "seams are not of two whole edges in the order picked",
            ),
            counted(
                self.placements,
                "placement is about a body",
                "placements are about a body",
            ),
            counted(
                self.special,
                "seam has a stage, lies over others or may twist: stitches do not say that",
                "seams have a stage, lie over others or may twist: stitches do not say that",
            ),
            counted(
                self.gathers,
                "seam is gathered or not by the lengths of its edges (from 15 % on): stitches do not say that",
                "seams are gathered or not by the lengths of their edges (from 15 % on): stitches do not say that",
            ),
            counted(
                self.ids,
                "id of a seam: stitches are numbered",
                "ids of seams: stitches are numbered",
            ),
            self.is_sparing.then(|| {
                format!(
                    "fitted curves: edges of patterns of more than {MOST_FITTED} points are written as their chords"
                )
            }),
        ];
        all.into_iter().chain(self.others).flatten().collect()
    }
}

/// Returns the length of the edges of a side \[m\], which run from corner to corner.
fn length(side: &Side, pattern: &Pattern) -> f64 {
    let edges = side.runs().iter().filter_map(|run| {
        let panel = &pattern.panels[pattern.panel_index(&run.panel)?];
        let (edge, _) = stored_edge(run, panel.edges.len())?;
        Some(polyline::length(&panel.edges.get(edge)?.points))
    });
    edges.sum()
}
