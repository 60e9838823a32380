//! Parts of a garment that go round the trunk nowhere near where they start.
//!
//! Panels start where a drawing or a file puts them, which need not be the height at which they are
//! worn: a waistband that starts at the hip rides up to the waist. A part is too small only if some
//! girth of it is lacking at every height that it can take.

use super::section::{Section, Sections, level, steps};
use crate::scene::{Avatar, Scene};
use std::collections::BTreeMap;

/// Distance of the levels at which a garment is measured, and of the heights that it can take
/// \[m\].
const STEP: f64 = 0.02;
/// Furthest that a part is worn below where it starts \[m\].
const LOWER: f64 = 0.03;
/// Share of the body's girth that a garment may lack: over one step a waist widens by as much.
const NO_LACK_SHARE: f64 = 0.02;

/// Longest trunk that is measured \[m\]: landmarks of a body of one's own may be anywhere.
const TALLEST: f64 = 1.0;

/// The girth of a part at a level, with what it lacks there.
#[derive(Clone, Copy)]
struct Lack {
    /// Share of the body's girth that is lacking; 0 or less if none is.
    share: f64,
    /// Height at the body \[m\].
    at: f64,
    /// Girth of the body there \[m\].
    body_m: f64,
    section: Section,
}

/// Returns where the panels about the trunk lack most, in words; nothing if they reach round it.
pub(super) fn lack(
    avatar: &Avatar,
    scene: &Scene,
    sections: &Sections<'_>,
    panels: &[usize],
) -> Option<String> {
    let height = |name: &str| avatar.landmarks.get(name).map(|p| p.y);
    let (crotch, hip) = (height("crotch")?, height("hip_front")?);
    let (waist, bust) = (height("waist_front")?, height("bust_point_l")?);
    if !(crotch < hip && hip < waist && waist < bust && bust - crotch < TALLEST) {
        return None;
    }
    let levels = steps([crotch - (waist - hip), bust + LOWER], STEP);
    let girths = steps([crotch, bust], STEP).chain([hip, waist, bust]);
    let girths: Vec<(f64, f64)> = girths
        .filter_map(|at| Some((at, avatar.girth_at(at)?)))
        .collect();
    // Below the crotch the body is legs; above the bust what is worn hangs from the shoulders.
    let at_body = |at: f64| {
        let off = |girth: &(f64, f64)| (girth.0 - at).abs();
        let nearest = girths.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.filter(|_| at >= crotch).copied()
    };
    let lack = |at: f64, section: Section| {
        let (at, body_m) = at_body(at)?;
        let share = 1.0 - section.stretched_m / body_m;
        Some(Lack {
            share,
            at,
            body_m,
            section,
        })
    };
    let most = |lacks: Vec<Lack>| lacks.into_iter().max_by(|a, b| a.share.total_cmp(&b.share));
    let least = |part: Vec<(f64, Section)>| {
        let raised = steps([-LOWER, waist - hip], STEP).map(|rise| {
            let lacks = part
                .iter()
                .filter_map(|(at, section)| lack(at + rise, *section));
            most(lacks.collect())
        });
        // At a height at which it is beside no part of the trunk nothing is known of it.
        let raised: Option<Vec<Lack>> = raised.collect();
        raised?
            .into_iter()
            .min_by(|a, b| a.share.total_cmp(&b.share))
    };
    let parts = parts(scene, sections, panels, levels).into_values();
    let worst =
        most(parts.filter_map(least).collect()).filter(|lack| lack.share > NO_LACK_SHARE)?;
    let names = [("bust", bust), ("waist", waist), ("hip", hip)];
    let off = |named: &(&str, f64)| (named.1 - worst.at).abs();
    let (name, _) = names.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
    Some(worst.section.against(name, worst.body_m))
}

/// Returns the closed sections at these levels with their heights \[m\], by the panels that they
/// go through: parts that are apart at the start take heights of their own.
fn parts(
    scene: &Scene,
    sections: &Sections<'_>,
    panels: &[usize],
    levels: impl Iterator<Item = f64>,
) -> BTreeMap<Vec<usize>, Vec<(f64, Section)>> {
    let reaches = |panel: usize, at: f64| {
        let heights = scene.start[scene.mesh.panels[panel].vertices.clone()].iter();
        let heights = heights.map(|p| p.y - at);
        let [least, most] = heights.fold([0.0_f64; 2], |[least, most], off| {
            [least.min(off), most.max(off)]
        });
        least < 0.0 && most > 0.0
    };
    let mut parts: BTreeMap<Vec<usize>, Vec<(f64, Section)>> = BTreeMap::new();
    for at in levels {
        let section = sections.of(level(at), panels, &scene.start);
        if section.is_closed {
            let through = panels.iter().copied().filter(|&panel| reaches(panel, at));
            parts
                .entry(through.collect())
                .or_default()
                .push((at, section));
        }
    }
    parts
}
