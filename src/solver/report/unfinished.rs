//! What is said of a shape that no drape was run on to its end: refused, or given up before its seams were closed.

use crate::scene::Scene;
use crate::solver::drape::sew::{SEAM_STIFFNESS, closed_stiffness};
use crate::solver::model::build::{Stage, assemble};
use crate::solver::model::dof_map::DofMap;
use crate::solver::options::SolverOptions;
use crate::solver::report::describe::energies;
use crate::solver::report::schema::DrapeReport;
use nalgebra::Vector3;

/// Fills in residual, floor and energies of the shape `x` with its seams as stiff springs, and takes back what was estimated.
///
/// All of it is finite for any finite shape: what would be beyond all numbers is the greatest of them, since JSON has no other.
pub(crate) fn describe(
    scene: &Scene,
    options: &SolverOptions,
    x: &[Vector3<f64>],
    clock: &dyn Fn() -> f64,
    report: &mut DrapeReport,
) {
    let dof_map = DofMap::identity(x.len());
    let stitches: Vec<_> = scene.mesh.stitches.iter().map(|s| (s.a, s.b)).collect();
    let stiffness = closed_stiffness(options, SEAM_STIFFNESS);
    let stage = Stage {
        dof_map: &dof_map,
        stitches: (!stitches.is_empty()).then_some((stitches, stiffness)),
        gravity: true,
        friction: None,
        explicit: false,
    };
    let mut system = assemble(scene, options, &stage, clock);
    let mut force = vec![Vector3::zeros(); x.len()];
    system.net_force(x, &mut force);
    let finite = |v: f64| {
        if v.is_nan() {
            f64::MAX
        } else {
            v.min(f64::MAX)
        }
    };
    report.residual = finite(system.residual(&force));
    report.residual_floor = finite(system.residual_floor(x));
    report.energy_j = energies(&mut system, x);
    report.error_estimate_m = None;
    report.error_estimate_valid = false;
}
