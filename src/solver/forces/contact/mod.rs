//! Contact of cloth with the body, with friction, and of cloth with cloth.

mod body;
mod chord;
mod cloth;
mod layer;
mod pressure;
mod skin;
mod tip;

pub(crate) use crate::solver::forces::contact::body::{BodyContact, Friction};
pub(crate) use crate::solver::forces::contact::chord::{Chord, ChordContact};
pub(crate) use crate::solver::forces::contact::cloth::{ClothContact, ClothSurface, LayerOrder};
pub use crate::solver::forces::contact::pressure::{contact_force, contact_pressure};
pub use crate::solver::forces::contact::skin::kept_distance;
pub(crate) use crate::solver::forces::contact::tip::{Facet, TipContact};
