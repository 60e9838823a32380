//! The shape that a garment is to be sewn on from (P12): found by the id of its fit, put into the
//! garment file by content, and checked.

use super::garment::{Garment, StartPanel, StartRef, StartShape};
use super::library::{AssetLibrary, FinishedFit, NoFinishedFit};
use crate::config::Limits;
use crate::fault::{Fault, GarmentCode};
use std::sync::Arc;
use uuid::Uuid;

/// Largest coordinate of a start \[m\].
const LARGEST: f64 = 100.0;

/// Puts the shape that `garment` starts from into it, and returns that shape; none if there is none
/// or it is at fault.
pub(super) fn inline_start(
    garment: &mut Garment,
    library: &dyn AssetLibrary,
    limits: &Limits,
    faults: &mut Vec<Fault>,
) -> Option<Arc<StartShape>> {
    let start = match garment.start_from.take()? {
        StartRef::Id(id) => found(id, library),
        StartRef::Whole(start) => Ok(*start),
    };
    match start.and_then(|start| check(&start, limits).map(|()| start)) {
        Ok(start) => {
            garment.start_from = Some(StartRef::Whole(Box::new(start.clone())));
            Some(Arc::new(start))
        }
        Err(fault) => {
            faults.push(fault);
            None
        }
    }
}

/// Finds the shape in which a fit ended.
fn found(id: Uuid, library: &dyn AssetLibrary) -> Result<StartShape, Fault> {
    let FinishedFit { mesh, report, .. } =
        library.finished_fit(id).map_err(|none| refused(id, none))?;
    let panels = mesh.panels.into_iter().map(|panel| StartPanel {
        panel: panel.panel,
        positions: panel.positions,
        uv: panel.uv,
        triangles: panel.triangles,
    });
    Ok(StartShape {
        energy_j: report.energy_j.total(),
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

/// Checks that a start is a shape of triangles within the limits.
fn check(start: &StartShape, limits: &Limits) -> Result<(), Fault> {
    let fault = |detail: String| {
        Fault::new(GarmentCode::StartShape, "/start_from", detail).fix(
            "give the id of a fit that has succeeded, or `start_from` of a saved file as it is",
        )
    };
    let count = |of: fn(&StartPanel) -> usize| start.panels.iter().map(of).sum::<usize>();
    let vertices = count(|panel| panel.positions.len());
    // A sheet has about twice as many triangles as vertices.
    if vertices > limits.mesh_vertices || count(|p| p.triangles.len()) > 2 * limits.mesh_vertices {
        let detail = format!(
            "the start has {vertices} vertices; at most {} are taken",
            limits.mesh_vertices
        );
        return Err(fault(detail));
    }
    let named = |panel: &StartPanel, what| {
        let id: String = panel.panel.chars().take(60).collect();
        fault(format!("panel {id} of the start {what}"))
    };
    for panel in &start.panels {
        check_panel(panel, limits).map_err(|what| named(panel, what))?;
    }
    Ok(())
}

/// Returns in words the first thing that is wrong with a panel, if anything is.
fn check_panel(panel: &StartPanel, limits: &Limits) -> Result<(), &'static str> {
    let is_wrong = |p: &f64| !(-LARGEST..=LARGEST).contains(p);
    let count = panel.positions.len();
    if panel.panel.chars().count() > limits.name_chars {
        return Err("has too long a name");
    }
    if panel.uv.len() != count {
        return Err("has not as many pattern coordinates as positions");
    }
    if panel.positions.iter().flatten().any(is_wrong) || panel.uv.iter().flatten().any(is_wrong) {
        return Err("has a position that is not near the body");
    }
    if panel
        .triangles
        .iter()
        .flatten()
        .any(|v| *v as usize >= count)
    {
        return Err("has a triangle with a corner that is not there");
    }
    Ok(())
}
