//! Verdict on how a body carries a garment: what each opening goes round, where the garment hangs,
//! and the reasons, in words.
//!
//! An opening is meant to go round what it goes round at the start, where the panels stand about
//! the body as they were placed. A garment is worn if each of its openings goes round that at the
//! end, once, if it has not turned about the body, and if the opening that carries it is where the
//! body can.

mod body_ends;
mod carried;
mod linking;
mod loose;
mod openings;
mod turn;

use self::body_ends::{BodyEnds, Encircled};
use self::carried::mean_height;
pub(super) use self::loose::too_large;
use self::openings::{Opening, openings};
use super::girths;
use crate::mesh::PanelRange;
use crate::scene::{Avatar, Body, Scene};
use crate::solver::{Support, SupportOpening};
use nalgebra::Vector3;

/// Furthest that a garment may turn about the body \[degrees\].
const TURNED_DEG: f64 = 20.0;
/// Cosine of the angle up to which triangles of a flat panel lie in one plane.
const FLAT: f64 = 0.999_999;
/// Openings shorter than this are holes for a button or a drawstring \[m\].
const SHORT: f64 = 0.12;

/// An opening with its places, and what it goes round, at the start and at the end.
struct WornOpening {
    opening: Opening,
    start: Vec<Vector3<f64>>,
    end: Vec<Vector3<f64>>,
    before: Encircled,
    after: Encircled,
    /// True if some of it starts where the body lacks a head: the edge of a hood.
    is_of_hood: bool,
}

impl WornOpening {
    /// Returns true if it is the edge of a hood that has fallen off a neck without a head.
    fn is_fallen_hood(&self) -> bool {
        self.is_of_hood && self.before == Encircled::Neck && self.after == Encircled::Nothing
    }
}

/// Returns how the body of `scene` carries the garment of panels `panels` at `positions` \[m\],
/// where the solver found that it came to rest as `found` says.
pub(super) fn support(
    scene: &Scene,
    panels: &[&str],
    positions: &[Vector3<f64>],
    found: &Support,
) -> Support {
    let Some(avatar) = scene.body.as_ref().and_then(Body::avatar) else {
        return found.clone();
    };
    if !scene.pins.is_empty() {
        return not_judged("corners are pinned, which carry it");
    }
    let Some(ends) = BodyEnds::new(avatar) else {
        return not_judged("the body has no landmarks");
    };
    let openings = worn_openings(scene, positions, &ends);
    let mut faults: Vec<String> = openings
        .iter()
        .filter_map(|opening| misplaced(opening, panels, &ends))
        .collect();
    let hanging = hanging(avatar, &openings, positions);
    // Cloth that was laid flat hangs far below where it began, by edges that are where they belong.
    let carried_m = found.sank_m.filter(|_| {
        let is_told = |o: &WornOpening| matches!(o.after, Encircled::Neck | Encircled::Trunk);
        hanging.is_none() && openings.iter().any(is_told)
    });
    faults.extend(hanging);
    faults.extend(turned(scene, positions));
    let seam = crotch_seam(scene, &openings).map(|v| positions[v]);
    faults.extend(carried::low_crotch(avatar, seam));
    faults.extend(girths::overstretched(scene, positions));
    if found.ok != Some(true) && carried_m.is_none() {
        faults.insert(0, found.because.clone());
    }
    let because = match (faults.is_empty(), carried_m) {
        (false, _) => faults.join("; "),
        (true, Some(sank_m)) => format!(
            "it came to rest on the body, which carries it by its openings, {:.0} mm lower than it was laid",
            sank_m * 1e3
        ),
        (true, None) => found.because.clone(),
    };
    let hood = if openings.iter().any(WornOpening::is_fallen_hood) {
        "; how its hood lies is not judged: the body has no head"
    } else {
        ""
    };
    Support {
        ok: Some(faults.is_empty()),
        because: because + hood,
        openings: openings
            .iter()
            .map(|opening| told(opening, panels))
            .collect(),
        sank_m: None,
    }
}

/// Returns the openings of a garment that are more than holes.
fn worn_openings(scene: &Scene, positions: &[Vector3<f64>], ends: &BodyEnds) -> Vec<WornOpening> {
    let is_face_down: Vec<bool> = scene.cut.iter().map(|cut| cut.face_down).collect();
    let worn = |opening: Opening| {
        let at = |x: &[Vector3<f64>]| opening.vertices.iter().map(|&v| x[v]).collect::<Vec<_>>();
        let (start, end) = (at(&scene.start), at(positions));
        WornOpening {
            before: ends.encircled(&start),
            after: ends.encircled(&end),
            is_of_hood: ends.reaches_a_missing_head(&start),
            opening,
            start,
            end,
        }
    };
    let openings = openings(&scene.mesh, &is_face_down).into_iter().map(worn);
    let is_wide = |opening: &WornOpening| carried::length(&opening.end) >= SHORT;
    openings.filter(is_wide).collect()
}

fn not_judged(because: &str) -> Support {
    Support {
        ok: None,
        because: format!("not judged: {because}"),
        openings: vec![],
        sank_m: None,
    }
}

/// Returns the vertices at which panels along the opening of the left leg are sewn to panels along
/// that of the right one.
fn crotch_seam<'a>(
    scene: &'a Scene,
    openings: &'a [WornOpening],
) -> impl Iterator<Item = usize> + 'a {
    let along = |leg: Encircled, vertex: usize| {
        let panel = scene.mesh.panel_of_vertex(vertex);
        let of_leg = openings.iter().filter(move |opening| opening.before == leg);
        of_leg
            .into_iter()
            .any(|opening| opening.opening.panels.contains(&panel))
    };
    let is_between =
        move |a: usize, b: usize| along(Encircled::LeftLeg, a) && along(Encircled::RightLeg, b);
    let stitches = scene.mesh.stitches.iter();
    let between = stitches.filter(move |s| is_between(s.a, s.b) || is_between(s.b, s.a));
    between.map(|s| s.a)
}

/// Returns the fault of a garment that has turned about the body, in words.
fn turned(scene: &Scene, positions: &[Vector3<f64>]) -> Option<String> {
    let flat = flat_panels(scene);
    let of = |x: &[Vector3<f64>]| flat.iter().map(|&v| x[v]).collect::<Vec<_>>();
    let turned = turn::turn_deg(&of(&scene.start), &of(positions));
    (turned.abs() > TURNED_DEG)
        .then(|| format!("it has turned by {turned:.0} degrees about the body since it was placed"))
}

/// Returns the vertices of the panels that start flat: those that are rolled may start turned.
fn flat_panels(scene: &Scene) -> Vec<usize> {
    let normal = |t: &[usize; 3]| {
        let [a, b, c] = t.map(|v| scene.start[v]);
        (b - a).cross(&(c - a)).normalize()
    };
    let is_flat = |range: &&PanelRange| {
        let mut normals = scene.mesh.triangles[range.triangles.clone()]
            .iter()
            .map(normal);
        let first = normals.next().unwrap_or_default();
        normals.all(|n| n.dot(&first) > FLAT)
    };
    let flat = scene.mesh.panels.iter().filter(is_flat);
    flat.flat_map(|range| range.vertices.clone()).collect()
}

/// Returns the fault of an opening that is not round what it was placed round, in words. An opening
/// that was placed round nothing, or round a limb or a head that the body lacks, may go round
/// nothing.
fn misplaced(opening: &WornOpening, panels: &[&str], ends: &BodyEnds) -> Option<String> {
    let (before, after) = (opening.before, opening.after);
    let names = names(opening, panels).join(", ");
    if after == Encircled::Other {
        return Some(format!("the opening along {names} goes round {after}"));
    }
    let is_lost = after == Encircled::Nothing && !ends.has(before) || opening.is_fallen_hood();
    let is_known = !matches!(before, Encircled::Nothing | Encircled::Other);
    (before != after && is_known && !is_lost).then(|| {
        format!("the opening along {names} was placed round {before} and goes round {after}")
    })
}

/// Returns the names of the panels along an opening.
fn names(opening: &WornOpening, panels: &[&str]) -> Vec<String> {
    let along = opening.opening.panels.iter();
    along.map(|&panel| panels[panel].to_owned()).collect()
}

/// Returns the fault of the opening that is to carry the garment, in words: the neck, which a hood
/// may hang from, or else the highest one round the trunk.
fn hanging(avatar: &Avatar, openings: &[WornOpening], cloth: &[Vector3<f64>]) -> Option<String> {
    let highest = |around: &[Encircled]| {
        let of_kind = openings
            .iter()
            .filter(|opening| around.contains(&opening.after));
        of_kind.max_by(|a, b| mean_height(&a.end).total_cmp(&mean_height(&b.end)))
    };
    if highest(&[Encircled::Neck]).is_some() || openings.iter().any(WornOpening::is_fallen_hood) {
        return carried::off_the_shoulders(avatar, cloth);
    }
    if highest(&[
        Encircled::BothArms,
        Encircled::NeckAndLeftArm,
        Encircled::NeckAndRightArm,
    ])
    .is_some()
    {
        return None;
    }
    let Some(top) = highest(&[Encircled::Trunk]) else {
        return Some("no opening goes round the neck or the trunk: nothing carries it".to_owned());
    };
    if carried::begins_at_the_bust(avatar, &top.start) {
        carried::off_the_bust(avatar, &top.end)
    } else {
        carried::off_the_waist(avatar, &top.end)
    }
}

fn told(opening: &WornOpening, panels: &[&str]) -> SupportOpening {
    SupportOpening {
        panels: names(opening, panels),
        placed_round: opening.before.to_string(),
        goes_round: opening.after.to_string(),
        length_m: carried::length(&opening.end),
        height_m: mean_height(&opening.end),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Limits;
    use crate::fit::{Garment, PatternRef, ShippedAssets, resolve, scene};
    use crate::pattern::{self, ImportOptions};
    use crate::progress::CancelToken;
    use crate::solver::Context;
    use nalgebra::Rotation3;

    /// The top that comes with the service, before it is sewn.
    fn top() -> Scene {
        let limits = Limits::default();
        let bytes = include_bytes!("../../../static/samples/top.dxf");
        let pattern =
            pattern::import(bytes, &ImportOptions::default(), &limits).expect("a pattern");
        let stated = include_str!("../../../static/samples/top.garment.json");
        let garment = Garment {
            pattern: Some(PatternRef::Whole(Box::new(pattern))),
            ..serde_json::from_str(stated).expect("a garment")
        };
        let resolved = resolve(garment, &ShippedAssets, &limits).expect("it is right");
        let context = Context {
            cpu_s: &|| 0.0,
            cancel: &CancelToken::new(),
            progress: &mut |_| {},
            limits: &limits,
        };
        scene(&resolved, &context).expect("it can be assembled")
    }

    /// The verdict on the shape that `moved` makes of the start.
    fn judged(moved: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Support {
        let at_rest = Support {
            ok: Some(true),
            ..Support::default()
        };
        judged_as(moved, &at_rest)
    }

    /// The same where the solver found this.
    fn judged_as(moved: impl Fn(&Vector3<f64>) -> Vector3<f64>, found: &Support) -> Support {
        let scene = top();
        let shape: Vec<_> = scene.start.iter().map(moved).collect();
        support(&scene, &["front", "back"], &shape, found)
    }

    #[test]
    fn cloth_that_sank_is_worn_where_its_openings_are_where_they_belong() {
        let sunk = Support {
            ok: Some(false),
            because: "it sank by 300 mm: nothing holds it where it was put".to_owned(),
            sank_m: Some(0.3),
            ..Support::default()
        };
        let worn = judged_as(dressed, &sunk);
        assert_eq!(worn.ok, Some(true), "{}", worn.because);
        assert!(worn.because.contains("300 mm lower"), "{}", worn.because);
        let off = judged_as(|p| *p, &sunk);
        assert_eq!(off.ok, Some(false));
        assert!(off.because.contains("it sank"), "{}", off.because);
    }

    /// The top with the back of its neck drawn up like a hood, which falls over the front.
    #[test]
    fn a_hood_without_a_head_is_not_judged() {
        let mut scene = top();
        let avatar = scene.body.as_ref().and_then(Body::avatar).expect("a body");
        let ends = BodyEnds::new(avatar).expect("landmarks");
        let openings = worn_openings(&scene, &scene.start, &ends);
        let neck = openings.iter().find(|o| o.before == Encircled::Neck);
        let neck = neck.expect("a neck").opening.vertices.clone();
        let mut shape: Vec<_> = scene.start.iter().map(dressed).collect();
        let at_rest = Support {
            ok: Some(true),
            ..Support::default()
        };
        for &v in &neck {
            shape[v].z = 0.3;
        }
        let names = ["front", "back"];
        let fallen = support(&scene, &names, &shape, &at_rest);
        assert_eq!(fallen.ok, Some(false), "{}", fallen.because);
        for v in neck {
            if scene.start[v].z < 0.0 {
                scene.start[v].y += 0.3;
            }
        }
        let hood = support(&scene, &names, &shape, &at_rest);
        assert_eq!(hood.ok, Some(true), "{}", hood.because);
        assert!(hood.because.contains("no head"), "{}", hood.because);
    }

    /// Front and back, 10 cm before and behind the shoulders, drawn together onto them.
    fn dressed(p: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(p.x, p.y, if p.y > 1.38 { 0.0 } else { p.z })
    }

    #[test]
    fn a_top_on_the_shoulders_is_worn_by_its_four_openings() {
        let worn = judged(dressed);
        assert_eq!(worn.ok, Some(true), "{}", worn.because);
        let mut round: Vec<_> = worn
            .openings
            .iter()
            .map(|o| o.goes_round.as_str())
            .collect();
        round.sort_unstable();
        assert_eq!(
            round,
            ["the left arm", "the neck", "the right arm", "the trunk"]
        );
    }

    #[test]
    fn a_top_that_slid_to_the_hips_is_not_worn() {
        let worn = judged(|p| dressed(p) - Vector3::y() * 0.45);
        assert_eq!(worn.ok, Some(false));
        let why = "was placed round the neck and goes round the trunk";
        assert!(worn.because.contains(why), "{}", worn.because);
    }

    #[test]
    fn a_top_that_hangs_before_and_behind_the_shoulders_is_off_them() {
        let worn = judged(|p| *p);
        assert_eq!(worn.ok, Some(false));
        assert!(worn.because.contains("off the"), "{}", worn.because);
    }

    #[test]
    fn a_top_that_has_turned_is_not_worn() {
        let worn = judged(|p| Rotation3::new(Vector3::y() * 0.6) * dressed(p));
        assert_eq!(worn.ok, Some(false));
        assert!(
            worn.because.contains("turned by 34 degrees"),
            "{}",
            worn.because
        );
    }
}
