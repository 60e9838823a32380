//! Trousers whose legs are a front and a back half each, rolled about the legs.
//!
//! Left flat, narrow ones close over a leg like two hands and are caught beside it. Rolled, the
//! halves meet at the outside of the leg, round it and that half of the hips, and only their inner
//! edges, below the crotch and before and behind the trunk, have a way to go.

use super::leg_cuffs::LegCuff;
use super::leg_line::{BESIDE_MIDDLE, LegLine, along, is_free, least_radius};
use super::panel_placement::{OwnStitch, PanelPlacement};
use super::placed::Placed;
use super::taper::{Lines, Taper, width};
use super::{anchored::outline, limb_pose::tilt};
use crate::pattern::{Panel, Wrap};
use crate::scene::{Avatar, Limb};
use nalgebra::{Rotation2, Rotation3, Vector2, Vector3};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Distance of the halves from each other at the outside of the leg, half of it \[m\].
const APART: f64 = 0.003;
/// Least sine of the angle between the plane of such a half and a level one.
const UPRIGHT: f64 = 0.9;
/// Least length of a leg below the crotch as it starts, over that on the drawing: one that would
/// start through a foot is sewn above it and let down onto it.
const LEAST_SHORTENED: f64 = 0.8;
/// Way that the upper end of a leg is moved out by at most \[m\].
const MOST_OUT: f64 = 0.1;
/// Furthest that such a half reaches beyond the body's middle as it starts \[m\]: to the crotch of
/// the other leg.
const BEYOND_MIDDLE: f64 = 0.15;

/// Rolls the legs among `panels`, which are sewn between the legs: those of which one is before and
/// one behind, and the cuffs at their ends.
pub(super) fn roll(
    placed: &mut [Placed],
    panels: &[PanelPlacement<'_>],
    of_panel: &[Vec<OwnStitch>],
    legs: &BTreeSet<usize>,
    avatar: &Avatar,
) {
    let cuffs = LegCuff::all(placed, panels, of_panel, legs);
    for limb in [Limb::LegLeft, Limb::LegRight] {
        let half = |&panel: &usize| {
            let PanelPlacement {
                panel: drawn,
                placement,
                ..
            } = panels[panel];
            let flat = placement.may_be_rolled().then_some(&placed[panel])?;
            Half::of(panel, drawn, flat, limb)
        };
        let (fronts, backs): (Vec<_>, Vec<_>) =
            legs.iter().filter_map(half).partition(|half| half.is_front);
        if let ([front], [back]) = (&fronts[..], &backs[..]) {
            let both = [front.panel, back.panel];
            let own = cuffs.iter().filter(|cuff| cuff.is_sewn_to(both));
            let cuff_m = own.clone().map(LegCuff::height).fold(0.0, f64::max);
            let starts = starts([front, back], placed, limb, (avatar, cuff_m));
            for (panel, start) in both.into_iter().zip(starts) {
                placed[panel] = start;
            }
            for cuff in own {
                cuff.roll(placed, limb, avatar);
            }
        }
    }
}

/// Half a leg as it stands flat before or behind one.
struct Half {
    panel: usize,
    is_front: bool,
    /// Turns the drawing so that up on the body is +y.
    up: Rotation2<f64>,
    /// The outline on the turned drawing \[m\].
    outline: Vec<Vector2<f64>>,
    /// +1 where the turned drawing's +x runs along increasing angle about the leg, else -1.
    sense: f64,
    /// +1 where the outside of the leg is at the drawing's +x, else -1.
    outside: f64,
    /// Height of its upper end \[m\].
    top: f64,
    lines: Lines,
}

impl Half {
    fn of(panel: usize, drawn: &Panel, flat: &Placed, limb: Limb) -> Option<Self> {
        let side = limb.side();
        let points: Vec<_> = outline(drawn).map(|uv| flat.position(uv)).collect();
        let middle = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
        let inmost = points
            .iter()
            .map(|p| side * p.x)
            .fold(f64::INFINITY, f64::min);
        if flat.wrap != Wrap::Flat || side * middle.x <= 0.0 || inmost < -BEYOND_MIDDLE {
            return None;
        }
        // Both are level on the drawing, where a flat panel is drawn to scale.
        let way = |to: Vector2<f64>| flat.position(to.into()) - flat.position([0.0; 2]);
        let upward = Vector2::new(way(Vector2::x()).y, way(Vector2::y()).y);
        if upward.norm() < UPRIGHT {
            return None;
        }
        let up = Rotation2::new(FRAC_PI_2 - upward.y.atan2(upward.x));
        let is_front = middle.z > flat.axis.z;
        // Along increasing angle from +z towards +x, before the axis and behind it.
        let ahead = if is_front { 1.0 } else { -1.0 };
        let sense = (ahead * way(up.inverse() * Vector2::x()).x).signum();
        let outline: Vec<_> = outline(drawn).map(|uv| up * Vector2::from(uv)).collect();
        Some(Self {
            panel,
            is_front,
            up,
            lines: Lines::of(&outline),
            outline,
            sense,
            outside: sense * ahead * side,
            top: points.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max),
        })
    }

    /// The edge at the outside of the leg of what reaches so far to its two sides.
    fn outer(&self, [left, right]: [f64; 2]) -> f64 {
        if self.outside > 0.0 { right } else { left }
    }

    fn height(&self) -> f64 {
        self.lines.ends[0] - self.lines.ends[1]
    }

    /// The half rolled about a leg with radii at its widest line and its hem, the upper end beside
    /// `axis`.
    fn rolled(&self, radii: [f64; 2], axis: Vector3<f64>, side: f64, line: &LegLine) -> Placed {
        let taper = Taper::between(&self.lines, radii, line.ends, |sides| self.outer(sides));
        // All of it is on its own side of the seam at the outside.
        let beyond =
            |p: &Vector2<f64>| self.outside * (p.x - taper.map_or(0.0, |taper| taper.aside(p.y)));
        let outmost = self
            .outline
            .iter()
            .map(beyond)
            .fold(f64::NEG_INFINITY, f64::max);
        let [top, bottom] = self.lines.ends;
        Placed {
            up: self.up,
            key: [self.outside * (outmost + APART), top],
            center_y: 0.5 * (bottom + top),
            sense: self.sense,
            outward: side * FRAC_PI_2,
            axis,
            radius: radii[0],
            wrap: Wrap::Cylinder,
            spread: 1.0,
            cone: None,
            taper,
            tilt: Some(tilt(&line.direction)),
            rotation: Rotation3::identity(),
            offset: Vector3::zeros(),
        }
    }
}

/// The two halves of a leg, and the leg.
struct Pair<'a> {
    halves: [&'a Half; 2],
    /// Points along their outlines, on the turned drawings.
    points: [Vec<Vector2<f64>>; 2],
    /// +1 for the left leg, else -1.
    side: f64,
    line: LegLine,
    /// Height of the upper end of the higher half \[m\], and its length.
    top: f64,
    length: f64,
    /// Height of the cuff below it \[m\].
    cuff: f64,
}

/// Returns the starts of the two halves about a leg, as high as they stand or so much lower that
/// the crotch has room.
fn starts(
    halves: [&Half; 2],
    placed: &[Placed],
    limb: Limb,
    (avatar, cuff): (&Avatar, f64),
) -> [Placed; 2] {
    let side = limb.side();
    let top = halves[0].top.max(halves[1].top);
    let bottom = halves.map(|half| half.top - half.height());
    let length = top - bottom[0].min(bottom[1]);
    let center = 0.5 * (placed[halves[0].panel].axis.z + placed[halves[1].panel].axis.z);
    let waist = Vector3::new(0.0, top, center);
    let pair = Pair {
        halves,
        points: halves.map(|half| along(&half.outline)),
        side,
        line: LegLine::of(limb, &waist, length, Some(avatar)),
        top,
        length,
        cuff,
    };
    let first = pair.line.hips.max(pair.around(|lines| lines.widest.1));
    let radius = least_radius(first, |radius, has_room| {
        pair.is_free(&pair.rolled(radius, avatar), has_room, avatar)
    });
    pair.rolled(radius, avatar)
}

impl Pair<'_> {
    /// Returns the radius of a tube as wide as a line across both halves \[m\].
    fn around(&self, line: fn(&Lines) -> [f64; 2]) -> f64 {
        let widths = self.halves.map(|half| width(line(&half.lines)) + APART);
        widths.iter().sum::<f64>() / TAU
    }

    /// The halves rolled to a tube of this radius \[m\] about a line that leads from the leg's
    /// ankle so far out that their inner edges are beside the body's middle.
    fn rolled(&self, radius: f64, avatar: &Avatar) -> [Placed; 2] {
        let starts = self.about(&self.line, radius, avatar);
        let places = (0..2).flat_map(|k| self.places(&starts, k));
        let inmost = places
            .map(|p| self.side * p.x)
            .fold(f64::INFINITY, f64::min);
        let out = (BESIDE_MIDDLE - inmost).clamp(0.0, MOST_OUT);
        if out == 0.0 {
            return starts;
        }
        let line = self.line.moved_out(self.side * out, self.length);
        self.about(&line, radius, avatar)
    }

    fn about(&self, line: &LegLine, radius: f64, avatar: &Avatar) -> [Placed; 2] {
        let at_hem = self.around(|lines| lines.hem.1).min(radius);
        let crotch = self
            .halves
            .map(|half| half.top - half.lines.ends[0] + half.lines.widest.0);
        let crotch = self.top - crotch[0].max(crotch[1]);
        let down = line.way_down([crotch, self.length + self.cuff], avatar);
        let room = line.lowest_hem(avatar) - self.cuff - down - crotch;
        let shortened = (room / (self.length - crotch)).clamp(LEAST_SHORTENED, 1.0);
        self.halves.map(|half| {
            let axis = line.at(down + self.top - half.top);
            let start = half.rolled([radius, at_hem], axis, self.side, line);
            Placed {
                taper: start.taper.map(|taper| taper.shortened(shortened)),
                ..start
            }
        })
    }

    /// Where the points along a half's outline start.
    fn places<'b>(
        &'b self,
        starts: &'b [Placed; 2],
        k: usize,
    ) -> impl Iterator<Item = Vector3<f64>> + 'b {
        let back = starts[k].up.inverse();
        self.points[k]
            .iter()
            .map(move |p| starts[k].position((back * p).into()))
    }

    fn is_free(&self, starts: &[Placed; 2], has_room: bool, avatar: &Avatar) -> bool {
        (0..2).all(|k| {
            let hips = has_room.then_some((self.halves[k].lines.widest.0, avatar));
            is_free(&starts[k], &self.points[k], self.side, hips)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Placement, PlacementAnchor};
    use crate::scene::placement::test_body::body;
    use crate::scene::placement::{AnchoredPlacement, SeamPoint, place_panels};
    use crate::seam::Face;

    /// Height of the waist above the crotch \[m\].
    const RISE: f64 = 0.28;
    const LENGTH: f64 = 0.95;

    /// Half a leg of these widths at the waist, the crotch and the hem \[m\], the outside of the
    /// leg at the left of the drawing: hem, outside, waist, crotch.
    fn half([waist, crotch, hem]: [f64; 3]) -> Panel {
        let corners = [
            [0.02, 0.0],
            [0.0, LENGTH - RISE],
            [0.01, LENGTH],
            [0.01 + waist, LENGTH],
            [crotch, LENGTH - RISE],
            [0.02 + hem, 0.0],
        ];
        Panel::polygon("half", &corners)
    }

    /// The starts of a front and a back of these widths for the left or the right leg, sewn between
    /// the legs.
    fn starts(widths: [[f64; 3]; 2], side: f64, avatar: &Avatar) -> [(Panel, Placed); 2] {
        let anchors = [PlacementAnchor::SkirtFront, PlacementAnchor::SkirtBack];
        let panels = widths.map(half);
        let anchored = anchors.map(|at| {
            let placement = Placement {
                at: Some(at),
                offset_m: [side * 0.15, 0.0, 0.0],
                ..Placement::default()
            };
            AnchoredPlacement::new(&panels[0], Some(&placement)).expect("a place")
        });
        // The front's outside is at the wearer's right as it is drawn, the back's at the left.
        let faces = if side < 0.0 {
            [Face::Up, Face::Down]
        } else {
            [Face::Down, Face::Up]
        };
        let placements = [0, 1].map(|k| PanelPlacement {
            panel: &panels[k],
            placement: &anchored[k],
            face: faces[k],
        });
        let stitches = [0.0, 0.5, 0.9].map(|share| {
            [0, 1].map(|panel| {
                let [_, crotch, hem] = widths[panel];
                let x = 0.02 + hem + share * (crotch - 0.02 - hem);
                let uv = [x, share * (LENGTH - RISE)];
                SeamPoint { panel, uv }
            })
        });
        let placed = place_panels(&placements, &stitches, Some(avatar));
        let [front, back] = [0, 1].map(|k| placed[k].clone());
        let [a, b] = panels;
        [(a, front), (b, back)]
    }

    fn points_of(panel: &Panel) -> impl Iterator<Item = Vector2<f64>> {
        let edges = panel.edges.iter().map(|edge| &edge.points);
        edges.flat_map(|points| {
            let [p, q] = [points[0], points[1]].map(Vector2::from);
            (0..20).map(move |k| p.lerp(&q, f64::from(k) / 20.0))
        })
    }

    /// Narrow, straight and wide legs, on both sides: each half is on its own side of the seam at
    /// the outside, which is nearly closed, and all of them beside the body's middle and off it.
    #[test]
    fn halves_of_a_leg_are_round_it() {
        let avatar = body();
        let ankle = avatar.landmarks["ankle_l"].y;
        let legs = [
            [[0.2, 0.27, 0.14], [0.22, 0.33, 0.17]],
            [[0.22, 0.31, 0.24], [0.24, 0.38, 0.26]],
            [[0.22, 0.31, 0.4], [0.24, 0.38, 0.42]],
        ];
        for widths in legs {
            for side in [1.0, -1.0] {
                let halves = starts(widths, side, &avatar);
                for ((panel, at), front) in halves.iter().zip([1.0, -1.0]) {
                    assert!(at.is_about_limb(), "{widths:?}");
                    for uv in points_of(panel) {
                        let p = at.position(uv.into());
                        let told = format!("{widths:?} {side} {front} {uv}: {p}");
                        assert!(side * p.x > 0.0, "{told}");
                        assert!(avatar.exact_distance(&p) > 0.0, "{told}");
                        assert!(p.y > ankle, "{told}");
                    }
                    let middle = at.position([0.5 * widths[0][2], LENGTH - RISE]);
                    assert!(front * (middle.z - at.axis.z) > 0.0, "{widths:?} {middle}");
                }
                for v in [0.1, 0.6, 0.9].map(|share| share * LENGTH) {
                    let [a, b] = halves.each_ref().map(|(_, at)| at.position([0.01, v]));
                    assert!((a - b).norm() < 0.05, "{widths:?} {a} {b}");
                }
            }
        }
    }
}
