//! Union-find with parity over panels that have the same face out or opposite ones, as far as seams
//! tell.

/// Relation between the faces of two panels: the same (`same`) or opposite.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct FaceRelation {
    /// The two panels.
    pub ends: [usize; 2],
    /// True if their faces are the same.
    pub same: bool,
}

/// Sets of panels whose faces are known relative to one another.
#[derive(Clone, Debug)]
pub(super) struct ParityUnionFind {
    /// Parent of each, and whether it has the same face as its parent.
    parent: Vec<(usize, bool)>,
}

impl ParityUnionFind {
    /// `count` panels of which nothing is known.
    pub(super) fn new(count: usize) -> Self {
        Self {
            parent: (0..count).map(|i| (i, true)).collect(),
        }
    }

    /// Returns the head of the set that `i` is in, and true if `i` has the same face as the head.
    pub(super) fn find(&mut self, i: usize) -> (usize, bool) {
        let (mut head, mut same) = (i, true);
        while self.parent[head].0 != head {
            let (next, next_same) = self.parent[head];
            same = same == next_same;
            head = next;
        }
        self.parent[i] = (head, same);
        (head, same)
    }

    /// Adds `relation`; returns false, and adds nothing, if it contradicts what is known.
    pub(super) fn join(&mut self, relation: FaceRelation) -> bool {
        let [(head_a, same_a), (head_b, same_b)] = relation.ends.map(|end| self.find(end));
        let heads_same = (same_a == same_b) == relation.same;
        if head_a != head_b {
            self.parent[head_a.max(head_b)] = (head_a.min(head_b), heads_same);
            return true;
        }
        heads_same
    }

    /// Adds all of `relations`; returns false if any contradicts what is known. Those that do not
    /// are added all the same.
    pub(super) fn join_all(&mut self, relations: &[FaceRelation]) -> bool {
        let mut fits = true;
        for relation in relations {
            fits &= self.join(*relation);
        }
        fits
    }

    /// Returns true if all of `relations` fit what is known and each other.
    pub(super) fn fits(&self, relations: &[FaceRelation]) -> bool {
        self.clone().join_all(relations)
    }
}
