//! Measures of a sewn garment: areas, lengths of seams, girths beside those of the body.

use super::resolve::ResolvedGarment;
use super::run::avatar;
use super::zone::{self, Zone};
use crate::export::GarmentMesh;
use crate::fault::Faults;
use crate::scene::{Avatar, Limb};
use nalgebra::Vector3;
use serde::Serialize;
use std::f64::consts::TAU;
use utoipa::ToSchema;

/// Largest gap in a cut through cloth, seen from its middle, that still goes round \[rad\].
const MOST_OPEN: f64 = 0.5;
/// Depth of the thigh's girth under the crotch \[m\].
const UNDER_CROTCH: f64 = 0.02;

/// Measures of a sewn garment.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub struct GarmentMeasures {
    /// Areas, in the order of the panels.
    pub panels: Vec<PanelMeasures>,
    /// Lengths of the seams on the pattern, in their order.
    pub seams: Vec<SeamMeasures>,
    /// Girths of the cloth where it goes round the body, from the top down; none without an avatar.
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

/// Girth of the cloth at a level of the body.
#[derive(Clone, Debug, PartialEq, Serialize, ToSchema)]
pub struct GirthMeasures {
    /// `bust`, `waist`, `hip`, `left upper arm`, `right upper arm`, `left thigh` or `right thigh`.
    pub at: String,
    /// Height of its middle above the floor \[m\].
    pub height_m: f64,
    /// Length of the cut through the cloth \[m\]; where cloth lies on cloth, of both.
    pub cloth_m: f64,
    /// Girth of the body there \[m\].
    pub body_m: f64,
    /// Room: the cloth's girth less the body's \[m\].
    pub ease_m: f64,
}

/// Measures the outcome of a fit.
///
/// # Errors
/// A body that cannot be made.
pub fn measures(garment: &ResolvedGarment, mesh: &GarmentMesh) -> Result<GarmentMeasures, Faults> {
    let avatar = avatar(garment)?;
    let girths = avatar.map(|avatar| girths(&avatar, mesh));
    Ok(GarmentMeasures {
        panels: panels(mesh),
        seams: seams(garment),
        girths: girths.unwrap_or_default(),
    })
}

fn panels(mesh: &GarmentMesh) -> Vec<PanelMeasures> {
    let area = |corners: [Vector3<f64>; 3]| {
        let [p, q, r] = corners;
        0.5 * (q - p).cross(&(r - p)).norm()
    };
    let panels = mesh.panels.iter().map(|panel| {
        let triangles = || panel.triangles.iter().map(|t| t.map(|v| v as usize));
        let flat = |v: usize| Vector3::new(panel.uv[v][0], panel.uv[v][1], 0.0);
        PanelMeasures {
            panel: panel.panel.clone(),
            area_m2: triangles().map(|t| area(t.map(flat))).sum(),
            draped_area_m2: triangles()
                .map(|t| area(t.map(|v| panel.positions[v].into())))
                .sum(),
        }
    });
    panels.collect()
}

fn seams(garment: &ResolvedGarment) -> Vec<SeamMeasures> {
    let seams = garment.seams.seams.iter().map(|seam| {
        let side = |k: usize| {
            seam.matched
                .iter()
                .map(|pair| pair[k].length(&garment.pattern))
                .sum()
        };
        SeamMeasures {
            seam: seam.id.clone(),
            a_m: side(0),
            b_m: side(1),
        }
    });
    seams.collect()
}

/// A level of the body at which girths are compared: a plane, and the zones whose cloth it cuts.
struct Level {
    at: &'static str,
    point: Vector3<f64>,
    normal: Vector3<f64>,
    zones: fn(Zone) -> bool,
    body_m: f64,
}

fn girths(avatar: &Avatar, mesh: &GarmentMesh) -> Vec<GirthMeasures> {
    let zones: Vec<Vec<Zone>> = mesh
        .panels
        .iter()
        .map(|panel| {
            let places = panel.positions.iter();
            places.map(|p| zone::of(avatar, &(*p).into())).collect()
        })
        .collect();
    let girth = |level: Level| {
        let cut = cut(mesh, &zones, &level);
        let cloth_m = goes_round(&cut, &level.normal).then(|| {
            let lengths = cut.iter().map(|[a, b]| (b - a).norm());
            lengths.sum::<f64>()
        })?;
        Some(GirthMeasures {
            at: level.at.to_owned(),
            height_m: level.point.y,
            cloth_m,
            body_m: level.body_m,
            ease_m: cloth_m - level.body_m,
        })
    };
    levels(avatar).into_iter().filter_map(girth).collect()
}

/// Returns the levels that a body has, from the top down.
fn levels(avatar: &Avatar) -> Vec<Level> {
    let girths = avatar.girths();
    let mut levels = vec![];
    let mut add = |at, place: Option<(Vector3<f64>, Vector3<f64>)>, zones, measure: &str| {
        if let (Some((point, normal)), Some(&body_m)) = (place, girths.get(measure)) {
            levels.push(Level {
                at,
                point,
                normal,
                zones,
                body_m,
            });
        }
    };
    let level = |landmark: &str| {
        let height = avatar.landmarks.get(landmark)?.y;
        Some((Vector3::y() * height, Vector3::y()))
    };
    let upper_arm = |limb| {
        let axis = avatar.limb(limb)?;
        let [shoulder, elbow, _] = axis.joints;
        Some(axis.at(0.5 * (elbow - shoulder).norm()))
    };
    let thigh = |limb| {
        let axis = avatar.limb(limb)?;
        let crotch = avatar.landmarks.get("crotch")?.y - UNDER_CROTCH;
        let (joint, direction) = axis.at(0.0);
        Some(axis.at((crotch - joint.y) / direction.y))
    };
    let trunk: fn(Zone) -> bool = Zone::is_trunk;
    add("bust", level("bust_point_l"), trunk, "bust_m");
    for (at, limb, zones) in [
        (
            "left upper arm",
            Limb::ArmLeft,
            (|z| z == Zone::LeftArm) as fn(Zone) -> bool,
        ),
        ("right upper arm", Limb::ArmRight, |z| z == Zone::RightArm),
    ] {
        add(at, upper_arm(limb), zones, "upper_arm_m");
    }
    add("waist", level("waist_front"), trunk, "waist_m");
    add("hip", level("hip_front"), trunk, "hip_m");
    for (at, limb, zones) in [
        (
            "left thigh",
            Limb::LegLeft,
            (|z| z == Zone::LeftLeg) as fn(Zone) -> bool,
        ),
        ("right thigh", Limb::LegRight, |z| z == Zone::RightLeg),
    ] {
        add(at, thigh(limb), zones, "thigh_m");
    }
    levels
}

/// Returns the pieces of the line in which a level cuts the cloth of its zones \[m\].
fn cut(mesh: &GarmentMesh, zones: &[Vec<Zone>], level: &Level) -> Vec<[Vector3<f64>; 2]> {
    let mut pieces = vec![];
    for (panel, zones) in mesh.panels.iter().zip(zones) {
        for triangle in &panel.triangles {
            let corners = triangle.map(|v| v as usize);
            if !corners.iter().any(|&v| (level.zones)(zones[v])) {
                continue;
            }
            let places = corners.map(|v| Vector3::from(panel.positions[v]));
            let heights = places.map(|p| (p - level.point).dot(&level.normal));
            let crossing = |(i, j): (usize, usize)| {
                let apart = (heights[i] >= 0.0) != (heights[j] >= 0.0);
                let share = heights[i] / (heights[i] - heights[j]);
                apart.then(|| places[i].lerp(&places[j], share))
            };
            let mut ends = [(0, 1), (1, 2), (2, 0)].into_iter().filter_map(crossing);
            if let (Some(a), Some(b)) = (ends.next(), ends.next()) {
                pieces.push([a, b]);
            }
        }
    }
    pieces
}

/// Returns true if a cut goes round its middle.
fn goes_round(cut: &[[Vector3<f64>; 2]], normal: &Vector3<f64>) -> bool {
    let middle = cut.iter().flatten().sum::<Vector3<f64>>() / (2 * cut.len()).max(1) as f64;
    let across = if normal.x.abs() < 0.9 {
        Vector3::x()
    } else {
        Vector3::z()
    };
    let along = normal.cross(&across).normalize();
    let across = along.cross(normal).normalize();
    let angle = |p: &Vector3<f64>| (p - middle).dot(&along).atan2((p - middle).dot(&across));
    let mut angles: Vec<f64> = cut.iter().flatten().map(angle).collect();
    angles.sort_by(f64::total_cmp);
    let Some(first) = angles.first().copied() else {
        return false;
    };
    angles.push(first + TAU);
    angles.windows(2).all(|pair| pair[1] - pair[0] < MOST_OPEN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::DrapedPanel;
    use crate::scene::{DressForm, Limbs};

    /// A tube of cloth of this radius about the trunk, from above the bust to below the hip, open
    /// in front by an angle \[rad\].
    fn tube(radius: f64, open: f64) -> GarmentMesh {
        const COLUMNS: u32 = 360;
        let mut panel = DrapedPanel::default();
        for height in [0.7, 1.3] {
            for column in 0..=COLUMNS {
                let share = f64::from(column) / f64::from(COLUMNS);
                let (sin, cos) = (0.5 * open + (TAU - open) * share).sin_cos();
                panel.positions.push([radius * sin, height, radius * cos]);
                panel.uv.push([radius * (TAU - open) * share, height]);
            }
        }
        for a in 0..COLUMNS {
            let above = a + COLUMNS + 1;
            panel.triangles.push([a, a + 1, above]);
            panel.triangles.push([a + 1, above + 1, above]);
        }
        GarmentMesh {
            panels: vec![panel],
        }
    }

    fn body() -> Avatar {
        let form = DressForm {
            limbs: Some(Limbs {
                arms: false,
                legs: false,
            }),
            ..DressForm::default()
        };
        form.build().expect("a body")
    }

    #[test]
    fn a_tube_has_its_girth_and_the_body_its_own() {
        let girths = girths(&body(), &tube(0.25, 0.0));
        let at: Vec<&str> = girths.iter().map(|girth| &*girth.at).collect();
        assert_eq!(at, ["bust", "waist", "hip"]);
        for (girth, asked) in girths.iter().zip([0.92, 0.74, 0.98]) {
            assert!((girth.cloth_m - TAU * 0.25).abs() < 1e-3, "{girth:?}");
            assert!((girth.body_m - asked).abs() < 5e-3, "{girth:?}");
            assert!((girth.ease_m - (girth.cloth_m - girth.body_m)).abs() < 1e-12);
        }
    }

    #[test]
    fn what_is_open_in_front_goes_round_nothing() {
        assert_eq!(girths(&body(), &tube(0.25, 1.0)), []);
    }

    #[test]
    fn areas_are_those_of_the_pattern_and_of_the_shape() {
        let measured = &panels(&tube(0.25, 0.0))[0];
        let area = TAU * 0.25 * 0.6;
        assert!((measured.area_m2 - area).abs() < 1e-9);
        // Chords of one degree.
        assert!((measured.draped_area_m2 / area - 1.0).abs() < 1e-4);
    }
}
