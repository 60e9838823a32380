//! A panel as a part of a garment: what it is, and which of its edges are its hem, its side, its armhole.

use super::shape::Shape;
use std::rc::Rc;

/// What a panel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    Bodice,
    Skirt,
    Trouser,
    Sleeve,
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

/// Front or back of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Which {
    Front,
    Back,
}

/// Side of the wearer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Lateral {
    Left,
    Right,
}

impl Lateral {
    pub(super) fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// What an edge is of its panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Role {
    Hem,
    Side,
    Armhole,
    Shoulder,
    Neck,
    /// Centre front or centre back.
    Centre,
    /// The upper edge of a sleeve.
    Cap,
    Underarm,
    /// Where the two halves of a sleeve meet, over the shoulder.
    Top,
    Waist,
    Inseam,
    Crotch,
    /// A long edge of a band.
    Long,
    /// A short edge of a band.
    End,
}

/// Where on a panel that lies hem down and face up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Hand {
    /// On the left of the drawing.
    Left,
    /// On the right of the drawing.
    Right,
}

impl Hand {
    pub(super) fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

/// Edges of one role, one after another.
#[derive(Clone, Debug)]
pub(super) struct Segment {
    pub(super) role: Role,
    pub(super) hand: Hand,
    /// In order of numbers; darts between them are left out.
    pub(super) edges: Vec<usize>,
    /// The role before it.
    pub(super) before: Role,
}

/// A panel whose edges have roles.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    /// Its place in the pattern.
    pub(super) panel: usize,
    pub(super) kind: Kind,
    /// What else its name says: the sleeve or the leg of a cuff.
    pub(super) of: Vec<Kind>,
    /// Its place in a row of such pieces.
    pub(super) number: u32,
    pub(super) which: Option<Which>,
    pub(super) lateral: Option<Lateral>,
    /// Whether its name says so.
    pub(super) lateral_said: bool,
    /// Whether it covers one side of the body only.
    pub(super) half: bool,
    /// Whether it is drawn as seen through the body: not with its outer side up.
    pub(super) turned: bool,
    pub(super) shape: Rc<Shape>,
    pub(super) segments: Vec<Segment>,
    /// How badly it fits what such a panel looks like; 0 is best.
    pub(super) cost: f64,
    /// Whether its name says its kind, or front or back.
    pub(super) named: bool,
    /// Whether its name says its kind, not only front or back.
    pub(super) kind_said: bool,
}

/// One edge on the way along a seam, and whether it is gone in order of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Step {
    pub(super) panel: usize,
    pub(super) edge: usize,
    pub(super) forward: bool,
    /// Arc length \[m\].
    pub(super) length: f64,
}

/// Steps one after another.
pub(super) type Chain = Vec<Step>;

/// The same chain from its end.
pub(super) fn reversed(chain: &[Step]) -> Chain {
    let back = |step: &Step| Step {
        forward: !step.forward,
        ..*step
    };
    chain.iter().rev().map(back).collect()
}

pub(super) fn length(chain: &[Step]) -> f64 {
    chain.iter().map(|step| step.length).sum()
}

impl Piece {
    /// The wearer's side on which a hand of it lies: a front with its outer side up has the wearer's right on its left.
    pub(super) fn lateral_of(&self, hand: Hand) -> Lateral {
        let behind = self.which == Some(Which::Back);
        if (hand == Hand::Left) == (behind != self.turned) {
            Lateral::Left
        } else {
            Lateral::Right
        }
    }

    /// The hand at which a segment on the upper side begins, in order of numbers.
    pub(super) fn first_hand(&self) -> Hand {
        if self.shape.mirrored {
            Hand::Right
        } else {
            Hand::Left
        }
    }

    /// The hand of it that lies on the wearer's side.
    pub(super) fn hand_of(&self, lateral: Lateral) -> Hand {
        if self.lateral_of(Hand::Left) == lateral {
            Hand::Left
        } else {
            Hand::Right
        }
    }

    /// The segments of a role.
    pub(super) fn all(&self, role: Role) -> impl Iterator<Item = &Segment> {
        self.segments.iter().filter(move |s| s.role == role)
    }

    /// The segment of a role, on one hand if there are two.
    pub(super) fn segment(&self, role: Role, hand: Option<Hand>) -> Option<&Segment> {
        self.all(role)
            .find(|s| hand.is_none_or(|hand| s.hand == hand))
    }

    /// A segment in order of numbers.
    pub(super) fn chain(&self, segment: &Segment) -> Chain {
        let step = |&edge: &usize| Step {
            panel: self.panel,
            edge,
            forward: true,
            length: self.shape.edges[edge].length,
        };
        segment.edges.iter().map(step).collect()
    }

    /// A segment from where it meets `role`.
    pub(super) fn chain_from(&self, segment: &Segment, role: Role) -> Chain {
        let chain = self.chain(segment);
        if segment.before == role {
            chain
        } else {
            reversed(&chain)
        }
    }
}
