//! The saved garment file (P6) and the whole way from it to an outcome.

mod availability;
mod garment;
mod neutral;
mod prepare;
mod run;

pub use garment::{
    AvatarAsked, Elastic, FormAsked, Garment, MapKind, PanelAsked, PatternAsked, Pin, SCHEMA,
    SeamsAsked, SelfContact, SuggestWord, Wind,
};
pub use prepare::{Prepared, prepare};
pub use run::{Outcome, run, scene};

use crate::pattern::Pattern;
use crate::scene::{DressForm, Fabric};
use std::sync::Arc;
use uuid::Uuid;

/// What a garment may refer to by id.
pub trait Library: Sync {
    /// A stored pattern.
    fn pattern(&self, id: Uuid) -> Option<Arc<Pattern>>;
    /// The measurements of a stored avatar.
    fn form(&self, id: Uuid) -> Option<DressForm>;
    /// A fabric, shipped or stored.
    fn fabric(&self, id: &str) -> Option<Fabric>;
}
