//! The smallest contradictory cycle among links: round it an odd number of them changes the face.

use super::parity::Link;
use std::collections::VecDeque;

/// A link with where it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Tied {
    /// What it says.
    pub link: Link,
    /// The seam that says so; `None` for a face that was stated.
    pub seam: Option<usize>,
}

/// The fewest of `ties`, in order round, that cannot all be right; `None` if all can.
///
/// Breadth-first search from each node on the double cover (each node once for either face): the shortest way from
/// a node to itself with the other face is a shortest contradictory cycle through it. O(nodes x ties).
pub(super) fn smallest(nodes: usize, ties: &[Tied]) -> Option<Vec<Tied>> {
    let mut around: Vec<Vec<usize>> = vec![vec![]; nodes];
    for (i, tie) in ties.iter().enumerate() {
        let [a, b] = tie.link.ends;
        around[a].push(i);
        if a != b {
            around[b].push(i);
        }
    }
    let mut best: Option<Vec<Tied>> = None;
    for start in 0..nodes {
        let shorter_than = best.as_ref().map_or(usize::MAX, Vec::len);
        if let Some(found) = through(start, ties, &around, shorter_than) {
            best = Some(found);
        }
    }
    best
}

fn through(
    start: usize,
    ties: &[Tied],
    around: &[Vec<usize>],
    shorter_than: usize,
) -> Option<Vec<Tied>> {
    let (first, goal) = (2 * start, 2 * start + 1);
    let mut reached_by: Vec<Option<(usize, usize)>> = vec![None; 2 * around.len()];
    let mut queue = VecDeque::from([(first, 0)]);
    while let Some((place, steps)) = queue.pop_front() {
        if steps + 1 >= shorter_than {
            return None;
        }
        for &i in &around[place / 2] {
            let [a, b] = ties[i].link.ends;
            let other = if a == place / 2 { b } else { a };
            let next = 2 * other + ((place % 2) ^ usize::from(!ties[i].link.same));
            if next == first || reached_by[next].is_some() {
                continue;
            }
            reached_by[next] = Some((place, i));
            if next == goal {
                return Some(way_back(goal, &reached_by, ties));
            }
            queue.push_back((next, steps + 1));
        }
    }
    None
}

fn way_back(goal: usize, reached_by: &[Option<(usize, usize)>], ties: &[Tied]) -> Vec<Tied> {
    let mut way = vec![];
    let mut place = goal;
    while let Some((before, tie)) = reached_by[place] {
        way.push(ties[tie]);
        place = before;
    }
    way.reverse();
    way
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tie(seam: usize, a: usize, b: usize, same: bool) -> Tied {
        Tied {
            link: Link { ends: [a, b], same },
            seam: Some(seam),
        }
    }

    #[test]
    fn agreeing_links_have_no_contradictory_cycle() {
        let ties = [tie(0, 0, 1, false), tie(1, 1, 2, false), tie(2, 2, 0, true)];
        assert_eq!(smallest(3, &ties), None);
    }

    #[test]
    fn smaller_of_two_contradictory_cycles_is_found() {
        let ties = [
            tie(0, 0, 1, true),
            tie(1, 1, 2, true),
            tie(2, 2, 3, true),
            tie(3, 3, 0, false),
            tie(4, 3, 4, true),
            tie(5, 4, 3, false),
        ];
        let seams: Vec<_> = smallest(5, &ties).unwrap().iter().map(|t| t.seam).collect();
        assert_eq!(seams, [Some(4), Some(5)]);
    }

    #[test]
    fn panel_that_differs_from_itself_is_a_cycle_of_one() {
        let ties = [tie(0, 0, 1, false), tie(1, 1, 1, false)];
        assert_eq!(smallest(2, &ties).unwrap(), [ties[1]]);
    }
}
