//! Seamster sews garments without a screen: 2D pattern pieces as real CAD writes them (DXF) and a
//! list of seams go in, a garment sewn and draped on a body comes out, with a report that says how
//! far to trust it.
//!
//! The method is Chen Qing-Qing, "Three-Dimensional Garment Simulation Technology Based on
//! Interactive Suture Setting" (2013), taken further as ARCHITECTURE.md tells.
//!
//! The modules in reading order, which is the way the data goes; none uses a name from a module
//! below it:
//!
//! - [`fault`], [`config`], [`progress`], [`memory`]: what every module shares: faults, limits,
//!   cancelling, peak memory.
//! - `json`: requests measured before they are read.
//! - [`pattern`]: DXF bytes to a [`pattern::Pattern`] of panels.
//! - [`seam`]: seam pairs as asked to checked [`seam::Seam`]s.
//! - [`mesh`]: panels to a [`mesh::ClothMesh`] whose boundary points match across seams.
//! - [`scene`]: fabrics, avatar and placement to a [`scene::Scene`] of only the terms it needs.
//! - [`solver`]: a scene to a [`solver::Drape`] and how far to trust it.
//! - [`export`]: a drape to GLB, OBJ and JSON.
//! - [`fit`]: the saved garment file and the whole way from it to an outcome.
//! - [`study`]: a garment by many methods, settings and meshes: error against run time.
//! - [`job`]: fits and studies queued, stored and run by workers.
//! - [`http`]: the service.

pub mod config;
pub mod export;
pub mod fault;
pub mod fit;
pub mod http;
pub mod job;
mod json;
pub mod memory;
pub mod mesh;
pub mod pattern;
pub mod progress;
pub mod scene;
pub mod seam;
pub mod solver;
pub mod study;
