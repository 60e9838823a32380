//! Rows of samples with their depths, drawn on one by one and averaged into pixels.
//!
//! A picture is drawn in bands, so that the samples of a large one need no more memory than those
//! of a small one.

use super::camera::{SAMPLES, Seen};
use super::image::Picture;
use super::screen_triangle::ScreenTriangle;
use std::ops::Range;

/// Rows of pixels of a band.
const ROWS: usize = 64;
/// Samples along each side of a pixel.
const SIDE: usize = SAMPLES as usize;

/// Rows of samples of one view.
pub(super) struct Band {
    /// Samples of a row.
    width: usize,
    /// The rows, counted from the top of the picture.
    rows: Range<usize>,
    depth: Vec<f32>,
    color: Vec<[u8; 3]>,
}

/// A straight line of a width, before what lies further off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// Its ends.
    pub(super) ends: [Seen; 2],
    /// Half its width \[samples\].
    pub(super) radius: f64,
    /// Red, green and blue.
    pub(super) color: [u8; 3],
}

impl Band {
    /// Creates the bands of a view of a size \[pixels\], from the top, each to be drawn on.
    pub(super) fn all(
        [width, height]: [u32; 2],
        background: [u8; 3],
    ) -> impl Iterator<Item = Self> {
        let [width, height] = [width, height].map(|pixels| pixels as usize * SIDE);
        let tops = (0..height).step_by(ROWS * SIDE);
        tops.map(move |top| {
            let rows = top..height.min(top + ROWS * SIDE);
            let samples = width * rows.len();
            Self {
                width,
                rows,
                depth: vec![f32::NEG_INFINITY; samples],
                color: vec![background; samples],
            }
        })
    }

    /// Draws a triangle before what lies further off.
    pub(super) fn triangle(&mut self, triangle: &ScreenTriangle) {
        let color = triangle.color().map(f64::from);
        let top = self.rows.start;
        triangle.cover(self.rows.clone(), 0..self.width, |sample| {
            let at = (sample.y - top) * self.width + sample.x;
            let depth = single(sample.depth);
            if depth > self.depth[at] {
                self.depth[at] = depth;
                self.color[at] = color.map(|channel| channel_of(channel * sample.tone));
            }
        });
    }

    /// Draws a line before what lies further off.
    pub(super) fn line(&mut self, line: &Line) {
        let [a, b] = line.ends;
        let along = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
        let square = along[0] * along[0] + along[1] * along[1];
        let near = [0, 1].map(|axis| [a.at[axis].min(b.at[axis]), a.at[axis].max(b.at[axis])]);
        self.stroke(near, line.radius, line.color, |[x, y]| {
            let from = [x - a.at[0], y - a.at[1]];
            let along_it = from[0] * along[0] + from[1] * along[1];
            let t = (along_it / square.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            let off = [from[0] - t * along[0], from[1] - t * along[1]];
            (off, a.depth + t * (b.depth - a.depth))
        });
    }

    /// Draws a dot before everything.
    pub(super) fn dot(&mut self, [x, y]: [f64; 2], radius: f64, color: [u8; 3]) {
        self.stroke([[x; 2], [y; 2]], radius, color, |at| {
            ([at[0] - x, at[1] - y], f64::INFINITY)
        });
    }

    /// Colors the samples round a box that are within a radius of what is drawn: `off` returns how
    /// far from it a place lies, and the depth of it there.
    fn stroke(
        &mut self,
        [across, down]: [[f64; 2]; 2],
        radius: f64,
        color: [u8; 3],
        off: impl Fn([f64; 2]) -> ([f64; 2], f64),
    ) {
        let columns = samples_near(across, radius, 0..self.width);
        for y in samples_near(down, radius, self.rows.clone()) {
            for x in columns.clone() {
                let ([dx, dy], depth) = off([x, y].map(|sample| sample as f64 + 0.5));
                let at = (y - self.rows.start) * self.width + x;
                let depth = single(depth);
                if dx * dx + dy * dy <= radius * radius && depth >= self.depth[at] {
                    self.depth[at] = depth;
                    self.color[at] = color;
                }
            }
        }
    }

    /// Writes the means of the samples of each pixel into a picture, from the column `left` on.
    pub(super) fn write(&self, picture: &mut Picture, left: usize) {
        for row in (0..self.rows.len()).step_by(SIDE) {
            let pixels = picture.row_mut(left, (self.rows.start + row) / SIDE);
            let pixels = pixels.chunks_exact_mut(3).take(self.width / SIDE);
            for (x, pixel) in pixels.enumerate() {
                for (channel, value) in pixel.iter_mut().enumerate() {
                    *value = self.mean(row, x * SIDE, channel);
                }
            }
        }
    }

    fn mean(&self, row: usize, column: usize, channel: usize) -> u8 {
        let rows = row..row + SIDE;
        let starts = rows.map(|row| row * self.width + column);
        let samples = starts.flat_map(|start| &self.color[start..start + SIDE]);
        let sum: usize = samples.map(|color| usize::from(color[channel])).sum();
        let count = SIDE * SIDE;
        u8::try_from((sum + count / 2) / count).unwrap_or(u8::MAX)
    }
}

/// Returns the samples that lie within a radius of a stretch \[samples\], of those given.
fn samples_near([low, high]: [f64; 2], radius: f64, of: Range<usize>) -> Range<usize> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a cast of floats to integers saturates, and negative samples are outside"
    )]
    let index = |place: f64| place.max(0.0) as usize;
    of.start.max(index(low - radius))..of.end.min(index(high + radius + 1.0))
}

fn single(depth: f64) -> f32 {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "single precision tells depths apart that differ by less than a micrometer"
    )]
    let depth = depth as f32;
    depth
}

fn channel_of(value: f64) -> u8 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a cast of floats to integers saturates"
    )]
    let channel = (value + 0.5) as u8;
    channel
}
