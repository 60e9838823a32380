//! Stitches: which vertex is sewn to which.

use super::cloth_mesh::Stitch;
use super::divide::Divisions;
use crate::seam::Seam;
use std::collections::HashSet;

/// Pairs the vertices of both sides of every seam; `vertex` gives the one at (panel, number of the
/// edge, part).
///
/// A pair that occurs twice (where two stretches of a seam meet) is kept once; a vertex is never
/// sewn to itself (the fold of an edge sewn to its own other half).
pub(super) fn stitches(
    seams: &[Seam],
    divisions: &Divisions,
    vertex: impl Fn(usize, usize, usize) -> usize,
) -> Vec<Stitch> {
    let mut seen = HashSet::new();
    let mut stitches = vec![];
    for (index, seam) in seams.iter().enumerate() {
        for matched in &seam.matched {
            let [side_a, side_b] = matched.map(|stretch| {
                let parts = divisions.of(&stretch).parts(&stretch);
                parts.into_iter().map(move |part| (stretch, part))
            });
            for ((of_a, part_a), (of_b, part_b)) in side_a.zip(side_b) {
                let a = vertex(of_a.panel, divisions.slot(&of_a), part_a);
                let b = vertex(of_b.panel, divisions.slot(&of_b), part_b);
                if a != b && seen.insert((a.min(b), a.max(b))) {
                    stitches.push(Stitch {
                        seam: index,
                        stage: seam.stage,
                        a,
                        b,
                    });
                }
            }
        }
    }
    stitches
}
