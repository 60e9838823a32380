//! Forces on a shape that was never relaxed: refused, or given up before its seams were closed.

use crate::scene::Scene;
use crate::solver::model::build::build;
use crate::solver::model::build_options::BuildOptions;
use crate::solver::model::seams::Seams;
use crate::solver::options::SolverOptions;
use crate::solver::outcome::ForceBalance;
use crate::solver::report::measure::energies;
use nalgebra::Vector3;

/// Measures residual, floor and energies of the shape `x` \[m; `#V`\] with its seams as stiff
/// springs.
///
/// All of it is finite for any finite shape: what would be beyond all numbers is the greatest of
/// them, since JSON has no other.
pub(crate) fn measure_unrelaxed(
    scene: &Scene,
    options: &SolverOptions,
    x: &[Vector3<f64>],
    clock: &dyn Fn() -> f64,
) -> ForceBalance {
    let stiffness = options.closed_seam_stiffness(options.sewing_stiffness());
    let build_options = BuildOptions {
        seams: Seams::Stiff { stiffness },
        hold: None,
        gravity: true,
        friction: None,
        explicit: false,
        least_thickness: None,
        finest: true,
    };
    let mut system = build(scene, options, &build_options, clock).system;
    let mut force = vec![Vector3::zeros(); x.len()];
    system.net_force(x, &mut force);
    ForceBalance {
        residual: finite(system.residual(&force)),
        residual_floor: finite(system.residual_floor(x)),
        energy: energies(&mut system, x),
    }
}

/// Returns `v`, or the greatest finite number where it is none or larger.
fn finite(v: f64) -> f64 {
    if v.is_nan() {
        f64::MAX
    } else {
        v.min(f64::MAX)
    }
}
