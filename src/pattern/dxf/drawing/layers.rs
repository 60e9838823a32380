//! The meaning of layers: the numbers of AAMA and ASTM D6673, and the names that general CAD uses.

use crate::pattern::NotchKind;

/// The meaning of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LayerRole {
    /// The outline of pieces, as cut.
    Boundary,
    /// Turn points: corners of outlines.
    Turn,
    /// Notches of one shape.
    Notch(NotchKind),
    /// The fold about which a half piece is mirrored.
    Mirror,
    /// The direction of the warp.
    Grain,
    /// Lines drawn on the cloth and not cut.
    Internal,
    /// Holes.
    Cutout,
    /// Marks drilled through.
    Drill,
    /// Lines along which pieces are sewn.
    Sew,
    /// Names and notes.
    Annotation,
    /// Nothing that a pattern needs: curve points, grading, plaid, and 84-87, which repeat 1, 8, 11
    /// and 14.
    Ignored,
    /// A layer without a meaning of its own.
    General,
}

/// Returns the meaning of a layer.
pub(crate) fn role(layer: &str) -> LayerRole {
    let layer = layer.trim();
    match layer.parse::<u32>() {
        Ok(number) => numbered(number),
        Err(_) => named(&layer.to_lowercase()),
    }
}

/// Returns true if a layer is not one of the numbers of AAMA and ASTM.
pub(crate) fn is_named(layer: &str) -> bool {
    layer.trim().parse::<u32>().is_err()
}

fn numbered(number: u32) -> LayerRole {
    match number {
        1 => LayerRole::Boundary,
        2 => LayerRole::Turn,
        4 => LayerRole::Notch(NotchKind::V),
        80 => LayerRole::Notch(NotchKind::T),
        81 => LayerRole::Notch(NotchKind::Castle),
        82 => LayerRole::Notch(NotchKind::Check),
        83 => LayerRole::Notch(NotchKind::U),
        6 => LayerRole::Mirror,
        7 => LayerRole::Grain,
        8 => LayerRole::Internal,
        11 => LayerRole::Cutout,
        13 => LayerRole::Drill,
        14 => LayerRole::Sew,
        15 | 19 => LayerRole::Annotation,
        3 | 5 | 9 | 10 | 12 | 84..=87 => LayerRole::Ignored,
        _ => LayerRole::General,
    }
}

fn named(layer: &str) -> LayerRole {
    const NAMES: [(&str, LayerRole); 19] = [
        ("cutout", LayerRole::Cutout),
        ("hole", LayerRole::Cutout),
        ("cut", LayerRole::Boundary),
        ("outline", LayerRole::Boundary),
        ("boundary", LayerRole::Boundary),
        ("contour", LayerRole::Boundary),
        ("seam", LayerRole::Sew),
        ("sew", LayerRole::Sew),
        ("stitch", LayerRole::Sew),
        ("fold", LayerRole::Mirror),
        ("mirror", LayerRole::Mirror),
        ("grain", LayerRole::Grain),
        ("notch", LayerRole::Notch(NotchKind::Slit)),
        ("drill", LayerRole::Drill),
        ("internal", LayerRole::Internal),
        ("text", LayerRole::Annotation),
        ("label", LayerRole::Annotation),
        ("annotation", LayerRole::Annotation),
        ("defpoints", LayerRole::Ignored),
    ];
    NAMES
        .iter()
        .find(|(part, _)| layer.contains(part))
        .map_or(LayerRole::General, |(_, role)| *role)
}
