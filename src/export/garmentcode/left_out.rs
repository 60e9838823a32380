//! What a pattern holds and its specification cannot say, a sentence each.

use super::panel::DrawnPanel;
use crate::pattern::{Panel, Pattern, SeamPair};

/// Counts of what a specification leaves out.
pub(super) struct LeftOut {
    /// Seams that are no stitches.
    pub(super) seams: usize,
    /// Placements about a body.
    pub(super) placements: usize,
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
        let others = vec![
            counted(sum(|panel| panel.notches.len()), "notches"),
            counted(
                sum(|panel| usize::from(panel.grain.is_some())),
                "grain lines",
            ),
            counted(sum(|panel| panel.holes.len()), "holes"),
            counted(
                sum(|panel| panel.internal_lines.len()),
                "lines on the cloth",
            ),
            counted(sum(|panel| panel.drill_holes.len()), "drill holes"),
            counted(
                sum(|panel| usize::from(!panel.cut_line.is_empty())),
                "cut lines",
            ),
            counted(
                sum(|panel| usize::from(panel.quantity.is_some())),
                "quantities",
            ),
            counted(
                sum(|panel| usize::from(panel.copy_of.is_some())),
                "mirrored copies are panels of their own",
            ),
            counted(
                renamed.count(),
                "panels have other names, so that no two are equal",
            ),
            counted(
                of_no_face.count(),
                "panels of unknown face are taken to be drawn from outside",
            ),
            counted(
                drawn.iter().map(DrawnPanel::divided_count).sum(),
                "edges are written as several, with more corners: no one curve follows them",
            ),
            counted(
                pattern.seams.iter().filter(|seam| is_special(seam)).count(),
                "seams have a stage, lie over others or may twist: stitches do not say that",
            ),
            (deviation > 1e-6).then(|| {
                format!(
                    "up to {:.3} mm: edges are written as curves near their points",
                    1e3 * deviation
                )
            }),
        ];
        Self {
            seams: 0,
            placements: 0,
            others,
        }
    }

    /// Returns the sentences.
    pub(super) fn sentences(self) -> Vec<String> {
        let seams = counted(
            self.seams,
            "seams are not of two whole edges in the order picked",
        );
        let placements = counted(self.placements, "placements are about a body");
        let all = [seams, placements].into_iter().chain(self.others);
        all.flatten().collect()
    }
}

fn is_special(seam: &SeamPair) -> bool {
    seam.stage > 0 || seam.layered || seam.allow_twist
}

fn counted(count: usize, what: &str) -> Option<String> {
    (count > 0).then(|| format!("{count} {what}"))
}
