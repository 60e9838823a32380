//! Trousers: outer and inner leg seams, then the crotch.

use super::garment::{Garment, Saying};
use super::piece::{Kind, Lateral, Role, Which};

/// Sews the trousers.
pub(super) fn sew(garment: &mut Garment) {
    for (lateral, side) in [(Lateral::Left, "left"), (Lateral::Right, "right")] {
        for (role, name, because) in [
            (
                Role::Side,
                "outseam",
                "front and back leg meet at the outside",
            ),
            (
                Role::Inseam,
                "inseam",
                "front and back leg meet at the inside",
            ),
        ] {
            let [a, b] = [Which::Front, Which::Back]
                .map(|which| garment.chain(Kind::Trouser, which, (role, lateral), Role::Hem));
            garment.sew(Saying::new(&format!("{name}-{side}"), because), a, b);
        }
    }
    for (which, name) in [(Which::Front, "crotch-front"), (Which::Back, "crotch-back")] {
        let [a, b] = [Lateral::Left, Lateral::Right].map(|lateral| {
            garment.chain(Kind::Trouser, which, (Role::Crotch, lateral), Role::Waist)
        });
        garment.sew(
            Saying::new(name, "the left and the right leg meet at the crotch"),
            a,
            b,
        );
    }
}
