//! A subject as a camera sees it: triangles, lines and dots in the plane of the picture.

use super::band::Line;
use super::border::border_edges;
use super::camera::{Camera, SAMPLES, Seen};
use super::light::tone;
use super::palette;
use super::screen_triangle::{ScreenTriangle, ShadedCorner};
use super::subject::{PictureSubject, is_drawable};
use crate::export::garment_mesh::DrapedPanel;
use crate::export::normals;
use crate::scene::TriangleMesh;
use nalgebra::Vector3;

/// Distance by which the body is drawn further inside its surface \[m\]: more than its facets stand
/// out of its true shape and cloth that rests on it sinks in.
const BODY_INSET: f64 = 0.003;
/// Cosine to the viewer below which the inset grows no more in depth.
const GRAZING: f64 = 0.1;
/// Width of the borders of panels \[pixels\].
const BORDER_WIDTH: f64 = 1.2;
/// Height of borders above their panels, so that the cloth beside does not hide them \[m\].
const BORDER_LIFT: f64 = 0.002;
/// Radius of a mark \[m\], and its bounds \[pixels\].
const MARK_RADIUS: f64 = 0.006;
const MARK_PIXELS: [f64; 2] = [2.5, 9.0];

/// A subject in the plane of a picture.
pub(super) struct Projection {
    /// Surfaces of cloth and body.
    pub(super) triangles: Vec<ScreenTriangle>,
    /// Borders of panels.
    pub(super) lines: Vec<Line>,
    /// Places of the marks.
    pub(super) dots: Vec<[f64; 2]>,
    /// Radius of the marks \[samples\].
    pub(super) dot_radius: f64,
}

impl Projection {
    /// Projects a subject.
    ///
    /// Assumes triangles whose indices are below the number of their vertices.
    pub(super) fn new(subject: &PictureSubject<'_>, camera: &Camera) -> Self {
        let pixel = f64::from(SAMPLES);
        let [least, most] = MARK_PIXELS.map(|pixels| pixels * pixel);
        let marks = subject.marks.iter().map(|mark| Vector3::from(*mark));
        let marks = marks.filter(is_drawable);
        let mut projection = Self {
            triangles: vec![],
            lines: vec![],
            dots: marks.map(|mark| camera.see(&mark).at).collect(),
            dot_radius: (MARK_RADIUS * camera.samples_per_m).clamp(least, most),
        };
        if let Some(body) = subject.body {
            projection.body(body, camera);
        }
        let normals = normals::of_garment(subject.mesh);
        for (number, (panel, normals)) in subject.mesh.panels.iter().zip(&normals).enumerate() {
            let colors = [palette::outer(number), palette::inner(number)];
            projection.panel(panel, normals, colors, camera);
        }
        projection
    }

    fn body(&mut self, body: &TriangleMesh, camera: &Camera) {
        let normals = normals::smooth(&body.vertices, &body.triangles);
        for corners in &body.triangles {
            let points = corners.map(|i| body.vertices[i]);
            let shaded = corners.map(|i| shaded(&body.vertices[i], &normals[i], camera));
            let cosine = camera.turn(&face_normal(points)).z.abs().max(GRAZING);
            let sunk = shaded.map(|corner| corner.lifted(-BODY_INSET / cosine));
            self.triangle(points, sunk, palette::BODY);
        }
    }

    fn panel(
        &mut self,
        panel: &DrapedPanel,
        normals: &[Vector3<f64>],
        [outer, inner]: [[u8; 3]; 2],
        camera: &Camera,
    ) {
        let point = |i: u32| Vector3::from(panel.positions[i as usize]);
        for corners in &panel.triangles {
            let points = corners.map(point);
            let is_outer = camera.turn(&face_normal(points)).z >= 0.0;
            let (color, side) = if is_outer {
                (outer, 1.0)
            } else {
                (inner, -1.0)
            };
            let normal = |i: u32| side * normals[i as usize];
            let corners = corners.map(|i| shaded(&point(i), &normal(i), camera));
            self.triangle(points, corners, color);
        }
        let lift = BORDER_LIFT + 2.0 * f64::from(SAMPLES) / camera.samples_per_m;
        for ends in border_edges(&panel.triangles) {
            let points = ends.map(point);
            if points.iter().all(is_drawable) {
                self.lines.push(Line {
                    ends: points.map(|point| camera.see(&point).lifted(lift)),
                    radius: BORDER_WIDTH * f64::from(SAMPLES) / 2.0,
                    color: palette::BORDER,
                });
            }
        }
    }

    fn triangle(&mut self, points: [Vector3<f64>; 3], corners: [ShadedCorner; 3], color: [u8; 3]) {
        if points.iter().all(is_drawable) {
            self.triangles.extend(ScreenTriangle::new(corners, color));
        }
    }
}

impl Seen {
    /// Returns the same place in the picture, nearer to its viewer.
    fn lifted(self, by: f64) -> Self {
        Self {
            depth: self.depth + by,
            ..self
        }
    }
}

impl ShadedCorner {
    fn lifted(self, by: f64) -> Self {
        Self {
            seen: self.seen.lifted(by),
            ..self
        }
    }
}

fn shaded(point: &Vector3<f64>, normal: &Vector3<f64>, camera: &Camera) -> ShadedCorner {
    ShadedCorner {
        seen: camera.see(point),
        tone: tone(&camera.turn(normal)),
    }
}

/// Returns the unit normal of a triangle; of one without area, which is not drawn, anything.
fn face_normal([a, b, c]: [Vector3<f64>; 3]) -> Vector3<f64> {
    let normal = (b - a).cross(&(c - a));
    normal.try_normalize(0.0).unwrap_or(normal)
}
