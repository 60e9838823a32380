//! What the layers mean: the numbers of AAMA and ASTM D6673, and the names that general CAD uses.

use crate::pattern::NotchKind;

/// What lies on a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// The outline of pieces, as cut.
    Boundary,
    /// Turn points: where outlines have corners.
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
    /// Where pieces are sewn.
    Sew,
    /// Names and notes.
    Annotation,
    /// Nothing that a pattern needs: curve points, grading, plaid, and 84-87, which repeat 1, 8, 11 and 14.
    Ignored,
    /// A layer without a meaning of its own.
    General,
}

/// The meaning of a layer.
pub(super) fn role(layer: &str) -> Role {
    let layer = layer.trim();
    match layer.parse::<u32>() {
        Ok(number) => numbered(number),
        Err(_) => named(&layer.to_lowercase()),
    }
}

/// Whether a layer is not one of the numbers of AAMA and ASTM.
pub(super) fn is_named(layer: &str) -> bool {
    layer.trim().parse::<u32>().is_err()
}

fn numbered(number: u32) -> Role {
    match number {
        1 => Role::Boundary,
        2 => Role::Turn,
        4 => Role::Notch(NotchKind::V),
        80 => Role::Notch(NotchKind::T),
        81 => Role::Notch(NotchKind::Castle),
        82 => Role::Notch(NotchKind::Check),
        83 => Role::Notch(NotchKind::U),
        6 => Role::Mirror,
        7 => Role::Grain,
        8 => Role::Internal,
        11 => Role::Cutout,
        13 => Role::Drill,
        14 => Role::Sew,
        15 | 19 => Role::Annotation,
        3 | 5 | 9 | 10 | 12 | 84..=87 => Role::Ignored,
        _ => Role::General,
    }
}

fn named(layer: &str) -> Role {
    const NAMES: [(&str, Role); 19] = [
        ("cutout", Role::Cutout),
        ("hole", Role::Cutout),
        ("cut", Role::Boundary),
        ("outline", Role::Boundary),
        ("boundary", Role::Boundary),
        ("contour", Role::Boundary),
        ("seam", Role::Sew),
        ("sew", Role::Sew),
        ("stitch", Role::Sew),
        ("fold", Role::Mirror),
        ("mirror", Role::Mirror),
        ("grain", Role::Grain),
        ("notch", Role::Notch(NotchKind::Slit)),
        ("drill", Role::Drill),
        ("internal", Role::Internal),
        ("text", Role::Annotation),
        ("label", Role::Annotation),
        ("annotation", Role::Annotation),
        ("defpoints", Role::Ignored),
    ];
    NAMES
        .iter()
        .find(|(part, _)| layer.contains(part))
        .map_or(Role::General, |(_, role)| *role)
}
