//! The results of a judgment.

/// Two triangles that meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The two triangles: of cloth, ascending, or one of cloth and one of the body or of the other
    /// surface.
    pub triangles: [u32; 2],
    /// A place to mark: a common point, rounded, or where the two are in one plane a point amid
    /// them. In the unit of the positions.
    pub point: [f64; 3],
}

/// Crossings: all of them counted, the first ones kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CrossingList {
    /// Count of crossings.
    pub count: usize,
    /// The first that were found, as many as were asked for, always in the same order.
    pub kept: Vec<Crossing>,
}

impl CrossingList {
    pub(crate) fn push(&mut self, crossing: Crossing, most: usize) {
        self.count += 1;
        if self.kept.len() < most {
            self.kept.push(crossing);
        }
    }
}

/// Faults of a garment's surface; see [`find_crossings`](crate::find_crossings) for the rules.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CrossingReport {
    /// Pairs of cloth triangles that meet.
    pub cloth: CrossingList,
    /// Cloth triangles without area, or with two corners stitched to one another; ascending.
    pub degenerate: Vec<u32>,
    /// Pairs of a cloth triangle and a body triangle that meet.
    pub body: CrossingList,
    /// Cloth vertices inside the body, ascending.
    pub inside: Vec<u32>,
}
