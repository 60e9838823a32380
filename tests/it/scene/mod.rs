//! Tests of `scene`: raw scenes of particles and springs.

mod raw;
