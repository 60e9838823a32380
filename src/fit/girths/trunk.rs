//! Parts of a garment that go round the trunk nowhere near where they start.
//!
//! Panels start where a drawing or a file puts them, which need not be the height at which they are
//! worn: a waistband that starts at the hip rides up to the waist. A part is too small only if some
//! girth of it is lacking at every height that it can take.

use super::section::{Section, Sections, level, steps};
use super::words::section_in_words;
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

/// A closed section of a garment, and the height at which it starts \[m\].
type Ring = (f64, Section);

/// Heights \[m\] and girths of a body's trunk.
struct TrunkGirths {
    crotch: f64,
    hip: f64,
    waist: f64,
    bust: f64,
    /// Heights with the girth there \[m\].
    girths: Vec<(f64, f64)>,
}

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
    let trunk = TrunkGirths::of(avatar)?;
    let parts = parts_apart(scene, sections, panels, trunk.levels()).into_values();
    let lacks = parts.filter_map(|rings| trunk.least_lack(&rings));
    let worst = most(lacks).filter(|lack| lack.share > NO_LACK_SHARE)?;
    let place = trunk.name(worst.at);
    Some(section_in_words(&worst.section, place, worst.body_m))
}

impl TrunkGirths {
    /// Returns the trunk of a body whose landmarks are in their order.
    fn of(avatar: &Avatar) -> Option<Self> {
        let height = |name: &str| avatar.landmarks.get(name).map(|p| p.y);
        let (crotch, hip) = (height("crotch")?, height("hip_front")?);
        let (waist, bust) = (height("waist_front")?, height("bust_point_l")?);
        let is_sound = crotch < hip && hip < waist && waist < bust && bust - crotch < TALLEST;
        let heights = || steps([crotch, bust], STEP).chain([hip, waist, bust]);
        let girth = |at: f64| Some((at, avatar.girth_at(at)?));
        is_sound.then(|| Self {
            crotch,
            hip,
            waist,
            bust,
            girths: heights().filter_map(girth).collect(),
        })
    }

    /// Returns the furthest that a part rides up: a band from the hip to the waist \[m\].
    fn rise(&self) -> f64 {
        self.waist - self.hip
    }

    /// Returns the heights at which a garment is measured \[m\].
    fn levels(&self) -> impl Iterator<Item = f64> + use<> {
        steps([self.crotch - self.rise(), self.bust + LOWER], STEP)
    }

    /// Returns what is lacking of a part with these rings at the height at which it lacks least;
    /// none if it is beside no part of the trunk at one of the heights that it can take, where
    /// nothing is known of it.
    fn least_lack(&self, rings: &[Ring]) -> Option<Lack> {
        let at_rise = |rise: f64| {
            let lacks = rings.iter();
            most(lacks.filter_map(|(at, section)| self.lack(at + rise, *section)))
        };
        let lacks: Option<Vec<Lack>> = steps([-LOWER, self.rise()], STEP).map(at_rise).collect();
        let lacks = lacks?.into_iter();
        lacks.min_by(|a, b| a.share.total_cmp(&b.share))
    }

    /// Returns what a section lacks at a height \[m\]. Below the crotch the body is legs; above
    /// the bust what is worn hangs from the shoulders.
    fn lack(&self, at: f64, section: Section) -> Option<Lack> {
        let off = |girth: &&(f64, f64)| (girth.0 - at).abs();
        let nearest = self.girths.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let &(height, body_m) = nearest.filter(|_| at >= self.crotch)?;
        Some(Lack {
            share: 1.0 - section.stretched_m / body_m,
            at: height,
            body_m,
            section,
        })
    }

    /// Returns the name of the place that is nearest to a height \[m\].
    fn name(&self, at: f64) -> &'static str {
        let places = [
            ("bust", self.bust),
            ("waist", self.waist),
            ("hip", self.hip),
        ];
        let off = |place: &(&str, f64)| (place.1 - at).abs();
        let nearest = places.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.map_or("trunk", |place| place.0)
    }
}

fn most(lacks: impl Iterator<Item = Lack>) -> Option<Lack> {
    lacks.max_by(|a, b| a.share.total_cmp(&b.share))
}

/// Returns the closed sections at these levels with their heights \[m\], by the panels that they
/// go through: parts that are apart at the start take heights of their own.
fn parts_apart(
    scene: &Scene,
    sections: &Sections<'_>,
    panels: &[usize],
    levels: impl Iterator<Item = f64>,
) -> BTreeMap<Vec<usize>, Vec<Ring>> {
    let reaches = |panel: usize, at: f64| {
        let heights = scene.start[scene.mesh.panels[panel].vertices.clone()].iter();
        let heights = heights.map(|p| p.y - at);
        let [least, most] = heights.fold([0.0_f64; 2], |[least, most], off| {
            [least.min(off), most.max(off)]
        });
        least < 0.0 && most > 0.0
    };
    let mut parts: BTreeMap<Vec<usize>, Vec<Ring>> = BTreeMap::new();
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
