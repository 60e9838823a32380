//! Every method that steps, with drag, ends in the shape at rest that Newton's method finds.

use nalgebra::Vector3;
use seamster::config::Limits;
use seamster::progress::CancelToken;
use seamster::scene::Scene;
use seamster::solver::{Context, Drape, Method, SolverOptions, drape};
use seamster_fixtures::motions::{METHODS, apart, grid};

/// A net hung by its two upper corners and held in its plane, where its rest shape is the only one.
fn hung() -> Scene {
    Scene {
        gravity: Vector3::new(0.0, -9.8, 0.0),
        drag: Some(10.0),
        pins: vec![20, 24],
        fixed_axis: Some(2),
        ..grid(5, 100.0)
    }
}

fn at_rest(method: Method) -> Drape {
    let options = SolverOptions {
        method,
        tolerance: 1e-8,
        ..SolverOptions::default()
    };
    let (limits, cancel) = (Limits::default(), CancelToken::new());
    let mut context = Context {
        cpu_s: &|| 0.0,
        cancel: &cancel,
        progress: &mut |_| {},
        limits: &limits,
    };
    drape(&hung(), &options, &mut context)
}

/// A residual of 1e-8 of the weight of 1 g moves a particle on springs of 100 N/m by 1e-12 m; the
/// softest way that the net of 25 can move is some hundred times softer.
#[test]
fn every_method_ends_in_the_same_shape() {
    let newton = at_rest(Method::Newton);
    assert!(newton.report.converged, "{}", newton.report.why);
    for method in METHODS {
        let drape = at_rest(method);
        assert!(drape.report.converged, "{method:?}: {}", drape.report.why);
        assert!(drape.report.residual <= 1e-8);
        let error = apart(&drape.positions, &newton.positions);
        assert!(error < 1e-9, "{method:?}: {error}");
    }
    let names = METHODS.map(|method| at_rest(method).report.method);
    assert_eq!(
        names,
        ["symplectic_euler", "verlet", "implicit_euler", "bdf2"]
    );
}
