//! Bounds of a search.

use thiserror::Error;

/// Bounds of a search for crossings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SearchLimits {
    /// Crossings of each kind that are kept; all are counted.
    pub kept: usize,
    /// Pairs that may be looked at: of triangles whose boxes overlap, and of a vertex and a body
    /// triangle whose solid angle is summed up.
    pub pairs: usize,
}

/// More pairs would have to be looked at than the limit allows: the cloth is crumpled to far below
/// the length of its edges, or the body cuts it into very many parts.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("more pairs of triangles lie near each other than may be looked at")]
pub struct TooManyPairs;

/// Pairs that may still be looked at.
#[derive(Debug)]
pub(crate) struct PairsLeft(pub(crate) usize);

impl PairsLeft {
    /// Takes `count` pairs.
    ///
    /// # Errors
    /// [`TooManyPairs`] if there are not so many left.
    pub(crate) fn take(&mut self, count: usize) -> Result<(), TooManyPairs> {
        self.0 = self.0.checked_sub(count).ok_or(TooManyPairs)?;
        Ok(())
    }
}
