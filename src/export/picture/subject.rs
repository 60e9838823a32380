//! Subject of a picture.

use crate::export::garment_mesh::GarmentMesh;
use crate::scene::TriangleMesh;
use nalgebra::Vector3;

/// Largest coordinate that is drawn \[m\]: what a solver threw further off is no garment any more,
/// and would leave the rest too small to be seen.
const REACH: f64 = 10.0;

/// A garment, and what is shown with it.
#[derive(Clone, Copy, Debug)]
pub struct PictureSubject<'a> {
    /// Shape of the garment.
    pub mesh: &'a GarmentMesh,
    /// Body that wears it.
    pub body: Option<&'a TriangleMesh>,
    /// Places to be marked \[m\].
    pub marks: &'a [[f64; 3]],
}

impl PictureSubject<'_> {
    /// Returns the points that a picture has to show: those of the garment, of the body where there
    /// is no garment.
    pub(super) fn points(&self) -> Vec<Vector3<f64>> {
        let panels = self.mesh.panels.iter();
        let cloth = panels.flat_map(|panel| panel.positions.iter().map(|p| Vector3::from(*p)));
        let cloth: Vec<_> = cloth.filter(is_drawable).collect();
        if !cloth.is_empty() {
            return cloth;
        }
        let body = self.body.iter().flat_map(|body| &body.vertices);
        body.filter(|p| is_drawable(p)).copied().collect()
    }
}

/// Returns true if a point is near enough to be drawn.
pub(super) fn is_drawable(point: &Vector3<f64>) -> bool {
    point.iter().all(|coordinate| coordinate.abs() <= REACH)
}
