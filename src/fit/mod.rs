//! The saved garment file (P6) and the whole way from it to an outcome.

mod availability;
mod garment;
mod json_schema;
mod neutral;
mod prepare;
mod run;
mod seams;
mod sewn;
mod shape;
mod shipped;
mod suggested;

pub use garment::{
    AvatarAsked, Elastic, FormAsked, Garment, MapKind, PanelAsked, PatternAsked, Pin, SCHEMA,
    SeamsAsked, SelfContact, SuggestWord, Wind,
};
pub use json_schema::garment_schema_json;
pub use neutral::scene_json;
pub use prepare::{Prepared, prepare};
pub use run::{Outcome, run, scene};
pub(crate) use seams::check_seams;
pub(crate) use sewn::{with_copies, without_allowances};
pub(crate) use shape::Shape;
pub use shape::{Misshapen, read_garment};
pub use shipped::Shipped;

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
