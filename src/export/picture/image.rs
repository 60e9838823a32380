//! Pictures as pixels and as PNG.

use png::{BitDepth, ColorType, Compression, Encoder};

/// Pixels of a picture, 8 bits a channel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: u32,
    height: u32,
    rgb: Vec<u8>,
}

impl Picture {
    /// Creates a picture of one color.
    pub(super) fn new([width, height]: [u32; 2], color: [u8; 3]) -> Self {
        let rgb = color.repeat(width as usize * height as usize);
        Self { width, height, rgb }
    }

    /// Width \[pixels\].
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height \[pixels\].
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Red, green and blue of each pixel, row by row from the top; `3 width height`.
    pub fn rgb(&self) -> &[u8] {
        &self.rgb
    }

    /// Red, green and blue of the pixels of row `y` from column `x` on, for writing.
    pub(super) fn row_mut(&mut self, x: usize, y: usize) -> &mut [u8] {
        let width = self.width as usize;
        &mut self.rgb[3 * (y * width + x)..3 * (y + 1) * width]
    }

    /// Writes the picture as PNG. Pictures are drawn on request: the fast compression takes a tenth
    /// of the time of the usual one, for one and a half times the bytes.
    pub fn png(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, self.width, self.height);
        encoder.set_color(ColorType::Rgb);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_compression(Compression::Fast);
        encoder
            .write_header()
            .and_then(|mut writer| writer.write_image_data(&self.rgb))
            .expect(
                "the size is not zero, fits the pixels, and a vector takes all that is written",
            );
        bytes
    }
}
