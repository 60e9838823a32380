//! Observed orders: the powers of the step that errors fall with.

use super::report::{StudyOrder, StudyRun};
use crate::solver::Method;

/// Returns the order of each method among `runs`, of which `steps` are the lengths of the steps
/// taken \[s\].
pub(super) fn orders(runs: &[StudyRun], steps: &[f64]) -> Vec<StudyOrder> {
    let mut orders: Vec<StudyOrder> = Vec::new();
    for run in runs.iter().filter(|run| run.step_s.is_some()) {
        let known = orders.iter().any(|order| order.method == run.method);
        if let Some(theory) = theory(run.method).filter(|_| !known) {
            orders.push(StudyOrder {
                method: run.method,
                edge_length_m: run.edge_length_m,
                observed: None,
                finest: None,
                theory,
                steps_s: Vec::new(),
            });
        }
    }
    for order in &mut orders {
        let of_method = runs.iter().zip(steps).filter(|(run, _)| {
            run.method == order.method && run.step_s.is_some() && run.error_certain
        });
        let points: Vec<(f64, f64)> = of_method
            .filter_map(|(run, &step)| Some((step, run.error_m?)))
            .collect();
        order.steps_s = points.iter().map(|p| p.0).collect();
        order.observed = slope(&points);
        let mut shortest = points;
        shortest.sort_by(|a, b| a.0.total_cmp(&b.0));
        shortest.truncate(2);
        order.finest = slope(&shortest);
    }
    orders
}

/// Returns the order of theory where forces are smooth; none for a method that does not step.
fn theory(method: Method) -> Option<f64> {
    match method {
        Method::SymplecticEuler | Method::ImplicitEuler => Some(1.0),
        Method::Verlet | Method::Bdf2 => Some(2.0),
        Method::Auto | Method::Newton => None,
    }
}

/// Returns the slope of log error over log step by least squares; none with fewer than two
/// different steps.
fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let positive = points.iter().filter(|(h, e)| *h > 0.0 && *e > 0.0);
    let logs: Vec<(f64, f64)> = positive.map(|(h, e)| (h.ln(), e.ln())).collect();
    let n = logs.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|l| l.0), mean(|l| l.1));
    let spread: f64 = logs.iter().map(|l| (l.0 - x).powi(2)).sum();
    let above: f64 = logs.iter().map(|l| (l.0 - x) * (l.1 - y)).sum();
    (logs.len() > 1 && spread > 1e-6).then(|| above / spread)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_has_its_exponent() {
        let points = [0.1, 0.05, 0.02].map(|h: f64| (h, 3.0 * h.powf(1.7)));
        let found = slope(&points).expect("three steps");
        assert!((found - 1.7).abs() < 1e-12, "{found}");
        assert_eq!(slope(&[(0.1, 1.0), (0.1, 1.0)]), None);
    }
}
