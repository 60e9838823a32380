//! The shape at rest of a scene, from the coarsest level of a hierarchy of meshes to the finest.
//!
//! In the order of a run, which [`multilevel`] leads:
//!
//! 1. [`hierarchy`] makes ever coarser meshes of the scene, and [`continuation`] softer versions of
//!    stiff cloth.
//! 2. [`perturb`] moves particles of the start apart that lie in one point.
//! 3. [`solve_level`] runs each level, coarsest first: [`sew`] pulls its seams shut, unless a
//!    coarser level did, and [`relax`] closes them for good and finds the shape at rest. Both run
//!    [`stage`]s, by Newton's method or by motion, and a [`monitor`] follows every iteration.
//! 4. The shape of a level is refined to the next one while the time allows.
//! 5. [`error_estimate`] tells how far the last shape is from the solution; of a shape that was
//!    never relaxed, [`force_balance`] tells the forces.
//!
//! The outcome is typed ([`crate::solver::outcome`]) and is put into words after the solve.

pub(crate) mod continuation;
pub(crate) mod drag;
pub(crate) mod error_estimate;
pub(crate) mod force_balance;
pub(crate) mod hierarchy;
pub(crate) mod level;
pub(crate) mod monitor;
pub(crate) mod multilevel;
pub(crate) mod perturb;
pub(crate) mod relax;
pub(crate) mod sew;
pub(crate) mod solve_level;
pub(crate) mod stage;
