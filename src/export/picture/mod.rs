//! A garment as a picture, drawn without a GPU or a browser.
//!
//! Orthographic views by a z-buffer of 2 x 2 samples a pixel, lit by Lambert's cosine law. Each
//! panel has a color of its own, its inner side a darker one; the body is drawn a little further
//! inside its surface, so that its facets do not show through cloth. The same subject gives the
//! same bytes: places are rounded to a grid, and what lies equally near is drawn in the order of
//! panels.

mod band;
mod border;
mod camera;
mod image;
mod light;
mod palette;
mod projection;
mod screen_triangle;
mod subject;
mod view;

pub use image::Picture;
pub use subject::PictureSubject;
pub use view::View;

use crate::config::Limits;
use crate::fault::Fault;
use band::Band;
use camera::{Camera, Layout};
use nalgebra::Vector3;
use projection::Projection;

/// Draws one view of a garment, `width` pixels wide and as high as the garment needs.
///
/// # Errors
/// `request/out_of_range`: a width outside the limits.
pub fn picture(
    subject: &PictureSubject<'_>,
    view: View,
    width: u32,
    limits: &Limits,
) -> Result<Picture, Fault> {
    draw(subject, &[view], width, limits)
}

/// Draws a garment from its front, right, back and left beside each other, at one scale, all
/// together `width` pixels wide.
///
/// # Errors
/// As [`picture`].
pub fn picture_sheet(
    subject: &PictureSubject<'_>,
    width: u32,
    limits: &Limits,
) -> Result<Picture, Fault> {
    draw(subject, &View::SHEET, width, limits)
}

fn draw(
    subject: &PictureSubject<'_>,
    views: &[View],
    width: u32,
    limits: &Limits,
) -> Result<Picture, Fault> {
    let points: Vec<Vector3<f64>> = subject.points();
    let layout = Layout::new(&points, views, width, limits)?;
    let mut picture = Picture::new(layout.picture, palette::BACKGROUND);
    for (number, view) in views.iter().enumerate() {
        let camera = layout.camera(&points, *view);
        let left = number * layout.view[0] as usize;
        draw_view(subject, &camera, layout.view, (&mut picture, left));
    }
    Ok(picture)
}

/// Draws one view of a size \[pixels\] into a picture, from the column `left` on.
fn draw_view(
    subject: &PictureSubject<'_>,
    camera: &Camera,
    size: [u32; 2],
    (picture, left): (&mut Picture, usize),
) {
    let projection = Projection::new(subject, camera);
    for mut band in Band::all(size, palette::BACKGROUND) {
        for triangle in &projection.triangles {
            band.triangle(triangle);
        }
        for line in &projection.lines {
            band.line(line);
        }
        for dot in &projection.dots {
            band.dot(*dot, projection.dot_radius, palette::MARK);
        }
        band.write(picture, left);
    }
}
