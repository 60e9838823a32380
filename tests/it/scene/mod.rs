//! Tests of `scene`: bodies, raw scenes of particles and springs.

mod bodies;
mod raw;
