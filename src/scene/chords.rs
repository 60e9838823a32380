//! Panels that start so round that the edges of a coarser mesh would be chords through the body.

use super::{Body, Scene};
use crate::mesh::{ClothMesh, PanelRange};
use nalgebra::{Vector2, Vector3};
use std::collections::BTreeMap;

/// Mesh edges of the next coarser mesh over those of a mesh: it has a third of the vertices.
const COARSER_EDGE: f64 = 1.75;
/// Most that a panel may turn along one mesh edge at its start \[rad\]: the edge sags by an eighth
/// of the radius there.
const MOST_TURN: f64 = 1.0;
/// Longest mesh edges of a coarser mesh of what is worn \[m\]: a quarter of the girth of an arm.
/// Longer ones close through arms, ankles and shoulders, or beside them.
const LONGEST_WORN: f64 = 0.065;
/// Height of the strips in which the start of a panel is looked at, in mesh edges.
const STRIP_EDGES: f64 = 4.0;
/// Most strips of a panel.
const MOST_STRIPS: f64 = 8.0;

/// Returns the panels whose edges on a coarser mesh would be chords through the body: those that
/// start so round, as a sleeve or a collar, and of what is worn those whose edges are as long.
pub(super) fn chords(scene: &Scene) -> Vec<bool> {
    let is_worn = matches!(scene.body, Some(Body::Avatar(_)));
    let is_chord = |range| {
        let edge = COARSER_EDGE * mean_edge(&scene.mesh, range);
        is_worn && edge > LONGEST_WORN || edge * start_curvature(scene, range) > MOST_TURN
    };
    scene.mesh.panels.iter().map(is_chord).collect()
}

/// Returns the length of the edges of equal triangles as many as a panel has \[m\].
fn mean_edge(mesh: &ClothMesh, range: &PanelRange) -> f64 {
    let triangles = &mesh.triangles[range.triangles.clone()];
    let doubled = triangles.iter().map(|t| {
        let [p, q, r] = t.map(|v| Vector2::from(mesh.uv[v]));
        (q - p).perp(&(r - p)).abs()
    });
    let area = 0.5 * doubled.sum::<f64>() / triangles.len().max(1) as f64;
    (4.0 / 3f64.sqrt() * area).sqrt()
}

/// Returns the curvature of the start of a panel that is rolled one way, where it is rolled closest
/// \[1/m\]: of strips of equal height, the angles of the inner edges, each times the edge's length,
/// over the area (D. Cohen-Steiner, J.-M. Morvan, "Restricted Delaunay triangulations and normal
/// cycle", 19th Symposium on Computational Geometry, 2003).
fn start_curvature(scene: &Scene, range: &PanelRange) -> f64 {
    let strips = Strips::of(
        &scene.start[range.vertices.clone()],
        mean_edge(&scene.mesh, range),
    );
    let mut beside: BTreeMap<[usize; 2], Vector3<f64>> = BTreeMap::new();
    let mut sums = vec![[0.0; 2]; strips.count];
    for &[a, b, c] in &scene.mesh.triangles[range.triangles.clone()] {
        let [p, q, r] = [a, b, c].map(|v| scene.start[v]);
        let across = (q - p).cross(&(r - p));
        sums[strips.number((p.y + q.y + r.y) / 3.0)][1] += 0.5 * across.norm();
        for [from, to] in [[a, b], [b, c], [c, a]] {
            if let Some(other) = beside.insert([from.min(to), from.max(to)], across) {
                let [from, to] = [from, to].map(|v| scene.start[v]);
                let turned = other.angle(&across) * (to - from).norm();
                sums[strips.number(0.5 * (from.y + to.y))][0] += turned;
            }
        }
    }
    let of = |[turned, area]: &[f64; 2]| if *area > 0.0 { turned / area } else { 0.0 };
    sums.iter().map(of).fold(0.0, f64::max)
}

/// Strips of equal height between the lowest and the highest of some points.
struct Strips {
    lowest: f64,
    height: f64,
    count: usize,
}

impl Strips {
    /// As many as are some edges high each.
    fn of(points: &[Vector3<f64>], edge: f64) -> Self {
        let heights = points.iter().map(|p| p.y);
        let [lowest, highest] = heights
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| {
                [low.min(y), high.max(y)]
            });
        let fit = (highest - lowest) / (STRIP_EDGES * edge);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between one and a few"
        )]
        let count = fit.clamp(1.0, MOST_STRIPS) as usize;
        #[expect(clippy::cast_precision_loss, reason = "a few")]
        let height = (highest - lowest) / count as f64;
        Self {
            lowest,
            height,
            count,
        }
    }

    /// The number of the strip at a height.
    fn number(&self, y: f64) -> usize {
        let share = (y - self.lowest) / self.height.max(f64::MIN_POSITIVE);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "bounded by their number"
        )]
        let number = share.max(0.0) as usize;
        number.min(self.count - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Stitch;
    use crate::pattern::{Panel, Placement, PlacementAnchor};
    use crate::scene::{AnchoredPlacement, Cut, PanelParts, Parts, build, fabric};
    use crate::seam::Face;

    /// A panel 20 cm wide and 120 cm long of squares of 2 cm, at a place of the body.
    fn panel(at: PlacementAnchor) -> Scene {
        let (columns, rows, side) = (10, 60, 0.02);
        let uv = (0..=rows)
            .flat_map(|j| (0..=columns).map(move |i| [side * f64::from(i), side * f64::from(j)]));
        let at_corner = |i: usize, j: usize| j * (columns as usize + 1) + i;
        let (columns_of, rows_of) = (columns as usize, rows as usize);
        let triangles = (0..rows_of).flat_map(|j| {
            (0..columns_of).flat_map(move |i| {
                let [a, b, c, d] =
                    [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| at_corner(i, j));
                [[a, b, c], [a, c, d]]
            })
        });
        let uv: Vec<_> = uv.collect();
        let triangles: Vec<_> = triangles.collect();
        let corners = [(0, 0), (0, rows_of), (columns_of, rows_of), (columns_of, 0)];
        let mesh = ClothMesh {
            panels: vec![PanelRange {
                vertices: 0..uv.len(),
                triangles: 0..triangles.len(),
                corners: corners.map(|(i, j)| at_corner(i, j)).to_vec(),
            }],
            uv,
            triangles,
            stitches: Vec::<Stitch>::new(),
        };
        let outline = Panel::rectangle("sleeve", [0.2, 1.2]);
        let placement = Placement {
            at: Some(at),
            ..Placement::default()
        };
        let anchored = AnchoredPlacement::new(&outline, Some(&placement)).expect("a place");
        build(Parts {
            mesh,
            panels: vec![PanelParts {
                cut: Cut {
                    fabric: 0,
                    warp_angle: 0.0,
                    face_down: false,
                },
                placed: anchored.place(&outline, Face::Up, None),
            }],
            fabrics: vec![fabric::library().remove("linen").expect("a shipped fabric")],
            body: None,
            friction: None,
            pins: vec![],
        })
    }

    /// 20 cm rolled by a turn have a radius of 32 mm, so that edges of 35 mm turn by more than a
    /// radian.
    #[test]
    fn a_sleeve_keeps_its_vertices_where_a_front_is_made_coarser() {
        assert_eq!(chords(&panel(PlacementAnchor::TorsoFront)), [false]);
        assert_eq!(chords(&panel(PlacementAnchor::ArmLeft)), [true]);
        let sleeve = panel(PlacementAnchor::ArmLeft);
        let curvature = start_curvature(&sleeve, &sleeve.mesh.panels[0]);
        let exact = std::f64::consts::TAU / 0.2;
        // The turns between columns are those of the roll, but those at its sides are missing.
        let missing = 1.0 / 10.0;
        assert!(
            (curvature / exact - 1.0).abs() < missing + 0.01,
            "{curvature} {exact}"
        );
    }

    /// A tube that narrows from a radius of 10 cm to one of 3: on the whole, edges of 35 mm turn by
    /// 0.6 rad, at its lower end by more than one.
    #[test]
    fn a_tube_keeps_its_vertices_where_it_is_narrow() {
        let mut tube = panel(PlacementAnchor::TorsoFront);
        let radius = |v: f64| 0.03 + 0.07 * v / 1.2;
        let rolled = |[u, v]: &[f64; 2]| {
            let (sin, cos) = (u / radius(*v)).sin_cos();
            Vector3::new(radius(*v) * sin, *v, radius(*v) * cos)
        };
        tube.start = tube.mesh.uv.iter().map(rolled).collect();
        assert_eq!(chords(&tube), [true]);
        // In the middle of the lowest of eight strips. Turns at the sides are missing, a tenth;
        // over the strip the radius changes by an eighth each way, a hundredth of the mean.
        let curvature = start_curvature(&tube, &tube.mesh.panels[0]);
        let expected = 1.0 / radius(1.2 / 16.0);
        assert!(
            (curvature / expected - 1.0).abs() < 0.1 + 0.02,
            "{curvature} {expected}"
        );
        let edge = COARSER_EDGE * mean_edge(&tube.mesh, &tube.mesh.panels[0]);
        assert!(edge / radius(0.6) < MOST_TURN);
    }
}
