//! A closed surface of triangles, and whether it is one.

use crate::fault::{AvatarCode, Fault};
use nalgebra::Vector3;

/// Most triangles of a body; far beyond what a body needs at millimeter detail.
const TRIANGLES: usize = 500_000;
/// Largest coordinate of a body \[m\].
const EXTENT: f64 = 10.0;

/// A closed surface of triangles, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// \[m\]; `#V`.
    pub vertices: Vec<Vector3<f64>>,
    /// `#T`.
    pub triangles: Vec<[usize; 3]>,
}

impl TriangleMesh {
    /// The corners of triangle `t` \[m\].
    pub fn corners(&self, t: usize) -> [Vector3<f64>; 3] {
        self.triangles[t].map(|v| self.vertices[v])
    }

    /// Enclosed volume \[m³\], negative where the surface is inside out (divergence theorem).
    pub fn volume(&self) -> f64 {
        let six_fold: f64 = (0..self.triangles.len())
            .map(|t| {
                let [a, b, c] = self.corners(t);
                a.dot(&b.cross(&c))
            })
            .sum();
        six_fold / 6.0
    }

    /// Returns the faults that keep this from being the closed, two-sided, outward surface of a
    /// body.
    pub(super) fn check(&self) -> Vec<Fault> {
        let faults = self.check_parts();
        if faults.is_empty() {
            self.check_whole()
        } else {
            faults
        }
    }

    fn check_parts(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        let mut fault = |code: AvatarCode, pointer: String, detail: String| {
            faults.push(Fault::new(code, pointer, detail));
        };
        if self.triangles.is_empty() {
            fault(
                AvatarCode::Empty,
                "/surface".into(),
                "the surface has no triangle".into(),
            );
        }
        if self.triangles.len() > TRIANGLES {
            let detail = format!(
                "{} triangles; at most {TRIANGLES} are taken",
                self.triangles.len()
            );
            fault(AvatarCode::TooLarge, "/surface/triangles".into(), detail);
        }
        let outside = |v: &Vector3<f64>| !v.iter().all(|x| x.abs() <= EXTENT);
        if let Some(v) = self.vertices.iter().position(outside) {
            let detail =
                format!("vertex {v} is not a finite point within {EXTENT} m of the origin");
            fault(AvatarCode::Vertex, format!("/surface/vertices/{v}"), detail);
        }
        let dangling = |t: &[usize; 3]| t.iter().any(|&v| v >= self.vertices.len());
        if let Some(t) = self.triangles.iter().position(dangling) {
            let detail = format!("triangle {t} names a vertex that is not there");
            fault(AvatarCode::Index, format!("/surface/triangles/{t}"), detail);
        }
        faults
    }

    fn check_whole(&self) -> Vec<Fault> {
        let mut faults = Vec::new();
        let flat = |t: &usize| {
            let [a, b, c] = self.corners(*t);
            (b - a).cross(&(c - a)).norm() <= 1e-14
        };
        if let Some(t) = (0..self.triangles.len()).find(flat) {
            let detail = format!("triangle {t} has no area");
            let fix = "merge its corners or leave the triangle out, keeping the surface closed";
            faults.push(
                Fault::new(
                    AvatarCode::Degenerate,
                    format!("/surface/triangles/{t}"),
                    detail,
                )
                .fix(fix),
            );
        }
        faults.extend(self.check_edges());
        if faults.is_empty() && self.volume() <= 0.0 {
            let detail = "the surface is inside out: its triangles run clockwise seen from outside";
            faults.push(
                Fault::new(AvatarCode::InsideOut, "/surface", detail)
                    .fix("turn every triangle round: [a, b, c] to [a, c, b]"),
            );
        }
        faults
    }

    /// Each edge must be used once in each direction.
    fn check_edges(&self) -> Vec<Fault> {
        let mut directed: Vec<(usize, usize)> = self
            .triangles
            .iter()
            .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)])
            .collect();
        directed.sort_unstable();
        let mut faults = Vec::new();
        let doubled = directed.windows(2).filter(|w| w[0] == w[1]).count();
        if doubled > 0 {
            let detail = format!(
                "{doubled} edges are run along in the same direction by more than one triangle"
            );
            let fix = "give all triangles the same sense and let two meet at each edge";
            faults.push(Fault::new(AvatarCode::NotManifold, "/surface", detail).fix(fix));
        }
        let open = directed
            .iter()
            .filter(|(a, b)| directed.binary_search(&(*b, *a)).is_err())
            .count();
        if open > 0 {
            let detail =
                format!("the surface is open: {open} edges have a triangle on one side only");
            faults.push(Fault::new(AvatarCode::Open, "/surface", detail).fix("close its holes"));
        }
        faults
    }
}
