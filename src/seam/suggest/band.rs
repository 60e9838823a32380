//! Bands: waistbands, cuffs, collars, bindings. A long edge goes round an opening, the ends meet each other.

use super::garment::{Garment, Saying, ease};
use super::join;
use super::piece::{Chain, Kind, Lateral, Piece, Role, Segment, Step, Which, reversed};

/// Which long edge is sewn where nothing else tells, as drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rim {
    Lower,
    Upper,
    /// Both long edges are sewn: as drawn, whatever else.
    Lowest,
    Uppermost,
}

impl Rim {
    fn is_lower(self) -> bool {
        matches!(self, Self::Lower | Self::Lowest)
    }

    fn weight(self) -> f64 {
        match self {
            Self::Lower | Self::Upper => DRAWN_WEIGHT,
            Self::Lowest | Self::Uppermost => 100.0,
        }
    }
}

/// How much a corner that meets counts against ease and against the way a band is drawn.
const EASE_WEIGHT: f64 = 6.0;
const DRAWN_WEIGHT: f64 = 0.4;
/// How much it counts that both bands of an opening are sewn at the same edge as drawn.
const ALIKE_WEIGHT: f64 = 1.5;

/// An opening that something goes round, as the part in front and the part behind; all in the first where it is not
/// known which part is in front.
pub(super) type Opening = [Chain; 2];

/// Pieces that go round one opening: one, or a front and a back one.
#[derive(Clone, Debug)]
pub(super) enum Bands {
    One(Box<Piece>),
    Two(Box<[Piece; 2]>),
}

/// The bands of a kind that `fits` picks, the least numbered first.
pub(super) fn bands(garment: &Garment, kind: Kind, fits: impl Fn(&Piece) -> bool) -> Option<Bands> {
    let of = |which: Option<Which>| {
        garment
            .of(kind)
            .filter(|p| fits(p) && (which.is_none() || p.which == which))
            .min_by_key(|p| p.number)
            .cloned()
    };
    match (of(Some(Which::Front)), of(Some(Which::Back))) {
        (Some(front), Some(back)) => Some(Bands::Two(Box::new([front, back]))),
        _ => of(None).map(|band| Bands::One(Box::new(band))),
    }
}

/// Whether a piece is worn on one side of the wearer, or on no side in particular.
pub(super) fn is_on(piece: &Piece, lateral: Lateral) -> bool {
    piece.lateral.is_none() || piece.lateral == Some(lateral)
}

/// A long edge of a band laid along an opening.
#[derive(Clone, Debug)]
pub(super) struct Laid {
    band: Piece,
    long: Segment,
    pub(super) chain: Chain,
}

/// Sews bands round an opening, and their ends to each other. Gives the opening that their free long edges make.
pub(super) fn round(
    garment: &mut Garment,
    saying: Saying<'_>,
    opening: &Opening,
    bands: &Bands,
    rim: Rim,
) -> Option<Opening> {
    match bands {
        Bands::One(band) => one(garment, saying, &opening.concat(), band, rim),
        Bands::Two(pair) => {
            let [front, back] = pair.as_ref();
            if opening[1].is_empty() {
                on_ring(garment, saying, &opening[0], [front, back], rim)
            } else {
                two(garment, saying, opening, [front, back], rim)
            }
        }
    }
}

/// One band, closed on itself.
fn one(
    garment: &mut Garment,
    saying: Saying<'_>,
    opening: &Chain,
    band: &Piece,
    rim: Rim,
) -> Option<Opening> {
    let laid = lay(garment, opening, band, rim)?;
    if !garment.sew_round(saying, Some(opening.clone()), Some(laid.chain.clone())) {
        return None;
    }
    let (a, b) = (laid.end(true), laid.end(false));
    if !is_sewn(garment, a.as_ref()) {
        garment.sew(ends(&format!("{}-ends", saying.id)), a, b);
    }
    Some([laid.free()?, vec![]])
}

/// Two bands, each along its part of the opening.
fn two(
    garment: &mut Garment,
    saying: Saying<'_>,
    opening: &Opening,
    bands: [&Piece; 2],
    rim: Rim,
) -> Option<Opening> {
    let [a, b] = lay_both(garment, [&opening[0], &opening[1]], bands, rim)?;
    let whole = (
        opening.concat(),
        [a.chain.clone(), b.chain.clone()].concat(),
    );
    let apart =
        join::parted(&opening[0], &a.chain).len() + join::parted(&opening[1], &b.chain).len();
    if join::parted_round(&whole.0, &whole.1).len() > apart {
        // Their ends meet elsewhere than front and back of the opening do.
        garment.sew_round(saying, Some(whole.0), Some(whole.1));
    } else {
        for (name, part, laid) in [("front", &opening[0], &a), ("back", &opening[1], &b)] {
            let id = format!("{}-{name}", saying.id);
            garment.sew(
                Saying { id: &id, ..saying },
                Some(part.clone()),
                Some(laid.chain.clone()),
            );
        }
    }
    close(garment, saying, &a, &b);
    Some([a.free()?, b.free()?])
}

/// Two bands round an opening of which it is not known what is in front.
fn on_ring(
    garment: &mut Garment,
    saying: Saying<'_>,
    opening: &Chain,
    bands: [&Piece; 2],
    rim: Rim,
) -> Option<Opening> {
    let [a, b] = lay_both(garment, [opening, opening], bands, rim)?;
    let both = [a.chain.clone(), b.chain.clone()].concat();
    garment.sew_anyhow(saying, opening, &both);
    close(garment, saying, &a, &b);
    Some([a.free()?, b.free()?])
}

/// Sews the ends of two bands to each other.
fn close(garment: &mut Garment, saying: Saying<'_>, a: &Laid, b: &Laid) {
    for (name, first, second) in [
        ("left", a.end(true), b.end(false)),
        ("right", a.end(false), b.end(true)),
    ] {
        if is_sewn(garment, first.as_ref()) {
            continue;
        }
        garment.sew(ends(&format!("{}-end-{name}", saying.id)), first, second);
    }
}

/// Whether the end of a band is part of a seam already: a band that goes round two openings has it sewn once.
fn is_sewn(garment: &Garment, end: Option<&Chain>) -> bool {
    let first = end.and_then(|chain| chain.first());
    first.is_some_and(|step| garment.is_sewn(step.panel, step.edge))
}

pub(super) fn ends(id: &str) -> Saying<'_> {
    Saying::new(id, "the ends of the band meet")
}

/// The long edge that fits an opening best, laid so that both outer sides are out.
pub(super) fn lay(garment: &Garment, opening: &Chain, band: &Piece, rim: Rim) -> Option<Laid> {
    let ways = ways_to_lay(garment, opening, band, rim).into_iter();
    ways.max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, laid)| laid)
}

/// Every free long edge of a band along an opening, with how well it fits.
fn ways_to_lay(garment: &Garment, opening: &Chain, band: &Piece, rim: Rim) -> Vec<(f64, Laid)> {
    let free = |long: &&Segment| !long.edges.iter().any(|e| garment.is_sewn(band.panel, *e));
    let long = band
        .segments
        .iter()
        .filter(|s| matches!(s.role, Role::Long | Role::Hem | Role::Waist));
    let laid = long.filter(free).map(|long| Laid {
        band: band.clone(),
        long: long.clone(),
        chain: facing(garment, opening, band, long),
    });
    let with_score = laid.map(|laid| (laid.fits(opening, rim), laid));
    with_score.collect()
}

/// The long edges of two bands that fit their openings best, and each other: front and back are drawn alike.
fn lay_both(
    garment: &Garment,
    openings: [&Chain; 2],
    bands: [&Piece; 2],
    rim: Rim,
) -> Option<[Laid; 2]> {
    let [first, second] = [0, 1].map(|i| ways_to_lay(garment, openings[i], bands[i], rim));
    let mut best: Option<(f64, [&Laid; 2])> = None;
    for (a, x) in &first {
        for (b, y) in &second {
            let alike = if x.is_lower() == y.is_lower() {
                ALIKE_WEIGHT
            } else {
                0.0
            };
            if best.is_none_or(|(most, _)| a + b + alike > most) {
                best = Some((a + b + alike, [x, y]));
            }
        }
    }
    best.map(|(_, both)| both.map(Laid::clone))
}

/// A long edge gone the way that has both outer sides out: against the order of numbers where the opening goes with it,
/// unless one of the two is drawn mirrored or as seen through the body.
fn facing(garment: &Garment, opening: &[Step], band: &Piece, long: &Segment) -> Chain {
    let chain = band.chain(long);
    let Some(first) = opening.first() else {
        return chain;
    };
    let seen_from_inside = |p: &Piece| p.shape.mirrored != p.turned;
    let host = garment.pieces.iter().find(|p| p.panel == first.panel);
    let differ = host.is_some_and(|host| seen_from_inside(host) != seen_from_inside(band));
    if first.forward == differ {
        chain
    } else {
        reversed(&chain)
    }
}

impl Laid {
    /// How well it fits an opening, more being better.
    fn fits(&self, opening: &Chain, rim: Rim) -> f64 {
        let drawn = if rim.is_lower() == self.is_lower() {
            rim.weight()
        } else {
            0.0
        };
        let ease = ease(opening, &self.chain).min(0.5);
        join::agreement(opening, &self.chain) - EASE_WEIGHT * ease + drawn
    }

    /// Whether the edge lies in the lower half of the band as drawn.
    fn is_lower(&self) -> bool {
        self.band.shape.height(&self.long.edges) < self.band.shape.height(&self.band.shape.ring)
    }

    /// The end of the band where the laid edge begins or ends, going away from that edge.
    pub(super) fn end(&self, at_start: bool) -> Option<Chain> {
        let forward = self.chain.first()?.forward;
        let next = at_start != forward;
        let neighbour = self.neighbour(next, 1)?;
        if !matches!(neighbour.role, Role::End | Role::Side) {
            return None;
        }
        let chain = self.band.chain(neighbour);
        Some(if next { chain } else { reversed(&chain) })
    }

    /// The other long edge, gone the same way.
    fn free(&self) -> Option<Chain> {
        let forward = self.chain.first()?.forward;
        let chain = self.band.chain(self.neighbour(true, 2)?);
        Some(if forward { reversed(&chain) } else { chain })
    }

    fn neighbour(&self, next: bool, by: usize) -> Option<&Segment> {
        let all = &self.band.segments;
        let at = all.iter().position(|s| s.edges == self.long.edges)?;
        let count = all.len();
        all.get(if next { at + by } else { at + count - by } % count)
    }
}
