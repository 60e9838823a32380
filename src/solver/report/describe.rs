//! What a report says of a shape besides how it was reached: energies, terms, what was left out, whether it is worn.

use crate::scene::Scene;
use crate::solver::forces::TermKind;
use crate::solver::model::build::bends;
use crate::solver::model::system::System;
use crate::solver::report::schema::{DrapeReport, Energy, SkippedTerm, Support, TermTime};
use nalgebra::Vector3;

/// How far the middle of a garment may sink while it comes to rest before it counts as fallen off \[m\].
const FALLEN: f64 = 0.15;
/// How deep inside the body cloth may be that still is worn on it \[m\]: more than any layer gives way or any triangle cuts off.
const INSIDE: f64 = 0.01;

#[inline(never)] // so that a profile tells what it takes
pub(crate) fn energies(system: &mut System<'_>, x: &[Vector3<f64>]) -> Energy {
    Energy {
        stretch: system.energy_of(TermKind::Stretch, x),
        bend: system.energy_of(TermKind::Bend, x),
        gravity: system.energy_of(TermKind::Gravity, x),
        seam: system.energy_of(TermKind::Seam, x),
        contact: system.energy_of(TermKind::Contact, x),
    }
}

/// Adds the time that each term of `system` took.
pub(crate) fn add_terms(terms: &mut Vec<TermTime>, system: &System<'_>) {
    for term in of_system(system) {
        match terms.iter_mut().find(|t| t.name == term.name) {
            Some(known) => known.cpu_s += term.cpu_s,
            None => terms.push(term),
        }
    }
}

fn of_system(system: &System<'_>) -> Vec<TermTime> {
    let mut terms: Vec<TermTime> = system
        .terms
        .iter()
        .map(|t| TermTime {
            name: t.potential.kind().name().to_owned(),
            cpu_s: t.cpu_s,
        })
        .collect();
    if system.contact.is_some() {
        terms.push(TermTime {
            name: "contact".to_owned(),
            cpu_s: system.contact_cpu_s,
        });
    }
    terms
}

/// The terms that `scene` has no need of, but for those in `ran`: coarser meshes bend even where the cloth does not.
pub(crate) fn left_out(scene: &Scene, ran: &[TermTime]) -> Vec<SkippedTerm> {
    let mut left_out = Vec::new();
    let mut leave = |name: &str, because: &str| {
        if ran.iter().all(|term| term.name != name) {
            left_out.push(SkippedTerm {
                name: name.to_owned(),
                because: because.to_owned(),
            });
        }
    };
    if scene.gravity == Vector3::zeros() {
        leave("gravity", "the scene has none");
    }
    if scene.wind.is_none() {
        leave("wind", "the scene has none");
    }
    leave("self_contact", "cloth against cloth is not looked for");
    if scene.body.is_none() {
        leave("contact", "the scene has no avatar");
        leave("friction", "the scene has no avatar");
    } else if scene.friction == 0.0 {
        leave("friction", "the coefficient is 0");
    }
    if scene.mesh.stitches.is_empty() {
        leave("seam", "the scene has no seams");
    }
    if !bends(scene) {
        leave("bend", "the fabrics have no bending rigidity");
    }
    left_out
}

/// Mean height against gravity \[m\]; 0 where there is none.
pub(crate) fn mean_height(gravity: &Vector3<f64>, x: &[Vector3<f64>]) -> f64 {
    let up = -gravity.try_normalize(0.0).unwrap_or_default();
    x.iter().map(|p| p.dot(&up)).sum::<f64>() / x.len().max(1) as f64
}

/// Whether the body carries the garment: it came to rest on it without sinking far.
pub(crate) fn worn(scene: &Scene, report: &DrapeReport, sunk: f64) -> Support {
    let way = if sunk < 0.0 { "higher" } else { "lower" };
    let moved = format!("{:.0} mm {way} than it was sewn", sunk.abs() * 1e3);
    let (ok, because) = if scene.body.is_none() {
        (false, "there is no avatar".to_owned())
    } else if !report.converged {
        (
            false,
            format!("it did not come to rest; its middle is {moved}"),
        )
    } else if report.penetration_max_m > INSIDE {
        let inside = report.penetration_max_m * 1e3;
        (
            false,
            format!("it came to rest with cloth {inside:.0} mm inside the body"),
        )
    } else if sunk > FALLEN {
        let sunk = sunk * 1e3;
        (
            false,
            format!("it sank by {sunk:.0} mm: nothing holds it where it was put"),
        )
    } else {
        (true, format!("it came to rest on the body, {moved}"))
    };
    Support { ok, because }
}
