//! The shape that a garment is to be sewn on from (P12): found by the id of its fit, put into the
//! garment file by content, and checked.

use super::garment::{AvatarRef, DressFormSpec, Garment, StartPanel, StartRef, StartShape};
use super::library::{AssetLibrary, FinishedFit, NoFinishedFit};
use super::stored_surface;
use crate::config::Limits;
use crate::fault::{Fault, GarmentCode};
use crate::pattern::Point2;
use uuid::Uuid;

/// Puts the shape that `garment` starts from into it, the last part that it lacks; none if that is
/// at fault.
pub(super) fn inline_start(
    garment: &mut Garment,
    library: &dyn AssetLibrary,
    limits: &Limits,
    faults: &mut Vec<Fault>,
) {
    let start = match garment.start_from.take() {
        None => return,
        Some(StartRef::Id(id)) => found(id, library).map(Box::new),
        Some(StartRef::Whole(start)) => Ok(start),
    };
    let checked = start.and_then(|start| {
        check_avatar(garment.avatar.as_ref(), start.avatar.as_ref())?;
        check_surface(&start, limits)?;
        Ok(start)
    });
    match checked {
        Ok(start) => garment.start_from = Some(StartRef::Whole(start)),
        Err(fault) => faults.push(fault),
    }
}

/// Finds the shape in which a fit ended.
fn found(id: Uuid, library: &dyn AssetLibrary) -> Result<StartShape, Fault> {
    let FinishedFit { garment, mesh } =
        library.finished_fit(id).map_err(|none| refused(id, none))?;
    let panels = mesh.panels.into_iter().map(|panel| StartPanel {
        panel: panel.panel,
        positions: panel.positions,
        uv: panel.uv,
        triangles: panel.triangles,
    });
    Ok(StartShape {
        avatar: garment.avatar,
        panels: panels.collect(),
    })
}

fn refused(id: Uuid, none: NoFinishedFit) -> Fault {
    match none {
        NoFinishedFit::Unknown => {
            let detail = format!("no fit has the id {id}");
            Fault::new(GarmentCode::StartUnknown, "/start_from", detail)
                .fix("leave it out, or give the id of a fit that has succeeded")
        }
        NoFinishedFit::NotSucceeded(status) => {
            let detail = format!("fit {id}, from which it is to start, is {status}");
            Fault::new(GarmentCode::StartUnfinished, "/start_from", detail)
                .fix("give the id of a fit that has succeeded, or leave it out")
        }
    }
}

/// Checks that both are worn on bodies of one kind: dress forms in the same pose, with the same
/// limbs where the garment states them, whatever their measures; or one body of one's own. Beside
/// arms in another pose a sleeve would hang in the air.
fn check_avatar(avatar: Option<&AvatarRef>, earlier: Option<&AvatarRef>) -> Result<(), Fault> {
    let detail = match (avatar, earlier) {
        (None, None) => return Ok(()),
        // An avatar that is not known is a fault of its own.
        (Some(AvatarRef::Id(_)), _) => return Ok(()),
        (Some(AvatarRef::Form(one)), Some(AvatarRef::Form(other))) => {
            match difference(one, other) {
                None => return Ok(()),
                Some(what) => format!("the earlier fit is worn on a dress form {what}"),
            }
        }
        (one, other) if one == other => return Ok(()),
        _ => "the earlier fit is worn on another body, or on none".to_owned(),
    };
    let fault = Fault::new(GarmentCode::StartAvatar, "/start_from", detail);
    Err(fault.fix("leave it out: sewn from flat panels it fits any body"))
}

/// Returns the difference of two dress forms, besides their measures, in words; none if there is
/// none. Limbs that the garment leaves to the service are those that its panels need.
fn difference(one: &DressFormSpec, other: &DressFormSpec) -> Option<&'static str> {
    let (one, other) = (one.form, other.form);
    if one.pose != other.pose {
        Some("in another pose")
    } else if one.limbs.is_some() && one.limbs != other.limbs {
        Some("with other limbs")
    } else {
        None
    }
}

/// Checks that a start is a surface with pattern coordinates, within the limits.
fn check_surface(start: &StartShape, limits: &Limits) -> Result<(), Fault> {
    let fault = |detail: String| {
        let fix =
            "give the id of a fit that has succeeded, or `start_from` of a saved file as it is";
        Fault::new(GarmentCode::StartShape, "/start_from", detail).fix(fix)
    };
    let count = |of: fn(&StartPanel) -> usize| start.panels.iter().map(of).sum::<usize>();
    let [vertices, triangles] = [
        count(|panel| panel.positions.len()),
        count(|panel| panel.triangles.len()),
    ];
    stored_surface::check_size(vertices, triangles, limits)
        .map_err(|detail| fault(format!("the start has {detail}")))?;
    for panel in &start.panels {
        let id = stored_surface::excerpt(&panel.panel);
        check_panel(panel, limits)
            .map_err(|what| fault(format!("panel {id} of the start {what}")))?;
    }
    Ok(())
}

/// Returns in words the first thing that is wrong with a panel, if anything is.
fn check_panel(panel: &StartPanel, limits: &Limits) -> Result<(), &'static str> {
    if panel.panel.chars().count() > limits.name_chars {
        return Err("has too long a name");
    }
    if panel.uv.len() != panel.positions.len() {
        return Err("has not as many pattern coordinates as positions");
    }
    if panel.uv.iter().flatten().any(stored_surface::is_far) {
        return Err("has a pattern coordinate that is no number of meters");
    }
    stored_surface::check(&panel.positions, &panel.triangles)?;
    let area = |t: &[u32; 3]| twice_area(t.map(|v| panel.uv[v as usize]));
    if panel.triangles.iter().any(|t| area(t) == 0.0) {
        return Err("has a triangle without area on the pattern");
    }
    Ok(())
}

fn twice_area([p, q, r]: [Point2; 3]) -> f64 {
    (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
}
