//! The limbs of a dress form where the garment leaves them to the service: those that its cloth is
//! near.

use super::sides::arm_side;
use crate::pattern::Panel;
use crate::scene::{AnchoredPlacement, DressForm, Limbs};
use crate::seam::Face;
use nalgebra::Vector3;

/// Heights on a body of 1.68 m above which cloth is near the arms, and below which it is near the
/// legs: armpit and hip \[m\].
const ARMS_ABOVE: f64 = 1.25;
const LEGS_BELOW: f64 = 0.85;
/// Height below which the hands are, and their distance from the middle \[m\]: a panel of the trunk
/// that starts further out would be sewn round them.
const HANDS_BELOW: f64 = 0.95;
const HANDS_AT: f64 = 0.45;

/// Returns the form with the limbs that it states, or else with those that it has measures of and
/// those near `panels`, as they start about a body of middle size.
pub(super) fn with_limbs<'a>(
    form: DressForm,
    panels: impl Iterator<Item = (&'a Panel, &'a AnchoredPlacement)>,
) -> DressForm {
    let arms = [
        form.arm_length_m,
        form.upper_arm_m,
        form.elbow_m,
        form.wrist_m,
    ];
    let legs = [
        form.inside_leg_m,
        form.thigh_m,
        form.knee_m,
        form.calf_m,
        form.ankle_m,
    ];
    let near = near(panels);
    let limbs = form.limbs.unwrap_or(Limbs {
        arms: near.arms || arms.iter().any(Option::is_some),
        legs: near.legs || legs.iter().any(Option::is_some),
    });
    DressForm {
        limbs: Some(limbs),
        ..form
    }
}

fn near<'a>(panels: impl Iterator<Item = (&'a Panel, &'a AnchoredPlacement)>) -> Limbs {
    let (mut highest, mut lowest) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut is_round_hands = false;
    for (panel, placement) in panels {
        let placed = placement.place(panel, Face::Up, None);
        let points = panel.edges.iter().flat_map(|edge| &edge.points);
        let points: Vec<_> = points.map(|point| placed.position(*point)).collect();
        let heights = points.iter().map(|p| p.y);
        (lowest, highest) = heights.fold((lowest, highest), |(lowest, highest), y| {
            (y.min(lowest), y.max(highest))
        });
        let is_beside_hands = |p: &Vector3<f64>| p.y < HANDS_BELOW && p.x.abs() > HANDS_AT;
        is_round_hands |= arm_side(&points).is_none() && points.iter().any(is_beside_hands);
    }
    Limbs {
        arms: highest > ARMS_ABOVE && !is_round_hands,
        legs: lowest < LEGS_BELOW,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Placement, PlacementAnchor};

    /// The limbs for one panel of this width and height \[m\].
    fn limbs(at: PlacementAnchor, size: [f64; 2], form: DressForm) -> Limbs {
        let panel = Panel::rectangle("one", size);
        let placement = Placement {
            at: Some(at),
            ..Placement::default()
        };
        let placement = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
        let with = with_limbs(form, [(&panel, &placement)].into_iter());
        with.limbs.expect("they are known now")
    }

    #[test]
    fn a_body_has_the_limbs_that_cloth_starts_near() {
        let near = |at, size| {
            let Limbs { arms, legs } = limbs(at, size, DressForm::default());
            (arms, legs)
        };
        assert_eq!(near(PlacementAnchor::TorsoFront, [0.5, 0.5]), (true, false));
        assert_eq!(near(PlacementAnchor::SkirtFront, [0.5, 0.6]), (false, true));
        assert_eq!(near(PlacementAnchor::TorsoFront, [0.5, 1.0]), (true, true));
        assert_eq!(near(PlacementAnchor::TorsoFront, [1.2, 1.0]), (false, true));
        assert_eq!(near(PlacementAnchor::ArmLeft, [0.4, 0.55]), (true, false));
    }

    #[test]
    fn limbs_that_are_stated_or_measured_stay() {
        let stated = DressForm {
            limbs: Some(Limbs::default()),
            ..DressForm::default()
        };
        let top = (PlacementAnchor::TorsoFront, [0.5, 0.5]);
        assert_eq!(limbs(top.0, top.1, stated), Limbs::default());
        let measured = DressForm {
            thigh_m: Some(0.55),
            ..DressForm::default()
        };
        assert!(limbs(top.0, top.1, measured).legs);
    }
}
