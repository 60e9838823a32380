//! The reference of motions: Verlet and BDF2, each extrapolated to steps of zero, refined until
//! they agree well below the errors that are to be measured.
//!
//! Both are of order 2, so of two motions with steps h and h/2 the extrapolation is (4 x(h/2) -
//! x(h)) / 3 (L. F. Richardson, Phil. Trans. R. Soc. A 210, 1911). One is explicit and keeps
//! energy, the other implicit and damps: what both agree on is the motion.

use super::finding::ReferenceFinding;
use crate::solver::{Method, rms_distance};
use nalgebra::Vector3;

/// The two methods agree well enough if their distance is this share of the smallest error.
const WELL_BELOW: f64 = 0.1;
/// Halvings of a step at most, of both methods together.
const HALVINGS: usize = 5;

/// Some frames of a motion \[m\].
#[derive(Clone, Debug)]
pub(super) struct MotionFrames(pub(super) Vec<Vec<Vector3<f64>>>);

impl MotionFrames {
    /// Returns the RMS distance to another motion over all frames and vertices \[m\].
    pub(super) fn distance(&self, other: &Self) -> f64 {
        let frames = self.0.iter().zip(&other.0);
        let squares = frames.map(|(x, y)| rms_distance(x, y).powi(2));
        (squares.sum::<f64>() / self.0.len().max(1) as f64).sqrt()
    }
}

/// The motion that others are measured by.
pub(super) struct MotionReference {
    pub(super) frames: MotionFrames,
    /// The methods that were finished.
    pub(super) methods: Vec<Method>,
    /// Distance between the two \[m\], if there are two and it is finite.
    pub(super) apart_m: Option<f64>,
    pub(super) finding: ReferenceFinding,
}

/// A method at two steps, one half the other.
struct ExtrapolatedMotion {
    method: Method,
    /// The shorter step \[s\].
    step_s: f64,
    fine: MotionFrames,
    extrapolated: MotionFrames,
    /// Distance between the two steps' motions \[m\].
    apart_m: f64,
}

/// Makes a motion by a method in steps of a length \[s\], a part of a weight; returns none if there
/// is no time for it.
type MakeMotion<'a> = dyn FnMut(Method, f64, f64) -> Option<MotionFrames> + 'a;

impl MotionReference {
    /// Weight of the reference among the parts of a study.
    pub(super) const WEIGHT: f64 = 8.0;

    /// Begins with these steps of Verlet and BDF2 \[s\], and refines them until they agree well
    /// below the error that `smallest` returns: the smallest one against a reference \[m\]. Returns
    /// none if not even the first pair was finished.
    pub(super) fn refined(
        [explicit, implicit]: [f64; 2],
        motion: &mut MakeMotion<'_>,
        smallest: impl Fn(&MotionFrames) -> f64,
    ) -> Option<Self> {
        let first = ExtrapolatedMotion::new(Method::Verlet, explicit, motion);
        let second = ExtrapolatedMotion::new(Method::Bdf2, implicit, motion);
        let (mut first, mut second) = match (first, second) {
            (Some(first), Some(second)) => (first, second),
            (Some(only), None) | (None, Some(only)) => return Some(Self::of_one(only)),
            (None, None) => return None,
        };
        for _ in 0..HALVINGS {
            let apart = first.extrapolated.distance(&second.extrapolated);
            if apart <= WELL_BELOW * smallest(&first.extrapolated) {
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
        Some(Self::of_two(first, &second))
    }

    fn of_two(first: ExtrapolatedMotion, second: &ExtrapolatedMotion) -> Self {
        let apart_m = first.extrapolated.distance(&second.extrapolated);
        Self {
            frames: first.extrapolated,
            methods: vec![first.method, second.method],
            apart_m: Some(apart_m).filter(|d| d.is_finite()),
            finding: ReferenceFinding::TwoMotions {
                methods: [(first.method, first.step_s), (second.method, second.step_s)],
                apart_m,
            },
        }
    }

    fn of_one(only: ExtrapolatedMotion) -> Self {
        Self {
            frames: only.extrapolated,
            methods: vec![only.method],
            apart_m: None,
            finding: ReferenceFinding::OneMotion(only.method, only.step_s),
        }
    }
}

impl ExtrapolatedMotion {
    fn new(method: Method, step_s: f64, motion: &mut MakeMotion<'_>) -> Option<Self> {
        let coarse = motion(method, step_s, 1.0)?;
        let fine = motion(method, 0.5 * step_s, 1.0)?;
        Some(Self::of(method, 0.5 * step_s, &coarse, fine))
    }

    fn of(method: Method, step_s: f64, coarse: &MotionFrames, fine: MotionFrames) -> Self {
        let frames = fine.0.iter().zip(&coarse.0);
        let extrapolated = frames.map(|(fine, coarse)| extrapolate(fine, coarse));
        Self {
            method,
            step_s,
            apart_m: coarse.distance(&fine),
            extrapolated: MotionFrames(extrapolated.collect()),
            fine,
        }
    }

    fn refine(&mut self, motion: &mut MakeMotion<'_>) -> Option<()> {
        let finer = motion(self.method, 0.5 * self.step_s, 1.0)?;
        *self = Self::of(self.method, 0.5 * self.step_s, &self.fine, finer);
        Some(())
    }
}

/// Extrapolates two shapes to steps of zero: the error of either falls with the square of its step.
fn extrapolate(fine: &[Vector3<f64>], coarse: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    let pairs = fine.iter().zip(coarse);
    pairs.map(|(f, c)| (f * 4.0 - c) / 3.0).collect()
}
