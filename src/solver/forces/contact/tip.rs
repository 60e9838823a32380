//! Places within triangles kept off tips of the body: what stands out of it more sharply than the
//! mesh can follow comes through between the particles.
//!
//! They feel a layer about as thick as particles do: a tip that is between two places still is
//! nearer to the cloth than they are. Which triangles are near a tip is that of the last accepted
//! step (lagged), so that within a step there is one energy. Without friction, which the particles
//! have.

use super::layer;
use crate::scene::{Body, BodySample, Tips};
use crate::solver::forces::active_elements::ActiveElements;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::Vector3;

/// Thickness of the layer \[m\].
const OFFSET: f64 = 2e-3;
/// Parts of the corners in each place: quarters of the edges, whose middles have contact of their
/// own, and what is between them.
const PLACES: [[f64; 3]; 9] = [
    [0.75, 0.25, 0.0],
    [0.25, 0.75, 0.0],
    [0.0, 0.75, 0.25],
    [0.0, 0.25, 0.75],
    [0.25, 0.0, 0.75],
    [0.75, 0.0, 0.25],
    [0.5, 0.25, 0.25],
    [0.25, 0.5, 0.25],
    [0.25, 0.25, 0.5],
];
/// Distance between a triangle's circle and a tip up to which they are near \[m\]: most steps move
/// less.
const NEAR: f64 = 0.01;
/// Pairs of corners, each with itself too.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
/// A triangle between three particles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Facet {
    pub(crate) corners: [usize; 3],
    /// Cloth area \[m²\].
    pub(crate) area: f64,
}

/// A place within a triangle that is in the layer.
struct Touch<'a> {
    number: usize,
    corners: &'a [usize; 3],
    /// Part of each corner in the place.
    parts: &'a [f64; 3],
    /// Cloth area that the place stands for \[m²\].
    area: f64,
    /// \[m\]
    depth: f64,
    sample: BodySample,
}

/// Contact of places within triangles with tips of the body.
pub(crate) struct TipContact {
    body: Body,
    tips: Tips,
    facets: Vec<Facet>,
    hardness: f64,
    /// Numbers of the triangles near a tip.
    near: Vec<usize>,
    slots: Vec<[Slot; 6]>,
    active: ActiveElements,
}

impl TipContact {
    /// Returns contact of `facets` with those `tips` of the body; its pressure acts over `hardness`
    /// times their area.
    pub(crate) fn new(body: Body, tips: Tips, facets: Vec<Facet>, hardness: f64) -> Self {
        Self {
            body,
            tips,
            near: Vec::new(),
            facets,
            hardness,
            slots: Vec::new(),
            active: ActiveElements::default(),
        }
    }

    /// Returns true if a tip is near a triangle.
    fn is_near(&self, facet: &Facet, x: &[Vector3<f64>]) -> bool {
        let corners = facet.corners.map(|i| x[i]);
        let middle = corners.iter().sum::<Vector3<f64>>() / 3.0;
        let far = corners.iter().map(|corner| (corner - middle).norm());
        let within = far.fold(0.0, f64::max) + NEAR;
        self.tips.distance(&middle, within) < within
    }

    /// Calls `run` with every place of an acting triangle near a tip that is in the layer.
    fn for_each_touching(&self, x: &[Vector3<f64>], mut run: impl FnMut(&Touch<'_>)) {
        self.active.for_each(self.near.len(), |k| {
            let number = self.near[k];
            let facet = &self.facets[number];
            let corners = facet.corners.map(|i| x[i]);
            for parts in &PLACES {
                let sample = self.body.sample(&place(&corners, parts));
                let Some(sample) = sample.filter(|sample| sample.distance < OFFSET) else {
                    continue;
                };
                run(&Touch {
                    number,
                    corners: &facet.corners,
                    parts,
                    // A tip may be narrower than what lies between two places.
                    area: facet.area / 3.0 * self.hardness,
                    depth: OFFSET - sample.distance,
                    sample,
                });
            }
        });
    }
}

fn place(corners: &[Vector3<f64>; 3], parts: &[f64; 3]) -> Vector3<f64> {
    corners[0] * parts[0] + corners[1] * parts[1] + corners[2] * parts[2]
}

impl Potential for TipContact {
    fn kind(&self) -> TermKind {
        TermKind::Contact
    }

    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>) {
        for facet in &self.facets {
            let pair = |&(i, j): &(usize, usize)| (facet.corners[i], facet.corners[j]);
            pairs.extend(PAIRS[3..].iter().map(pair));
        }
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        let slots =
            |facet: &Facet| PAIRS.map(|(i, j)| sparsity.slot(facet.corners[i], facet.corners[j]));
        self.slots = self.facets.iter().map(slots).collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        self.for_each_touching(x, |touch| sum += touch.area * layer::energy(touch.depth));
        sum
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        self.for_each_touching(x, |touch| {
            let whole = touch.sample.normal * (touch.area * layer::pressure(touch.depth));
            for (&i, part) in touch.corners.iter().zip(touch.parts) {
                force[i] += whole * *part;
            }
        });
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        self.for_each_touching(x, |touch| {
            let BodySample {
                normal, curvature, ..
            } = touch.sample;
            let mut block = normal * normal.transpose() * layer::slope(touch.depth);
            block -= curvature * ((1.0 - hessian_modification) * layer::pressure(touch.depth));
            block *= touch.area;
            for (&(i, j), &slot) in PAIRS.iter().zip(&self.slots[touch.number]) {
                hessian.add(slot, &(block * (touch.parts[i] * touch.parts[j])));
            }
        });
    }

    fn narrow(&mut self, moving: Option<&[bool]>) {
        let (near, facets) = (&self.near, &self.facets);
        self.active.narrow(moving, near.len(), |k, moving| {
            let corners = &facets[near[k]].corners;
            corners.iter().any(|&i| moving[i])
        });
    }

    fn add_stiffness_bound(&self, _stiffness: &mut [f64]) {
        // Few triangles are near tips, and what is there is kept off by particles as well.
    }

    /// Finds anew which triangles are near a tip.
    fn accept(&mut self, x: &[Vector3<f64>]) -> bool {
        let near = |number: &usize| self.is_near(&self.facets[*number], x);
        self.near = (0..self.facets.len()).filter(near).collect();
        false
    }
}
