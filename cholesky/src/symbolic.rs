//! Symbolic factorization: the front of each part of the graph, and the place of everything in it.
//!
//! A front (I. S. Duff, J. K. Reid, "The multifrontal solution of indefinite sparse symmetric
//! linear systems", ACM TOMS 9(3), 1983) is the dense matrix of the vertices of one part, its own,
//! and of those later ones that the part and its children touch, which are below. Its own columns
//! become columns of the factor; what they contribute to the rest is added to the front of the
//! parent.

use crate::dissection::Part;
use crate::graph::Graph;
use crate::tiles::{TILE_VERTICES, tile_count, triangle_len};
use std::ops::Range;

/// Front of one part.
#[derive(Clone, Debug)]
pub(crate) struct Front {
    /// Its own vertices, by their rank in the order of elimination.
    pub(crate) own: Range<usize>,
    /// Ranks of the vertices below, ascending.
    pub(crate) below: Vec<usize>,
    /// Vertices below, as rows and columns of its contribution to the parent.
    pub(crate) contribution: Vec<ContributionVertex>,
    /// Fronts that contribute to this one.
    pub(crate) children: Vec<usize>,
    /// First of the fronts that contribute to it, directly or by others: they lie between that one
    /// and this.
    pub(crate) first_descendant: usize,
    /// Columns of the factor that begin with this one.
    pub(crate) panel: usize,
    /// True if it is an odd number of steps below a root: the contributions of such fronts lie on
    /// another stack than those of their parents and children.
    pub(crate) is_odd: bool,
    /// Start of its contribution to the parent on that stack.
    pub(crate) stack: usize,
    /// Entries of the matrix in its own columns.
    pub(crate) entries: Range<usize>,
}

/// A vertex below a front, as a row and a column of the contribution to the parent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContributionVertex {
    /// Place in the front of the parent: first its own vertices, then those below.
    pub(crate) place: usize,
    /// Place in the tile of the parent.
    pub(crate) in_tile: usize,
    /// Start of its tile row in the panel of the parent.
    pub(crate) in_panel: usize,
    /// Start of its tile row in the update of the parent, if it is below that too.
    pub(crate) in_update: usize,
}

/// An entry of the matrix: one block, and its place in a panel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry {
    /// Index among the blocks of the matrix.
    pub(crate) block: usize,
    /// First of its three columns in the panel.
    pub(crate) column: usize,
    /// Its place in the tile.
    pub(crate) in_tile: usize,
    /// True if the panel holds the transpose of the block.
    pub(crate) is_transposed: bool,
}

/// All fronts, children first.
#[derive(Clone, Debug)]
pub(crate) struct Symbolic {
    /// Vertices in the order of elimination.
    pub(crate) order: Vec<usize>,
    pub(crate) fronts: Vec<Front>,
    pub(crate) entries: Vec<Entry>,
    /// Tile columns of the factor.
    pub(crate) factor_len: usize,
    /// Tile columns that lie on the even and on the odd stack at most.
    pub(crate) stack_len: [usize; 2],
}

impl Front {
    /// Returns the number of its own scalar columns.
    pub(crate) fn columns(&self) -> usize {
        3 * self.own.len()
    }

    /// Returns the multiplications and additions of its factorization, in pairs.
    pub(crate) fn multiply_adds(&self) -> f64 {
        let (own, below) = (self.columns() as f64, 3.0 * self.below.len() as f64);
        own * own * own / 3.0 + own * own * below + own * below * below
    }

    /// Returns the tile rows of its own vertices, and of those below.
    pub(crate) fn tile_rows(&self) -> [usize; 2] {
        [tile_count(self.own.len()), tile_count(self.below.len())]
    }

    /// Returns the tile columns of its panel.
    pub(crate) fn panel_len(&self) -> usize {
        let [own, below] = self.tile_rows();
        (own + below) * self.columns()
    }

    /// Returns the tile columns of its contribution to the parent.
    pub(crate) fn update_len(&self) -> usize {
        triangle_len(tile_count(self.below.len()))
    }

    /// Returns the tile row of a vertex of the front in the panel, and its place in the tile.
    fn tile_of(&self, place: usize) -> (usize, usize) {
        let own = self.own.len();
        let (first, vertex) = if place < own {
            (0, place)
        } else {
            (tile_count(own), place - own)
        };
        (first + vertex / TILE_VERTICES, vertex % TILE_VERTICES)
    }

    /// Returns the place of a vertex below a child of this front, of this rank.
    fn contribution_vertex(&self, rank: usize) -> ContributionVertex {
        let place = self.place_of(rank);
        let (tile, in_tile) = self.tile_of(place);
        let own_tiles = self.tile_rows()[0];
        ContributionVertex {
            place,
            in_tile,
            in_panel: tile * self.columns(),
            in_update: tile.checked_sub(own_tiles).map_or(0, triangle_len),
        }
    }

    /// Returns the place of the vertex of this rank.
    fn place_of(&self, rank: usize) -> usize {
        if self.own.contains(&rank) {
            return rank - self.own.start;
        }
        let below = self.below.binary_search(&rank);
        self.own.len() + below.expect("a front holds what its part and its children touch")
    }
}

impl Symbolic {
    /// Returns the multiplications and additions of a numeric factorization, in pairs: the squares
    /// of the lengths of all columns of the factor.
    pub(crate) fn multiply_adds(&self) -> f64 {
        self.fronts.iter().map(Front::multiply_adds).sum()
    }

    /// Returns the fronts that the factorization of one needs, and that one.
    pub(crate) fn subtree(&self, front: usize) -> Range<usize> {
        self.fronts[front].first_descendant..front + 1
    }

    /// Analyzes the lower triangle of a matrix whose graph was dissected into `parts`.
    pub(crate) fn new(
        (column_start, rows): (&[usize], &[usize]),
        graph: &Graph,
        parts: &[Part],
    ) -> Self {
        let order: Vec<usize> = parts
            .iter()
            .flat_map(|part| part.vertices.iter().copied())
            .collect();
        let mut rank = vec![0; order.len()];
        for (i, &v) in order.iter().enumerate() {
            rank[v] = i;
        }
        let mut symbolic = Self {
            fronts: fronts(graph, parts, &order, &rank),
            order,
            entries: Vec::with_capacity(rows.len()),
            factor_len: 0,
            stack_len: [0; 2],
        };
        symbolic.place_in_parents(parts);
        symbolic.lay_out();
        symbolic.find_entries(column_start, rows, &rank);
        symbolic
    }

    fn place_in_parents(&mut self, parts: &[Part]) {
        // Parents come last.
        for (i, part) in parts.iter().enumerate().rev() {
            let Some(parent) = part.parent else { continue };
            self.fronts[i].is_odd = !self.fronts[parent].is_odd;
            let below = self.fronts[i].below.iter();
            self.fronts[i].contribution = below
                .map(|&rank| self.fronts[parent].contribution_vertex(rank))
                .collect();
        }
    }

    /// Gives every panel its place in the factor, and every contribution one on its stack.
    fn lay_out(&mut self) {
        let mut top = [0, 0];
        for i in 0..self.fronts.len() {
            let first_child = self.fronts[i].children.first();
            let freed = first_child.map(|&child| self.fronts[child].stack);
            let front = &mut self.fronts[i];
            let [mine, other] = [front.is_odd, !front.is_odd].map(usize::from);
            front.panel = self.factor_len;
            self.factor_len += front.panel_len();
            front.stack = top[mine];
            top[mine] += front.update_len();
            self.stack_len[mine] = self.stack_len[mine].max(top[mine]);
            if let Some(freed) = freed {
                top[other] = freed;
            }
        }
    }

    fn find_entries(&mut self, column_start: &[usize], rows: &[usize], rank: &[usize]) {
        let mut front_of = vec![0; rank.len()];
        for (i, front) in self.fronts.iter().enumerate() {
            front_of[front.own.clone()].fill(i);
        }
        let mut by_front: Vec<Vec<Entry>> = vec![Vec::new(); self.fronts.len()];
        for column in 0..rank.len() {
            for block in column_start[column]..column_start[column + 1] {
                let (row, column) = (rank[rows[block]], rank[column]);
                let (first, last) = (row.min(column), row.max(column));
                let front = &self.fronts[front_of[first]];
                let (tile, in_tile) = front.tile_of(front.place_of(last));
                by_front[front_of[first]].push(Entry {
                    block,
                    column: tile * front.columns() + 3 * (first - front.own.start),
                    in_tile,
                    is_transposed: row < column,
                });
            }
        }
        for (front, entries) in self.fronts.iter_mut().zip(by_front) {
            let start = self.entries.len();
            self.entries.extend(entries);
            front.entries = start..self.entries.len();
        }
    }
}

/// Returns the fronts with their vertices.
fn fronts(graph: &Graph, parts: &[Part], order: &[usize], rank: &[usize]) -> Vec<Front> {
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); parts.len()];
    for (i, part) in parts.iter().enumerate() {
        if let Some(parent) = part.parent {
            children[parent].push(i);
        }
    }
    let mut fronts: Vec<Front> = Vec::with_capacity(parts.len());
    let mut start = 0;
    for (part, children) in parts.iter().zip(children) {
        let own = start..start + part.vertices.len();
        start = own.end;
        let touched = order[own.clone()]
            .iter()
            .flat_map(|&v| graph.neighbors(v))
            .map(|&v| rank[v]);
        let inherited = children
            .iter()
            .flat_map(|&child| fronts[child].below.iter().copied());
        let mut below: Vec<usize> = touched
            .chain(inherited)
            .filter(|&rank| rank >= own.end)
            .collect();
        below.sort_unstable();
        below.dedup();
        let first_child = children.first();
        fronts.push(Front {
            own,
            below,
            contribution: Vec::new(),
            first_descendant: first_child
                .map_or(fronts.len(), |&child| fronts[child].first_descendant),
            children,
            panel: 0,
            is_odd: false,
            stack: 0,
            entries: 0..0,
        });
    }
    fronts
}
