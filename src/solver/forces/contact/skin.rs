//! The layer on the skin, sampled at points of the cloth, which move little from one look to the
//! next.

use crate::scene::{Body, BodySample, Scene};
use nalgebra::Vector3;

/// Distance that cloth is kept from the skin, besides half its thickness \[m\]: what keeps the
/// middles of triangles, which cut across the body's curves, outside too (an edge of 12 mm sags 0.9
/// mm into a shoulder of 20 mm radius).
const SKIN_OFFSET: f64 = 2e-3;

/// A sample of the body that is used again: good for positions within `reach` of where it was
/// taken.
#[derive(Clone, Copy, Debug)]
struct CachedSample {
    at: Vector3<f64>,
    sample: Option<BodySample>,
    /// Distance that a point may move before the sample is of no use any more \[m\].
    reach: f64,
}

/// The layer on a body's skin as points of the cloth meet it.
pub(super) struct Skin {
    body: Body,
    /// Thickness of the layer \[m\].
    pub(super) offset: f64,
    cache: Vec<CachedSample>,
    /// Distance for which a sample is carried on by its second-order expansion \[m\]; 0 takes a new
    /// one each time.
    reuse: f64,
}

impl Skin {
    /// Returns the layer of thickness `offset` \[m\] for so many points.
    pub(super) fn new(body: Body, offset: f64, point_count: usize) -> Self {
        let never = CachedSample {
            at: Vector3::repeat(f64::INFINITY),
            sample: None,
            reach: 0.0,
        };
        Self {
            body,
            offset,
            cache: vec![never; point_count],
            reuse: 0.0,
        }
    }

    /// Returns the same layer that carries each sample on for `reuse` \[m\].
    pub(super) fn with_reuse(mut self, reuse: f64) -> Self {
        self.reuse = reuse;
        self
    }

    /// Returns the sample of point `i` if it is in the layer, its distance being that at `x`.
    pub(super) fn touch(&mut self, i: usize, x: &Vector3<f64>) -> Option<BodySample> {
        let cached = &mut self.cache[i];
        let moved = x - cached.at;
        // A point that was never looked at is infinitely far from where it was.
        if moved.norm() > cached.reach {
            let sample = self.body.sample(x);
            // Outside the layer nothing is felt until the point has come nearer by the distance
            // that is left.
            let free = sample.map_or(self.offset, |s| s.distance - self.offset);
            let touching = sample.filter(|s| s.distance < self.offset + self.reuse);
            *cached = CachedSample {
                at: *x,
                sample: touching,
                reach: if touching.is_some() {
                    self.reuse
                } else {
                    0.5 * free.max(0.0)
                },
            };
            return touching.filter(|s| s.distance < self.offset);
        }
        let mut sample = cached.sample?;
        let bent = sample.curvature * moved;
        sample.distance += sample.normal.dot(&moved) + 0.5 * moved.dot(&bent);
        sample.normal += bent;
        (sample.distance < self.offset).then_some(sample)
    }
}

/// Returns the distance that cloth is kept from the skin \[m\].
pub fn kept_distance(scene: &Scene) -> f64 {
    let thickness = scene.fabrics.iter().map(|f| f.thickness_m);
    SKIN_OFFSET + 0.5 * thickness.fold(0.0, f64::max)
}
