//! Cloth against a body.

use crate::limits::{PairsLeft, TooManyPairs};
use crate::predicates::{self, EDGES, Point};
use crate::report::{Crossing, CrossingList};
use crate::surface::Surface;
use crate::tree::{Bounds, BoxTree};
use crate::weld::Classes;
use crate::winding::{is_closed, winding_number};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Faults of cloth on a body.
#[derive(Default)]
pub(crate) struct BodyFaults {
    pub(crate) crossings: CrossingList,
    pub(crate) inside: Vec<u32>,
}

/// Finds where cloth and body meet, and the vertices of cloth inside the body.
///
/// # Errors
/// [`TooManyPairs`] if more pairs have to be looked at than are left.
pub(crate) fn find(
    cloth: &Surface<'_>,
    body: &Surface<'_>,
    kept: usize,
    left: &mut PairsLeft,
) -> Result<BodyFaults, TooManyPairs> {
    let contact = BodyContact::new(cloth, body, left)?;
    let is_inside = contact.find_inside(left)?;
    let mut crossings = CrossingList::default();
    for &t in &contact.touching {
        let corners = cloth.triangles()[t as usize];
        if !corners.iter().all(|v| is_inside[*v as usize]) {
            contact.list_crossings(t, &mut crossings, kept);
        }
    }
    let inside = (0..).zip(&is_inside).filter(|(_, inside)| **inside);
    Ok(BodyFaults {
        crossings,
        inside: inside.map(|(v, _)| v).collect(),
    })
}

/// The parts of cloth that meet the body.
struct BodyContact<'a> {
    cloth: &'a Surface<'a>,
    body: &'a Surface<'a>,
    bounds: Vec<Bounds>,
    tree: BoxTree,
    /// Triangles that meet the body, ascending.
    touching: Vec<u32>,
    /// Edges that meet the body, by their ends, ascending.
    cut_edges: Vec<[u32; 2]>,
    is_on_wall: Vec<bool>,
}

impl<'a> BodyContact<'a> {
    fn new(
        cloth: &'a Surface<'a>,
        body: &'a Surface<'a>,
        left: &mut PairsLeft,
    ) -> Result<Self, TooManyPairs> {
        let mut contact = Self {
            cloth,
            body,
            bounds: cloth.bounds(),
            tree: BoxTree::new(&body.bounds()),
            touching: vec![],
            cut_edges: vec![],
            is_on_wall: vec![false; cloth.positions().len()],
        };
        for t in 0..cloth.triangle_count() {
            let near = contact.near(t);
            left.take(near.len())?;
            let walls = contact.walls(t, &near);
            if !walls.is_empty() {
                contact.touching.push(t);
                contact.mark(t, &walls);
            }
        }
        contact.cut_edges.sort_unstable();
        contact.cut_edges.dedup();
        Ok(contact)
    }

    /// Returns the body triangles whose boxes overlap that of a cloth triangle, ascending.
    fn near(&self, triangle: u32) -> Vec<u32> {
        let mut near = vec![];
        self.tree
            .visit(&self.bounds[triangle as usize], |wall| near.push(wall));
        near.sort_unstable();
        near
    }

    /// Returns those of the body triangles `near` that a cloth triangle meets, each with a place.
    fn walls(&self, triangle: u32, near: &[u32]) -> Vec<(u32, Point)> {
        let corners = self.cloth.corners(triangle);
        let meeting = |&wall: &u32| {
            let point = predicates::common_point(&corners, &self.body.corners(wall));
            point.map(|point| (wall, point))
        };
        near.iter().filter_map(meeting).collect()
    }

    /// Marks the edges and corners of a cloth triangle that meet one of the walls.
    fn mark(&mut self, triangle: u32, walls: &[(u32, Point)]) {
        let names = self.cloth.triangles()[triangle as usize];
        let corners = self.cloth.corners(triangle);
        let meets = |ends: [Point; 2]| {
            let mut walls = walls.iter().map(|(wall, _)| self.body.corners(*wall));
            walls.any(|wall| predicates::point_on_segment(ends, &wall).is_some())
        };
        for [i, j] in EDGES {
            if meets([corners[i], corners[j]]) {
                self.cut_edges.push(ascending([names[i], names[j]]));
            }
        }
        for (v, corner) in names.into_iter().zip(corners) {
            if meets([corner; 2]) {
                self.is_on_wall[v as usize] = true;
            }
        }
    }

    /// Returns for each vertex if it is inside the body; false for those of no triangle.
    ///
    /// Winding numbers about a closed body change at its surface only, so one vertex decides for
    /// all that it reaches along edges that do not meet the body.
    fn find_inside(&self, left: &mut PairsLeft) -> Result<Vec<bool>, TooManyPairs> {
        let mut is_inside = vec![false; self.cloth.positions().len()];
        let parts = self.parts();
        let mut decided = BTreeMap::new();
        for v in self.cloth.triangles().iter().flatten() {
            let part = parts[*v as usize];
            is_inside[*v as usize] = match decided.entry(part) {
                Entry::Occupied(entry) => *entry.get(),
                Entry::Vacant(entry) => {
                    left.take(self.body.triangles().len())?;
                    *entry.insert(self.is_inside(part))
                }
            };
        }
        Ok(is_inside)
    }

    /// Returns for each vertex the lowest one that it reaches without meeting the body.
    fn parts(&self) -> Vec<u32> {
        let mut parts = Classes::new(self.cloth.positions().len());
        if is_closed(self.body) {
            for names in self.cloth.triangles() {
                for edge in EDGES.map(|[i, j]| ascending([names[i], names[j]])) {
                    if self.cut_edges.binary_search(&edge).is_err() {
                        parts.unite(edge[0], edge[1]);
                    }
                }
            }
        }
        for (v, &w) in (0..).zip(self.cloth.welded()) {
            if self.cloth.point(v) == self.cloth.point(w) {
                parts.unite(v, w);
            }
        }
        parts.lowest()
    }

    fn is_inside(&self, vertex: u32) -> bool {
        let winding_number = winding_number(self.body, &self.cloth.point(vertex));
        // On a wall it is the mean of what is around: between 0 and 1 on the hull, 1 or more on
        // walls inside of it. The margin is for rounding.
        let least = if self.is_on_wall[vertex as usize] {
            1.0 - 1e-6
        } else {
            0.5
        };
        winding_number >= least
    }

    /// Finds the walls a second time: to keep them would take memory for every crossing.
    fn list_crossings(&self, triangle: u32, list: &mut CrossingList, kept: usize) {
        for (wall, point) in self.walls(triangle, &self.near(triangle)) {
            let triangles = [triangle, wall];
            list.push(Crossing { triangles, point }, kept);
        }
    }
}

fn ascending([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
