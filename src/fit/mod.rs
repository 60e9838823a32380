//! The saved garment file (P6) and the whole way from it to an outcome.

mod garment;

pub use garment::{
    AvatarAsked, Elastic, FormAsked, Garment, MapKind, PanelAsked, PatternAsked, Pin, SCHEMA,
    SeamsAsked, SelfContact, SuggestWord, Wind,
};

use crate::config::Limits;
use crate::export::GarmentMesh;
use crate::fault::Faults;
use crate::pattern::Pattern;
use crate::progress::{CancelToken, Progress};
use crate::scene::{Avatar, Fabric};
use crate::solver::Report;
use std::sync::Arc;
use uuid::Uuid;

/// What a garment may refer to by id.
pub trait Library: Sync {
    /// A stored pattern.
    fn pattern(&self, id: Uuid) -> Option<Arc<Pattern>>;
    /// A stored avatar.
    fn avatar(&self, id: Uuid) -> Option<Arc<Avatar>>;
    /// A fabric, shipped or stored.
    fn fabric(&self, id: &str) -> Option<Fabric>;
}

/// A garment that was checked whole: everything it refers to was found, its seams can be sewn. Built only by [`prepare`].
#[derive(Clone, Debug)]
pub struct Prepared {
    /// The garment, complete in itself: what it referred to is inside.
    pub garment: Garment,
}

/// Checks a garment and finds everything it refers to.
///
/// # Errors
/// All its faults at once, with JSON pointers into the garment.
pub fn prepare(
    _garment: Garment,
    _library: &dyn Library,
    _limits: &Limits,
) -> Result<Prepared, Faults> {
    Err(Faults(vec![]))
}

/// What a fit comes to.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The shape, the best one even if it did not converge.
    pub mesh: GarmentMesh,
    /// How far to trust it.
    pub report: Report,
    /// The assembled scene in neutral JSON.
    pub scene: serde_json::Value,
    /// Whether it was stopped by the cancel token.
    pub canceled: bool,
}

/// Sews and drapes a prepared garment.
///
/// # Errors
/// What could be found only on the way: a mesh too fine for the limits, an avatar that cannot be made.
pub fn run(
    _prepared: &Prepared,
    _limits: &Limits,
    _cancel: &CancelToken,
    _progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, Faults> {
    Err(Faults(vec![]))
}
