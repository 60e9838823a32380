//! Seams, loads and contact of a system.

use crate::solver::forces::friction_anchors::FrictionAnchors;
use crate::solver::model::holds::SewingHold;
use crate::solver::model::seams::Seams;

/// Seams, loads and contact of a system, besides the cloth of its scene.
pub(crate) struct BuildOptions<'a> {
    /// Joint of the stitches.
    pub(crate) seams: Seams,
    /// The hold of panels while their seams close; none once they are sewn.
    pub(crate) hold: Option<SewingHold<'a>>,
    /// True if weight and wind act.
    pub(crate) gravity: bool,
    /// Friction anchors to begin with; none without friction.
    pub(crate) friction: Option<&'a FrictionAnchors>,
    /// True for explicit steps, which are many and small.
    pub(crate) explicit: bool,
    /// Thickness that cloth has at least where it touches itself \[m\]; none if cloth may pass
    /// through cloth.
    pub(crate) least_thickness: Option<f64>,
    /// True on the mesh asked for: there the middles of edges are kept off the body too, and layers
    /// of cloth rub on each other. The edges of coarser meshes cut so far into the body that
    /// pushing them out would stretch the garment; their thick cloth, with friction, locks where it
    /// is crumpled (a shirt with bands did not come to rest on 275 vertices).
    pub(crate) finest: bool,
}
