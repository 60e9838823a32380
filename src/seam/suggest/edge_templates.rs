//! What panels usually look like: the cycles of roles by kind, with the lengths, bends and corners that drafts have.

use super::labels::{EdgeRole, PanelKind};
use EdgeRole::{
    Armhole, Cap, Centre, Crotch, End, Hem, Inseam, Long, Neck, Shoulder, Side, Top, Underarm,
    Waist,
};

/// What an edge of one role usually looks like. Angles in degrees, positive where the outline is convex.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeTemplate {
    pub(super) role: EdgeRole,
    /// Logarithm of its length over the size of the panel, and how much that varies.
    pub(super) length: [f64; 2],
    /// How much it turns on its way, and how much that varies.
    pub(super) bend: [f64; 2],
    /// The turn from it to the next role, and how much that varies.
    pub(super) corner: [f64; 2],
}

/// The cycle of roles round a panel, in clockwise order where it lies hem down; those of half a panel with its side on the left.
#[derive(Clone, Copy, Debug)]
pub(super) struct PanelTemplate {
    pub(super) half: bool,
    pub(super) edges: &'static [EdgeTemplate],
    /// Misfit that any division into these roles has.
    pub(super) rarity: f64,
}

const fn look(role: EdgeRole, length: [f64; 2], bend: [f64; 2], corner: [f64; 2]) -> EdgeTemplate {
    EdgeTemplate {
        role,
        length,
        bend,
        corner,
    }
}

const BODICE: &[EdgeTemplate] = &[
    look(Hem, [0.0, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [75.0, 30.0]),
    look(Armhole, [-0.7, 0.4], [-75.0, 35.0], [90.0, 25.0]),
    look(Shoulder, [-1.4, 0.5], [0.0, 20.0], [90.0, 30.0]),
    look(Neck, [-0.5, 0.5], [-120.0, 70.0], [90.0, 30.0]),
    look(Shoulder, [-1.4, 0.5], [0.0, 20.0], [90.0, 25.0]),
    look(Armhole, [-0.7, 0.4], [-75.0, 35.0], [75.0, 30.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [90.0, 20.0]),
];

const BODICE_HALF: &[EdgeTemplate] = &[
    look(Hem, [-0.3, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [75.0, 30.0]),
    look(Armhole, [-0.4, 0.4], [-75.0, 35.0], [90.0, 25.0]),
    look(Shoulder, [-1.3, 0.5], [0.0, 20.0], [90.0, 30.0]),
    look(Neck, [-0.9, 0.5], [-60.0, 45.0], [70.0, 40.0]),
    look(Centre, [0.25, 0.4], [0.0, 15.0], [90.0, 15.0]),
];

/// Without shoulders: the upper edge goes from side to side.
const STRAPLESS: &[EdgeTemplate] = &[
    look(Hem, [0.3, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [-0.3, 0.5], [0.0, 25.0], [90.0, 30.0]),
    look(Neck, [0.3, 0.4], [0.0, 50.0], [90.0, 30.0]),
    look(Side, [-0.3, 0.5], [0.0, 25.0], [90.0, 20.0]),
];

const STRAPLESS_HALF: &[EdgeTemplate] = &[
    look(Hem, [0.0, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [0.0, 0.5], [0.0, 25.0], [90.0, 30.0]),
    look(Neck, [0.0, 0.4], [0.0, 50.0], [90.0, 30.0]),
    look(Centre, [0.0, 0.4], [0.0, 15.0], [90.0, 15.0]),
];

const SLEEVE: &[EdgeTemplate] = &[
    look(Hem, [0.0, 0.6], [0.0, 40.0], [90.0, 25.0]),
    look(Underarm, [-0.4, 0.9], [0.0, 20.0], [90.0, 30.0]),
    look(Cap, [0.4, 0.4], [10.0, 50.0], [90.0, 30.0]),
    look(Underarm, [-0.4, 0.9], [0.0, 20.0], [90.0, 25.0]),
];

const SLEEVE_HALF: &[EdgeTemplate] = &[
    look(Hem, [-0.2, 0.6], [0.0, 25.0], [90.0, 25.0]),
    look(Underarm, [0.0, 0.9], [0.0, 20.0], [70.0, 40.0]),
    look(Cap, [0.0, 0.4], [35.0, 40.0], [90.0, 25.0]),
    look(Top, [0.4, 0.6], [0.0, 20.0], [90.0, 25.0]),
];

const SKIRT: &[EdgeTemplate] = &[
    look(Hem, [0.2, 0.6], [30.0, 60.0], [90.0, 20.0]),
    look(Side, [0.0, 0.5], [5.0, 20.0], [90.0, 20.0]),
    look(Waist, [-0.4, 0.5], [-30.0, 60.0], [90.0, 20.0]),
    look(Side, [0.0, 0.5], [5.0, 20.0], [90.0, 20.0]),
];

const SKIRT_HALF: &[EdgeTemplate] = &[
    look(Hem, [-0.2, 0.6], [15.0, 40.0], [90.0, 20.0]),
    look(Side, [0.3, 0.5], [10.0, 15.0], [90.0, 20.0]),
    look(Waist, [-0.6, 0.5], [-20.0, 40.0], [90.0, 20.0]),
    look(Centre, [0.3, 0.5], [0.0, 10.0], [90.0, 15.0]),
];

const TROUSER: &[EdgeTemplate] = &[
    look(Hem, [-0.5, 0.4], [0.0, 20.0], [90.0, 20.0]),
    look(Side, [0.5, 0.4], [0.0, 25.0], [90.0, 25.0]),
    look(Waist, [-0.7, 0.4], [0.0, 25.0], [90.0, 25.0]),
    look(Crotch, [-0.4, 0.4], [-60.0, 35.0], [110.0, 25.0]),
    look(Inseam, [0.0, 0.7], [0.0, 25.0], [90.0, 20.0]),
];

const BAND: &[EdgeTemplate] = &[
    look(Long, [0.9, 0.6], [0.0, 60.0], [90.0, 25.0]),
    look(End, [-0.9, 0.6], [0.0, 30.0], [90.0, 25.0]),
    look(Long, [0.9, 0.6], [0.0, 60.0], [90.0, 25.0]),
    look(End, [-0.9, 0.6], [0.0, 30.0], [90.0, 25.0]),
];

const YOKE: &[EdgeTemplate] = &[
    look(Hem, [0.7, 0.4], [0.0, 25.0], [90.0, 25.0]),
    look(Armhole, [-0.7, 0.5], [0.0, 30.0], [90.0, 25.0]),
    look(Shoulder, [-0.4, 0.4], [0.0, 25.0], [90.0, 30.0]),
    look(Neck, [0.0, 0.4], [-90.0, 50.0], [90.0, 30.0]),
    look(Shoulder, [-0.4, 0.4], [0.0, 25.0], [90.0, 25.0]),
    look(Armhole, [-0.7, 0.5], [0.0, 30.0], [90.0, 25.0]),
];

const HOOD: &[EdgeTemplate] = &[
    look(Neck, [-0.3, 0.5], [0.0, 50.0], [90.0, 30.0]),
    look(Hem, [0.0, 0.4], [0.0, 30.0], [90.0, 30.0]),
    look(Centre, [0.5, 0.4], [90.0, 50.0], [90.0, 30.0]),
];

/// The front of a lapel: its free edge runs out to the neck.
const LAPEL: &[EdgeTemplate] = &[
    look(Long, [0.7, 0.5], [0.0, 40.0], [90.0, 25.0]),
    look(End, [-0.7, 0.6], [0.0, 30.0], [90.0, 40.0]),
    look(Hem, [0.7, 0.5], [0.0, 60.0], [150.0, 30.0]),
];

const GODET: &[EdgeTemplate] = &[
    look(Hem, [0.3, 0.5], [20.0, 40.0], [110.0, 30.0]),
    look(Side, [0.5, 0.4], [0.0, 20.0], [140.0, 30.0]),
    look(Side, [0.5, 0.4], [0.0, 20.0], [110.0, 30.0]),
];

const RAGLAN: &[EdgeTemplate] = &[
    look(Hem, [0.1, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [75.0, 30.0]),
    look(Armhole, [-0.5, 0.4], [-30.0, 30.0], [60.0, 40.0]),
    look(Neck, [-1.0, 0.5], [-60.0, 50.0], [60.0, 40.0]),
    look(Armhole, [-0.5, 0.4], [-30.0, 30.0], [75.0, 30.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [90.0, 20.0]),
];

const RAGLAN_SLEEVE: &[EdgeTemplate] = &[
    look(Hem, [-0.2, 0.6], [0.0, 30.0], [90.0, 25.0]),
    look(Underarm, [-0.4, 0.9], [0.0, 20.0], [80.0, 40.0]),
    look(Armhole, [-0.2, 0.4], [-10.0, 40.0], [80.0, 40.0]),
    look(Neck, [-1.6, 0.6], [0.0, 40.0], [80.0, 40.0]),
    look(Armhole, [-0.2, 0.4], [-10.0, 40.0], [80.0, 40.0]),
    look(Underarm, [-0.4, 0.9], [0.0, 20.0], [90.0, 25.0]),
];

const fn whole(edges: &'static [EdgeTemplate]) -> PanelTemplate {
    PanelTemplate {
        half: false,
        edges,
        rarity: 0.0,
    }
}

const fn half(edges: &'static [EdgeTemplate]) -> PanelTemplate {
    PanelTemplate {
        half: true,
        ..whole(edges)
    }
}

/// A template to be taken only where no usual one fits.
const fn rarity(template: PanelTemplate) -> PanelTemplate {
    PanelTemplate {
        rarity: 0.7,
        ..template
    }
}

/// The templates of a kind.
pub(super) fn of(kind: PanelKind) -> Vec<PanelTemplate> {
    match kind {
        PanelKind::Bodice => vec![
            whole(BODICE),
            half(BODICE_HALF),
            rarity(whole(STRAPLESS)),
            rarity(half(STRAPLESS_HALF)),
            rarity(whole(RAGLAN)),
        ],
        PanelKind::Skirt => vec![whole(SKIRT), half(SKIRT_HALF)],
        PanelKind::Trouser => vec![half(TROUSER)],
        PanelKind::Sleeve => vec![whole(SLEEVE), half(SLEEVE_HALF), whole(RAGLAN_SLEEVE)],
        PanelKind::Yoke => vec![whole(YOKE)],
        PanelKind::Hood => vec![half(HOOD)],
        PanelKind::Collar => vec![whole(BAND), half(LAPEL)],
        PanelKind::CollarStand
        | PanelKind::NeckBand
        | PanelKind::ArmBand
        | PanelKind::Waistband => {
            vec![whole(BAND)]
        }
        PanelKind::Cuff => vec![whole(BAND), whole(SKIRT)],
        PanelKind::Godet => vec![whole(GODET)],
        PanelKind::Pocket | PanelKind::Placket | PanelKind::Layer => vec![],
    }
}
