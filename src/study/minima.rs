//! The different rest shapes that runs on one mesh led to.

use super::report::StudyMinimum;
use super::rest::Rest;
use crate::solver::{Drape, rms_distance};
use nalgebra::Vector3;

/// Shapes nearer than this are the same \[m, RMS\]: a hundredth of a millimetre is nothing on a garment.
const SAME: f64 = 1e-5;
/// Or nearer than so many times what is known of their own errors.
const ESTIMATES: f64 = 10.0;
/// Different shapes kept at most.
const KEPT: usize = 16;

/// Rest shapes that differ.
#[derive(Debug, Default)]
pub(super) struct Minima {
    known: Vec<Minimum>,
    /// The one that is listed first.
    first: usize,
}

#[derive(Debug)]
struct Minimum {
    drape: Drape,
    energy_j: f64,
    estimate_m: f64,
    runs: usize,
}

impl Minima {
    /// The number of the shape that `rest` is, a new one if need be; `None` if there are too many.
    pub(super) fn find(&mut self, rest: &Rest, is_run: bool) -> Option<usize> {
        let (shape, estimate_m) = (&rest.drape.positions, rest.estimate_m());
        let same = |known: &Minimum| {
            let near = SAME.max(ESTIMATES * (known.estimate_m + estimate_m));
            rms_distance(&known.drape.positions, shape) <= near
        };
        let number = self.known.iter().position(same).or_else(|| {
            (self.known.len() < KEPT).then(|| {
                self.known.push(Minimum {
                    drape: rest.drape.clone(),
                    energy_j: rest.energy_j(),
                    estimate_m,
                    runs: 0,
                });
                self.known.len() - 1
            })
        })?;
        self.known[number].runs += usize::from(is_run);
        Some(number)
    }

    pub(super) fn drape(&self, number: usize) -> &Drape {
        &self.known[number].drape
    }

    fn shape(&self, number: usize) -> &[Vector3<f64>] {
        &self.known[number].drape.positions
    }

    /// Distance between two of them \[m\].
    pub(super) fn apart(&self, i: usize, j: usize) -> f64 {
        rms_distance(self.shape(i), self.shape(j))
    }

    /// How near to one of them another counts as the same, at least \[m\].
    pub(super) fn uncertainty(&self, number: usize) -> f64 {
        self.known[number].estimate_m
    }

    /// Lists this one first.
    pub(super) fn make_first(&mut self, number: usize) {
        self.first = number;
    }

    /// Where a number is in the list.
    pub(super) fn place_of(&self, number: usize) -> usize {
        match number {
            n if n == self.first => 0,
            n if n < self.first => n + 1,
            n => n,
        }
    }

    pub(super) fn listed(&self) -> Vec<StudyMinimum> {
        let mut order: Vec<usize> = (0..self.known.len()).collect();
        order.sort_by_key(|&number| self.place_of(number));
        let one = |number: usize| StudyMinimum {
            energy_j: self.known[number].energy_j,
            from_reference_m: self.apart(number, self.first),
            runs: self.known[number].runs,
        };
        order.into_iter().map(one).collect()
    }
}
