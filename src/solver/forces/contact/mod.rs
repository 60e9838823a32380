//! Contact of cloth with the body, with friction, and of cloth with cloth.

mod body;
pub(crate) mod chord;
mod cloth;
pub(crate) mod layer;
mod skin;
mod tip;

pub(crate) use crate::solver::forces::contact::body::{BodyContact, Friction};
pub(crate) use crate::solver::forces::contact::chord::{Chord, ChordContact};
pub(crate) use crate::solver::forces::contact::cloth::{ClothContact, ClothSurface, LayerOrder};
pub use crate::solver::forces::contact::skin::kept_distance;
pub(crate) use crate::solver::forces::contact::tip::{Facet, TipContact};
