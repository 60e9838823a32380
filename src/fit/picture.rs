//! The picture of a garment on its body.

use super::resolve::ResolvedGarment;
use super::run::{FitOutcome, avatar};
use crate::config::Limits;
use crate::export::{self, Picture, PictureSubject, View};
use crate::fault::Faults;

/// Draws the outcome of a fit on its body, from one side or from four beside each other, `width`
/// pixels wide. Places where it passes through itself or the body are marked.
///
/// # Errors
/// A body that cannot be made, or a width outside the limits.
pub fn picture(
    garment: &ResolvedGarment,
    outcome: &FitOutcome,
    (view, width): (Option<View>, u32),
    limits: &Limits,
) -> Result<Picture, Faults> {
    let avatar = avatar(garment)?;
    let crossings = outcome.report.intersections.iter();
    let subject = PictureSubject {
        mesh: &outcome.mesh,
        body: avatar.as_ref().map(|avatar| &avatar.surface),
        marks: &crossings.map(|crossing| crossing.at).collect::<Vec<_>>(),
    };
    let picture = match view {
        Some(view) => export::picture(&subject, view, width, limits)?,
        None => export::picture_sheet(&subject, width, limits)?,
    };
    Ok(picture)
}
