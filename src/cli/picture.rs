//! The picture of a sewn garment.

use super::input::parse_word;
use super::output::write;
use clap::Args;
use seamster::config::Limits;
use seamster::export::View;
use seamster::fault::Faults;
use seamster::fit::{self, FitOutcome, ResolvedGarment};
use std::path::PathBuf;

/// Words of the views, for the help.
const VIEWS: &str = "front|back|left|right|three_quarter";

/// File of a picture, and what it shows.
#[derive(Args)]
pub(super) struct PictureOptions {
    /// File to write a picture to: the garment on its body from four sides, crossings marked in red
    #[arg(long, value_name = "OUT.png", value_parser = png_path)]
    picture: Option<PathBuf>,
    /// The one side that the picture shows
    #[arg(long, requires = "picture", value_name = VIEWS, value_parser = parse_word::<View>)]
    view: Option<View>,
}

impl PictureOptions {
    /// Draws a garment as PNG, where a picture is requested.
    ///
    /// # Errors
    /// A body that cannot be made.
    pub(super) fn draw(
        &self,
        garment: &ResolvedGarment,
        outcome: &FitOutcome,
        limits: &Limits,
    ) -> Result<Option<Vec<u8>>, Faults> {
        if self.picture.is_none() {
            return Ok(None);
        }
        let shape = (&outcome.mesh, &outcome.report);
        let picture = fit::picture(garment, shape, (self.view, None), limits)?;
        Ok(Some(picture.png()))
    }

    /// Writes the PNG to the file that was named.
    ///
    /// # Errors
    /// The file and why it cannot be written.
    pub(super) fn write(&self, png: &[u8]) -> Result<(), String> {
        self.picture
            .as_ref()
            .map_or(Ok(()), |path| write(path, png))
    }
}

/// Reads the name of a PNG file.
fn png_path(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let extension = path.extension().and_then(|extension| extension.to_str());
    if extension.is_some_and(|extension| extension.eq_ignore_ascii_case("png")) {
        Ok(path)
    } else {
        Err("its name must end in .png".to_owned())
    }
}
