//! The smallest contradictory cycle among face relations: round it an odd number of them changes
//! the face.

use super::parity::{FaceRelation, ParityUnionFind};
use std::collections::VecDeque;

/// A face relation with its source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FaceConstraint {
    /// The relation.
    pub relation: FaceRelation,
    /// Index of the seam that implies it; `None` for a stated face.
    pub seam: Option<usize>,
}

/// Returns the fewest of `constraints`, in order round, that cannot all hold; `None` if all can.
///
/// Breadth-first search from each node on the double cover (each node once for either face): the
/// shortest way from a node to itself with the other face is a shortest contradictory cycle through
/// it. O(nodes x constraints).
pub(super) fn smallest(
    nodes: usize,
    constraints: &[FaceConstraint],
) -> Option<Vec<FaceConstraint>> {
    let mut around: Vec<Vec<usize>> = vec![vec![]; nodes];
    for (i, constraint) in constraints.iter().enumerate() {
        let [a, b] = constraint.relation.ends;
        around[a].push(i);
        if a != b {
            around[b].push(i);
        }
    }
    let mut best: Option<Vec<FaceConstraint>> = None;
    for start in 0..nodes {
        let shorter_than = best.as_ref().map_or(usize::MAX, Vec::len);
        if let Some(found) = through(start, constraints, &around, shorter_than) {
            best = Some(found);
        }
    }
    best
}

fn through(
    start: usize,
    constraints: &[FaceConstraint],
    around: &[Vec<usize>],
    shorter_than: usize,
) -> Option<Vec<FaceConstraint>> {
    let (first, goal) = (2 * start, 2 * start + 1);
    let mut reached_by: Vec<Option<(usize, usize)>> = vec![None; 2 * around.len()];
    let mut queue = VecDeque::from([(first, 0)]);
    while let Some((place, steps)) = queue.pop_front() {
        if steps + 1 >= shorter_than {
            return None;
        }
        for &i in &around[place / 2] {
            let [a, b] = constraints[i].relation.ends;
            let other = if a == place / 2 { b } else { a };
            let next = 2 * other + ((place % 2) ^ usize::from(!constraints[i].relation.same));
            if next == first || reached_by[next].is_some() {
                continue;
            }
            reached_by[next] = Some((place, i));
            if next == goal {
                return Some(path_back(goal, &reached_by, constraints));
            }
            queue.push_back((next, steps + 1));
        }
    }
    None
}

fn path_back(
    goal: usize,
    reached_by: &[Option<(usize, usize)>],
    constraints: &[FaceConstraint],
) -> Vec<FaceConstraint> {
    let mut path = vec![];
    let mut place = goal;
    while let Some((before, constraint)) = reached_by[place] {
        path.push(constraints[constraint]);
        place = before;
    }
    path.reverse();
    path
}

/// Counts the constraints that contradict those before them when some are left out; returns the
/// rest as a union-find too.
pub(super) fn contradictions_without(
    constraints: &[FaceConstraint],
    nodes: usize,
    out: impl Fn(&FaceConstraint) -> bool,
) -> (usize, ParityUnionFind) {
    let mut parity = ParityUnionFind::new(nodes);
    let mut contradictions = 0;
    for constraint in constraints.iter().filter(|constraint| !out(constraint)) {
        contradictions += usize::from(!parity.join(constraint.relation));
    }
    (contradictions, parity)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn constraint(seam: usize, a: usize, b: usize, same: bool) -> FaceConstraint {
        FaceConstraint {
            relation: FaceRelation { ends: [a, b], same },
            seam: Some(seam),
        }
    }

    #[test]
    fn agreeing_links_have_no_contradictory_cycle() {
        let constraints = [
            constraint(0, 0, 1, false),
            constraint(1, 1, 2, false),
            constraint(2, 2, 0, true),
        ];
        assert_eq!(smallest(3, &constraints), None);
    }

    #[test]
    fn smaller_of_two_contradictory_cycles_is_found() {
        let constraints = [
            constraint(0, 0, 1, true),
            constraint(1, 1, 2, true),
            constraint(2, 2, 3, true),
            constraint(3, 3, 0, false),
            constraint(4, 3, 4, true),
            constraint(5, 4, 3, false),
        ];
        let seams: Vec<_> = smallest(5, &constraints)
            .unwrap()
            .iter()
            .map(|t| t.seam)
            .collect();
        assert_eq!(seams, [Some(4), Some(5)]);
    }

    #[test]
    fn panel_that_differs_from_itself_is_a_cycle_of_one() {
        let constraints = [constraint(0, 0, 1, false), constraint(1, 1, 1, false)];
        assert_eq!(smallest(2, &constraints).unwrap(), [constraints[1]]);
    }
}
