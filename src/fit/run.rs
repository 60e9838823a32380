//! Sews and drapes a prepared garment.

use super::garment::AvatarAsked;
use super::prepare::{Prepared, fabric, placement};
use crate::export::{GarmentMesh, PanelMesh};
use crate::fault::{Fault, Faults};
use crate::mesh::{self, ClothMesh};
use crate::scene::{self, Avatar, Body, Cut, PanelParts, Parts, Scene, ToPlace};
use crate::seam::Face;
use crate::solver::{self, Context, DrapeReport, SolverOptions};
use nalgebra::Vector3;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a fit comes to.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The shape, the best one even if it did not converge.
    pub mesh: GarmentMesh,
    /// How far to trust it.
    pub report: DrapeReport,
    /// Whether it was stopped by the cancel token.
    pub canceled: bool,
}

/// Direction of the warp where neither the pattern nor the garment says: +y.
const WARP_DEG: f64 = 90.0;

/// Sews and drapes a prepared garment.
///
/// # Errors
/// What could be found only on the way: a mesh too fine for the limits.
pub fn run(prepared: &Prepared, context: &mut Context<'_>) -> Result<Outcome, Faults> {
    let began = (context.cpu_s)();
    let simulate = &prepared.garment.simulate;
    let cloth = triangulate(prepared, context)?;
    let meshed = (context.cpu_s)();
    let scene = assemble(prepared, cloth)?;
    let assembled = (context.cpu_s)();
    let drape = solver::drape(&scene, &within(simulate, assembled - began), context);
    let solved = (context.cpu_s)();
    let mesh = garment_mesh(prepared, &scene, &drape.positions);
    let mut report = drape.report;
    report.cpu_s.mesh = meshed - began;
    report.cpu_s.assemble = assembled - meshed;
    report.cpu_s.export = (context.cpu_s)() - solved;
    report.cpu_s.total = (context.cpu_s)() - began;
    report.memory_peak_bytes = memory_peak();
    report.plan.time_limit_s = simulate.time_limit_s;
    report.warnings = prepared.warnings().to_vec();
    Ok(Outcome {
        mesh,
        report,
        canceled: drape.canceled,
    })
}

/// The same with the CPU time that was spent already taken off what is allowed \[s\].
fn within(asked: &SolverOptions, spent: f64) -> SolverOptions {
    let left = |limit: f64| (limit - spent).max(0.0);
    SolverOptions {
        time_limit_s: asked.time_limit_s.map(left),
        ..asked.clone()
    }
}

/// The assembled scene of a prepared garment, before anything moves.
///
/// # Errors
/// As [`run`].
pub fn scene(prepared: &Prepared, context: &Context<'_>) -> Result<Scene, Faults> {
    assemble(prepared, triangulate(prepared, context)?)
}

fn triangulate(prepared: &Prepared, context: &Context<'_>) -> Result<ClothMesh, Faults> {
    mesh::triangulate(
        &prepared.pattern,
        &prepared.seams,
        prepared.garment.simulate.edge_length_m,
        context.limits,
        context.cancel,
    )
}

fn assemble(prepared: &Prepared, mesh: ClothMesh) -> Result<Scene, Faults> {
    let Prepared {
        garment,
        pattern,
        seams,
        ..
    } = prepared;
    let avatar = match &garment.avatar {
        Some(AvatarAsked::Form(asked)) => Some(Arc::new(
            asked
                .form
                .build()
                .map_err(|faults| faults.under("/avatar/form"))?,
        )),
        Some(AvatarAsked::Id(id)) => {
            return Err(Fault::new(
                "garment/avatar_unknown",
                "/avatar",
                format!("avatar {id} was not looked up"),
            )
            .into());
        }
        None => None,
    };
    let mut fabrics = Vec::new();
    let mut number: BTreeMap<&str, usize> = BTreeMap::new();
    let mut panels = Vec::new();
    for (panel, face) in pattern.panels.iter().zip(&seams.faces) {
        let (id, coefficients) = fabric(garment, &panel.id);
        let fabric = *number.entry(id).or_insert_with(|| {
            fabrics.push(coefficients.clone());
            fabrics.len() - 1
        });
        let asked_grain = garment.panels.get(&panel.id).and_then(|p| p.grain_deg);
        let warp_deg = asked_grain
            .or(panel.grain.map(|g| g.angle_deg))
            .unwrap_or(WARP_DEG);
        let cut = Cut {
            fabric,
            warp_angle: warp_deg.to_radians(),
            face_down: *face == Face::Down,
        };
        let to_place = ToPlace {
            panel,
            face: *face,
            asked: placement(garment, pattern, &panel.id),
        };
        panels.push(PanelParts {
            cut,
            placed: scene::place(to_place, avatar.as_deref().map(|a: &Avatar| a))?,
        });
    }
    let pin =
        |pin: &super::Pin| Some(mesh.panels[pattern.panel_index(&pin.panel)?].corners[pin.corner]);
    let pins = garment.pins.iter().filter_map(pin).collect();
    let scene = scene::build(Parts {
        mesh,
        panels,
        fabrics,
        body: avatar.map(Body::Avatar),
        friction: garment.friction,
        pins,
    });
    let wind = |wind: super::garment::Wind| scene::Wind {
        velocity: wind.velocity_m_s.into(),
        gust: wind.gust,
    };
    Ok(Scene {
        wind: garment.wind.map(wind),
        ..scene
    })
}

/// The shape of each panel, its triangles turned so that they are counter-clockwise seen from outside.
fn garment_mesh(prepared: &Prepared, scene: &Scene, positions: &[Vector3<f64>]) -> GarmentMesh {
    let panels = prepared
        .pattern
        .panels
        .iter()
        .zip(&scene.mesh.panels)
        .zip(&scene.cut);
    let one = |((panel, range), cut): ((&crate::pattern::Panel, &mesh::PanelRange), &Cut)| {
        let first = range.vertices.start;
        let local = |v: usize| {
            u32::try_from(v - first).expect("Limits bound the vertices of a mesh below 2^32")
        };
        let turn = |[a, b, c]: [u32; 3]| if cut.face_down { [a, c, b] } else { [a, b, c] };
        PanelMesh {
            panel: panel.id.clone(),
            fabric: fabric(&prepared.garment, &panel.id).0.to_owned(),
            positions: positions[range.vertices.clone()]
                .iter()
                .map(|p| (*p).into())
                .collect(),
            uv: scene.mesh.uv[range.vertices.clone()].to_vec(),
            triangles: scene.mesh.triangles[range.triangles.clone()]
                .iter()
                .map(|t| turn(t.map(local)))
                .collect(),
        }
    };
    GarmentMesh {
        panels: panels.map(one).collect(),
    }
}

/// Largest resident memory of the process \[bytes\], 0 where the system does not tell.
fn memory_peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    peak.and_then(|kib| kib.trim().trim_end_matches(" kB").parse::<u64>().ok())
        .map_or(0, |kib| kib * 1024)
}
