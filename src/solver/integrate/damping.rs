//! Drag from the fabric.
//!
//! A fabric gives a share ζ of critical damping. It is that of the fundamental mode of the cloth
//! hung by one end under standard gravity: a hanging strip of length L swings with ω = j₀₁/2
//! √(g/L), j₀₁ = 2.4048 (D. Bernoulli 1732; the first zero of J₀), and drag F = -c m v damps a mode
//! of frequency ω by c / (2 ω), so c = 2 ζ ω. L is the longest side of the largest panel.
//!
//! Drag in proportion to mass is the paper's `C_d` (P8) shared out by mass. It damps slow modes
//! most. A part in proportion to stiffness, which would damp fast ones, is left out: it would
//! shorten explicit steps by as much as it damps, and implicit methods damp what their step cannot
//! follow anyway.

use crate::scene::Scene;
use crate::solver::model::system::STANDARD_GRAVITY;

/// Half the first zero of the Bessel function J₀.
const HALF_BESSEL_ZERO: f64 = 0.5 * 2.404_825_557_695_773;

/// Returns the fundamental frequency of the cloth of `scene` \[rad/s\]; 0 if it has no length.
pub(crate) fn fundamental_frequency(scene: &Scene) -> f64 {
    let mut longest = 0.0_f64;
    for panel in &scene.mesh.panels {
        for axis in 0..2 {
            let side = || {
                scene.mesh.uv[panel.vertices.clone()]
                    .iter()
                    .map(|p| p[axis])
            };
            let low = side().fold(f64::INFINITY, f64::min);
            longest = side().fold(longest, |longest, v| longest.max(v - low));
        }
    }
    if longest > 0.0 {
        HALF_BESSEL_ZERO * (STANDARD_GRAVITY / longest).sqrt()
    } else {
        0.0
    }
}

/// Returns the drag per mass `C_d / m` of the cloth of `scene` \[1/s\], by the mean ζ of its
/// panels' mass.
pub(crate) fn drag(scene: &Scene) -> f64 {
    let (mut mass, mut damped) = (0.0, 0.0);
    for (panel, cut) in scene.mesh.panels.iter().zip(&scene.cut) {
        let own: f64 = scene.mass[panel.vertices.clone()].iter().sum();
        mass += own;
        damped += own * scene.fabrics[cut.fabric].damping_ratio;
    }
    if mass > 0.0 {
        2.0 * damped / mass * fundamental_frequency(scene)
    } else {
        0.0
    }
}
