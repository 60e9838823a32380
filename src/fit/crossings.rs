//! Places where a garment passes through itself and through the body, by an exact test that
//! knows nothing of the solver.

use crate::scene::{Avatar, Body, FixedCloth, Scene};
use crate::solver::{Intersection, IntersectionKind};
use nalgebra::Vector3;
use seamster_crossings::{
    Crossing, CrossingList, CrossingReport, SearchLimits, Surface, find_crossings,
    find_crossings_between,
};
use std::collections::BTreeMap;

/// Crossings of each kind whose places are looked at.
const KEPT: usize = 10_000;
/// Places of each kind that a report names at most.
const PLACES: usize = 25;
/// Width of a place \[m\]: about that of a fold.
const PLACE: f64 = 0.03;

/// The crossings of a garment: how many of each kind, and the places where most of them are.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct FoundCrossings {
    /// Pairs of triangles of cloth that meet, those with a garment worn beneath among them.
    pub(super) cloth: usize,
    /// Triangles without area.
    pub(super) degenerate: usize,
    /// Pairs of a triangle of cloth and one of the body that meet; none without a body.
    pub(super) body: Option<usize>,
    /// Vertices inside the body; none without a body.
    pub(super) inside: Option<usize>,
    /// Places, those with most crossings first.
    pub(super) places: Vec<Intersection>,
}

/// Finds the crossings of a garment whose panels have the names `panels`, at `positions` \[m\] in
/// the single precision in which meshes are written, looking at `pairs` of triangles at most; none
/// if that does not do, or if single precision does not hold a position.
pub(super) fn find(
    scene: &Scene,
    panels: &[&str],
    positions: &[Vector3<f64>],
    pairs: usize,
) -> Option<FoundCrossings> {
    let mesh = &scene.mesh;
    let points = single(positions);
    let triangles = indices(&mesh.triangles);
    let stitches: Vec<[usize; 2]> = mesh.stitches.iter().map(|s| [s.a, s.b]).collect();
    let cloth = Surface::new(&points, &triangles, &indices(&stitches)).ok()?;
    let limits = SearchLimits { kept: KEPT, pairs };
    let avatar = scene.body.as_ref().and_then(Body::avatar);
    let report = match avatar {
        Some(avatar) => with_body(&cloth, avatar, limits)?,
        None => find_crossings(&cloth, None, limits).ok()?,
    };
    let fixed = scene.fixed_cloth.as_deref();
    let beneath = match fixed {
        Some(fixed) => with_fixed(&cloth, fixed, limits)?,
        None => CrossingList::default(),
    };
    Some(FoundCrossings {
        cloth: report.cloth.count + beneath.count,
        degenerate: report.degenerate.len(),
        body: avatar.map(|_| report.body.count),
        inside: avatar.map(|_| report.inside.len()),
        places: places(scene, panels, &points, (&report, &beneath)),
    })
}

fn with_body(cloth: &Surface<'_>, avatar: &Avatar, limits: SearchLimits) -> Option<CrossingReport> {
    let points = single(&avatar.surface.vertices);
    let triangles = indices(&avatar.surface.triangles);
    let body = Surface::new(&points, &triangles, &[]).ok()?;
    find_crossings(cloth, Some(&body), limits).ok()
}

/// Finds the crossings of cloth with cloth that does not move.
fn with_fixed(
    cloth: &Surface<'_>,
    fixed: &FixedCloth,
    limits: SearchLimits,
) -> Option<CrossingList> {
    let (points, triangles) = (single(&fixed.vertices), indices(&fixed.triangles));
    let fixed = Surface::new(&points, &triangles, &[]).ok()?;
    find_crossings_between(cloth, &fixed, limits).ok()
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "the judged positions are those written out; what does not fit is refused as not finite"
)]
pub(super) fn single(positions: &[Vector3<f64>]) -> Vec<[f32; 3]> {
    let single = |p: &Vector3<f64>| [p.x as f32, p.y as f32, p.z as f32];
    positions.iter().map(single).collect()
}

pub(super) fn indices<const N: usize>(of: &[[usize; N]]) -> Vec<[u32; N]> {
    let index =
        |v: usize| u32::try_from(v).expect("Limits bound the vertices of a mesh below 2^32");
    of.iter().map(|v| v.map(index)).collect()
}

/// Returns the places where most crossings are.
fn places(
    scene: &Scene,
    panels: &[&str],
    points: &[[f32; 3]],
    (report, beneath): (&CrossingReport, &CrossingList),
) -> Vec<Intersection> {
    let mesh = &scene.mesh;
    let fixed = scene.fixed_cloth.iter().flat_map(|fixed| &fixed.panels);
    let fixed: Vec<_> = fixed.collect();
    let panel = |triangle: u32| mesh.panel_of_triangle(triangle as usize);
    let mut places = Places::default();
    for Crossing { triangles, point } in &report.cloth.kept {
        let [a, b] = triangles.map(panel);
        places.add(IntersectionKind::Cloth, vec![a.min(b), a.max(b)], *point);
    }
    for Crossing { triangles, point } in &beneath.kept {
        let triangle = triangles[1] as usize;
        // Panels beneath are numbered after the garment's own.
        let other = panels.len() + fixed.partition_point(|p| p.triangles.end <= triangle);
        let both = vec![panel(triangles[0]), other];
        places.add(IntersectionKind::Cloth, both, *point);
    }
    for &triangle in report.degenerate.iter().take(KEPT) {
        let corner = points[mesh.triangles[triangle as usize][0]];
        let panel = vec![panel(triangle)];
        places.add(IntersectionKind::Degenerate, panel, corner.map(f64::from));
    }
    for Crossing { triangles, point } in &report.body.kept {
        places.add(IntersectionKind::Body, vec![panel(triangles[0])], *point);
    }
    for &vertex in report.inside.iter().take(KEPT) {
        let vertex = vertex as usize;
        let panel = mesh.panel_of_vertex(vertex);
        let at = points[vertex].map(f64::from);
        places.add(IntersectionKind::InsideBody, vec![panel], at);
    }
    let fixed = fixed.iter().map(|panel| &*panel.name);
    let names: Vec<_> = panels.iter().copied().chain(fixed).collect();
    places.most(&names)
}

/// Kind, panels and cell of space of a crossing.
type PlaceKey = (IntersectionKind, Vec<usize>, [i64; 3]);

/// Crossings gathered by place: how many, and a point of the first.
#[derive(Default)]
struct Places(BTreeMap<PlaceKey, (usize, [f64; 3])>);

impl Places {
    fn add(&mut self, kind: IntersectionKind, panels: Vec<usize>, at: [f64; 3]) {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "a cast of floats to integers saturates, and places far off may be one"
        )]
        let cell = at.map(|coordinate| (coordinate / PLACE).floor() as i64);
        let place = self.0.entry((kind, panels, cell)).or_insert((0, at));
        place.0 += 1;
    }

    /// Returns the places with most crossings, those first.
    fn most(self, names: &[&str]) -> Vec<Intersection> {
        let mut places: Vec<_> = self.0.into_iter().collect();
        // Stable: places with as many crossings stay in the order of their keys.
        places.sort_by_key(|(_, (count, _))| std::cmp::Reverse(*count));
        let mut named = BTreeMap::new();
        places.retain(|((kind, ..), _)| {
            let named: &mut usize = named.entry(*kind).or_default();
            *named += 1;
            *named <= PLACES
        });
        let place = |((kind, panels, _), (count, at)): (PlaceKey, _)| Intersection {
            kind,
            panels: panels.into_iter().map(|p| names[p].to_owned()).collect(),
            at,
            count,
        };
        places.into_iter().map(place).collect()
    }
}
