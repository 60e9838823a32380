//! Reasons why panels are not sewn, in words.

use super::labels::EdgeRole;

/// Reason why a panel is not sewn.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Loose {
    /// Another form of a panel that is sewn, by its index.
    Alternative(usize),
    /// The garment cannot do without it.
    Body,
    /// It is cut several times, and sewn once.
    Copy,
    /// A band, a collar, a cuff or a hood.
    Trim,
    /// A ring that is worn by its hole and needs no seam.
    Worn,
    /// A pocket, a facing, or a panel that nothing tells of.
    Unneeded,
}

/// Returns the sentence on a panel that is not sewn.
pub(super) fn told<'a>(panel: &str, reason: &Loose, id: impl Fn(&usize) -> &'a str) -> String {
    match reason {
        Loose::Alternative(other) => format!(
            "panel `{panel}` is taken for another form of `{}`, which is sewn in its place; to choose it, suggest the seams without `{}`",
            id(other),
            id(other)
        ),
        Loose::Body | Loose::Trim => format!(
            "no seam is suggested for panel `{panel}`, though its name or its size says that the garment needs it"
        ),
        Loose::Copy => format!(
            "panel `{panel}` is cut several times and sewn once: it may be the front and the back, and its seams are offers; state the seams"
        ),
        Loose::Worn => format!("panel `{panel}` is worn by its hole and needs no seam"),
        Loose::Unneeded => format!(
            "no seam is suggested for panel `{panel}`: what it is was not recognised, or it is not needed"
        ),
    }
}

/// Returns the name of a role in a sentence.
pub(super) fn role_name(role: EdgeRole) -> &'static str {
    match role {
        EdgeRole::Hem => "lower edge",
        EdgeRole::Side => "side",
        EdgeRole::Armhole => "armhole",
        EdgeRole::Shoulder => "shoulder",
        EdgeRole::Neck => "neck",
        EdgeRole::Center => "center",
        EdgeRole::Cap => "cap",
        EdgeRole::Underarm => "underarm",
        EdgeRole::Top => "upper seam",
        EdgeRole::Waist => "waist",
        EdgeRole::Inseam => "inseam",
        EdgeRole::Crotch => "crotch",
        EdgeRole::Long => "long edge",
        EdgeRole::End => "end",
    }
}
