//! Boxes that overlap: a balanced tree of bounding boxes.

/// Boxes of a leaf: so few are tested one by one faster than split.
const LEAF_LEN: usize = 4;

/// A closed box with sides along the axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    min: [f32; 3],
    max: [f32; 3],
}

impl Bounds {
    /// Returns the smallest box about the points.
    pub(crate) fn of(points: &[[f32; 3]]) -> Self {
        let mut bounds = Self {
            min: [f32::INFINITY; 3],
            max: [f32::NEG_INFINITY; 3],
        };
        for point in points {
            bounds.include(&Self {
                min: *point,
                max: *point,
            });
        }
        bounds
    }

    fn include(&mut self, other: &Self) {
        for k in 0..3 {
            self.min[k] = self.min[k].min(other.min[k]);
            self.max[k] = self.max[k].max(other.max[k]);
        }
    }

    /// Returns true if the boxes have a common point.
    fn overlaps(&self, other: &Self) -> bool {
        // Without branches: which side parts two boxes cannot be foreseen.
        (0..3).fold(true, |overlap, k| {
            overlap & (self.min[k] <= other.max[k]) & (other.min[k] <= self.max[k])
        })
    }

    /// Twice the coordinate of the center, in double precision: it cannot overflow.
    fn twice_center(&self, axis: usize) -> f64 {
        f64::from(self.min[axis]) + f64::from(self.max[axis])
    }

    fn longest_axis(&self) -> usize {
        let length = |k: usize| f64::from(self.max[k]) - f64::from(self.min[k]);
        let longer = |a: usize, b: usize| if length(b) > length(a) { b } else { a };
        longer(longer(0, 1), 2)
    }
}

/// A part of the boxes and the box about them.
#[derive(Clone, Copy, Debug)]
struct TreeNode {
    bounds: Bounds,
    /// First of the node's items, of which there are none unless it is a leaf.
    first: u32,
    item_count: u32,
    /// First node that is not below this one.
    next: u32,
}

/// Boxes, halved along the longest side again and again: depth and memory are bounded by their
/// count, wherever they lie. The same boxes make the same tree.
#[derive(Debug)]
pub(crate) struct BoxTree {
    /// Parents before their children, which follow in order: a walk needs no stack.
    nodes: Vec<TreeNode>,
    items: Vec<(Bounds, u32)>,
}

impl BoxTree {
    pub(crate) fn new(bounds: &[Bounds]) -> Self {
        let mut items: Vec<_> = bounds.iter().copied().zip(0..).collect();
        let mut nodes = Vec::with_capacity(items.len());
        if !items.is_empty() {
            split(&mut items, 0, &mut nodes);
        }
        Self { nodes, items }
    }

    /// Calls `visit` with the index of every box that has a point in common with `bounds`.
    pub(crate) fn visit(&self, bounds: &Bounds, mut visit: impl FnMut(u32)) {
        let mut index = 0;
        while let Some(node) = self.nodes.get(index) {
            if !node.bounds.overlaps(bounds) {
                index = node.next as usize;
                continue;
            }
            let first = node.first as usize;
            for (item, name) in &self.items[first..first + node.item_count as usize] {
                if item.overlaps(bounds) {
                    visit(*name);
                }
            }
            index += 1;
        }
    }
}

/// Adds the node of `items`, the first of which is item `first` of all, and those below it.
fn split(items: &mut [(Bounds, u32)], first: u32, nodes: &mut Vec<TreeNode>) {
    let mut bounds = items[0].0;
    for (item, _) in &items[1..] {
        bounds.include(item);
    }
    let index = nodes.len();
    nodes.push(TreeNode {
        bounds,
        first,
        item_count: 0,
        next: 0,
    });
    if items.len() <= LEAF_LEN {
        nodes[index].item_count = length(items.len());
    } else {
        let axis = bounds.longest_axis();
        let middle = items.len() / 2;
        items.select_nth_unstable_by(middle, |(a, i), (b, j)| {
            let centers = a.twice_center(axis).total_cmp(&b.twice_center(axis));
            centers.then(i.cmp(j))
        });
        let (low, high) = items.split_at_mut(middle);
        split(low, first, nodes);
        split(high, first + length(middle), nodes);
    }
    nodes[index].next = length(nodes.len());
}

fn length(count: usize) -> u32 {
    u32::try_from(count).expect("as many as triangles, which are indexed by 32 bits")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::random::Random;

    /// Returns the boxes that overlap `query`, ascending, by trying each.
    fn try_each(boxes: &[Bounds], query: &Bounds) -> Vec<u32> {
        let overlapping = boxes.iter().zip(0..).filter(|(b, _)| b.overlaps(query));
        overlapping.map(|(_, i)| i).collect()
    }

    #[test]
    fn every_overlap_is_visited_once() {
        let mut random = Random::new(1);
        for (count, extent) in [
            (0, 9),
            (1, 9),
            (4, 9),
            (5, 9),
            (300, 0),
            (300, 3),
            (999, 30),
        ] {
            let corners: Vec<_> = (0..3 * count).map(|_| random.point(extent)).collect();
            let boxes: Vec<_> = corners.chunks(3).map(Bounds::of).collect();
            let tree = BoxTree::new(&boxes);
            for query in &boxes {
                let mut visited = vec![];
                tree.visit(query, |i| visited.push(i));
                visited.sort_unstable();
                assert_eq!(visited, try_each(&boxes, query));
            }
        }
    }

    #[test]
    fn boxes_that_only_touch_overlap() {
        let low = Bounds::of(&[[0.0; 3], [1.0; 3]]);
        assert!(low.overlaps(&Bounds::of(&[[1.0; 3], [2.0; 3]])));
        assert!(!low.overlaps(&Bounds::of(&[[1.0, 1.0, 1.0 + f32::EPSILON], [2.0; 3]])));
    }
}
