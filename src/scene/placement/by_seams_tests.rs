//! Bands, cuffs and collars start where their seams are short.

use super::test_body::body;
use super::{AnchoredPlacement, PanelPlacement, Placed, SeamPoint, place_panels};
use crate::pattern::{Panel, Placement, PlacementAnchor, Wrap};
use crate::scene::{Avatar, DressForm, Limb};
use crate::seam::Face;
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};

/// The starts of rectangles of these sizes \[m\] at these key points, so much higher than them.
fn starts(
    rectangles: &[([f64; 2], PlacementAnchor, f64)],
    stitches: impl Iterator<Item = [SeamPoint; 2]>,
    avatar: Option<&Avatar>,
) -> Vec<Placed> {
    let anchored = rectangles.iter().map(|(size, at, higher)| {
        let panel = Panel::rectangle("one", *size);
        let placement = Placement {
            at: Some(*at),
            offset_m: [0.0, *higher, 0.0],
            ..Placement::default()
        };
        let placement = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
        (panel, placement)
    });
    let anchored: Vec<_> = anchored.collect();
    let placed = anchored.iter().map(|(panel, placement)| PanelPlacement {
        panel,
        placement,
        face: Face::Up,
    });
    let stitches: Vec<_> = stitches.collect();
    place_panels(&placed.collect::<Vec<_>>(), &stitches, avatar)
}

fn point(panel: usize, uv: [f64; 2]) -> SeamPoint {
    SeamPoint { panel, uv }
}

/// Shares from 0 to 1.
fn shares() -> impl Iterator<Item = f64> {
    (0..=20).map(|k| f64::from(k) / 20.0)
}

/// A band drawn upright, 0.8 m long, is sewn with one long edge to the tops of two skirts.
#[test]
fn a_band_drawn_upright_is_laid_round_the_waist() {
    let panels = [
        ([0.4, 0.6], PlacementAnchor::SkirtFront, 0.0),
        ([0.4, 0.6], PlacementAnchor::SkirtBack, 0.0),
        ([0.05, 0.8], PlacementAnchor::Waist, 0.0),
    ];
    // Up the band is once round: the front from left to right, then the back.
    let stitches = shares().flat_map(|share| {
        [(0, 0.0), (1, 0.4)].map(|(skirt, from)| {
            let top = point(skirt, [0.4 * share, 0.6]);
            [top, point(2, [0.05, from + 0.4 * share])]
        })
    });
    let start = starts(&panels, stitches, None);
    let band = &start[2];
    assert_eq!(band.wrap, Wrap::Cylinder);
    // Level, with the sewn edge below the other one, and its ends where the back begins: at
    // the wearer's left, which is where the drawn front ends.
    let [low, high] = [[0.05, 0.3], [0.0, 0.3]].map(|uv| band.position(uv).y);
    assert!((high - low - 0.05).abs() < 1e-12, "{low} {high}");
    let middle_of_front = band.position([0.05, 0.2]);
    assert!(
        middle_of_front.z > 0.0 && middle_of_front.x.abs() < 1e-9,
        "{middle_of_front}"
    );
}

/// Front and back 65 cm long, with a band at their hems that is tighter than the hip, sewn by
/// the upper or the lower edge of its drawing: it hangs below them either way.
#[test]
fn a_band_at_the_hem_of_a_bodice_starts_there_and_clear_of_the_body() {
    let avatar = DressForm::default().build().expect("a body");
    let panels = [
        ([0.5, 0.65], PlacementAnchor::TorsoFront, 0.0),
        ([0.5, 0.65], PlacementAnchor::TorsoBack, 0.0),
        ([0.8, 0.06], PlacementAnchor::Waist, 0.0),
    ];
    for sewn in [0.06, 0.0] {
        let stitches = shares().flat_map(|share| {
            [(0, 0.0), (1, 0.4)].map(|(bodice, from)| {
                let hem = point(bodice, [0.5 * share, 0.0]);
                [hem, point(2, [from + 0.4 * share, sewn])]
            })
        });
        let start = starts(&panels, stitches, Some(&avatar));
        let hem = start[0].position([0.25, 0.0]).y;
        assert!(hem < avatar.landmarks["waist_front"].y - 0.1, "{hem}");
        for share in shares() {
            let at = |y| start[2].position([0.8 * share, y]);
            let [upper, lower] = [sewn, 0.06 - sewn].map(at);
            assert!((upper.y - hem).abs() < 1e-9, "{upper} beside {hem}");
            assert!(
                (upper.y - lower.y - 0.06).abs() < 1e-9,
                "{sewn}: {upper} {lower}"
            );
            assert!(avatar.exact_distance(&lower) > 0.01, "{lower}");
        }
    }
}

/// A band that is tighter than the body: closed on itself it starts with its ends together, but not
/// where it only has a dart.
#[test]
fn a_tight_band_starts_closed_if_its_ends_are_sewn() {
    let avatar = body();
    let panels = [
        ([0.4, 0.6], PlacementAnchor::SkirtFront, 0.0),
        ([0.7, 0.05], PlacementAnchor::Waist, 0.0),
    ];
    let gap = |own: [f64; 2]| {
        let stitches = shares().flat_map(|share| {
            let top = [
                point(0, [0.4 * share, 0.6]),
                point(1, [0.15 + 0.4 * share, 0.0]),
            ];
            [top, own.map(|x| point(1, [x, 0.05 * share]))]
        });
        let start = starts(&panels, stitches, Some(&avatar));
        let [a, b] = [0.0, 0.7].map(|x| start[1].position([x, 0.02]));
        assert!(avatar.exact_distance(&a) > 0.0, "{a}");
        ((a - b).norm(), start[1].radius)
    };
    let (closed, radius) = gap([0.0, 0.7]);
    assert!(
        0.7 < TAU * radius && closed < 0.03 * TAU * radius + 1e-9,
        "{closed} {radius}"
    );
    let (dart, radius) = gap([0.34, 0.36]);
    let chord = 2.0 * radius * (PI - 0.35 / radius).sin();
    assert!((dart - chord).abs() < 1e-9, "{dart} {chord}");
}

/// A sleeve that ends above the wrist, and a cuff that is tighter than the arm and a hand: it
/// starts nearly closed below the sleeve, clear of the arm that it is round.
#[test]
fn a_tight_cuff_starts_closed_round_the_end_of_a_sleeve() {
    let avatar = body();
    let panels = [
        ([0.3, 0.48], PlacementAnchor::ArmLeft, 0.0),
        ([0.2, 0.07], PlacementAnchor::ArmLeft, 0.0),
        ([0.4, 0.6], PlacementAnchor::TorsoFront, 0.0),
    ];
    let stitches = shares().flat_map(|share| {
        let hem = [point(0, [0.3 * share, 0.0]), point(1, [0.2 * share, 0.07])];
        let ends = [0.0, 0.2].map(|x| point(1, [x, 0.07 * share]));
        let inner = [0.0, 0.3].map(|x| point(0, [x, 0.48 * share]));
        [hem, ends, inner]
    });
    let cap = [point(0, [0.15, 0.48]), point(2, [0.4, 0.57])];
    let start = starts(&panels, stitches.chain([cap]), Some(&avatar));
    let [sleeve, cuff, _] = &start[..] else {
        panic!("three panels")
    };
    let arm = avatar.limb(Limb::ArmLeft).expect("an arm");
    let (_, forearm) = arm.at(arm.length());
    let mut off = Vector3::zeros();
    for share in shares() {
        for v in [0.0, 0.035, 0.07] {
            let p = cuff.position([0.2 * share, v]);
            assert!(avatar.exact_distance(&p) > 0.0, "{p}");
        }
        let hem = sleeve.position([0.3 * share, 0.0]);
        let upper = cuff.position([0.2 * share, 0.07]);
        // Nearer than to the other side of the hem.
        assert!((hem - upper).norm() < 0.3 / PI, "{share} {hem} {upper}");
        off += (upper - hem) / 21.0;
    }
    // Within a step along the arm.
    assert!(off.dot(&forearm).abs() < 0.02, "{off}");
    let ends = [0.0, 0.2].map(|x| cuff.position([x, 0.03]));
    assert!(
        (ends[0] - ends[1]).norm() < 0.03 * TAU * cuff.radius + 1e-9,
        "{ends:?}"
    );
}

/// A band of trousers that start lower than the waist stands on them.
#[test]
fn a_waistband_stands_on_what_starts_below_the_waist() {
    let avatar = body();
    let panels = [
        ([0.45, 0.6], PlacementAnchor::SkirtFront, -0.1),
        ([0.45, 0.6], PlacementAnchor::SkirtBack, -0.1),
        ([0.9, 0.05], PlacementAnchor::Waist, 0.0),
    ];
    let stitches = shares().flat_map(|share| {
        [(0, 0.0), (1, 0.45)].map(|(leg, from)| {
            let top = point(leg, [0.45 * share, 0.6]);
            [top, point(2, [from + 0.45 * share, 0.0])]
        })
    });
    let start = starts(&panels, stitches, Some(&avatar));
    let top = start[0].position([0.2, 0.6]).y;
    let [low, high] = [0.0, 0.05].map(|v| start[2].position([0.3, v]).y);
    assert!((low - top).abs() < 1e-9 && high > low, "{top} {low} {high}");
}

#[test]
fn a_panel_without_stitches_stays_as_it_was_placed() {
    let panel = Panel::rectangle("band", [0.8, 0.05]);
    let placement = Placement {
        at: Some(PlacementAnchor::Waist),
        ..Placement::default()
    };
    let placement = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
    let alone = PanelPlacement {
        panel: &panel,
        placement: &placement,
        face: Face::Up,
    };
    let uv = [0.1, 0.02];
    let before = placement.place(&panel, Face::Up, None).position(uv);
    assert_eq!(place_panels(&[alone], &[], None)[0].position(uv), before);
}
