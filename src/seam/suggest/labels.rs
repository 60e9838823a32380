//! Labels of panels and edges: kind, front or back, left or right, edge role.

use serde::Deserialize;

/// Kind of a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum PanelKind {
    Bodice,
    Skirt,
    /// The front or the back of a leg of trousers.
    Trouser,
    /// A leg of trousers in one piece.
    Leg,
    Sleeve,
    /// The lower part of a sleeve of two parts.
    UnderSleeve,
    /// Between front and back: a side panel, or the outer part of a front or back with a princess
    /// seam.
    Side,
    Yoke,
    Hood,
    Collar,
    CollarStand,
    NeckBand,
    ArmBand,
    Cuff,
    Waistband,
    /// A wedge set into a slit.
    Godet,
    Pocket,
    Placket,
    /// Facing, lining, interfacing: laid on another panel.
    Layer,
}

impl PanelKind {
    /// Kinds that a panel may be whose name says only front or back, or nothing.
    pub(super) const BODY: [Self; 3] = [Self::Bodice, Self::Skirt, Self::Trouser];

    /// Returns the word for such a panel in a sentence.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Self::Bodice => "a bodice",
            Self::Skirt => "a skirt",
            Self::Trouser => "trousers",
            Self::Leg => "a leg in one piece",
            Self::Sleeve => "a sleeve",
            Self::UnderSleeve => "an under sleeve",
            Self::Side => "a side panel",
            Self::Yoke => "a yoke",
            Self::Hood => "a hood",
            Self::Collar => "a collar",
            Self::CollarStand => "a collar stand",
            Self::NeckBand => "a neck band",
            Self::ArmBand => "an armhole band",
            Self::Cuff => "a cuff",
            Self::Waistband => "a waistband",
            Self::Godet => "a godet",
            Self::Pocket => "a pocket",
            Self::Placket => "a placket",
            Self::Layer => "a facing",
        }
    }
}

/// Front or back of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum FrontBack {
    Front,
    Back,
}

/// Side of the wearer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Laterality {
    Left,
    Right,
}

impl Laterality {
    /// Returns the side of the drawing on which the front of a sleeve or side panel lies that is
    /// drawn hem down and face up: the left for a left one.
    pub(super) fn usual_front_side(self) -> DrawnSide {
        match self {
            Self::Left => DrawnSide::Left,
            Self::Right => DrawnSide::Right,
        }
    }

    pub(super) fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// Role of an edge in its panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum EdgeRole {
    Hem,
    Side,
    Armhole,
    Shoulder,
    Neck,
    /// Center front or center back.
    Center,
    /// The upper edge of a sleeve.
    Cap,
    Underarm,
    /// Edge at which the two halves of a sleeve meet, over the shoulder.
    Top,
    Waist,
    Inseam,
    Crotch,
    /// A long edge of a band.
    Long,
    /// A short edge of a band.
    End,
}

/// Side of the drawing of a panel that lies hem down and face up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum DrawnSide {
    /// On the left of the drawing.
    Left,
    /// On the right of the drawing.
    Right,
}

impl DrawnSide {
    pub(super) fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}
