//! Measures of a sewn garment: areas, lengths of seams, girths beside those of the body.

use super::girths;
use super::resolve::ResolvedGarment;
use super::run;
use crate::export::GarmentMesh;
use crate::fault::Faults;
use crate::solver::Context;
use nalgebra::Vector3;
use serde::Serialize;
use utoipa::ToSchema;

/// Measures of a sewn garment.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub struct GarmentMeasures {
    /// Areas, in the order of the panels.
    pub panels: Vec<PanelMeasures>,
    /// Lengths of the seams on the pattern, in their order.
    pub seams: Vec<SeamMeasures>,
    /// Girths where the cloth is closed round the body; none without an avatar, and none of a fit
    /// whose mesh this version makes otherwise.
    pub girths: Vec<GirthMeasures>,
}

/// Areas of a panel.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub struct PanelMeasures {
    /// Id of the panel.
    pub panel: String,
    /// Area of its mesh on the pattern \[m²\].
    pub area_m2: f64,
    /// Area as it lies \[m²\].
    pub draped_area_m2: f64,
}

/// Lengths of a seam.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub struct SeamMeasures {
    /// Id of the seam.
    pub seam: String,
    /// Length of side A on the pattern \[m\].
    pub a_m: f64,
    /// Length of side B on the pattern \[m\].
    pub b_m: f64,
}

/// Girth of the cloth at a place of the body.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub struct GirthMeasures {
    /// `bust`, `waist`, `hip`, `left upper arm`, `right upper arm`, `left thigh` or `right thigh`.
    pub at: String,
    /// Height above the floor \[m\].
    pub height_m: f64,
    /// Length of the cut through the cloth \[m\]; where cloth lies on cloth, of both.
    pub cloth_m: f64,
    /// Girth of the body there \[m\].
    pub body_m: f64,
    /// Room: the cloth's girth less the body's \[m\]; too large where cloth lies on cloth.
    pub ease_m: f64,
}

/// Measures the outcome of a fit.
///
/// # Errors
/// As [`run`](super::run()).
pub fn measures(
    garment: &ResolvedGarment,
    mesh: &GarmentMesh,
    context: &Context<'_>,
) -> Result<GarmentMeasures, Faults> {
    let scene = run::scene(garment, context)?;
    let positions = mesh.panels.iter().flat_map(|panel| &panel.positions);
    let positions: Vec<_> = positions.map(|p| Vector3::from(*p)).collect();
    let uv = mesh.panels.iter().flat_map(|panel| &panel.uv);
    let is_same = positions.len() == scene.start.len() && uv.eq(&scene.mesh.uv);
    let girths = is_same.then(|| girths::measured(&scene, &positions));
    let girths = girths.into_iter().flatten().map(|girth| GirthMeasures {
        at: girth.at.to_owned(),
        height_m: girth.height_m,
        cloth_m: girth.cloth_m,
        body_m: girth.body_m,
        ease_m: girth.cloth_m - girth.body_m,
    });
    Ok(GarmentMeasures {
        panels: panels(mesh),
        seams: seams(garment),
        girths: girths.collect(),
    })
}

fn panels(mesh: &GarmentMesh) -> Vec<PanelMeasures> {
    let area = |[p, q, r]: [Vector3<f64>; 3]| 0.5 * (q - p).cross(&(r - p)).norm();
    let panels = mesh.panels.iter().map(|panel| {
        let triangles = || panel.triangles.iter().map(|t| t.map(|v| v as usize));
        let flat = |v: usize| Vector3::new(panel.uv[v][0], panel.uv[v][1], 0.0);
        let lying = |v: usize| Vector3::from(panel.positions[v]);
        PanelMeasures {
            panel: panel.panel.clone(),
            area_m2: triangles().map(|t| area(t.map(flat))).sum(),
            draped_area_m2: triangles().map(|t| area(t.map(lying))).sum(),
        }
    });
    panels.collect()
}

fn seams(garment: &ResolvedGarment) -> Vec<SeamMeasures> {
    let seams = garment.seams.seams.iter().map(|seam| {
        let pairs = seam.matched.iter();
        let side = |k: usize| {
            let lengths = pairs.clone().map(|pair| pair[k].length(&garment.pattern));
            lengths.sum()
        };
        SeamMeasures {
            seam: seam.id.clone(),
            a_m: side(0),
            b_m: side(1),
        }
    });
    seams.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::DrapedPanel;

    /// A rectangle of 0.3 x 0.2 m that is bent to a quarter of a cylinder in steps of one degree.
    #[test]
    fn areas_are_those_of_the_pattern_and_of_the_shape() {
        let mut panel = DrapedPanel::default();
        let radius = 0.3 / std::f64::consts::FRAC_PI_2;
        for height in [0.0, 0.2] {
            for step in 0..=90 {
                let (sin, cos) = f64::from(step).to_radians().sin_cos();
                panel.positions.push([radius * sin, height, radius * cos]);
                panel.uv.push([0.3 * f64::from(step) / 90.0, height]);
            }
        }
        for a in 0..90_u32 {
            panel.triangles.push([a, a + 1, a + 91]);
            panel.triangles.push([a + 1, a + 92, a + 91]);
        }
        let mesh = GarmentMesh {
            panels: vec![panel],
        };
        let measured = &panels(&mesh)[0];
        assert!((measured.area_m2 - 0.06).abs() < 1e-12);
        // A chord of an angle is shorter than its arc by a 24th of its square.
        let shorter = 1.0_f64.to_radians().powi(2) / 24.0;
        assert!((measured.draped_area_m2 / 0.06 - 1.0 + shorter).abs() < 1e-8);
    }
}
