//! The pieces of a garment as they lie round the body, and the seams that the rules have found so far.

use super::join;
use super::piece::{Chain, Kind, Lateral, Piece, Role, Segment, Step, Which, length, reversed};

/// Ease above which two edges are no seam, unless one of them may be gathered; and then.
const MOST_EASE: f64 = 0.30;
const MOST_GATHER: f64 = 3.0;
/// Ease at which trust in a seam has fallen to 60 %.
const USUAL_EASE: f64 = 0.05;

/// A seam that a rule proposes.
#[derive(Clone, Debug)]
pub(super) struct Draft {
    pub(super) id: String,
    pub(super) sides: [Chain; 2],
    pub(super) gather: bool,
    pub(super) confidence: f64,
    pub(super) because: String,
}

/// What a rule says of a seam besides its edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Saying<'a> {
    /// Its name, to which numbers are added where it has several parts.
    pub(super) id: &'a str,
    /// Why these edges belong together.
    pub(super) because: &'a str,
    /// Whether much ease is usual here.
    pub(super) gather: bool,
}

impl<'a> Saying<'a> {
    /// Edges of one length.
    pub(super) fn new(id: &'a str, because: &'a str) -> Self {
        Self {
            id,
            because,
            gather: false,
        }
    }

    /// The same where much ease is usual.
    pub(super) fn gathered(self) -> Self {
        Self {
            gather: true,
            ..self
        }
    }
}

/// The pieces of a garment round the body.
#[derive(Clone, Debug)]
pub(super) struct Garment {
    pub(super) pieces: Vec<Piece>,
    pub(super) drafts: Vec<Draft>,
}

impl Garment {
    /// The pieces of a kind.
    pub(super) fn of(&self, kind: Kind) -> impl Iterator<Item = &Piece> {
        self.pieces.iter().filter(move |piece| piece.kind == kind)
    }

    pub(super) fn has(&self, kind: Kind) -> bool {
        self.of(kind).next().is_some()
    }

    /// The piece of a kind in front of or behind one side of the wearer.
    pub(super) fn piece(&self, kind: Kind, which: Which, lateral: Lateral) -> Option<&Piece> {
        let covers = |piece: &&Piece| {
            piece.which == Some(which) && (!piece.half || piece.lateral == Some(lateral))
        };
        self.of(kind)
            .filter(covers)
            .min_by_key(|piece| piece.number)
    }

    /// Whether an edge is part of a seam already.
    pub(super) fn is_sewn(&self, panel: usize, edge: usize) -> bool {
        let sides = self.drafts.iter().flat_map(|d| d.sides.iter().flatten());
        sides
            .into_iter()
            .any(|step| (step.panel, step.edge) == (panel, edge))
    }

    /// The segment of a role on one side of the wearer.
    pub(super) fn segment(
        &self,
        kind: Kind,
        which: Which,
        place: (Role, Lateral),
    ) -> Option<(&Piece, &Segment)> {
        let (role, lateral) = place;
        let piece = self.piece(kind, which, lateral)?;
        if !piece.half && piece.all(role).count() < 2 {
            return None; // It lies on both sides.
        }
        let hand = if piece.half {
            None
        } else {
            Some(piece.hand_of(lateral))
        };
        Some((piece, piece.segment(role, hand)?))
    }

    /// A segment of a role on one side of the wearer as a chain from where it meets `from`.
    pub(super) fn chain(
        &self,
        kind: Kind,
        which: Which,
        place: (Role, Lateral),
        from: Role,
    ) -> Option<Chain> {
        let (piece, segment) = self.segment(kind, which, place)?;
        Some(piece.chain_from(segment, from))
    }

    /// An upper or lower edge of a piece, from the wearer's side `from` to the other; of half a piece, what it has of that.
    pub(super) fn across(&self, piece: &Piece, segment: &Segment, from: Lateral) -> Chain {
        let chain = piece.chain(segment);
        if piece.half {
            let outer = |role| matches!(role, Role::Side | Role::Shoulder | Role::Underarm);
            let begins_outside = outer(segment.before);
            let outside_first = piece.lateral == Some(from);
            return if begins_outside == outside_first {
                chain
            } else {
                reversed(&chain)
            };
        }
        let top = segment.role != Role::Hem;
        let first = piece.first_hand();
        let begins = if top { first } else { first.other() };
        if piece.lateral_of(begins) == from {
            chain
        } else {
            reversed(&chain)
        }
    }

    /// The edges of a role in front of the body from the wearer's left, or behind it from the right.
    pub(super) fn half_ring(&self, kind: Kind, role: Role, which: Which) -> Option<Chain> {
        let from = match which {
            Which::Front => Lateral::Left,
            Which::Back => Lateral::Right,
        };
        let first = self.piece(kind, which, from)?;
        let mut chain = self.across(first, first.segment(role, None)?, from);
        if first.half {
            let second = self.piece(kind, which, from.other())?;
            chain.extend(self.across(second, second.segment(role, None)?, from));
        }
        Some(chain)
    }

    /// Proposes that two chains that begin and end together are sewn.
    pub(super) fn sew(&mut self, saying: Saying<'_>, a: Option<Chain>, b: Option<Chain>) -> bool {
        let (Some(a), Some(b)) = (a, b) else {
            return false;
        };
        self.propose(saying, [&a, &b], join::parted(&a, &b))
    }

    /// Proposes that two closed chains are sewn that may be turned against each other in any way.
    pub(super) fn sew_anyhow(&mut self, saying: Saying<'_>, a: &Chain, b: &Chain) -> bool {
        self.propose(saying, [a, b], join::parted_anyhow(a, b))
    }

    /// Proposes that two closed chains are sewn.
    pub(super) fn sew_round(
        &mut self,
        saying: Saying<'_>,
        a: Option<Chain>,
        b: Option<Chain>,
    ) -> bool {
        let (Some(a), Some(b)) = (a, b) else {
            return false;
        };
        self.propose(saying, [&a, &b], join::parted_round(&a, &b))
    }

    fn propose(&mut self, saying: Saying<'_>, whole: [&Chain; 2], parts: Vec<join::Joint>) -> bool {
        let ease = ease(whole[0], whole[1]);
        let most = if saying.gather {
            MOST_GATHER
        } else {
            MOST_EASE
        };
        if ease.is_nan() || ease > most {
            return false;
        }
        let fit = self.fit(whole);
        let count = parts.len();
        for (i, sides) in parts.into_iter().enumerate() {
            let ease = join_ease(&sides);
            let usual = if saying.gather && ease > 0.1 {
                0.7
            } else {
                (-0.5 * (ease / USUAL_EASE).powi(2)).exp()
            };
            let id = if count == 1 {
                saying.id.to_owned()
            } else {
                format!("{}-{}", saying.id, i + 1)
            };
            self.drafts.push(Draft {
                id,
                sides,
                gather: ease > MOST_EASE,
                confidence: (fit * (0.4 + 0.6 * usual)).clamp(0.01, 0.99),
                because: format!(
                    "{}; the lengths agree to {:.1} %",
                    saying.because,
                    100.0 * ease
                ),
            });
        }
        true
    }

    /// How sure it is that the pieces of a seam are what they are taken for.
    fn fit(&self, sides: [&Chain; 2]) -> f64 {
        let piece = |step: &Step| self.pieces.iter().find(|p| p.panel == step.panel);
        let trust = |p: &Piece| {
            let look = (-p.cost / 6.0).exp();
            if p.named {
                0.7 + 0.3 * look
            } else {
                0.2 + 0.8 * look
            }
        };
        let all = sides.into_iter().flatten();
        all.filter_map(piece).map(trust).fold(1.0, f64::min)
    }
}

fn join_ease(sides: &join::Joint) -> f64 {
    ease(&sides[0], &sides[1])
}

/// Longer over shorter, less 1.
pub(super) fn ease(a: &[Step], b: &[Step]) -> f64 {
    let (a, b) = (length(a), length(b));
    a.max(b) / a.min(b).max(1e-9) - 1.0
}
