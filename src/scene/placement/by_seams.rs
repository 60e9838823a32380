//! Panels rolled about the body are turned so that their stitches are short: a band that is drawn
//! upright is laid round, a sleeve has its cap at the shoulder, or further down the arm where the
//! shoulder is dropped, a collar its ends where the neck opens.

use super::Placed;
use super::lifted;
use super::on_limb;
use super::panel_placement::{OwnStitch, PanelPlacement, SeamPoint, own_stitches, thinned};
use crate::scene::Avatar;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI};

/// Share of the sum of squares that another pose must save to be taken: where a panel fits alike
/// in several, it stays as it was placed.
const SAVED: f64 = 0.1;

/// Places `panels` on `avatar`, or in free space without one.
///
/// Flat panels are put where they are anchored, those that a file puts about a limb are rolled
/// about it, and those of the trunk are lifted above what their seams would close through. Those
/// that are rolled all round follow, each turned about its axis, and by quarters on the drawing
/// where the placement does not say which way is up, so that its `stitches` to the panels before it
/// and to itself are short.
pub fn place_panels(
    panels: &[PanelPlacement<'_>],
    stitches: &[[SeamPoint; 2]],
    avatar: Option<&Avatar>,
) -> Vec<Placed> {
    let of_panel = own_stitches(panels.len(), stitches);
    let place = |(panel, stitches): (&PanelPlacement<'_>, &Vec<OwnStitch>)| {
        let placed = panel.placement.place(panel.panel, panel.face, avatar);
        let to_itself = stitches.iter().filter(|[a, b]| a.panel == b.panel);
        let to_itself: Vec<_> = to_itself.map(|pair| pair.map(|p| p.uv)).collect();
        panel
            .placement
            .coned(placed, panel.panel, &to_itself, avatar)
    };
    let mut placed: Vec<Placed> = panels.iter().zip(&of_panel).map(place).collect();
    if let Some(avatar) = avatar {
        on_limb::roll(&mut placed, panels, &of_panel, avatar);
        lifted::lift(&mut placed, panels, &of_panel, avatar);
    }
    let mut is_settled: Vec<bool> = panels
        .iter()
        .map(|panel| !panel.placement.turns())
        .collect();
    let joins_settled = |is_settled: &[bool], panel: usize| {
        let mut own = of_panel[panel].iter();
        !is_settled[panel] && own.any(|[_, other]| is_settled[other.panel])
    };
    while let Some(panel) = (0..panels.len()).find(|&panel| joins_settled(&is_settled, panel)) {
        let is_known = |[_, other]: &&OwnStitch| other.panel == panel || is_settled[other.panel];
        let known = of_panel[panel].iter().filter(is_known).copied().collect();
        let known: Vec<_> = thinned(known).collect();
        placed[panel] = turned(&panels[panel], &known, (&placed, panel), avatar);
        is_settled[panel] = true;
    }
    placed
}

/// Returns the pose of `panel` in which its stitches are shortest, moved to what it is sewn to.
fn turned(
    panel: &PanelPlacement<'_>,
    stitches: &[OwnStitch],
    (placed, index): (&[Placed], usize),
    avatar: Option<&Avatar>,
) -> Placed {
    let seams = Seams {
        stitches,
        placed,
        index,
    };
    let moved = |pose: Placed| {
        let ways = seams.ways(&pose);
        if pose.is_about_limb() {
            pose.moved_down_the_limb(&ways)
        } else {
            panel
                .placement
                .moved_down_the_trunk(pose, panel.panel, &ways, avatar)
        }
    };
    let cost = |pose: &Placed, from: &Placed| {
        if pose.is_below(from) && seams.lie_below_the_middle(pose) {
            f64::INFINITY
        } else {
            seams.cost(pose)
        }
    };
    let drawn = &placed[index];
    let mut best = moved(drawn.clone());
    let mut least = (1.0 - SAVED) * cost(&best, drawn);
    for placement in panel.placement.quarter_turns() {
        let upright = placement.place(panel.panel, panel.face, avatar);
        let turned = |angle: f64| Placed {
            outward: upright.outward + angle,
            ..upright.clone()
        };
        // Points run on circles: the sum of squares is a constant and one wave of the angle.
        let [ahead, aside, behind] = [0.0, FRAC_PI_2, PI].map(|angle| seams.cost(&turned(angle)));
        let mean = 0.5 * (ahead + behind);
        let pose = moved(turned((mean - aside).atan2(mean - ahead)));
        let cost = cost(&pose, &upright);
        if cost < least {
            (best, least) = (pose, cost);
        }
    }
    best
}

/// The stitches of a panel to others that are placed, and to itself.
struct Seams<'a> {
    stitches: &'a [OwnStitch],
    placed: &'a [Placed],
    index: usize,
}

impl Seams<'_> {
    /// Returns the sum of the squares of the stitches' lengths in a pose of the panel \[m²\].
    fn cost(&self, pose: &Placed) -> f64 {
        let length = |[own, other]: &OwnStitch| {
            let at = if other.panel == self.index {
                pose
            } else {
                &self.placed[other.panel]
            };
            (pose.position(own.uv) - at.position(other.uv)).norm_squared()
        };
        self.stitches.iter().map(length).sum()
    }

    fn to_others(&self) -> impl Iterator<Item = &OwnStitch> {
        let stitches = self.stitches.iter();
        stitches.filter(|[_, other]| other.panel != self.index)
    }

    /// Returns the ways from the panel to the others that it is sewn to \[m\].
    fn ways(&self, pose: &Placed) -> Vec<Vector3<f64>> {
        let way = |[own, other]: &OwnStitch| {
            self.placed[other.panel].position(other.uv) - pose.position(own.uv)
        };
        self.to_others().map(way).collect()
    }

    /// Returns true if what the panel is sewn by is below its middle: at a hem, it would lie over
    /// what it hangs from.
    fn lie_below_the_middle(&self, pose: &Placed) -> bool {
        let middle = pose.middle().y;
        let above = |[own, _]: &OwnStitch| pose.position(own.uv).y - middle;
        self.to_others().map(above).sum::<f64>() < 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Panel, Placement, PlacementAnchor, Wrap};
    use crate::scene::DressForm;
    use crate::scene::placement::AnchoredPlacement;
    use crate::seam::Face;

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
}
