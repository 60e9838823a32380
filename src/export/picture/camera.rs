//! Orthographic projection of a view on the samples of its part of a picture.

use super::view::View;
use crate::config::Limits;
use crate::fault::{Fault, RequestCode};
use nalgebra::Vector3;

/// Samples along each side of a pixel.
pub(super) const SAMPLES: u32 = 2;
/// Size of the part of a picture over that of what it shows.
const MARGIN: f64 = 1.08;
/// Largest height of a picture over its width: what is narrower gets room beside it.
const TALLEST: f64 = 2.0;
/// Smallest size that a garment is taken to have \[m\].
const LEAST_SIZE: f64 = 0.05;

/// Size of each of several views of the same points beside each other, all at one scale.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    /// Width and height of the whole picture \[pixels\].
    pub(super) picture: [u32; 2],
    /// Width and height of one view \[pixels\].
    pub(super) view: [u32; 2],
    samples_per_m: f64,
}

impl Layout {
    /// Fits views of `points` \[m\] into a picture of a width \[pixels\]; its height follows from
    /// the points, as far as the limits let it.
    ///
    /// # Errors
    /// A width outside the limits.
    pub(super) fn new(
        points: &[Vector3<f64>],
        views: &[View],
        width: u32,
        limits: &Limits,
    ) -> Result<Self, Fault> {
        let [least, most] = limits.picture_px;
        if !(least..=most).contains(&width) {
            let detail = format!("a picture of {width} pixels of width");
            let fix = format!("give a width of {least} to {most} pixels");
            return Err(Fault::new(RequestCode::OutOfRange, "/width", detail).fix(fix));
        }
        let [across, up] = size(points, views);
        let count = u32::try_from(views.len()).unwrap_or(u32::MAX).max(1);
        let view_width = f64::from((width / count).max(1));
        #[expect(
            clippy::cast_possible_truncation,
            reason = "a cast of floats to integers saturates, and the limits bound it"
        )]
        let height = ((view_width * (up / across).min(TALLEST)).ceil() as u32).clamp(least, most);
        let pixels_per_m = (view_width / across).min(f64::from(height) / up);
        Ok(Self {
            picture: [width, height],
            view: [(width / count).max(1), height],
            samples_per_m: pixels_per_m * f64::from(SAMPLES),
        })
    }

    /// Returns the camera of a view of `points` \[m\].
    pub(super) fn camera(&self, points: &[Vector3<f64>], view: View) -> Camera {
        let axes = view.axes();
        let middle = [0, 1].map(|axis| {
            let [low, high] = range(points, &axes[axis]);
            (low + high) / 2.0
        });
        let half = self.view.map(|pixels| f64::from(pixels * SAMPLES) / 2.0);
        Camera {
            axes,
            middle,
            half,
            samples_per_m: self.samples_per_m,
        }
    }
}

/// Projection of space on samples, seen from infinitely far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    /// Unit vectors to the right, up and towards the viewer.
    axes: [Vector3<f64>; 3],
    middle: [f64; 2],
    half: [f64; 2],
    /// Scale \[samples/m\].
    pub(super) samples_per_m: f64,
}

/// A point as a camera sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seen {
    /// Place from the left and from the top \[samples\].
    pub(super) at: [f64; 2],
    /// Height above the picture, towards the viewer \[m\].
    pub(super) depth: f64,
}

impl Camera {
    /// Returns the place of a point \[m\] in the picture.
    pub(super) fn see(&self, point: &Vector3<f64>) -> Seen {
        let [right, up, toward] = self.axes.map(|axis| axis.dot(point));
        let x = self.half[0] + (right - self.middle[0]) * self.samples_per_m;
        let y = self.half[1] - (up - self.middle[1]) * self.samples_per_m;
        Seen {
            at: [x, y],
            depth: toward,
        }
    }

    /// Returns a direction by its parts to the right, up and towards the viewer.
    pub(super) fn turn(&self, direction: &Vector3<f64>) -> Vector3<f64> {
        self.axes.map(|axis| axis.dot(direction)).into()
    }
}

/// Returns the width and the height that every view of points needs \[m\], margin included.
fn size(points: &[Vector3<f64>], views: &[View]) -> [f64; 2] {
    [0, 1].map(|axis| {
        let sizes = views.iter().map(|view| {
            let [low, high] = range(points, &view.axes()[axis]);
            high - low
        });
        sizes.fold(LEAST_SIZE, f64::max) * MARGIN
    })
}

/// Returns the least and the largest coordinate of points along a direction; 0 without points.
fn range(points: &[Vector3<f64>], along: &Vector3<f64>) -> [f64; 2] {
    let coordinates = || points.iter().map(|point| along.dot(point));
    if points.is_empty() {
        return [0.0; 2];
    }
    [
        coordinates().fold(f64::INFINITY, f64::min),
        coordinates().fold(f64::NEG_INFINITY, f64::max),
    ]
}
