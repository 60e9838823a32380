//! The picture of a garment on its body.

use super::resolve::ResolvedGarment;
use super::run::avatar;
use crate::config::Limits;
use crate::export::{self, GarmentMesh, Picture, PictureSubject, View};
use crate::fault::Faults;
use crate::solver::DrapeReport;

/// Width of a picture of one side, if none is asked for \[pixels\].
const WIDTH: u32 = 1200;
/// Width of a picture of four sides, if none is asked for \[pixels\].
const SHEET_WIDTH: u32 = 2000;

/// Draws the outcome of a fit on its body, from one side or from four beside each other, `width`
/// pixels wide. Places where it passes through itself or the body are marked.
///
/// # Errors
/// A body that cannot be made, or a width outside the limits.
pub fn picture(
    garment: &ResolvedGarment,
    (mesh, report): (&GarmentMesh, &DrapeReport),
    (view, width): (Option<View>, Option<u32>),
    limits: &Limits,
) -> Result<Picture, Faults> {
    let avatar = avatar(garment)?;
    let crossings = report.intersections.iter();
    let subject = PictureSubject {
        mesh,
        body: avatar.as_ref().map(|avatar| &avatar.surface),
        marks: &crossings.map(|crossing| crossing.at).collect::<Vec<_>>(),
    };
    let picture = match view {
        Some(view) => export::picture(&subject, view, width.unwrap_or(WIDTH), limits)?,
        None => export::picture_sheet(&subject, width.unwrap_or(SHEET_WIDTH), limits)?,
    };
    Ok(picture)
}
