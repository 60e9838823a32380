//! Triangles that segments meet.

use crate::limits::{PairsLeft, TooManyPairs};
use crate::predicates;
use crate::surface::Surface;
use crate::tree::{Bounds, BoxTree};

/// A surface that many segments are held against.
#[derive(Debug)]
pub struct SegmentSearch<'a> {
    surface: &'a Surface<'a>,
    tree: BoxTree,
    left: PairsLeft,
}

impl<'a> SegmentSearch<'a> {
    /// Prepares the search, in which `pairs` of a segment and a triangle whose boxes overlap may be
    /// looked at.
    pub fn new(surface: &'a Surface<'a>, pairs: usize) -> Self {
        Self {
            surface,
            tree: BoxTree::new(&surface.bounds()),
            left: PairsLeft(pairs),
        }
    }

    /// Returns the triangles that a segment meets, exactly, each with a common point, which is
    /// rounded; ascending.
    ///
    /// # Errors
    /// [`TooManyPairs`] if the limit of pairs does not do.
    pub fn meeting(&mut self, ends: [[f32; 3]; 2]) -> Result<Vec<(u32, [f64; 3])>, TooManyPairs> {
        let mut near = vec![];
        self.tree.visit(&Bounds::of(&ends), |t| near.push(t));
        self.left.take(near.len())?;
        near.sort_unstable();
        let ends = ends.map(|end| end.map(f64::from));
        let meeting = |t: u32| {
            let point = predicates::point_on_segment(ends, &self.surface.corners(t));
            point.map(|point| (t, point))
        };
        Ok(near.into_iter().filter_map(meeting).collect())
    }
}
