//! Godets: wedges set into slits of a hem.

use super::garment::{Garment, Saying};
use super::piece::{Chain, Hand, Kind, Piece, Role, Step, length};
use super::shape::Dart;

/// How much the side of a godet and of its slit may differ.
const NEAR: f64 = 0.03;

/// Sets every godet into a slit.
pub(super) fn sew(garment: &mut Garment) {
    let mut godets: Vec<Piece> = garment.of(Kind::Godet).cloned().collect();
    godets.sort_by_key(|p| (p.which, p.number));
    for godet in godets {
        let Some((host, slit)) = slit(garment, &godet) else {
            continue;
        };
        let leg = |edge: usize, forward| -> Chain {
            vec![Step {
                panel: host.panel,
                edge,
                forward,
                length: host.shape.edges[edge].length,
            }]
        };
        let right = if host.shape.mirrored {
            Hand::Left
        } else {
            Hand::Right
        };
        // The slit's first leg meets the side of the godet that lies on the right: both outer sides are out.
        for (leg, hand, name) in [
            (leg(slit.inward, true), right, "a"),
            (leg(slit.outward, false), right.other(), "b"),
        ] {
            let side = godet
                .segment(Role::Side, Some(hand))
                .map(|s| godet.chain_from(s, Role::Hem));
            let id = format!("godet-{}-{name}", godet.panel);
            let saying = Saying::new(&id, "the godet is set into the slit");
            garment.sew(saying, Some(leg), side);
        }
    }
}

/// The first free slit that fits a godet, from the left of its panel.
fn slit(garment: &Garment, godet: &Piece) -> Option<(Piece, Dart)> {
    let side = length(&godet.chain(godet.segment(Role::Side, None)?));
    let mut found: Vec<(f64, Piece, Dart)> = vec![];
    for host in garment
        .of(Kind::Skirt)
        .filter(|p| p.which == godet.which || godet.which.is_none())
    {
        for dart in &host.shape.darts {
            let leg = host.shape.edges[dart.inward];
            if (leg.length - side).abs() <= NEAR * side && !garment.is_sewn(host.panel, dart.inward)
            {
                found.push((leg.ends[1][0], host.clone(), *dart));
            }
        }
    }
    let first = found.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((first.1, first.2))
}
