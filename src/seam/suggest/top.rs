//! Tops: shoulders, sides and centres of a bodice, as every class of top has them.

use super::garment::{Garment, Saying};
use super::piece::{Kind, Lateral, Role, Which};

/// Sews the bodice.
pub(super) fn sew(garment: &mut Garment) {
    for (lateral, side) in [(Lateral::Left, "left"), (Lateral::Right, "right")] {
        let both = |garment: &Garment, role, from| {
            [Which::Front, Which::Back]
                .map(|which| garment.chain(Kind::Bodice, which, (role, lateral), from))
        };
        let [a, b] = both(garment, Role::Shoulder, Role::Neck);
        let id = format!("shoulder-{side}");
        let saying = Saying::new(&id, "front and back meet at the shoulder");
        garment.sew(saying, a, b);
        let [a, b] = both(garment, Role::Side, Role::Hem);
        let id = format!("side-{side}");
        let saying = Saying::new(
            &id,
            "front and back meet at the side, hem to hem and armhole to armhole",
        );
        garment.sew(saying, a, b);
    }
    centre(garment, Kind::Bodice, Which::Front);
    centre(garment, Kind::Bodice, Which::Back);
}

/// Sews the two halves of a front or back together. A front with a placket stays open.
pub(super) fn centre(garment: &mut Garment, kind: Kind, which: Which) {
    if which == Which::Front && garment.has(Kind::Placket) {
        return;
    }
    let halves = [Lateral::Left, Lateral::Right]
        .map(|lateral| garment.chain(kind, which, (Role::Centre, lateral), Role::Hem));
    let [a, b] = halves;
    let id = match (kind, which) {
        (Kind::Skirt, Which::Front) => "skirt-centre-front",
        (Kind::Skirt, Which::Back) => "skirt-centre-back",
        (_, Which::Front) => "centre-front",
        (_, Which::Back) => "centre-back",
    };
    let saying = Saying::new(id, "the left and the right half meet at the centre");
    garment.sew(saying, a, b);
}
