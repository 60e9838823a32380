//! Vertices that stitches make one, by union-find.

/// Returns the welded index of each of `count` vertices: the lowest vertex that stitches, in any
/// number of steps, hold it to. A vertex without a stitch is its own.
///
/// # Panics
/// If a stitch names a vertex that is not there.
pub(crate) fn weld(count: usize, stitches: &[[u32; 2]]) -> Vec<u32> {
    let mut classes = Classes::new(count);
    for &[a, b] in stitches {
        classes.unite(a, b);
    }
    classes.lowest()
}

/// A partition of indices that can only become coarser.
///
/// Each class is a tree whose root is its lowest index: paths are halved on the way (R. E. Tarjan,
/// J. van Leeuwen, J. ACM 31(2), 1984).
pub(crate) struct Classes {
    parent: Vec<u32>,
}

impl Classes {
    pub(crate) fn new(count: usize) -> Self {
        let count = u32::try_from(count).expect("meshes are indexed by 32 bits");
        Self {
            parent: (0..count).collect(),
        }
    }

    pub(crate) fn unite(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b) as usize] = a.min(b);
    }

    fn root(&mut self, mut index: u32) -> u32 {
        while self.parent[index as usize] != index {
            let above = self.parent[index as usize];
            self.parent[index as usize] = self.parent[above as usize];
            index = self.parent[index as usize];
        }
        index
    }

    /// Returns the lowest index of each index's class.
    pub(crate) fn lowest(mut self) -> Vec<u32> {
        for index in 0..self.parent.len() {
            // No parent is higher than its child, so it is a root by now.
            self.parent[index] = self.parent[self.parent[index] as usize];
        }
        self.parent
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_of_stitches_make_one_vertex() {
        let stitches = [[5, 4], [2, 7], [4, 2], [0, 1], [1, 0], [6, 6]];
        assert_eq!(weld(8, &stitches), [0, 0, 2, 3, 2, 2, 6, 2]);
    }

    #[test]
    fn order_of_stitches_does_not_matter() {
        let mut stitches: Vec<[u32; 2]> =
            (0..99).map(|i| [(i * 37) % 100, (i * 53) % 100]).collect();
        let forward = weld(100, &stitches);
        stitches.reverse();
        assert_eq!(weld(100, &stitches), forward);
    }
}
