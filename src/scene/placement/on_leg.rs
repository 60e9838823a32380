//! A leg of trousers in one piece, rolled about a leg and that half of the hips.
//!
//! The middle of the panel lies at the outside of the leg; its edges of the crotch end short of the
//! body's middle, below the crotch, so that both seams close beside the trunk and not through it.

use super::leg_line::{LegLine, along, is_free, least_radius};
use super::limb_pose::tilt;
use super::placed::Placed;
use super::taper::{Lines, Taper};
use crate::scene::{Avatar, Limb};
use nalgebra::{Vector2, Vector3};
use std::f64::consts::TAU;

/// Returns the start of `upright`, a panel at the waist with this outline on the turned drawing,
/// about a leg of a body.
pub(super) fn place(
    upright: Placed,
    outline: &[Vector2<f64>],
    limb: Limb,
    avatar: Option<&Avatar>,
) -> Placed {
    let side = limb.side();
    let lines = Lines::of(outline);
    let [top, bottom] = lines.ends;
    let (crotch, [left, right]) = lines.widest;
    let line = LegLine::of(limb, &upright.axis, top - bottom, avatar);
    let down = avatar.map_or(0.0, |avatar| {
        line.way_down([top - crotch, top - bottom], avatar)
    });
    let rolled = |radius: f64| Placed {
        axis: line.at(down),
        tilt: Some(tilt(&line.direction)),
        outward: side * 0.25 * TAU,
        key: [0.5 * (left + right), top],
        radius,
        taper: Taper::of(&lines, radius, line.ends),
        offset: Vector3::zeros(),
        ..upright.clone()
    };
    let points = along(outline);
    let first = line.hips.max((right - left) / TAU);
    let radius = least_radius(first, |radius, has_room| {
        let hips = avatar.filter(|_| has_room).map(|avatar| (crotch, avatar));
        is_free(&rolled(radius), &points, side, hips)
    });
    let placed = rolled(radius);
    Placed {
        offset: upright.offset,
        ..placed
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Panel, Placement, PlacementAnchor};
    use crate::scene::placement::AnchoredPlacement;
    use crate::scene::placement::leg_line::{BELOW_CROTCH, BESIDE_MIDDLE};
    use crate::scene::placement::test_body::body;
    use crate::seam::Face;

    /// The outline of a leg so wide at the crotch and so long \[m\], narrower at waist and hem: the
    /// front on the left.
    fn outline(width: f64, length: f64) -> Vec<Vector2<f64>> {
        let crotch = length - RISE;
        let points = [
            [0.25, 0.0],
            [0.0, crotch],
            [0.12, length - 0.03],
            [0.82, length],
            [1.0, crotch],
            [0.75, 0.0],
        ];
        points.map(|[x, y]| Vector2::new(width * x, y)).to_vec()
    }

    /// The start of such a leg.
    fn start(outline: &[Vector2<f64>], anchor: PlacementAnchor, avatar: &Avatar) -> Placed {
        let panel = Panel::rectangle("leg", [1.0, 1.0]);
        let placement = Placement {
            at: Some(anchor),
            ..Placement::default()
        };
        let anchored = AnchoredPlacement::new(&panel, Some(&placement)).expect("a place");
        let waist = Placed {
            axis: Vector3::new(0.0, avatar.landmarks["waist_front"].y, 0.0),
            ..anchored.place(&panel, Face::Up, None)
        };
        let limb = match anchor {
            PlacementAnchor::LegRight => Limb::LegRight,
            _ => Limb::LegLeft,
        };
        place(waist, outline, limb, Some(avatar))
    }

    /// Height of the waist above the crotch \[m\].
    const RISE: f64 = 0.28;

    /// Tight and wide, short and long legs, on both sides.
    #[test]
    fn a_leg_starts_on_its_side_clear_of_the_body_and_of_the_foot() {
        let avatar = body();
        let [crotch, ankle] = ["crotch", "ankle_l"].map(|name| avatar.landmarks[name].y);
        let sides = [
            (PlacementAnchor::LegLeft, 1.0),
            (PlacementAnchor::LegRight, -1.0),
        ];
        for (anchor, side) in sides {
            for width in [0.48, 0.6, 0.9] {
                for length in [0.5, 0.9] {
                    let outline = outline(width, length);
                    let placed = start(&outline, anchor, &avatar);
                    let next = outline.iter().cycle().skip(1);
                    let edges = outline.iter().zip(next);
                    let along = edges
                        .flat_map(|(p, q)| (0..20).map(move |k| p.lerp(q, f64::from(k) / 20.0)));
                    for uv in along {
                        let p = placed.position(uv.into());
                        let told = format!("{anchor:?} {width} {length} {uv}: {p}");
                        assert!(side * p.x >= BESIDE_MIDDLE, "{told}");
                        assert!(avatar.exact_distance(&p) > 0.0, "{told}");
                        assert!(p.y > ankle, "{told}");
                    }
                    // Of the widest line that is looked at, within a step of a fortieth.
                    for x in [0.0, width] {
                        let end = placed.position([x, length - RISE]);
                        assert!(end.y < crotch - BELOW_CROTCH + 0.025 * length, "{end}");
                    }
                }
            }
        }
    }
}
