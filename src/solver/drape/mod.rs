//! The shape at rest of a scene, from the coarsest level of a hierarchy of meshes to the finest.

pub(crate) mod continuation;
pub(crate) mod hierarchy;
pub(crate) mod level;
pub(crate) mod monitor;
pub(crate) mod multilevel;
pub(crate) mod perturb;
pub(crate) mod relax;
pub(crate) mod sew;
pub(crate) mod stage;
