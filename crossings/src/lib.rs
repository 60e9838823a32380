//! The judge of a garment: which of its triangles meet one another or the body, decided exactly.
//!
//! It knows nothing of the solver and of contact, so that it can tell when they fail. It judges
//! what is written out: single-precision positions and the triangles between them.
//!
//! # Guarantees
//! - **Exact**: whether two triangles meet, whether one has no area, and where winding numbers can
//!   change are decided by signs that rounding cannot turn ([`robust`]). No tolerance is used.
//! - **Rounded**: [`Crossing::point`], and the winding numbers, which are compared with numbers far
//!   from all that they can be.
//! - **Same input, same output**, on one thread.
//! - **Memory** grows with the triangles, not with the crossings. **Time** grows with `n log n` and
//!   the pairs of triangles whose boxes overlap, which [`SearchLimits`] bound.

mod between;
mod body;
mod cloth;
mod limits;
mod predicates;
mod report;
mod segments;
mod surface;
#[cfg(test)]
mod tests;
mod tree;
mod weld;
mod winding;

pub use between::find_crossings_between;
pub use limits::{SearchLimits, TooManyPairs};
pub use report::{Crossing, CrossingList, CrossingReport};
pub use segments::SegmentSearch;
pub use surface::{Surface, SurfaceError};

use body::BodyFaults;
use limits::PairsLeft;

/// Finds all that is wrong with the surface of a garment, alone or on a body.
///
/// # Cloth against cloth
/// By the welded vertices that two triangles share:
/// - none: they cross if they have a common point, be it that they touch or overlap in a plane;
/// - one: they cross if the edge opposite to it in either meets the other;
/// - two: they cross if they are in one plane and on the same side of their common edge;
/// - three: they cross, as one lies on the other.
///
/// A triangle without area is a fault of its own. As the segment that it is, it crosses triangles
/// that share no vertex with it and have an area.
///
/// The shape of a triangle is that of its own corners. Where springs hold a seam, the copies of
/// its edge may lie apart, and two triangles that share it may overlap by as much; then they cross
/// only if they are folded about either copy.
///
/// # Cloth against the body
/// A vertex is *inside* where the winding number of the body is 1/2 or more, or on a wall around
/// which it is 1 or more. A body that crosses itself thus has one hull, and the walls inside of it
/// do not count: a vertex that touches the hull from outside is not inside. The stitches of the
/// body play no part.
///
/// A cloth triangle and a body triangle cross if they have a common point and not all corners of
/// the cloth triangle are inside: one that is all inside meets walls that do not count, and its
/// corners are reported. Nothing is lost by this: whatever meets a wall inside either has a corner
/// inside or passes through the hull as well.
///
/// The body's triangles appear counterclockwise from outside. If its surface is closed, one winding
/// number is summed for each part of the cloth that the body cuts off; if it has holes, one for
/// each vertex, which takes the product of the sizes of both.
///
/// # Errors
/// [`TooManyPairs`] if the limit of pairs does not do.
pub fn find_crossings(
    cloth: &Surface<'_>,
    body: Option<&Surface<'_>>,
    limits: SearchLimits,
) -> Result<CrossingReport, TooManyPairs> {
    let mut left = PairsLeft(limits.pairs);
    let is_degenerate: Vec<bool> = (0..cloth.triangle_count())
        .map(|t| cloth.is_degenerate(t))
        .collect();
    let faults = match body {
        Some(body) => body::find(cloth, body, limits.kept, &mut left)?,
        None => BodyFaults::default(),
    };
    let degenerate = (0..).zip(&is_degenerate).filter(|(_, flat)| **flat);
    Ok(CrossingReport {
        cloth: cloth::find(cloth, &is_degenerate, limits.kept, &mut left)?,
        degenerate: degenerate.map(|(t, _)| t).collect(),
        body: faults.crossings,
        inside: faults.inside,
    })
}
