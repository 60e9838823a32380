//! Stiffness continuation: cloth far stiffer than any worn is sewn and draped softer first, then
//! made stiffer tenfold at a time, each time from the shape before.
//!
//! The step of Newton's method goes along a straight line, while stiff cloth turns: a step d
//! stretches an edge l by d² / (2 l), so the stiffer the cloth, the shorter the steps, and folds
//! that are still to form take thousands. A shape at rest of softer cloth has its folds already,
//! and strains in proportion to its softness; ten times stiffer, most of the way is one linear
//! step. Poplin 1e4 times stiffer, hung by two corners: not at rest after 2000 iterations, and
//! after 250 so; 100 times stiffer and sewn, 125 instead of 509.

use crate::scene::{Fabric, Membrane, Scene};
use crate::solver::model::system::STANDARD_GRAVITY;

/// Strain of cloth under its own weight below which it is softened first: that of organza, the
/// stiffest for its weight that ships, is at least twice as large.
const STIFF_STRAIN: f64 = 3e-6;
/// Least strain of the softest cloth, with which it begins: half of poplin's.
const SOFT_STRAIN: f64 = 1.5e-5;
/// Ratio of the stiffness of one level to that of the level before.
const FACTOR: f64 = 10.0;
/// Largest number of softer scenes: beyond a factor of 1e12 forces are rounding.
const SOFTER_SCENES: usize = 12;

/// Makes ever softer versions of `scene`, the last of which is to be draped first; none if it is
/// not stiff.
///
/// Stretch and shear are capped, not scaled: what is soft beside something stiff stays as it is.
pub(crate) fn softened_scenes(scene: &Scene) -> Vec<Scene> {
    let stiffest = stiffest(scene);
    let strain = weight_per_width(scene) / stiffest;
    if !(strain > 0.0 && strain < STIFF_STRAIN) {
        return vec![];
    }
    let mut softer = vec![];
    let mut cap = stiffest / FACTOR;
    while softer.len() < SOFTER_SCENES && weight_per_width(scene) / cap < FACTOR * SOFT_STRAIN {
        softer.push(capped(scene, cap));
        cap /= FACTOR;
    }
    softer
}

/// Returns the largest modulus of any fabric, or the stiffness of the stiffest spring of a net
/// \[N/m\].
fn stiffest(scene: &Scene) -> f64 {
    let given = matches!(scene.membrane, Membrane::Springs(_));
    let fabrics = scene.fabrics.iter().filter(|_| !given);
    let moduli = fabrics.flat_map(|f| [f.stretch_warp_n_m, f.stretch_weft_n_m, f.shear_n_m]);
    let springs = scene.membrane.springs().iter().map(|s| s.stiffness_n_m);
    moduli.chain(springs).fold(0.0, f64::max)
}

/// Returns the weight of the garment under standard gravity over the largest extent of a panel, or
/// of the start of a net without one \[N/m\].
fn weight_per_width(scene: &Scene) -> f64 {
    let weight = scene.mass.iter().sum::<f64>() * STANDARD_GRAVITY;
    let flat = scene.mesh.panels.iter().flat_map(|panel| {
        let uv = &scene.mesh.uv[panel.vertices.clone()];
        [0, 1].map(|axis| extent(uv.iter().map(|p| p[axis])))
    });
    let longest = flat.fold(0.0, f64::max);
    let start = || (0..3).map(|axis| extent(scene.start.iter().map(|p| p[axis])));
    let length = if longest > 0.0 {
        longest
    } else {
        start().fold(0.0, f64::max)
    };
    weight / length.max(f64::MIN_POSITIVE)
}

/// Returns the difference of the largest and the least of the values.
fn extent(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
        (low.min(v), high.max(v))
    });
    high - low
}

/// Copies the scene, with nothing in it stiffer than `cap` \[N/m\].
fn capped(scene: &Scene, cap: f64) -> Scene {
    let mut scene = scene.clone();
    for fabric in &mut scene.fabrics {
        let Fabric {
            stretch_warp_n_m: warp,
            stretch_weft_n_m: weft,
            shear_n_m: shear,
            ..
        } = fabric;
        for modulus in [warp, weft, shear] {
            *modulus = modulus.min(cap);
        }
    }
    for spring in scene.membrane.springs_mut() {
        spring.stiffness_n_m = spring.stiffness_n_m.min(cap);
    }
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Limits;
    use crate::scene::{NetSpring, RawScene};

    /// Two vertices 1 m apart that weigh 1 N each, joined by a soft spring and a stiff one.
    fn pair(stiffness: f64) -> Scene {
        let spring = |stiffness_n_m| NetSpring {
            a: 0,
            b: 1,
            rest_length_m: 1.0,
            stiffness_n_m,
        };
        let raw = RawScene {
            start_m: vec![[0.0; 3], [1.0, 0.0, 0.0]],
            mass_kg: vec![1.0 / STANDARD_GRAVITY; 2],
            springs: vec![spring(10.0), spring(stiffness)],
            ..RawScene::default()
        };
        raw.into_scene(&Limits::default())
            .expect("a right scene of two vertices")
    }

    fn stiffnesses(scene: &Scene) -> Vec<f64> {
        scene
            .membrane
            .springs()
            .iter()
            .map(|s| s.stiffness_n_m)
            .collect()
    }

    /// 2 N over 1 m against 1e4 N/m is a strain of 2e-4: nothing to soften.
    #[test]
    fn cloth_as_soft_as_any_worn_is_left_alone() {
        assert!(softened_scenes(&pair(1e4)).is_empty());
    }

    /// 2 N/m against 1e7 N/m is 2e-7: tenfold softer twice brings it above 1.5e-5, and the soft
    /// spring stays.
    #[test]
    fn what_is_stiff_is_softened_tenfold_until_it_strains() {
        let softer: Vec<_> = softened_scenes(&pair(1e7))
            .iter()
            .map(stiffnesses)
            .collect();
        assert_eq!(softer, [vec![10.0, 1e6], vec![10.0, 1e5]]);
    }
}
