//! Particles and force terms of a scene.

pub(crate) mod bending;
pub(crate) mod body_contact;
pub(crate) mod build;
pub(crate) mod build_options;
pub(crate) mod cloth_surface;
pub(crate) mod dof_map;
pub(crate) mod holds;
pub(crate) mod membrane;
pub(crate) mod rest_shape;
pub(crate) mod seams;
pub(crate) mod system;
