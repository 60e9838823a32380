//! Holes closed: those up to a palm's size, and flat cuts through neck, wrist, thigh or ankle.

use super::edges::{by_edge, edge_uses};
use crate::fault::{AvatarCode, Fault, Warning};
use crate::scene::avatar::TriangleMesh;
use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use std::collections::{BTreeMap, HashMap};

/// Longest edge and largest width of a hole that is mended \[m\]: those of a palm.
const EDGE: f64 = 0.36;
const WIDTH: f64 = 0.12;
/// Longest edge of a flat cut through a limb or the neck \[m\].
const CUT: f64 = 0.75;
/// Distance from its plane up to which a cut is flat, as a share of its width.
const FLAT: f64 = 0.03;
/// Rings of vertices between the edge of a hole and its middle, at most.
const RINGS: usize = 30;
/// Triangles of a surface beyond which holes are closed as plainly as can be.
const MOST: usize = 500_000;
/// Holes that are told one by one.
const TOLD: usize = 8;

/// The edge of a hole.
struct Hole {
    /// Vertices along it, the surface on their left.
    edge: Vec<usize>,
    middle: Vector3<f64>,
    /// Length of the edge \[m\].
    length: f64,
    /// Largest distance from the middle, twice \[m\].
    width: f64,
    /// Largest distance from the plane that fits it best \[m\].
    unevenness: f64,
}

/// Closes the holes of a surface whose triangles have one sense.
///
/// # Errors
/// `avatar/open` for each hole that is too large, with its place and size.
pub(in super::super) fn close(
    surface: &mut TriangleMesh,
    warnings: &mut Vec<Warning>,
) -> Result<(), Vec<Fault>> {
    let mut faults = Vec::new();
    let holes = holes(surface);
    let count = holes.len();
    for (number, hole) in holes.into_iter().enumerate() {
        let is_small = hole.length <= EDGE && hole.width <= WIDTH;
        let is_cut = hole.length <= CUT && hole.unevenness <= FLAT * hole.width;
        if !is_small && !is_cut {
            faults.push(hole.fault());
            continue;
        }
        if number < TOLD {
            warnings.push(hole.warning(is_small));
        }
        fill(surface, &hole);
    }
    if count > TOLD {
        let detail = format!("{} more holes were closed", count - TOLD);
        warnings.push(Warning::new(AvatarCode::Mended, "", detail));
    }
    if faults.is_empty() {
        Ok(())
    } else {
        Err(faults)
    }
}

impl Hole {
    fn new(surface: &TriangleMesh, edge: Vec<usize>) -> Self {
        let points: Vec<_> = edge.iter().map(|&v| surface.vertices[v]).collect();
        let next = points.iter().cycle().skip(1);
        let pieces: Vec<_> = points.iter().zip(next).collect();
        let length: f64 = pieces.iter().map(|(a, b)| (*b - *a).norm()).sum();
        // of the line, not of its vertices, which may lie closer together on one side
        let moment: Vector3<f64> = pieces
            .iter()
            .map(|(a, b)| (*a + *b) * (0.5 * (*b - *a).norm()))
            .sum();
        let middle = if length > 0.0 {
            moment / length
        } else {
            points[0]
        };
        let radius = points
            .iter()
            .map(|p| (p - middle).norm())
            .fold(0.0, f64::max);
        let spread: Matrix3<f64> = points
            .iter()
            .map(|p| (p - middle) * (p - middle).transpose())
            .sum();
        let axes = SymmetricEigen::new(spread);
        let normal = axes
            .eigenvectors
            .column(axes.eigenvalues.imin())
            .into_owned();
        let off = points.iter().map(|p| (p - middle).dot(&normal).abs());
        let unevenness = off.fold(0.0, f64::max);
        Self {
            middle,
            length,
            width: 2.0 * radius,
            unevenness,
            edge,
        }
    }

    fn place(&self) -> String {
        let [x, y, z] = self.middle.map(|x| x + 0.0).into();
        format!(
            "at ({x:.3}, {y:.3}, {z:.3}) m, {:.0} mm wide, its edge {:.0} mm long",
            self.width * 1e3,
            self.length * 1e3
        )
    }

    fn warning(&self, is_small: bool) -> Warning {
        let what = if is_small { "a hole" } else { "a flat cut" };
        let detail = format!("{what} {} was closed", self.place());
        Warning::new(AvatarCode::Mended, "", detail)
    }

    fn fault(&self) -> Fault {
        let detail = format!(
            "the surface has a hole {}; up to a palm's size ({:.0} mm) they are mended, and flat cuts through a limb or the neck",
            self.place(),
            WIDTH * 1e3
        );
        Fault::new(AvatarCode::Open, "", detail).fix("close the hole in the file")
    }
}

/// The holes of a surface.
fn holes(surface: &TriangleMesh) -> Vec<Hole> {
    let uses = edge_uses(surface);
    // along the missing triangles, against those that are there
    let mut next: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for edge in by_edge(&uses).filter(|edge| edge.len() == 1) {
        let [low, high] = edge[0].ends;
        let (from, to) = if edge[0].ascends {
            (high, low)
        } else {
            (low, high)
        };
        next.entry(from).or_default().push(to);
    }
    let mut holes = Vec::new();
    while let Some((&first, _)) = next.first_key_value() {
        let mut path = vec![first];
        let mut place_on_path = HashMap::from([(first, 0)]);
        while let Some(&here) = path.last() {
            let Some(after) = next.get_mut(&here).and_then(Vec::pop) else {
                break;
            };
            if next.get(&here).is_some_and(Vec::is_empty) {
                next.remove(&here);
            }
            // where the path meets itself, a hole is complete
            if let Some(begin) = place_on_path.get(&after).copied() {
                let edge = path.split_off(begin);
                for v in &edge {
                    place_on_path.remove(v);
                }
                holes.push(Hole::new(surface, edge));
                if begin == 0 {
                    break;
                }
            }
            place_on_path.insert(after, path.len());
            path.push(after);
        }
    }
    holes
}

/// Fills a hole with rings of triangles about its middle.
fn fill(surface: &mut TriangleMesh, hole: &Hole) {
    let count = hole.edge.len();
    if count == 3 {
        surface
            .triangles
            .push([hole.edge[0], hole.edge[1], hole.edge[2]]);
        return;
    }
    let step = hole.length / count as f64;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a number of rings, clamped"
    )]
    let rings = ((0.5 * hole.width / step) as usize).clamp(1, RINGS);
    let room = MOST.saturating_sub(surface.triangles.len()) / (2 * count);
    let rings = rings.min(room.max(1));
    let mut outer = hole.edge.clone();
    for ring in 1..rings {
        let share = ring as f64 / rings as f64;
        let inner: Vec<usize> = (0..count)
            .map(|k| {
                let from = surface.vertices[hole.edge[k]];
                surface.vertices.push(from + (hole.middle - from) * share);
                surface.vertices.len() - 1
            })
            .collect();
        for k in 0..count {
            let after = (k + 1) % count;
            surface.triangles.push([outer[k], outer[after], inner[k]]);
            surface
                .triangles
                .push([inner[k], outer[after], inner[after]]);
        }
        outer = inner;
    }
    surface.vertices.push(hole.middle);
    let middle = surface.vertices.len() - 1;
    for k in 0..count {
        surface
            .triangles
            .push([outer[k], outer[(k + 1) % count], middle]);
    }
}
