//! What panels usually look like: the cycles of roles by kind, with the lengths, bends and corners that drafts have.

use super::piece::{Kind, Role};
use super::template::{Look, Template};
use Role::{
    Armhole, Cap, Centre, Crotch, End, Hem, Inseam, Long, Neck, Shoulder, Side, Top, Underarm,
    Waist,
};

const fn look(role: Role, length: [f64; 2], bend: [f64; 2], corner: [f64; 2]) -> Look {
    Look {
        role,
        length,
        bend,
        corner,
    }
}

const BODICE: &[Look] = &[
    look(Hem, [0.0, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [75.0, 30.0]),
    look(Armhole, [-0.7, 0.4], [-75.0, 35.0], [90.0, 25.0]),
    look(Shoulder, [-1.4, 0.5], [0.0, 20.0], [90.0, 30.0]),
    look(Neck, [-0.5, 0.5], [-120.0, 70.0], [90.0, 30.0]),
    look(Shoulder, [-1.4, 0.5], [0.0, 20.0], [90.0, 25.0]),
    look(Armhole, [-0.7, 0.4], [-75.0, 35.0], [75.0, 30.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [90.0, 20.0]),
];

const BODICE_HALF: &[Look] = &[
    look(Hem, [-0.3, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [75.0, 30.0]),
    look(Armhole, [-0.4, 0.4], [-75.0, 35.0], [90.0, 25.0]),
    look(Shoulder, [-1.3, 0.5], [0.0, 20.0], [90.0, 30.0]),
    look(Neck, [-0.9, 0.5], [-60.0, 45.0], [70.0, 40.0]),
    look(Centre, [0.25, 0.4], [0.0, 15.0], [90.0, 15.0]),
];

/// Without shoulders: the upper edge goes from side to side.
const STRAPLESS: &[Look] = &[
    look(Hem, [0.3, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [-0.3, 0.5], [0.0, 25.0], [90.0, 30.0]),
    look(Neck, [0.3, 0.4], [0.0, 50.0], [90.0, 30.0]),
    look(Side, [-0.3, 0.5], [0.0, 25.0], [90.0, 20.0]),
];

const STRAPLESS_HALF: &[Look] = &[
    look(Hem, [0.0, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [0.0, 0.5], [0.0, 25.0], [90.0, 30.0]),
    look(Neck, [0.0, 0.4], [0.0, 50.0], [90.0, 30.0]),
    look(Centre, [0.0, 0.4], [0.0, 15.0], [90.0, 15.0]),
];

const SLEEVE: &[Look] = &[
    look(Hem, [0.0, 0.6], [0.0, 40.0], [90.0, 25.0]),
    look(Underarm, [-0.4, 0.9], [0.0, 20.0], [90.0, 30.0]),
    look(Cap, [0.4, 0.4], [10.0, 50.0], [90.0, 30.0]),
    look(Underarm, [-0.4, 0.9], [0.0, 20.0], [90.0, 25.0]),
];

const SLEEVE_HALF: &[Look] = &[
    look(Hem, [-0.2, 0.6], [0.0, 25.0], [90.0, 25.0]),
    look(Underarm, [0.0, 0.9], [0.0, 20.0], [70.0, 40.0]),
    look(Cap, [0.0, 0.4], [35.0, 40.0], [90.0, 25.0]),
    look(Top, [0.4, 0.6], [0.0, 20.0], [90.0, 25.0]),
];

const SKIRT: &[Look] = &[
    look(Hem, [0.2, 0.6], [30.0, 60.0], [90.0, 20.0]),
    look(Side, [0.0, 0.5], [5.0, 20.0], [90.0, 20.0]),
    look(Waist, [-0.4, 0.5], [-30.0, 60.0], [90.0, 20.0]),
    look(Side, [0.0, 0.5], [5.0, 20.0], [90.0, 20.0]),
];

const SKIRT_HALF: &[Look] = &[
    look(Hem, [-0.2, 0.6], [15.0, 40.0], [90.0, 20.0]),
    look(Side, [0.3, 0.5], [10.0, 15.0], [90.0, 20.0]),
    look(Waist, [-0.6, 0.5], [-20.0, 40.0], [90.0, 20.0]),
    look(Centre, [0.3, 0.5], [0.0, 10.0], [90.0, 15.0]),
];

const TROUSER: &[Look] = &[
    look(Hem, [-0.5, 0.4], [0.0, 20.0], [90.0, 20.0]),
    look(Side, [0.5, 0.4], [0.0, 25.0], [90.0, 25.0]),
    look(Waist, [-0.7, 0.4], [0.0, 25.0], [90.0, 25.0]),
    look(Crotch, [-0.4, 0.4], [-60.0, 35.0], [110.0, 25.0]),
    look(Inseam, [0.0, 0.7], [0.0, 25.0], [90.0, 20.0]),
];

const BAND: &[Look] = &[
    look(Long, [0.9, 0.6], [0.0, 60.0], [90.0, 25.0]),
    look(End, [-0.9, 0.6], [0.0, 30.0], [90.0, 25.0]),
    look(Long, [0.9, 0.6], [0.0, 60.0], [90.0, 25.0]),
    look(End, [-0.9, 0.6], [0.0, 30.0], [90.0, 25.0]),
];

const YOKE: &[Look] = &[
    look(Hem, [0.7, 0.4], [0.0, 25.0], [90.0, 25.0]),
    look(Armhole, [-0.7, 0.5], [0.0, 30.0], [90.0, 25.0]),
    look(Shoulder, [-0.4, 0.4], [0.0, 25.0], [90.0, 30.0]),
    look(Neck, [0.0, 0.4], [-90.0, 50.0], [90.0, 30.0]),
    look(Shoulder, [-0.4, 0.4], [0.0, 25.0], [90.0, 25.0]),
    look(Armhole, [-0.7, 0.5], [0.0, 30.0], [90.0, 25.0]),
];

const HOOD: &[Look] = &[
    look(Neck, [-0.3, 0.5], [0.0, 50.0], [90.0, 30.0]),
    look(Hem, [0.0, 0.4], [0.0, 30.0], [90.0, 30.0]),
    look(Centre, [0.5, 0.4], [90.0, 50.0], [90.0, 30.0]),
];

/// The front of a lapel: its free edge runs out to the neck.
const LAPEL: &[Look] = &[
    look(Long, [0.7, 0.5], [0.0, 40.0], [90.0, 25.0]),
    look(End, [-0.7, 0.6], [0.0, 30.0], [90.0, 40.0]),
    look(Hem, [0.7, 0.5], [0.0, 60.0], [150.0, 30.0]),
];

const GODET: &[Look] = &[
    look(Hem, [0.3, 0.5], [20.0, 40.0], [110.0, 30.0]),
    look(Side, [0.5, 0.4], [0.0, 20.0], [140.0, 30.0]),
    look(Side, [0.5, 0.4], [0.0, 20.0], [110.0, 30.0]),
];

const RAGLAN: &[Look] = &[
    look(Hem, [0.1, 0.4], [0.0, 25.0], [90.0, 20.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [75.0, 30.0]),
    look(Armhole, [-0.5, 0.4], [-30.0, 30.0], [60.0, 40.0]),
    look(Neck, [-1.0, 0.5], [-60.0, 50.0], [60.0, 40.0]),
    look(Armhole, [-0.5, 0.4], [-30.0, 30.0], [75.0, 30.0]),
    look(Side, [-0.3, 0.6], [0.0, 25.0], [90.0, 20.0]),
];

const RAGLAN_SLEEVE: &[Look] = &[
    look(Hem, [-0.2, 0.6], [0.0, 30.0], [90.0, 25.0]),
    look(Underarm, [-0.4, 0.9], [0.0, 20.0], [80.0, 40.0]),
    look(Armhole, [-0.2, 0.4], [-10.0, 40.0], [80.0, 40.0]),
    look(Neck, [-1.6, 0.6], [0.0, 40.0], [80.0, 40.0]),
    look(Armhole, [-0.2, 0.4], [-10.0, 40.0], [80.0, 40.0]),
    look(Underarm, [-0.4, 0.9], [0.0, 20.0], [90.0, 25.0]),
];

const fn whole(looks: &'static [Look]) -> Template {
    Template {
        half: false,
        looks,
        rare: 0.0,
    }
}

const fn half(looks: &'static [Look]) -> Template {
    Template {
        half: true,
        ..whole(looks)
    }
}

/// A template to be taken only where no usual one fits.
const fn rare(template: Template) -> Template {
    Template {
        rare: 0.7,
        ..template
    }
}

/// The templates of a kind.
pub(super) fn of(kind: Kind) -> Vec<Template> {
    match kind {
        Kind::Bodice => vec![
            whole(BODICE),
            half(BODICE_HALF),
            rare(whole(STRAPLESS)),
            rare(half(STRAPLESS_HALF)),
            rare(whole(RAGLAN)),
        ],
        Kind::Skirt => vec![whole(SKIRT), half(SKIRT_HALF)],
        Kind::Trouser => vec![half(TROUSER)],
        Kind::Sleeve => vec![whole(SLEEVE), half(SLEEVE_HALF), whole(RAGLAN_SLEEVE)],
        Kind::Yoke => vec![whole(YOKE)],
        Kind::Hood => vec![half(HOOD)],
        Kind::Collar => vec![whole(BAND), half(LAPEL)],
        Kind::CollarStand | Kind::NeckBand | Kind::ArmBand | Kind::Waistband => {
            vec![whole(BAND)]
        }
        Kind::Cuff => vec![whole(BAND), whole(SKIRT)],
        Kind::Godet => vec![whole(GODET)],
        Kind::Pocket | Kind::Placket | Kind::Layer => vec![],
    }
}
