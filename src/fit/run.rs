//! Sews and drapes a resolved garment.

use super::crossings::FoundCrossings;
use super::garment::{Garment, SelfContact};
use super::girths;
use super::harder;
use super::layers;
use super::maps;
use super::resolve::ResolvedGarment;
use super::starts;
use super::support;
use super::verdict::{Demands, verdict};
use super::warm_start;
use crate::export::{DrapedPanel, GarmentMesh, VertexMaps};
use crate::fault::{Faults, PlacementCode, Warning, quoted_list};
use crate::memory;
use crate::mesh::{self, ClothMesh, PanelRange};
use crate::scene::{self, Avatar, Body, BodySource, Limbs, PanelParts, Parts, Scene};
use crate::solver::{Analysis, Context, DrapeReport, SkippedTerm};
use nalgebra::Vector3;
use std::sync::Arc;

/// The result of a fit.
#[derive(Clone, Debug)]
pub struct FitOutcome {
    /// The shape, the best one even if it did not converge.
    pub mesh: GarmentMesh,
    /// The report that says how far to trust it.
    pub report: DrapeReport,
    /// True if it was stopped by the cancel token.
    pub canceled: bool,
}

/// Sews and drapes a resolved garment.
///
/// # Errors
/// Faults that show only on the way: a mesh too fine for the limits.
pub fn run(garment: &ResolvedGarment, context: &mut Context<'_>) -> Result<FitOutcome, Faults> {
    let options = &garment.garment().simulate;
    let began = (context.cpu_s)();
    let cloth = triangulate(garment, context)?;
    let meshed = (context.cpu_s)();
    let (mut scene, warnings) = assemble(garment, cloth)?;
    let assembled = (context.cpu_s)();
    let names = garment.pattern.panels.iter().map(|panel| &*panel.id);
    let names: Vec<_> = names.collect();
    let (mut drape, left_start) = warm_start::drape(
        (&scene, &names),
        garment.start(),
        &options.less_spent(assembled - began),
        context,
    );
    let mut found = None;
    if !drape.canceled {
        let left = options.less_spent((context.cpu_s)() - began);
        found = harder::settle(&mut scene, (&mut drape, &names), &left, context);
    }
    let solved = (context.cpu_s)();
    let mut mesh = garment_mesh(garment, &scene, &drape.positions);
    let kinds = &garment.garment().maps;
    if !kinds.is_empty() && !drape.canceled {
        drape.report.maps = maps::add(kinds, (&scene, &names), &drape, &mut mesh);
    }
    let mut report = drape.report;
    if !drape.canceled {
        let pairs = context.limits.crossing_pairs;
        report.support = support::support(&scene, &names, &drape.positions, &report.support);
        report.layers_wrong_area_m2 = layers::wrong_area(&scene, &drape.positions, pairs);
        judge(garment, found, &mut report);
    }
    report.skipped_terms.extend(left_out_limbs(garment));
    report.cpu_s.mesh = meshed - began;
    report.cpu_s.assemble = assembled - meshed;
    report.cpu_s.export = (context.cpu_s)() - solved;
    report.cpu_s.total = (context.cpu_s)() - began;
    report.memory_peak_bytes = memory::peak_bytes().unwrap_or(0);
    report.plan.time_limit_s = options.time_limit_s;
    report.warnings = garment.warnings().to_vec();
    report.warnings.extend(warnings);
    report.warnings.extend(left_start);
    report.warnings.extend(size_warnings(&scene));
    let is_sewn_here = report.started_from.is_none() && !options.method.is_time_stepping();
    if is_sewn_here {
        report.warnings.extend(sewn_first(&scene, &names));
    }
    Ok(FitOutcome {
        mesh,
        report,
        canceled: drape.canceled,
    })
}

/// Returns what a user should know about the size of a garment, before it is sewn.
pub(super) fn size_warnings(scene: &Scene) -> impl Iterator<Item = Warning> {
    let warnings = [girths::too_small(scene), support::too_large(scene)];
    warnings.into_iter().flatten()
}

/// Returns the warning that some panels, of these names, are sewn before the others, if any are.
fn sewn_first(scene: &Scene, names: &[&str]) -> Option<Warning> {
    if scene.carriers.is_empty() {
        return None;
    }
    let ids = quoted_list(scene.carriers.iter().map(|&panel| names[panel]));
    let detail = format!("{ids} carry the garment: they are sewn to each other before the others");
    Some(Warning::new(PlacementCode::SewnFirst, "/seams", detail))
}

/// Says in the report which crossings a shape has, where they could be counted, and if it is good.
fn judge(garment: &ResolvedGarment, found: Option<FoundCrossings>, report: &mut DrapeReport) {
    if let Some(found) = found {
        report.self_intersections = Some(found.cloth);
        report.degenerate_triangles = Some(found.degenerate);
        report.body_intersections = found.body;
        report.vertices_inside_body = found.inside;
        report.intersections = found.places;
    }
    let demands = Demands {
        no_crossings: garment.garment().self_contact != SelfContact::Off,
        has_avatar: garment.avatar.is_some(),
        has_layers: !garment.layers.is_empty(),
        seam_gap_m: garment.garment().simulate.seam_eps_m,
    };
    report.good = Some(verdict(report, demands));
}

/// Returns the limbs that the body does without.
fn left_out_limbs(garment: &ResolvedGarment) -> Vec<SkippedTerm> {
    let Some(BodySource::Form(form)) = &garment.avatar else {
        return vec![];
    };
    let Some(Limbs { arms, legs }) = form.limbs else {
        return vec![];
    };
    let parts = [("arms", arms), ("legs", legs)].into_iter();
    let left_out = parts.filter(|(_, is_there)| !is_there);
    let skipped = left_out.map(|(name, _)| SkippedTerm {
        name: format!("{name} of the body"),
        because: "no panel starts near them, or `limbs` leaves them out".to_owned(),
    });
    skipped.collect()
}

/// Assembles the scene of a resolved garment, before anything moves.
///
/// # Errors
/// As [`run`].
pub fn scene(garment: &ResolvedGarment, context: &Context<'_>) -> Result<Scene, Faults> {
    let (scene, _) = assemble(garment, triangulate(garment, context)?)?;
    Ok(scene)
}

/// Returns the body that a resolved garment is draped on, if there is one. It is made once.
///
/// # Errors
/// Measurements outside what a person has.
pub(super) fn avatar(garment: &ResolvedGarment) -> Result<Option<Arc<Avatar>>, Faults> {
    let make = |body| garment.bodies.build(body);
    let avatar = garment.avatar.as_ref().map(make).transpose();
    avatar.map_err(|faults| faults.under("/avatar"))
}

fn triangulate(garment: &ResolvedGarment, context: &Context<'_>) -> Result<ClothMesh, Faults> {
    mesh::triangulate(
        &garment.pattern,
        &garment.seams,
        garment.garment().simulate.edge_length_m,
        context.limits,
        context.cancel,
    )
}

/// Assembles the scene of a garment on its mesh; with it what a user should know about the starts
/// of its panels.
fn assemble(garment: &ResolvedGarment, mesh: ClothMesh) -> Result<(Scene, Vec<Warning>), Faults> {
    let avatar = avatar(garment)?;
    let (placed, warnings) = starts::starts(garment, &mesh, avatar.as_deref());
    let panels = garment.panels.iter().zip(placed);
    let panels = panels.map(|(panel, placed)| PanelParts {
        cut: panel.cut,
        placed,
    });
    let pins = garment.pins.iter();
    let scene = scene::build(Parts {
        panels: panels.collect(),
        fabrics: garment.fabrics.iter().map(|f| f.fabric.clone()).collect(),
        friction: garment.garment().friction,
        pins: pins
            .map(|pin| mesh.panels[pin.panel].corners[pin.corner])
            .collect(),
        body: avatar.map(Body::Avatar),
        mesh,
    });
    let scene = Scene {
        fixed_cloth: garment.over.clone(),
        layers: garment.layers.clone(),
        wind: garment.wind,
        self_contact: keeps_apart(garment.garment()),
        ..scene
    };
    Ok((scene, warnings))
}

/// Returns true if cloth is to be kept from passing through cloth. Motion has no such contact, and
/// begins with a shape that is at rest without it.
fn keeps_apart(garment: &Garment) -> bool {
    garment.self_contact != SelfContact::Off && garment.simulate.analysis == Analysis::Static
}

/// Returns the shape of each panel, its triangles turned so that they are counter-clockwise seen
/// from outside.
fn garment_mesh(
    garment: &ResolvedGarment,
    scene: &Scene,
    positions: &[Vector3<f64>],
) -> GarmentMesh {
    let panels = garment.pattern.panels.iter().zip(&garment.panels);
    let panels = panels
        .zip(&scene.mesh.panels)
        .map(|((outline, panel), range)| DrapedPanel {
            panel: outline.id.clone(),
            fabric: garment.fabrics[panel.cut.fabric].id.clone(),
            positions: positions[range.vertices.clone()]
                .iter()
                .map(|p| (*p).into())
                .collect(),
            uv: scene.mesh.uv[range.vertices.clone()].to_vec(),
            triangles: panel_triangles(&scene.mesh, range, panel.cut.face_down),
            maps: VertexMaps::default(),
        });
    GarmentMesh {
        panels: panels.collect(),
    }
}

/// Returns the triangles of a panel by indices of its own vertices, turned over if its drawn side
/// is in.
fn panel_triangles(mesh: &ClothMesh, range: &PanelRange, face_down: bool) -> Vec<[u32; 3]> {
    let local = |v: usize| {
        u32::try_from(v - range.vertices.start)
            .expect("Limits bound the vertices of a mesh below 2^32")
    };
    let turn = |[a, b, c]: [u32; 3]| if face_down { [a, c, b] } else { [a, b, c] };
    let triangles = mesh.triangles[range.triangles.clone()].iter();
    triangles.map(|t| turn(t.map(local))).collect()
}
