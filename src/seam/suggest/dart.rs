//! Darts: two edges of one panel that meet at a tip, sewn together whatever the garment is.

use super::garment::{Garment, Saying};
use super::piece::{Chain, Kind, Piece, Role, Step};
use super::shape::Dart;
use crate::pattern::Pattern;

/// Darts of one panel that are sewn.
const MOST: usize = 40;

/// Sews every dart.
pub(super) fn sew(garment: &mut Garment, pattern: &Pattern) {
    for piece in garment.pieces.clone() {
        for (i, dart) in piece.shape.darts.iter().take(MOST).enumerate() {
            if garment.is_sewn(piece.panel, dart.inward) || is_slit(&piece, *dart) {
                continue;
            }
            let id = format!("dart-{}-{}", name(pattern, &piece), i + 1);
            let saying = Saying::new(&id, "two edges of the panel that meet at a tip are a dart");
            let leg = |edge: usize, forward| -> Chain {
                vec![Step {
                    panel: piece.panel,
                    edge,
                    forward,
                    length: piece.shape.edges[edge].length,
                }]
            };
            garment.sew(
                saying,
                Some(leg(dart.inward, true)),
                Some(leg(dart.outward, false)),
            );
        }
    }
}

/// Whether a dart opens in the hem of a skirt: a slit to walk in.
fn is_slit(piece: &Piece, dart: Dart) -> bool {
    let count = piece.shape.edges.len();
    let beside = [
        (dart.inward + count - 1) % count,
        (dart.outward + 1) % count,
    ];
    let hem: Vec<usize> = piece
        .all(Role::Hem)
        .flat_map(|s| s.edges.iter().copied())
        .collect();
    piece.kind == Kind::Skirt && beside.iter().all(|edge| hem.contains(edge))
}

fn name(pattern: &Pattern, piece: &Piece) -> String {
    let count = pattern.panels.len();
    let id = &pattern.panels[piece.panel % count].id;
    if piece.panel < count {
        id.clone()
    } else {
        format!("{id}~mirror")
    }
}
