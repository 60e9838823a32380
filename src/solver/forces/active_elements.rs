//! The elements of a term that act: all, or, while few particles move, those that they belong to.

use std::sync::Arc;

/// Elements of a term that act; a clone is cheap.
#[derive(Clone, Debug, Default)]
pub(crate) struct ActiveElements {
    /// Indices, ascending; none if all elements act.
    indices: Option<Arc<[usize]>>,
}

impl ActiveElements {
    /// Lets only those of `count` elements act that have a particle of `moving`; all if it is
    /// absent.
    pub(crate) fn narrow(
        &mut self,
        moving: Option<&[bool]>,
        count: usize,
        has_one: impl Fn(usize, &[bool]) -> bool,
    ) {
        self.indices = moving.map(|moving| (0..count).filter(|&i| has_one(i, moving)).collect());
    }

    /// Returns true if all elements act.
    pub(crate) fn is_all(&self) -> bool {
        self.indices.is_none()
    }

    /// Calls `run` with the index of each of `count` elements that acts, in order.
    #[inline]
    pub(crate) fn for_each(&self, count: usize, run: impl FnMut(usize)) {
        match &self.indices {
            None => (0..count).for_each(run),
            Some(indices) => indices.iter().copied().for_each(run),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_act_that_have_a_moving_particle() {
        let ends = [(0, 1), (1, 2), (2, 3)];
        let mut active = ActiveElements::default();
        let acting = |active: &ActiveElements| {
            let mut found = vec![];
            active.for_each(ends.len(), |i| found.push(i));
            found
        };
        assert_eq!(acting(&active), [0, 1, 2]);
        let has_one = |i: usize, moving: &[bool]| moving[ends[i].0] || moving[ends[i].1];
        active.narrow(Some(&[false, false, false, true]), ends.len(), has_one);
        assert_eq!(acting(&active), [2]);
        active.narrow(None, ends.len(), has_one);
        assert_eq!(acting(&active), [0, 1, 2]);
    }
}
