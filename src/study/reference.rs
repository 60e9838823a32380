//! The reference of motions: Verlet and BDF2, each extrapolated to steps of zero, refined until they agree well below the errors
//! that are to be measured.
//!
//! Both are of order 2, so of two motions with steps h and h/2 the extrapolation is (4 x(h/2) - x(h)) / 3 (L. F. Richardson,
//! Phil. Trans. R. Soc. A 210, 1911). One is explicit and keeps energy, the other implicit and damps: what both agree on is
//! the motion.

use super::report::StudyReference;
use crate::solver::{Method, rms_distance};
use nalgebra::Vector3;

/// The two methods agree well enough if their distance is this share of the smallest error.
const WELL_BELOW: f64 = 0.1;
/// Halvings of a step at most, of both methods together.
const HALVINGS: usize = 5;

/// Some frames of a motion \[m\].
#[derive(Clone, Debug)]
pub(super) struct Kept(pub(super) Vec<Vec<Vector3<f64>>>);

/// What motions are measured by.
pub(super) struct Reference {
    pub(super) motion: Kept,
    pub(super) told: StudyReference,
}

/// A method at two steps, one half the other.
struct Pair {
    method: Method,
    /// The shorter step \[s\].
    step_s: f64,
    fine: Kept,
    extrapolated: Kept,
    /// Distance between the two steps' motions \[m\].
    apart_m: f64,
}

/// A motion by a method in steps of a length \[s\], counted as so many parts; `None` if there is no time for it.
type Motion<'a> = dyn FnMut(Method, f64, f64) -> Option<Kept> + 'a;

impl Reference {
    /// Parts of a study that it counts as.
    pub(super) const PARTS: f64 = 8.0;

    /// Begins with these steps of Verlet and BDF2 \[s\]; `smallest` gives the smallest error against a reference \[m\]. `None` if not
    /// even the first pair was finished.
    pub(super) fn refined(
        [explicit, implicit]: [f64; 2],
        motion: &mut Motion<'_>,
        smallest: impl Fn(&Kept) -> f64,
    ) -> Option<Self> {
        let first = Pair::new(Method::Verlet, explicit, motion);
        let second = Pair::new(Method::Bdf2, implicit, motion);
        let (mut first, mut second) = match (first, second) {
            (Some(first), Some(second)) => (first, second),
            (Some(only), None) | (None, Some(only)) => return Some(Self::alone(only)),
            (None, None) => return None,
        };
        let agree = |a: &Pair, b: &Pair| {
            let apart = frames_apart(&a.extrapolated, &b.extrapolated);
            apart <= WELL_BELOW * smallest(&a.extrapolated)
        };
        for _ in 0..HALVINGS {
            if agree(&first, &second) {
                break;
            }
            // The one that its own steps still change more is the one to refine.
            let coarser = if first.apart_m > second.apart_m {
                &mut first
            } else {
                &mut second
            };
            if coarser.refine(motion).is_none() {
                break;
            }
        }
        Some(Self::of_both(first, &second))
    }

    fn of_both(first: Pair, second: &Pair) -> Self {
        let apart = frames_apart(&first.extrapolated, &second.extrapolated);
        let because = format!(
            "{} down to steps of {:.2e} s and {} down to {:.2e} s, each extrapolated, are {:.2e} mm apart; errors from {} times that on are certain",
            "verlet",
            first.step_s,
            "bdf2",
            second.step_s,
            1e3 * apart,
            super::motions::CERTAIN
        );
        let told = StudyReference {
            methods: vec![first.method, second.method],
            apart_m: Some(apart).filter(|d| d.is_finite()),
            uncertainty_m: Some(apart).filter(|d| d.is_finite()),
            because,
            ..StudyReference::default()
        };
        Self {
            motion: first.extrapolated,
            told,
        }
    }

    fn alone(only: Pair) -> Self {
        let name = only.method.name();
        let because = format!(
            "only {name} was finished in the time allowed, down to steps of {:.2e} s: not confirmed by a second method",
            only.step_s
        );
        let told = StudyReference {
            methods: vec![only.method],
            because,
            ..StudyReference::default()
        };
        Self {
            motion: only.extrapolated,
            told,
        }
    }
}

impl Pair {
    fn new(method: Method, step_s: f64, motion: &mut Motion<'_>) -> Option<Self> {
        let coarse = motion(method, step_s, 1.0)?;
        let fine = motion(method, 0.5 * step_s, 1.0)?;
        Some(Self::of(method, 0.5 * step_s, &coarse, fine))
    }

    fn of(method: Method, step_s: f64, coarse: &Kept, fine: Kept) -> Self {
        let extrapolate = |(fine, coarse): (&Vec<Vector3<f64>>, &Vec<Vector3<f64>>)| {
            let pairs = fine.iter().zip(coarse);
            pairs.map(|(f, c)| (f * 4.0 - c) / 3.0).collect()
        };
        Self {
            method,
            step_s,
            apart_m: frames_apart(coarse, &fine),
            extrapolated: Kept(fine.0.iter().zip(&coarse.0).map(extrapolate).collect()),
            fine,
        }
    }

    fn refine(&mut self, motion: &mut Motion<'_>) -> Option<()> {
        let finer = motion(self.method, 0.5 * self.step_s, 1.0)?;
        *self = Self::of(self.method, 0.5 * self.step_s, &self.fine, finer);
        Some(())
    }
}

/// RMS distance between two motions over all their frames and vertices \[m\].
pub(super) fn frames_apart(a: &Kept, b: &Kept) -> f64 {
    let squares =
        a.0.iter()
            .zip(&b.0)
            .map(|(x, y)| rms_distance(x, y).powi(2));
    (squares.sum::<f64>() / a.0.len().max(1) as f64).sqrt()
}
