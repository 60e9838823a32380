//! The different rest shapes that runs on one mesh led to.

use super::report::StudyMinimum;
use super::rest_shape::RestShape;
use crate::solver::{Drape, rms_distance};
use nalgebra::Vector3;

/// Shapes nearer than this are the same \[m, RMS\]: a hundredth of a millimeter is nothing on a
/// garment.
const SAME_M: f64 = 1e-5;
/// Shapes are also the same if they are nearer than this many times the estimates of their own
/// errors.
const SAME_ESTIMATES: f64 = 10.0;
/// The most different shapes that are kept.
const MOST_KEPT: usize = 16;

/// Rest shapes that differ.
#[derive(Debug, Default)]
pub(super) struct RestShapes {
    known: Vec<KnownRestShape>,
    /// The one that is listed first.
    first: usize,
}

#[derive(Debug)]
struct KnownRestShape {
    drape: Drape,
    energy_j: f64,
    estimate_m: f64,
    runs: usize,
}

impl RestShapes {
    /// Returns the number of the shape that `rest` is, a new one if need be; none if there are too
    /// many.
    pub(super) fn find_or_add(&mut self, rest: &RestShape, is_run: bool) -> Option<usize> {
        let number = self.find(rest).or_else(|| self.add(rest))?;
        self.known[number].runs += usize::from(is_run);
        Some(number)
    }

    fn find(&self, rest: &RestShape) -> Option<usize> {
        let (shape, estimate_m) = (&rest.drape.positions, rest.estimate_m());
        self.known.iter().position(|known| {
            let near = SAME_M.max(SAME_ESTIMATES * (known.estimate_m + estimate_m));
            rms_distance(&known.drape.positions, shape) <= near
        })
    }

    fn add(&mut self, rest: &RestShape) -> Option<usize> {
        if self.known.len() == MOST_KEPT {
            return None;
        }
        self.known.push(KnownRestShape {
            drape: rest.drape.clone(),
            energy_j: rest.energy_j(),
            estimate_m: rest.estimate_m(),
            runs: 0,
        });
        Some(self.known.len() - 1)
    }

    pub(super) fn drape(&self, number: usize) -> &Drape {
        &self.known[number].drape
    }

    fn shape(&self, number: usize) -> &[Vector3<f64>] {
        &self.known[number].drape.positions
    }

    /// Returns the distance between two of them \[m\].
    pub(super) fn distance(&self, i: usize, j: usize) -> f64 {
        rms_distance(self.shape(i), self.shape(j))
    }

    /// Returns the estimate of a shape's own error \[m\].
    pub(super) fn uncertainty(&self, number: usize) -> f64 {
        self.known[number].estimate_m
    }

    /// Lists this one first.
    pub(super) fn make_first(&mut self, number: usize) {
        self.first = number;
    }

    /// Returns the place of a number in the list.
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
        let listed = order.into_iter().map(|number| StudyMinimum {
            energy_j: self.known[number].energy_j,
            from_reference_m: self.distance(number, self.first),
            runs: self.known[number].runs,
        });
        listed.collect()
    }
}
