//! Pairs of boxes that overlap, by a balanced tree of boxes whose shape stays while they move.

use nalgebra::Vector3;
use std::ops::ControlFlow;

/// A closed box with sides along the axes \[m\].
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    low: Vector3<f64>,
    high: Vector3<f64>,
}

impl Bounds {
    /// Returns the box about two points, `margin` wider on every side.
    pub(super) fn about(a: &Vector3<f64>, b: &Vector3<f64>, margin: f64) -> Self {
        Self {
            low: a.inf(b).add_scalar(-margin),
            high: a.sup(b).add_scalar(margin),
        }
    }

    /// Returns a box `margin` wider on every side \[m\].
    pub(super) fn wider(&self, margin: f64) -> Self {
        Self {
            low: self.low.add_scalar(-margin),
            high: self.high.add_scalar(margin),
        }
    }

    pub(super) fn with(&self, other: &Self) -> Self {
        Self {
            low: self.low.inf(&other.low),
            high: self.high.sup(&other.high),
        }
    }

    pub(super) fn overlaps(&self, other: &Self) -> bool {
        (0..3).fold(true, |overlap, k| {
            overlap & (self.low[k] <= other.high[k]) & (other.low[k] <= self.high[k])
        })
    }

    pub(super) fn contains(&self, point: &Vector3<f64>) -> bool {
        (0..3).fold(true, |inside, k| {
            inside & (self.low[k] <= point[k]) & (point[k] <= self.high[k])
        })
    }
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Bounds,
    /// The item of a leaf.
    item: Option<u32>,
    /// The second child (the first one follows its parent).
    second: u32,
}

/// A tree over items, halved along the longest side of their first boxes.
#[derive(Clone, Debug, Default)]
pub(super) struct BoxTree {
    /// Parents before their children, those of fixed items last.
    nodes: Vec<Node>,
    /// The node of all fixed items; one past the end if there are none.
    fixed: usize,
}

impl BoxTree {
    /// Makes a tree of items with these boxes, the first `moving` of which are not fixed.
    pub(super) fn new(bounds: &[Bounds], moving: usize) -> Self {
        let count = u32::try_from(bounds.len()).expect("Limits bound triangles below 2^32");
        let mut items: Vec<(Bounds, u32)> = bounds.iter().copied().zip(0..count).collect();
        let mut nodes = Vec::with_capacity(2 * items.len());
        let (moving, still) = items.split_at_mut(moving);
        if !moving.is_empty() {
            split(moving, &mut nodes);
        }
        let fixed = nodes.len();
        if !still.is_empty() {
            split(still, &mut nodes);
        }
        Self { nodes, fixed }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Gives the items new boxes.
    pub(super) fn refit(&mut self, bounds: &[Bounds]) {
        for index in (0..self.nodes.len()).rev() {
            let node = self.nodes[index];
            self.nodes[index].bounds = match node.item {
                Some(item) => bounds[item as usize],
                None => {
                    let second = &self.nodes[node.second as usize].bounds;
                    self.nodes[index + 1].bounds.with(second)
                }
            };
        }
    }

    /// Calls `visit` with every pair of different items whose boxes overlap and that are not both
    /// fixed, always in the same order, until it breaks.
    pub(super) fn for_each_pair(
        &self,
        visit: &mut impl FnMut(u32, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        if self.fixed == 0 {
            return ControlFlow::Continue(());
        }
        self.pairs_within(0, visit)?;
        if self.fixed == self.nodes.len() {
            return ControlFlow::Continue(());
        }
        self.pairs_between(0, self.fixed, visit)
    }

    /// Calls `visit` with every item whose box overlaps `bounds`, always in the same order, until
    /// it breaks.
    pub(super) fn for_each_near(
        &self,
        bounds: &Bounds,
        visit: &mut impl FnMut(u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        if self.fixed > 0 {
            self.items_near(0, bounds, visit)?;
        }
        if self.fixed < self.nodes.len() {
            self.items_near(self.fixed, bounds, visit)?;
        }
        ControlFlow::Continue(())
    }

    fn items_near(
        &self,
        index: usize,
        bounds: &Bounds,
        visit: &mut impl FnMut(u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let node = &self.nodes[index];
        if !node.bounds.overlaps(bounds) {
            return ControlFlow::Continue(());
        }
        if let Some(item) = node.item {
            return visit(item);
        }
        self.items_near(index + 1, bounds, visit)?;
        self.items_near(node.second as usize, bounds, visit)
    }

    fn pairs_within(
        &self,
        index: usize,
        visit: &mut impl FnMut(u32, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let node = &self.nodes[index];
        if node.item.is_some() {
            return ControlFlow::Continue(());
        }
        let second = node.second as usize;
        self.pairs_within(index + 1, visit)?;
        self.pairs_within(second, visit)?;
        self.pairs_between(index + 1, second, visit)
    }

    fn pairs_between(
        &self,
        a: usize,
        b: usize,
        visit: &mut impl FnMut(u32, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let (first, second) = (&self.nodes[a], &self.nodes[b]);
        if !first.bounds.overlaps(&second.bounds) {
            return ControlFlow::Continue(());
        }
        match (first.item, second.item) {
            (Some(a), Some(b)) => visit(a, b),
            (None, _) => {
                self.pairs_between(a + 1, b, visit)?;
                self.pairs_between(first.second as usize, b, visit)
            }
            (Some(_), None) => {
                self.pairs_between(a, b + 1, visit)?;
                self.pairs_between(a, second.second as usize, visit)
            }
        }
    }
}

fn split(items: &mut [(Bounds, u32)], nodes: &mut Vec<Node>) {
    let bounds = items[1..]
        .iter()
        .fold(items[0].0, |sum, item| sum.with(&item.0));
    let index = nodes.len();
    nodes.push(Node {
        bounds,
        item: (items.len() == 1).then_some(items[0].1),
        second: 0,
    });
    if items.len() == 1 {
        return;
    }
    let axis = (bounds.high - bounds.low).imax();
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |(a, i), (b, j)| {
        let center = |bounds: &Bounds| bounds.low[axis] + bounds.high[axis];
        center(a).total_cmp(&center(b)).then(i.cmp(j))
    });
    let (low, high) = items.split_at_mut(middle);
    split(low, nodes);
    nodes[index].second = u32::try_from(nodes.len()).expect("twice the triangles, below 2^32");
    split(high, nodes);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes at pseudo-random places of a cube.
    fn boxes(seed: u64, count: usize) -> Vec<Bounds> {
        let mut state = seed;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / (1_u64 << 24) as f64
        };
        let mut make = || {
            let low = Vector3::new(random(), random(), random());
            Bounds::about(&low, &low.add_scalar(0.2 * random()), 0.01)
        };
        (0..count).map(|_| make()).collect()
    }

    fn found(tree: &BoxTree) -> Vec<(u32, u32)> {
        let mut pairs = vec![];
        let flow = tree.for_each_pair(&mut |a, b| {
            pairs.push((a.min(b), a.max(b)));
            ControlFlow::Continue(())
        });
        assert!(flow.is_continue());
        pairs.sort_unstable();
        pairs
    }

    fn tried(boxes: &[Bounds], moving: usize) -> Vec<(u32, u32)> {
        let count = u32::try_from(boxes.len()).expect("few");
        let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
        pairs
            .filter(|&(a, _)| (a as usize) < moving)
            .filter(|&(a, b)| boxes[a as usize].overlaps(&boxes[b as usize]))
            .collect()
    }

    #[test]
    fn every_overlapping_pair_is_visited_once_also_after_the_boxes_moved() {
        for (count, moving) in [
            (0, 0),
            (1, 1),
            (2, 2),
            (3, 3),
            (200, 200),
            (200, 90),
            (9, 0),
        ] {
            let first = boxes(1, count);
            let mut tree = BoxTree::new(&first, moving);
            assert_eq!(found(&tree), tried(&first, moving));
            let second = boxes(2, count);
            tree.refit(&second);
            assert_eq!(found(&tree), tried(&second, moving));
        }
    }

    #[test]
    fn items_near_a_box_are_those_that_overlap_it() {
        for (count, moving) in [(0, 0), (1, 1), (200, 90), (200, 200), (9, 0)] {
            let items = boxes(1, count);
            let tree = BoxTree::new(&items, moving);
            for bounds in boxes(3, 20) {
                let mut found = vec![];
                let flow = tree.for_each_near(&bounds, &mut |item| {
                    found.push(item as usize);
                    ControlFlow::Continue(())
                });
                found.sort_unstable();
                let overlapping = (0..count).filter(|&i| items[i].overlaps(&bounds));
                assert!(flow.is_continue() && overlapping.eq(found));
            }
        }
    }

    #[test]
    fn a_walk_ends_where_it_is_broken_off() {
        let tree = BoxTree::new(&[Bounds::about(&Vector3::x(), &Vector3::y(), 0.0); 9], 9);
        let mut visited = 0;
        let flow = tree.for_each_pair(&mut |_, _| {
            visited += 1;
            if visited == 5 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        assert!(flow.is_break() && visited == 5);
    }
}
