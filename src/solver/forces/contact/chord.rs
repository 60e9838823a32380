//! The middles of mesh edges kept off the body: edges are chords of its curves and cut into it
//! where their ends do not.
//!
//! They feel a thinner layer than the ends do (`layer.rs`), so that nothing is added where an edge
//! sags by less than the difference. Without friction, which the ends have.

use super::layer;
use super::skin::Skin;
use crate::scene::Body;
use crate::solver::forces::active_elements::ActiveElements;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Thickness of the layer that middles of edges feel \[m\].
pub(crate) const OFFSET: f64 = 1.5e-3;

/// An edge between two particles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Chord {
    pub(crate) ends: [usize; 2],
    /// Cloth area that it stands for \[m²\].
    pub(crate) area: f64,
}

/// Contact of the middles of edges with the body.
pub(crate) struct ChordContact {
    chords: Vec<Chord>,
    skin: Skin,
    slots: Vec<Slot>,
    diagonals: Vec<usize>,
    active: ActiveElements,
}

impl ChordContact {
    /// Returns contact that carries each sample of the body on for `reuse` \[m\].
    pub(crate) fn new(body: Body, chords: Vec<Chord>, reuse: f64) -> Self {
        Self {
            skin: Skin::new(body, OFFSET, chords.len()).with_reuse(reuse),
            chords,
            slots: vec![],
            diagonals: vec![],
            active: ActiveElements::default(),
        }
    }

    /// Calls `run` with every acting chord whose middle is in the layer: its number, itself, the
    /// depth \[m\], the normal and the curvature.
    fn for_each_touching(
        &mut self,
        x: &[Vector3<f64>],
        mut run: impl FnMut(usize, &Chord, f64, &Vector3<f64>, &Matrix3<f64>),
    ) {
        let active = self.active.clone();
        active.for_each(self.chords.len(), |k| {
            let chord = &self.chords[k];
            let middle = (x[chord.ends[0]] + x[chord.ends[1]]) * 0.5;
            if let Some(sample) = self.skin.touch(k, &middle) {
                let depth = self.skin.offset - sample.distance;
                run(k, chord, depth, &sample.normal, &sample.curvature);
            }
        });
    }
}

impl Potential for ChordContact {
    fn kind(&self) -> TermKind {
        TermKind::Contact
    }

    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>) {
        pairs.extend(
            self.chords
                .iter()
                .map(|chord| (chord.ends[0], chord.ends[1])),
        );
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        let slot = |chord: &Chord| sparsity.slot(chord.ends[0], chord.ends[1]);
        self.slots = self.chords.iter().map(slot).collect();
        self.diagonals = (0..sparsity.particle_count())
            .map(|i| sparsity.diagonal(i))
            .collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.for_each_touching(x, |_, chord, depth, _, _| {
            sum += chord.area * layer::energy(depth);
        });
        sum
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        self.for_each_touching(x, |_, chord, depth, normal, _| {
            let half = normal * (0.5 * chord.area * layer::pressure(depth));
            chord.ends.iter().for_each(|&i| force[i] += half);
        });
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        let slots = std::mem::take(&mut self.slots);
        let diagonals = std::mem::take(&mut self.diagonals);
        self.for_each_touching(x, |k, chord, depth, normal, curvature| {
            let mut block = normal * normal.transpose() * layer::slope(depth);
            block -= curvature * ((1.0 - hessian_modification) * layer::pressure(depth));
            // Either end moves the middle half as far.
            block *= 0.25 * chord.area;
            hessian.add(slots[k], &block);
            for &i in &chord.ends {
                hessian.add_diagonal(diagonals[i], &block);
            }
        });
        self.slots = slots;
        self.diagonals = diagonals;
    }

    fn narrow(&mut self, moving: Option<&[bool]>) {
        let chords = &self.chords;
        self.active.narrow(moving, chords.len(), |k, moving| {
            chords[k].ends.iter().any(|&i| moving[i])
        });
    }

    fn add_stiffness_bound(&self, stiffness: &mut [f64]) {
        for chord in &self.chords {
            for &i in &chord.ends {
                stiffness[i] += 0.5 * chord.area * layer::slope(layer::DEEP);
            }
        }
    }
}
