//! Landmarks found, and those that were not.

use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Landmarks by name \[m\].
pub(in super::super) type Found = BTreeMap<String, Vector3<f64>>;

/// A landmark that was not found, and why.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) struct Missing(
    pub(in super::super) &'static str,
    pub(in super::super) &'static str,
);
