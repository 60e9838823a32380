//! What a garment may refer to where nothing is stored.

use super::Library;
use crate::pattern::Pattern;
use crate::scene::{self, DressForm, Fabric};
use std::sync::Arc;
use uuid::Uuid;

/// The shipped fabrics, and nothing stored.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shipped;

impl Library for Shipped {
    fn pattern(&self, _id: Uuid) -> Option<Arc<Pattern>> {
        None
    }

    fn form(&self, _id: Uuid) -> Option<DressForm> {
        None
    }

    fn fabric(&self, id: &str) -> Option<Fabric> {
        scene::library().remove(id)
    }
}
