//! Chains of edges along a seam.

/// One edge along a seam, and whether it is gone in order of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct EdgeStep {
    pub(super) panel: usize,
    pub(super) edge: usize,
    pub(super) forward: bool,
    /// Arc length \[m\].
    pub(super) length: f64,
}

/// Steps one after another.
pub(super) type EdgeChain = Vec<EdgeStep>;

/// Returns the chain from its end.
pub(super) fn reversed(chain: &[EdgeStep]) -> EdgeChain {
    let back = |step: &EdgeStep| EdgeStep {
        forward: !step.forward,
        ..*step
    };
    chain.iter().rev().map(back).collect()
}

pub(super) fn length(chain: &[EdgeStep]) -> f64 {
    chain.iter().map(|step| step.length).sum()
}
