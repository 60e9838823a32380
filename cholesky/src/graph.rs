//! The graph of a symmetric matrix: its rows are vertices, its entries off the diagonal edges.

/// Neighbors of each vertex.
pub(crate) struct Graph {
    start: Vec<usize>,
    neighbors: Vec<usize>,
}

impl Graph {
    /// Returns the graph of `count` vertices with an edge for each pair; a pair occurs once.
    pub(crate) fn from_pairs(
        count: usize,
        pairs: impl Iterator<Item = (usize, usize)> + Clone,
    ) -> Self {
        let mut start = vec![0; count + 1];
        for (a, b) in pairs.clone() {
            start[a + 1] += 1;
            start[b + 1] += 1;
        }
        for i in 0..count {
            start[i + 1] += start[i];
        }
        let mut next = start.clone();
        let mut neighbors = vec![0; start[count]];
        for (a, b) in pairs {
            neighbors[next[a]] = b;
            neighbors[next[b]] = a;
            next[a] += 1;
            next[b] += 1;
        }
        Self { start, neighbors }
    }

    pub(crate) fn vertex_count(&self) -> usize {
        self.start.len() - 1
    }

    pub(crate) fn neighbors(&self, v: usize) -> &[usize] {
        &self.neighbors[self.start[v]..self.start[v + 1]]
    }
}
