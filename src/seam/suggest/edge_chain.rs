//! Chains of edges along a seam.

/// One edge along a seam, and whether it is gone in order of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct EdgeStep {
    pub(super) panel: usize,
    /// The hole that the edge is of; absent on the outline.
    pub(super) hole: Option<usize>,
    pub(super) edge: usize,
    pub(super) forward: bool,
    /// Arc length of the part that is gone \[m\].
    pub(super) length: f64,
    /// The part of the edge, as shares of its length in order of numbers.
    pub(super) span: [f64; 2],
}

/// A ring begins at a corner that is as near to where it would begin \[m\].
pub(super) const CORNER_TOLERANCE_M: f64 = 0.004;

/// All of an edge.
pub(super) const WHOLE: [f64; 2] = [0.0, 1.0];

impl EdgeStep {
    /// Splits the step at a share of its length, counted the way it is gone.
    fn split(self, share: f64) -> [Self; 2] {
        let [from, to] = self.span;
        let at = from + (to - from) * if self.forward { share } else { 1.0 - share };
        let spans = if self.forward {
            [[from, at], [at, to]]
        } else {
            [[at, to], [from, at]]
        };
        let lengths = [self.length * share, self.length * (1.0 - share)];
        [0, 1].map(|k| Self {
            span: spans[k],
            length: lengths[k],
            ..self
        })
    }
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

/// Returns the chain from its beginning to this far along it \[m\].
pub(super) fn up_to(chain: &[EdgeStep], distance: f64) -> EdgeChain {
    let mut left = distance;
    let mut first = EdgeChain::new();
    for step in chain {
        if left <= 0.0 {
            break;
        }
        if step.length > left * (1.0 + 1e-9) {
            first.push(step.split(left / step.length)[0]);
        } else {
            first.push(*step);
        }
        left -= step.length;
    }
    first
}

/// Returns a closed chain that begins this far along it \[m\], at a corner where one is as near as
/// `tolerance` \[m\].
pub(super) fn beginning_at(ring: &[EdgeStep], distance: f64, tolerance: f64) -> EdgeChain {
    let mut before = 0.0;
    let distance = distance.rem_euclid(length(ring).max(f64::MIN_POSITIVE));
    for (i, step) in ring.iter().enumerate() {
        let into = distance - before;
        before += step.length;
        if into > step.length + tolerance {
            continue;
        }
        let (start, end) = (into <= tolerance, into >= step.length - tolerance);
        let mut chain = ring.to_vec();
        if start || end {
            chain.rotate_left((i + usize::from(!start)) % ring.len());
            return chain;
        }
        let [first, second] = step.split(into / step.length);
        chain.rotate_left(i);
        chain[0] = second;
        chain.push(first);
        return chain;
    }
    ring.to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(edge: usize, length: f64, forward: bool) -> EdgeStep {
        EdgeStep {
            panel: 0,
            hole: None,
            edge,
            forward,
            length,
            span: WHOLE,
        }
    }

    #[test]
    fn a_ring_begins_within_an_edge_or_at_the_corner_beside_it() {
        let ring = [step(0, 1.0, true), step(1, 2.0, false)];
        let cut = beginning_at(&ring, 1.5, 0.01);
        assert_eq!(
            cut[0].span,
            [0.0, 0.75],
            "gone backward, a quarter is behind"
        );
        assert_eq!(cut[1], ring[0]);
        assert_eq!(cut[2].span, [0.75, 1.0]);
        assert!((length(&cut) - 3.0).abs() < 1e-12);
        let corner = beginning_at(&ring, 0.995, 0.01);
        assert_eq!(corner, [ring[1], ring[0]]);
    }
}
