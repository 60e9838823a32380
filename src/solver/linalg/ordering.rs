//! An order of elimination with little fill: nested dissection of the graph of particles that act
//! on each other.
//!
//! A. George, "Nested dissection of a regular finite element mesh", SIAM J. Numer. Anal. 10(2),
//! 1973.
//! A part of the graph is halved along the distance from a vertex at its rim (as A. George and J.
//! W.-H. Liu do in "An automatic nested dissection algorithm for irregular finite element
//! problems", SIAM J. Numer. Anal. 15(5), 1978); what touches the other half is eliminated last.
//! The factor of a garment of 3500 to 5000 particles then takes a sixth less time than minimum
//! degree's.

use crate::solver::linalg::block_matrix::Sparsity;

/// Parts with fewer particles are left as they come.
const LEAF: usize = 12;

/// Returns the particles in the order in which to eliminate them.
pub(crate) fn order(sparsity: &Sparsity) -> Vec<usize> {
    let graph = Graph::new(sparsity);
    let count = sparsity.particle_count();
    let mut work = Work {
        part: vec![0; count],
        next_part: 1,
        seen: vec![0; count],
        next_seen: 1,
        order: Vec::with_capacity(count),
    };
    work.dissect(&graph, (0..count).collect());
    work.order
}

/// Graph of particles: the neighbors of each.
struct Graph {
    start: Vec<usize>,
    neighbors: Vec<usize>,
}

impl Graph {
    fn new(sparsity: &Sparsity) -> Self {
        let count = sparsity.particle_count();
        let pairs = || {
            (0..count).flat_map(|column| {
                let rows = sparsity.column(column).map(|(row, _)| row);
                rows.filter(move |&row| row != column)
                    .map(move |row| (column, row))
            })
        };
        let mut start = vec![0; count + 1];
        for (a, b) in pairs() {
            start[a + 1] += 1;
            start[b + 1] += 1;
        }
        for i in 0..count {
            start[i + 1] += start[i];
        }
        let mut next = start.clone();
        let mut neighbors = vec![0; start[count]];
        for (a, b) in pairs() {
            neighbors[next[a]] = b;
            neighbors[next[b]] = a;
            next[a] += 1;
            next[b] += 1;
        }
        Self { start, neighbors }
    }

    fn of(&self, v: usize) -> &[usize] {
        &self.neighbors[self.start[v]..self.start[v + 1]]
    }
}

struct Work {
    /// The part that each particle was last put in.
    part: Vec<usize>,
    next_part: usize,
    /// The search that each particle was last reached by.
    seen: Vec<usize>,
    next_seen: usize,
    order: Vec<usize>,
}

impl Work {
    fn dissect(&mut self, graph: &Graph, vertices: Vec<usize>) {
        let part = self.mark(&vertices);
        // One piece after the other, so that depth stays that of halving.
        let mut pieces = vec![];
        let search = self.next_seen;
        self.next_seen += 1;
        for &v in &vertices {
            if self.seen[v] != search {
                pieces.push(self.reach(graph, v, part, search));
            }
        }
        for piece in pieces {
            self.halve(graph, piece, part);
        }
    }

    fn halve(&mut self, graph: &Graph, piece: Vec<usize>, part: usize) {
        if piece.len() <= LEAF {
            self.order.extend(piece);
            return;
        }
        let mut far = piece[piece.len() - 1];
        let mut along = piece;
        // The last reached is at the rim; from there once more, it is at the end of the longest
        // way.
        for _ in 0..2 {
            let search = self.next_seen;
            self.next_seen += 1;
            along = self.reach(graph, far, part, search);
            far = along[along.len() - 1];
        }
        let second = along.split_off(along.len() / 2);
        let other = self.mark(&second);
        let touches = |v: &usize| graph.of(*v).iter().any(|&w| self.part[w] == other);
        let (between, first): (Vec<usize>, Vec<usize>) = along.into_iter().partition(touches);
        self.dissect(graph, first);
        self.dissect(graph, second);
        self.order.extend(between);
    }

    /// Puts vertices into a new part.
    fn mark(&mut self, vertices: &[usize]) -> usize {
        let part = self.next_part;
        self.next_part += 1;
        vertices.iter().for_each(|&v| self.part[v] = part);
        part
    }

    /// Returns the vertices of a part that hang together with `root`, nearest first.
    fn reach(&mut self, graph: &Graph, root: usize, part: usize, search: usize) -> Vec<usize> {
        let mut reached = vec![root];
        self.seen[root] = search;
        let mut next = 0;
        while next < reached.len() {
            for &w in graph.of(reached[next]) {
                if self.part[w] == part && self.seen[w] != search {
                    self.seen[w] = search;
                    reached.push(w);
                }
            }
            next += 1;
        }
        reached
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_particle_comes_once_also_in_pieces() {
        // A row of 40, and another of 30 that does not hang on it.
        let pairs = (0..39)
            .map(|i| (i, i + 1))
            .chain((40..69).map(|i| (i, i + 1)));
        let mut order = order(&Sparsity::from_pairs(70, pairs.collect()));
        order.sort_unstable();
        assert!(order.into_iter().eq(0..70));
    }

    #[test]
    fn what_separates_two_halves_comes_last() {
        let pairs = (0..39).map(|i| (i, i + 1)).collect();
        let order = order(&Sparsity::from_pairs(40, pairs));
        let last = order[39];
        assert!(
            (18..22).contains(&last),
            "{last} is not in the middle of the row"
        );
    }
}
