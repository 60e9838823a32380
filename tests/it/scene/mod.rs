//! Tests of `scene`: bodies, raw scenes of particles and springs.

mod bodies;
mod own_bodies;
mod raw;
