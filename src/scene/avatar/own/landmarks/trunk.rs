//! Landmarks of the trunk: crotch, armpits, bust, waist and hip.

use super::found::{Found, Missing};
use super::level::{LevelLoop, loops_at, trunk_at};
use crate::scene::avatar::TriangleMesh;
use nalgebra::Vector3;

/// Distance between slices in which something is looked for, and between the last two \[m\].
const STEP: f64 = 0.004;
const FINE: f64 = 0.0002;
/// Shares of the height between which the crotch is, in a body with or without a head.
const CROTCH: [f64; 2] = [0.30, 0.65];
/// Share of the section that is left below the crotch in the larger leg, at most.
const LEG: f64 = 0.75;
/// Distance of the legs at the crotch \[m\]: cloth does not go higher between them.
const APART: f64 = 0.012;
/// Points of a loop that are looked at for the distance of two.
const LOOP_POINTS: usize = 400;
/// Outward leap of the trunk's side where the arm joins it, at least, as a share of the height.
const ARM: f64 = 0.018;
/// Height over which the outline under an arm turns outward by more than 45 degrees \[m\].
const SPAN: f64 = 0.008;
/// Depth below the armpits within which the points of the bust are, as a share of the height.
const BUST: f64 = 0.09;
/// Weight of the way outward against the way forward in looking for the points of the bust, which
/// face ahead and a little aside.
const ASIDE: f64 = 0.12;
/// Share of the way from the middle to the armpit at which the points of the bust begin.
const BREASTBONE: f64 = 0.25;
/// Rise behind a point of the bust that does not count \[m\].
const LEVEL: f64 = 0.0003;
/// Fall behind the points of the bust that ends the search \[m\].
const FALL: f64 = 0.002;
/// Limits of waist and hip \[m\]: as girths are taken.
const WAIST_BELOW_BUST: f64 = 0.08;
const WAIST_ABOVE_CROTCH: f64 = 0.13;
const HIP_BELOW_WAIST: f64 = 0.06;

/// Finds the crotch: where the trunk parts in two legs.
pub(super) fn crotch(surface: &TriangleMesh, height: f64) -> Result<Vector3<f64>, Missing> {
    let missing = Missing("crotch", "no height at which the trunk parts in two legs");
    let largest = |y: f64| {
        let areas = loops_at(surface, y).into_iter().map(|found| found.area);
        areas.fold(0.0, f64::max)
    };
    let [low, high] = CROTCH.map(|share| share * height);
    let mut above = high;
    let mut area = largest(above);
    loop {
        let below = above - STEP;
        if below < low {
            return Err(missing);
        }
        let next = largest(below);
        if next < LEG * area {
            let is_leg = |y: f64| largest(y) < 0.5 * (1.0 + LEG) * area;
            let mut y = bisect(below, above, is_leg);
            let mut place = between_legs(surface, y).ok_or(missing)?;
            while place.0 < APART && y > low {
                y -= 0.25 * STEP;
                place = between_legs(surface, y).ok_or(missing)?;
            }
            return Ok(place.1);
        }
        (above, area) = (below, next);
    }
}

/// Returns the place where a property ends, known to hold at `yes` and not at `no`.
fn bisect(mut yes: f64, mut no: f64, holds: impl Fn(f64) -> bool) -> f64 {
    while (yes - no).abs() > FINE {
        let middle = 0.5 * (yes + no);
        if holds(middle) {
            yes = middle;
        } else {
            no = middle;
        }
    }
    yes
}

/// The distance of the two legs at height `y`, and the point amid them.
fn between_legs(surface: &TriangleMesh, y: f64) -> Option<(f64, Vector3<f64>)> {
    let mut loops = loops_at(surface, y);
    loops.sort_by(|a, b| b.area.total_cmp(&a.area));
    let [one, two] = [loops.first()?, loops.get(1)?];
    let mut best = (f64::INFINITY, Vector3::zeros());
    let some = |found: &LevelLoop| {
        let step = found.points.len().div_ceil(LOOP_POINTS);
        let points = found.points.iter().step_by(step.max(1));
        points.copied().collect::<Vec<_>>()
    };
    let (one, two) = (some(one), some(two));
    for p in &one {
        for q in &two {
            let apart = (p[0] - q[0]).hypot(p[1] - q[1]);
            if apart < best.0 {
                best = (apart, Vector3::new(0.0, y, 0.5 * (p[1] + q[1])));
            }
        }
    }
    Some(best)
}

/// Finds the armpits, left and right: where an arm first joins the trunk, from below.
pub(super) fn armpits(
    surface: &TriangleMesh,
    crotch: f64,
    height: f64,
) -> Result<[Vector3<f64>; 2], Missing> {
    let missing = Missing("armpit", "no height at which an arm joins the trunk");
    let first = crotch + 0.3 * (height - crotch);
    let sides = |y: f64| trunk_at(surface, y).map(|trunk| trunk.sides());
    let mut found = [None; 2];
    let mut last = sides(first).ok_or(missing)?;
    let mut y = first;
    while y < height && found.iter().any(Option::is_none) {
        y += STEP;
        let Some(next) = sides(y) else { break };
        for side in 0..2 {
            let leap = next[side].x.abs() - last[side].x.abs();
            if found[side].is_none() && leap > ARM * height {
                let limit = last[side].x.abs() + 0.5 * leap;
                let is_trunk = |y: f64| sides(y).is_some_and(|s| s[side].x.abs() < limit);
                let mut at = bisect(y - STEP, y, is_trunk);
                // under a raised arm, the outline turns before it leaps
                let x = |y: f64| sides(y).map_or(f64::NAN, |s| s[side].x.abs());
                while at > first && x(at) - x(at - SPAN) > SPAN {
                    at -= 0.25 * STEP;
                }
                found[side] = sides(at).map(|sides| sides[side]);
            }
        }
        last = next;
    }
    match found {
        [Some(left), Some(right)] => Ok([left, right]),
        _ => Err(missing),
    }
}

/// Finds the points of the bust, left and right: the foremost ones under the armpits.
pub(super) fn bust_points(
    surface: &TriangleMesh,
    armpits: &[Vector3<f64>; 2],
    height: f64,
) -> Result<[Vector3<f64>; 2], Missing> {
    let missing = Missing("bust_point", "no trunk below the armpits");
    let top = armpits[0].y.min(armpits[1].y);
    let mut levels = Vec::new();
    let mut y = top - 0.5 * STEP;
    while y > top - BUST * height {
        levels.extend(trunk_at(surface, y));
        y -= 0.5 * STEP;
    }
    let side = |side: usize| {
        let points = levels
            .iter()
            .filter_map(|level| foremost(level, &armpits[side]));
        first_top(points)
    };
    match [side(0), side(1)] {
        [Some(left), Some(right)] => Ok([left, right]),
        _ => Err(missing),
    }
}

/// The foremost point of a level on the side of an armpit.
fn foremost(level: &LevelLoop, armpit: &Vector3<f64>) -> Option<Vector3<f64>> {
    let sign = armpit.x.signum();
    let limits = BREASTBONE * armpit.x.abs()..armpit.x.abs();
    let own = level
        .points
        .iter()
        .filter(|p| limits.contains(&(p[0] * sign)));
    let first = own.max_by(|a, b| forward(a[0], a[1]).total_cmp(&forward(b[0], b[1])));
    first.map(|p| Vector3::new(p[0], level.y, p[1]))
}

fn forward(x: f64, z: f64) -> f64 {
    z + ASIDE * x.abs()
}

/// The first of points, going down, from which the body falls back.
fn first_top(points: impl Iterator<Item = Vector3<f64>>) -> Option<Vector3<f64>> {
    let mut best: Option<Vector3<f64>> = None;
    for p in points {
        let reach = forward(p.x, p.z);
        match best {
            Some(top) if reach < forward(top.x, top.z) - FALL => break,
            Some(top) if reach <= forward(top.x, top.z) + LEVEL => {}
            _ => best = Some(p),
        }
    }
    best
}

/// Finds the levels of bust, waist and hip, and puts their landmarks in.
pub(super) fn girth_levels(
    surface: &TriangleMesh,
    (bust, crotch): (f64, f64),
    found: &mut Found,
) -> Result<(), Missing> {
    let levels = |from: f64, to: f64| {
        let mut levels = Vec::new();
        let mut y = from;
        while y <= to {
            levels.extend(trunk_at(surface, y));
            y += 0.5 * STEP;
        }
        levels.into_iter().map(|level| (level.girth(), level))
    };
    let narrowest = levels(crotch + WAIST_ABOVE_CROTCH, bust - WAIST_BELOW_BUST)
        .min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, waist) = narrowest.ok_or(Missing("waist", "no trunk between bust and crotch"))?;
    let widest =
        levels(crotch + FINE, waist.y - HIP_BELOW_WAIST).max_by(|a, b| a.0.total_cmp(&b.0));
    let (_, hip) = widest.ok_or(Missing("hip", "no trunk between waist and crotch"))?;
    let bust = trunk_at(surface, bust).ok_or(Missing("bust", "no trunk at the bust"))?;
    for (name, level) in [("bust", bust), ("waist", waist), ("hip", hip)] {
        let [mut front, back] = level
            .middle()
            .ok_or(Missing("waist", "the trunk is not about the middle"))?;
        if name == "hip" {
            // before the groin, as a tape lies
            front.z = level.foremost();
        }
        let [left, right] = level.sides();
        found.insert(format!("{name}_front"), front);
        found.insert(format!("{name}_back"), back);
        found.insert(format!("{name}_side_l"), left);
        found.insert(format!("{name}_side_r"), right);
    }
    Ok(())
}
