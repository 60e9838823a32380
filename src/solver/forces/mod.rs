//! The force terms, one file each: an energy, its force and its Hessian on particle positions.

pub(crate) mod active_elements;
pub(crate) mod bending;
pub(crate) mod central;
pub(crate) mod contact;
pub(crate) mod fiber;
pub(crate) mod friction_anchors;
pub(crate) mod gravity;
pub(crate) mod hold;
pub(crate) mod membrane;
pub(crate) mod membrane_lanes;
pub(crate) mod membrane_triangle;
pub(crate) mod pair;
pub(crate) mod potential;
pub(crate) mod sewing;
pub(crate) mod spring;
pub(crate) mod wind;

pub(crate) use crate::solver::forces::bending::{BendForce, BendPatch};
pub(crate) use crate::solver::forces::fiber::FiberForce;
pub(crate) use crate::solver::forces::gravity::Gravity;
pub(crate) use crate::solver::forces::hold::{Hold, ParticleHold};
pub(crate) use crate::solver::forces::membrane::ContinuumForce;
pub(crate) use crate::solver::forces::membrane_triangle::MembraneTriangle;
pub(crate) use crate::solver::forces::pair::{PairForce, PairForces};
pub(crate) use crate::solver::forces::potential::{Potential, TermKind};
pub(crate) use crate::solver::forces::sewing::SewingForce;
pub(crate) use crate::solver::forces::spring::{Spring, SpringForce};
pub(crate) use crate::solver::forces::wind::WindForce;

#[cfg(test)]
mod tests;
