//! A map of a shape.

use crate::export::VertexMaps;

/// A map of a shape.
#[derive(Clone, Debug)]
pub struct ShapeMap {
    /// `strain_warp`, `strain_weft`, `strain_share`, `pressure` or `gap`.
    pub name: &'static str,
    /// Unit of its values.
    pub unit: &'static str,
    /// RMS difference from the map of the next coarser mesh, where that came to rest.
    pub error: Option<f64>,
    /// Values at the vertices; `#V`.
    pub values: Vec<f64>,
    /// Its place in the maps of a panel.
    pub(super) place: fn(&mut VertexMaps) -> &mut Vec<f64>,
}
