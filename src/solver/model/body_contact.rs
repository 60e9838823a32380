//! Contact of a scene's cloth with its body: of particles, and on the mesh asked for of what is
//! between them.

use crate::scene::{Body, Scene};
use crate::solver::forces::Potential;
use crate::solver::forces::contact::{
    BodyContact, Chord, ChordContact, Facet, Friction, TipContact, kept_distance,
};
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::dof_map::DofMap;
use crate::solver::model::rest_shape::{rest_area, vertex_areas};
use std::collections::BTreeMap;

/// Distance for which explicit steps carry on a sample of the body \[m\]: third-order terms stay
/// below 1e-11 m.
const EXPLICIT_REUSE: f64 = 2e-5;

/// Sag of half an edge over a curve of the body that is felt \[m\].
const SAG_FELT: f64 = 1e-3;

/// Least curvature of a tip \[1/m\]: long edges sag over all of a body, and what is rounder is left
/// to them.
const TIP: f64 = 100.0;

/// Returns the terms that keep cloth off `body`.
pub(super) fn body_contact(
    scene: &Scene,
    body: &Body,
    dof_map: &DofMap,
    build_options: &BuildOptions<'_>,
) -> Vec<Box<dyn Potential>> {
    // The pressure of the skin acts over the area of the cloth: harder skin is more of it.
    let mut area = dof_map.sum(&vertex_areas(scene));
    area.iter_mut()
        .for_each(|area| *area *= scene.body_hardness);
    let anchors = build_options.friction.filter(|_| scene.friction > 0.0);
    let friction = anchors.map(|a| Friction::new(scene.friction, dof_map.count).with_anchors(a));
    let reuse = if build_options.explicit {
        EXPLICIT_REUSE
    } else {
        0.0
    };
    let contact = BodyContact::new(body.clone(), kept_distance(scene), &area)
        .with_friction(friction)
        .with_reuse(reuse);
    let mut terms: Vec<Box<dyn Potential>> = vec![Box::new(contact)];
    if build_options.finest {
        let chords = chords(scene, dof_map);
        terms.push(Box::new(ChordContact::new(body.clone(), chords, reuse)));
    }
    if build_options.finest && !build_options.explicit {
        let corners = dof_map.triangles(&scene.mesh.triangles);
        let tips = tip_contact(scene, body, corners);
        terms.extend(tips.map(|tips| Box::new(tips) as Box<dyn Potential>));
    }
    terms
}

/// Returns the edges of the mesh, each with a third of the area of the triangles beside it.
fn chords(scene: &Scene, dof_map: &DofMap) -> Vec<Chord> {
    let mut areas: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for t in &scene.mesh.triangles {
        let third = rest_area(t.map(|v| scene.mesh.uv[v])).abs() / 3.0;
        let [a, b, c] = t.map(|v| dof_map.of_vertex[v]);
        for [i, j] in [[a, b], [b, c], [c, a]] {
            if i != j {
                *areas.entry([i.min(j), i.max(j)]).or_default() += third;
            }
        }
    }
    let chord = |(ends, area): ([usize; 2], f64)| Chord {
        ends,
        area: area * scene.body_hardness,
    };
    areas.into_iter().map(chord).collect()
}

/// Returns contact of the triangles of the mesh, between these particles, with the tips of the body
/// that are too sharp for it; none if there are none.
pub(crate) fn tip_contact(
    scene: &Scene,
    body: &Body,
    corners: Vec<[usize; 3]>,
) -> Option<TipContact> {
    let facets = corners.into_iter().zip(&scene.mesh.triangles);
    let facets: Vec<_> = facets
        .filter(|([a, b, c], _)| a != b && b != c && c != a)
        .map(|(corners, t)| Facet {
            corners,
            area: rest_area(t.map(|v| scene.mesh.uv[v])).abs(),
        })
        .collect();
    let area: f64 = facets.iter().map(|facet| facet.area).sum();
    // Of a triangle of the mean area and equal sides.
    let edge_square = 4.0 / 3.0_f64.sqrt() * area / facets.len() as f64;
    // Half an edge sags by its square times the curvature over 8.
    let sharpness = (32.0 * SAG_FELT / edge_square).max(TIP);
    let tips = body.avatar()?.tips(sharpness)?;
    Some(TipContact::new(
        body.clone(),
        tips,
        facets,
        scene.body_hardness,
    ))
}
