//! Armholes: what front, side panels, back and yoke make of them together.

use super::side;
use crate::seam::suggest::edge_chain::{CORNER_TOLERANCE_M, EdgeChain, beginning_at, length};
use crate::seam::suggest::garment_model::{GarmentModel, SeamRationale};
use crate::seam::suggest::labels::{EdgeRole, FrontBack, Laterality, PanelKind};

/// An armhole from the shoulder down the front, then up the back to the shoulder.
pub(super) struct Armhole {
    pub(super) down: EdgeChain,
    pub(super) up: EdgeChain,
    /// Length of the end of the way down that side panels between front and back have \[m\].
    between: f64,
}

impl Armhole {
    /// Returns the armhole from the shoulder down the front and up the back.
    pub(super) fn around_from_shoulder(&self) -> EdgeChain {
        [self.down.clone(), self.up.clone()].concat()
    }

    /// Returns the armhole from the underarm up the back and down the front. Under the arm is the
    /// middle of what is between front and back.
    pub(super) fn around_from_underarm(&self) -> EdgeChain {
        let ring = [self.up.clone(), self.down.clone()].concat();
        beginning_at(
            &ring,
            length(&ring) - 0.5 * self.between,
            CORNER_TOLERANCE_M,
        )
    }
}

/// Returns the armhole of one side of the wearer.
pub(super) fn of(garment: &GarmentModel, laterality: Laterality) -> Option<Armhole> {
    let place = (EdgeRole::Armhole, laterality);
    let row = side::row(garment, laterality);
    let part = |front_back, from| garment.chain(PanelKind::Bodice, front_back, place, from);
    let front = part(FrontBack::Front, EdgeRole::Shoulder);
    let back = part(FrontBack::Back, EdgeRole::Side);
    if row.is_empty() && (front.is_none() || back.is_none()) {
        return None;
    }
    let mut down = front.unwrap_or_default();
    let mut up = EdgeChain::new();
    let mut between = 0.0;
    for laid in &row {
        let chain = laid.armhole().unwrap_or_default();
        if laid.panel.front_back.is_none() {
            between += length(&chain);
        }
        if laid.panel.front_back == Some(FrontBack::Back) {
            up.extend(chain);
        } else {
            down.extend(chain);
        }
    }
    up.extend(back.unwrap_or_default());
    if garment.has(PanelKind::Yoke) {
        let over = garment.chain(PanelKind::Yoke, FrontBack::Back, place, EdgeRole::Hem);
        up.extend(over.unwrap_or_default());
    }
    (!down.is_empty() && !up.is_empty()).then_some(Armhole { down, up, between })
}

/// Sets a sleeve's cap into the armhole of one side of the wearer.
pub(super) fn set_in(
    garment: &mut GarmentModel,
    laterality: Laterality,
    hole: Option<EdgeChain>,
    cap: Option<EdgeChain>,
) {
    let side = match laterality {
        Laterality::Left => "left",
        Laterality::Right => "right",
    };
    let id = format!("armhole-{side}");
    let because = "the sleeve is set into the armhole, front to front and underarm to underarm";
    // The order along the ring is that of the side panels in it.
    let row = side::row(garment, laterality);
    let is_guess = row.iter().any(|laid| laid.is_guess);
    let rationale = SeamRationale::new(&id, because).eased().guessed(is_guess);
    garment.sew_ring(rationale, hole, cap);
}
