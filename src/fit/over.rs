//! The garment that another one is worn over: found by the id of its fit, put into the garment file
//! as a surface, and checked.

use super::garment::{AvatarRef, Garment, InnerGarment, InnerPanel, OverRef};
use super::library::{AssetLibrary, FinishedFit, NoFinishedFit};
use super::stored_surface;
use crate::config::Limits;
use crate::fault::{Fault, GarmentCode};
use crate::scene::{DressForm, FixedCloth, FixedPanel};
use nalgebra::Vector3;
use std::ops::RangeInclusive;
use std::sync::Arc;
use uuid::Uuid;

/// Put before the names of the panels of an inner garment: once for each garment on it.
const PREFIX: &str = "over:";
/// Thickness of an inner garment \[m\]: that of a fabric.
const THICKNESS: RangeInclusive<f64> = 1e-5..=0.02;
/// Coulomb coefficient of an inner garment.
const FRICTION: RangeInclusive<f64> = 0.0..=2.0;

/// Puts the surface of the garment that `garment`, complete but for it, is worn over into it, and
/// returns that surface; none if there is none or it is at fault.
pub(super) fn inline_over(
    garment: &mut Garment,
    library: &dyn AssetLibrary,
    limits: &Limits,
    faults: &mut Vec<Fault>,
) -> Option<Arc<FixedCloth>> {
    let inner = match garment.over.take()? {
        OverRef::Id(id) => found(id, library),
        OverRef::Whole(inner) => Ok(*inner),
    };
    let checked = inner.and_then(|inner| {
        check_avatar(garment.avatar.as_ref(), &inner)?;
        let cloth = fixed_cloth(&inner, limits)?;
        Ok((inner, cloth))
    });
    match checked {
        Ok((inner, cloth)) => {
            garment.over = Some(OverRef::Whole(Box::new(inner)));
            Some(Arc::new(cloth))
        }
        Err(fault) => {
            faults.push(fault);
            None
        }
    }
}

/// Finds the surface of a finished fit, and of all that it is worn over.
fn found(id: Uuid, library: &dyn AssetLibrary) -> Result<InnerGarment, Fault> {
    let FinishedFit { garment, mesh } =
        library.finished_fit(id).map_err(|none| refused(id, none))?;
    let mut panels = match garment.over {
        Some(OverRef::Whole(inner)) => inner.panels,
        Some(OverRef::Id(_)) | None => vec![],
    };
    for panel in &mut panels {
        panel.panel.insert_str(0, PREFIX);
    }
    for panel in mesh.panels {
        let Some(fabric) = garment.fabrics.get(&panel.fabric) else {
            return Err(surface_fault(format!(
                "the fabric {} of panel {} is not in the garment of fit {id}",
                panel.fabric, panel.panel
            )));
        };
        panels.push(InnerPanel {
            panel: format!("{PREFIX}{}", panel.panel),
            thickness_m: fabric.thickness_m,
            friction: fabric.friction,
            positions: panel.positions,
            triangles: panel.triangles,
        });
    }
    Ok(InnerGarment {
        avatar: garment.avatar,
        panels,
    })
}

fn refused(id: Uuid, none: NoFinishedFit) -> Fault {
    match none {
        NoFinishedFit::Unknown => {
            let detail = format!("no fit has the id {id}");
            Fault::new(GarmentCode::OverUnknown, "/over", detail).fix(
                "sew it first: POST /v1/fits; without the service, give the saved file of a garment that was sewn over it there, GET /v1/fits/{id}/garment",
            )
        }
        NoFinishedFit::NotSucceeded(status) => {
            let detail = format!("fit {id}, over which it is to be worn, is {status}");
            Fault::new(GarmentCode::OverUnfinished, "/over", detail)
                .fix("give the id of a fit that has succeeded")
        }
    }
}

/// Returns true if two references are to one body, but for the limbs of a form, of which each
/// garment has its own.
fn is_same_body(one: &AvatarRef, other: &AvatarRef) -> bool {
    let torso = |form: DressForm| DressForm {
        limbs: None,
        ..form
    };
    match (one, other) {
        (AvatarRef::Form(one), AvatarRef::Form(other)) => torso(one.form) == torso(other.form),
        _ => one == other,
    }
}

/// Checks that both garments are worn on one body.
fn check_avatar(avatar: Option<&AvatarRef>, inner: &InnerGarment) -> Result<(), Fault> {
    let detail = match (avatar, inner.avatar.as_ref()) {
        (None, _) => "a garment without an avatar is worn over nothing",
        (Some(_), None) => "the garment beneath is worn on no avatar",
        // An avatar that is not known is a fault of its own.
        (Some(AvatarRef::Id(_)), _) => return Ok(()),
        (Some(own), Some(inner)) if !is_same_body(own, inner) => {
            "the garment beneath is worn on another avatar"
        }
        _ => return Ok(()),
    };
    let fault = Fault::new(GarmentCode::OverAvatar, "/over", detail);
    Err(fault.fix("give both garments the same avatar, and sew the inner one on it first"))
}

fn surface_fault(detail: impl Into<String>) -> Fault {
    Fault::new(GarmentCode::OverSurface, "/over", detail)
        .fix("give the id of a fit that has succeeded, or `over` of a saved file as it is")
}

/// Returns the surface of an inner garment.
fn fixed_cloth(inner: &InnerGarment, limits: &Limits) -> Result<FixedCloth, Fault> {
    let count = |of: fn(&InnerPanel) -> usize| inner.panels.iter().map(of).sum::<usize>();
    let vertices = count(|panel| panel.positions.len());
    let triangles = count(|panel| panel.triangles.len());
    stored_surface::check_size(vertices, triangles, limits)
        .map_err(|detail| surface_fault(format!("the garments beneath: {detail}")))?;
    let mut cloth = FixedCloth::default();
    for panel in &inner.panels {
        let wrong = |what: &str| {
            surface_fault(format!(
                "panel {} {what}",
                stored_surface::excerpt(&panel.panel)
            ))
        };
        check_panel(panel, limits).map_err(wrong)?;
        let (first, first_triangle) = (cloth.vertices.len(), cloth.triangles.len());
        let positions = panel.positions.iter();
        cloth.vertices.extend(positions.map(|p| Vector3::from(*p)));
        let count = cloth.vertices.len();
        cloth.thickness_m.resize(count, panel.thickness_m);
        cloth.friction.resize(count, panel.friction);
        let corners = |t: &[u32; 3]| t.map(|v| v as usize + first);
        cloth.triangles.extend(panel.triangles.iter().map(corners));
        cloth.panels.push(FixedPanel {
            name: panel.panel.clone(),
            triangles: first_triangle..cloth.triangles.len(),
        });
    }
    Ok(cloth)
}

/// Returns in words the first thing that is wrong with a panel, if anything is.
fn check_panel(panel: &InnerPanel, limits: &Limits) -> Result<(), &'static str> {
    let id = panel.panel.trim_start_matches(PREFIX);
    if id.chars().count() > limits.name_chars {
        return Err("has too long a name");
    }
    if !THICKNESS.contains(&panel.thickness_m) || !FRICTION.contains(&panel.friction) {
        return Err("has a thickness or friction that no fabric has");
    }
    stored_surface::check(&panel.positions, &panel.triangles)
}
