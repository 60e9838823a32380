//! Explicit methods: one fused kernel steps them all, each by a rule of its own.

pub(crate) mod kernel;
pub(crate) mod stepper;
pub(crate) mod symplectic_euler;
pub(crate) mod verlet;
