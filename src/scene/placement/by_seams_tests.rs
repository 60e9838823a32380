//! Bands, cuffs and collars start where their seams are short.

use super::test_body::body;
use super::{AnchoredPlacement, PanelPlacement, SeamPoint, place_panels};
use crate::pattern::{Panel, Placement, PlacementAnchor, Wrap};
use crate::scene::{DressForm, Limb};
use crate::seam::Face;
use nalgebra::Vector3;
use std::f64::consts::PI;

fn anchored(panel: &Panel, at: PlacementAnchor) -> AnchoredPlacement {
    let placement = Placement {
        at: Some(at),
        ..Placement::default()
    };
    AnchoredPlacement::new(panel, Some(&placement)).expect("a place")
}

/// A band drawn upright, 0.8 m long, is sewn with one long edge to the tops of two skirts.
#[test]
fn a_band_drawn_upright_is_laid_round_the_waist() {
    let skirts = [
        ("front", PlacementAnchor::SkirtFront),
        ("back", PlacementAnchor::SkirtBack),
    ];
    let mut panels = skirts
        .map(|(id, _)| Panel::rectangle(id, [0.4, 0.6]))
        .to_vec();
    panels.push(Panel::rectangle("band", [0.05, 0.8]));
    let mut placements: Vec<_> = skirts.map(|(_, at)| at).to_vec();
    placements.push(PlacementAnchor::Waist);
    let placements: Vec<_> = panels
        .iter()
        .zip(placements)
        .map(|(p, at)| anchored(p, at))
        .collect();
    let placed: Vec<_> = panels
        .iter()
        .zip(&placements)
        .map(|(panel, placement)| PanelPlacement {
            panel,
            placement,
            face: Face::Up,
        })
        .collect();
    // Up the band is once round: the front from left to right, then the back.
    let mut stitches = vec![];
    for k in 0..=20 {
        let along = 0.02 * f64::from(k);
        for (panel, start) in [(0, 0.0), (1, 0.4)] {
            let skirt = SeamPoint {
                panel,
                uv: [along, 0.6],
            };
            let band = SeamPoint {
                panel: 2,
                uv: [0.05, start + along],
            };
            stitches.push([skirt, band]);
        }
    }
    let start = place_panels(&placed, &stitches, None);
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
        Panel::rectangle("front", [0.5, 0.65]),
        Panel::rectangle("back", [0.5, 0.65]),
        Panel::rectangle("band", [0.8, 0.06]),
    ];
    let at = [
        PlacementAnchor::TorsoFront,
        PlacementAnchor::TorsoBack,
        PlacementAnchor::Waist,
    ];
    let placements: Vec<_> = panels
        .iter()
        .zip(at)
        .map(|(p, at)| anchored(p, at))
        .collect();
    let placed = panels.iter().zip(&placements);
    let placed = placed.map(|(panel, placement)| PanelPlacement {
        panel,
        placement,
        face: Face::Up,
    });
    let placed: Vec<_> = placed.collect();
    let point = |panel, uv| SeamPoint { panel, uv };
    for sewn in [0.06, 0.0] {
        let along = (0..=20).map(|k| f64::from(k) / 20.0);
        let stitches: Vec<_> = along
            .flat_map(|along| {
                [(0, 0.0), (1, 0.4)].map(|(panel, start)| {
                    let hem = point(panel, [0.5 * along, 0.0]);
                    [hem, point(2, [start + 0.4 * along, sewn])]
                })
            })
            .collect();
        let start = place_panels(&placed, &stitches, Some(&avatar));
        let hem = start[0].position([0.25, 0.0]).y;
        assert!(hem < avatar.landmarks["waist_front"].y - 0.1, "{hem}");
        for k in 0..=40 {
            let at = |y| start[2].position([0.02 * f64::from(k), y]);
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

/// A sleeve that ends above the wrist, and a cuff that is tighter than the arm and a hand: it
/// starts nearly closed below the sleeve, clear of the arm that it is round.
#[test]
fn a_tight_cuff_starts_closed_round_the_end_of_a_sleeve() {
    let avatar = body();
    let panels = [
        Panel::rectangle("sleeve", [0.3, 0.48]),
        Panel::rectangle("cuff", [0.2, 0.07]),
        Panel::rectangle("front", [0.4, 0.6]),
    ];
    let at = [
        PlacementAnchor::ArmLeft,
        PlacementAnchor::ArmLeft,
        PlacementAnchor::TorsoFront,
    ];
    let placements: Vec<_> = panels
        .iter()
        .zip(at)
        .map(|(panel, at)| anchored(panel, at))
        .collect();
    let placed = panels.iter().zip(&placements);
    let placed = placed.map(|(panel, placement)| PanelPlacement {
        panel,
        placement,
        face: Face::Up,
    });
    let placed: Vec<_> = placed.collect();
    let point = |panel, uv| SeamPoint { panel, uv };
    let shares = (0..=20).map(|k| f64::from(k) / 20.0);
    let stitches = shares.flat_map(|share| {
        let hem = [point(0, [0.3 * share, 0.0]), point(1, [0.2 * share, 0.07])];
        let ends = [0.0, 0.2].map(|x| point(1, [x, 0.07 * share]));
        let inner = [0.0, 0.3].map(|x| point(0, [x, 0.48 * share]));
        [hem, ends, inner]
    });
    let cap = [point(0, [0.15, 0.48]), point(2, [0.4, 0.57])];
    let stitches: Vec<_> = stitches.chain([cap]).collect();
    let start = place_panels(&placed, &stitches, Some(&avatar));
    let [sleeve, cuff, _] = &start[..] else {
        panic!("three panels")
    };
    let arm = avatar.limb(Limb::ArmLeft).expect("an arm");
    let (_, forearm) = arm.at(arm.length());
    let mut off = Vector3::zeros();
    for k in 0..=20 {
        let share = f64::from(k) / 20.0;
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
    assert!(off.dot(&forearm).abs() < 0.02, "{off}");
    let ends = [0.0, 0.2].map(|x| cuff.position([x, 0.03]));
    assert!((ends[0] - ends[1]).norm() < 0.02, "{ends:?}");
}

/// A band of trousers that start lower than the waist stands on them.
#[test]
fn a_waistband_stands_on_what_starts_below_the_waist() {
    let avatar = body();
    let panels = [
        Panel::rectangle("front", [0.45, 0.6]),
        Panel::rectangle("back", [0.45, 0.6]),
        Panel::rectangle("band", [0.9, 0.05]),
    ];
    let low = |at| Placement {
        at: Some(at),
        offset_m: [0.0, -0.1, 0.0],
        ..Placement::default()
    };
    let placements = [
        low(PlacementAnchor::SkirtFront),
        low(PlacementAnchor::SkirtBack),
        Placement {
            at: Some(PlacementAnchor::Waist),
            ..Placement::default()
        },
    ];
    let placements: Vec<_> = panels
        .iter()
        .zip(&placements)
        .map(|(panel, at)| AnchoredPlacement::new(panel, Some(at)).expect("a place"))
        .collect();
    let placed = panels.iter().zip(&placements);
    let placed = placed.map(|(panel, placement)| PanelPlacement {
        panel,
        placement,
        face: Face::Up,
    });
    let point = |panel, uv| SeamPoint { panel, uv };
    let placed: Vec<_> = placed.collect();
    let shares = (0..=20).map(|k| f64::from(k) / 20.0);
    let stitches = shares.flat_map(|share| {
        [(0, 0.0), (1, 0.45)].map(|(panel, from)| {
            let top = point(panel, [0.45 * share, 0.6]);
            [top, point(2, [from + 0.45 * share, 0.0])]
        })
    });
    let start = place_panels(&placed, &stitches.collect::<Vec<_>>(), Some(&avatar));
    let top = start[0].position([0.2, 0.6]).y;
    let [low, high] = [0.0, 0.05].map(|v| start[2].position([0.3, v]).y);
    assert!((low - top).abs() < 1e-9 && high > low, "{top} {low} {high}");
}

#[test]
fn a_panel_without_stitches_stays_as_it_was_placed() {
    let panel = Panel::rectangle("band", [0.8, 0.05]);
    let placement = anchored(&panel, PlacementAnchor::Waist);
    let alone = PanelPlacement {
        panel: &panel,
        placement: &placement,
        face: Face::Up,
    };
    let uv = [0.1, 0.02];
    let before = placement.place(&panel, Face::Up, None).position(uv);
    assert_eq!(place_panels(&[alone], &[], None)[0].position(uv), before);
}
