//! Sets of seams that would make the surface one-sided: which seam to blame, and how to mend it.

use super::Face;
use super::context::SeamCheckContext;
use super::cycle::{self, FaceConstraint, contradictions_without};
use super::face_conflicts;
use super::faces::{self, FaceColoring, SeamRelations};
use super::reversal;
use super::twist_fault::TwistFault;
use crate::fault::{Fault, SeamCode, quoted_list};

/// Contradictory cycles that are reported at once: finding each costs a search over all panels.
const MAX_REPORTED: usize = 50;

/// Finds panels whose stated faces are the trouble; then the smallest contradictory cycle, takes
/// the blamed seam out, and so on until none is left.
pub(super) fn find(
    context: &SeamCheckContext<'_>,
    stated: &[Option<Face>],
    coloring: &FaceColoring,
) -> Vec<TwistFault> {
    let nodes = stated.len() + 1;
    let mut constraints = constraints(context, stated, coloring);
    let mut twists = face_conflicts::find(context, stated, &mut constraints);
    while twists.len() < MAX_REPORTED
        && let Some(cycle) = cycle::smallest(nodes, &constraints)
    {
        let contradiction = ContradictoryCycle {
            context,
            cycle: &cycle,
            constraints: &constraints,
            nodes,
        };
        let Some(blamed) = contradiction.blamed(coloring) else {
            break;
        };
        let twist = contradiction.describe(blamed);
        constraints.retain(|constraint| constraint.seam != Some(twist.seam));
        twists.push(twist);
    }
    twists
}

/// Returns the constraints of stated faces and of the seams that must not twist, in the order of
/// ids.
fn constraints(
    context: &SeamCheckContext<'_>,
    stated: &[Option<Face>],
    coloring: &FaceColoring,
) -> Vec<FaceConstraint> {
    let mut constraints: Vec<FaceConstraint> = faces::stated_relations(stated)
        .map(|relation| FaceConstraint {
            relation,
            seam: None,
        })
        .collect();
    let mut relations: Vec<&SeamRelations<'_>> = context.relations.iter().collect();
    relations.sort_by_key(|implied| &implied.pair.id);
    for implied in relations
        .into_iter()
        .filter(|implied| !implied.pair.allow_twist)
    {
        constraints.extend(
            implied
                .relations(coloring)
                .iter()
                .map(|&relation| FaceConstraint {
                    relation,
                    seam: Some(implied.seam),
                }),
        );
    }
    constraints
}

/// A contradictory cycle among all constraints.
struct ContradictoryCycle<'a> {
    context: &'a SeamCheckContext<'a>,
    cycle: &'a [FaceConstraint],
    constraints: &'a [FaceConstraint],
    nodes: usize,
}

impl ContradictoryCycle<'_> {
    /// Returns the seam without which fewest contradictions are left; of several the one that would
    /// start far shorter in the other order, then the one whose ends are upside down as drawn, then
    /// the one set last.
    fn blamed(&self, coloring: &FaceColoring) -> Option<&SeamRelations<'_>> {
        let seams = self.cycle.iter().filter_map(|constraint| constraint.seam);
        let relations = self.context.relations;
        seams
            .filter_map(|seam| relations.iter().find(|implied| implied.seam == seam))
            .min_by_key(|implied| {
                let (left, _) =
                    contradictions_without(self.constraints, self.nodes, |constraint| {
                        constraint.seam == Some(implied.seam)
                    });
                (
                    left,
                    !reversal::is_shorter_reversed(self.context, implied, coloring),
                    implied.heights_agree != Some(false),
                    usize::MAX - implied.seam,
                )
            })
    }

    fn describe(&self, blamed: &SeamRelations<'_>) -> TwistFault {
        let fault = Fault::new(
            SeamCode::Twisted,
            format!("/seams/{}", blamed.seam),
            self.detail(blamed),
        );
        let (fix, corrected) = if let Some(fix) = self.turned_face() {
            (fix, None)
        } else if let Some(correction) = self.correction(blamed) {
            (correction.fix, Some(correction.pair))
        } else {
            let fix = "pick another edge for side b, or its corners in the other order; \
                       set `allow_twist` only if a one-sided surface is wanted";
            (fix.to_owned(), None)
        };
        TwistFault {
            seam: blamed.seam,
            fault: fault.fix(fix),
            corrected,
        }
    }

    /// Returns the fix where the stated face of a panel of the cycle is the trouble.
    fn turned_face(&self) -> Option<String> {
        let (now, _) = contradictions_without(self.constraints, self.nodes, |_| false);
        let panels = self
            .cycle
            .iter()
            .filter(|constraint| constraint.seam.is_none());
        let (_, panel, up) = panels
            .map(|stated| {
                let (left, _) =
                    contradictions_without(self.constraints, self.nodes, |constraint| {
                        constraint == stated
                    });
                (left, stated.relation.ends[0], stated.relation.same)
            })
            .filter(|(left, ..)| *left < now)
            .min_by_key(|&(left, panel, _)| {
                (
                    left,
                    faces::is_front(self.context.pattern, panel),
                    usize::MAX - panel,
                )
            })?;
        let id = &self.context.pattern.panels[panel].id;
        let other = if up { "down" } else { "up" };
        Some(format!(
            "turn `{id}`: set its `face` to `{other}`, or to `auto`"
        ))
    }

    fn correction(&self, blamed: &SeamRelations<'_>) -> Option<super::correction::Correction> {
        let (_, others) = contradictions_without(self.constraints, self.nodes, |constraint| {
            constraint.seam == Some(blamed.seam)
        });
        others
            .fits(&blamed.reversed)
            .then(|| self.context.correction(blamed))
            .flatten()
    }

    fn detail(&self, blamed: &SeamRelations<'_>) -> String {
        let pairs = self.context.pairs;
        let seams = quoted_list(
            self.cycle
                .iter()
                .filter_map(|constraint| constraint.seam)
                .map(|seam| &pairs[seam].id),
        );
        let panel_count = self.nodes - 1;
        let ends = self
            .cycle
            .iter()
            .flat_map(|constraint| constraint.relation.ends);
        let id = |panel: usize| &self.context.pattern.panels[panel].id;
        let panels = quoted_list(ends.filter(|&end| end < panel_count).map(id));
        let stated = quoted_list(
            self.cycle
                .iter()
                .filter(|constraint| constraint.seam.is_none())
                .map(|constraint| id(constraint.relation.ends[0])),
        );
        let name = &blamed.pair.id;
        if self.cycle.len() == 1 {
            format!(
                "seam `{name}` twists {panels}: both of its sides go the same way round, so the outer side of the cloth would be sewn to the inner one"
            )
        } else if stated.is_empty() {
            format!(
                "seam `{name}` twists the garment: {seams} together, round {panels}, would sew the outer side of the cloth to the inner one"
            )
        } else {
            format!(
                "seam `{name}` does not go with the faces stated for {stated}: {seams} would sew the outer side of the cloth to the inner one"
            )
        }
    }
}
