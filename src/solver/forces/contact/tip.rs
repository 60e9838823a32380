//! Places within triangles kept off tips of the body: what stands out of it more sharply than the
//! mesh can follow comes through between the particles.
//!
//! They feel the layer that middles of edges do (`chord.rs`), without friction, which the particles
//! have.

use super::chord;
use super::layer;
use crate::scene::{Body, BodySample, Tips};
use crate::solver::forces::active_elements::ActiveElements;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Slot, Sparsity};
use nalgebra::Vector3;

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
/// Times the distance at which a tip matters up to which one is looked for.
const FAR: f64 = 4.0;
/// Pairs of corners, each with itself too.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
/// A triangle between three particles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Facet {
    pub(crate) corners: [usize; 3],
    /// Cloth area \[m²\].
    pub(crate) area: f64,
}

/// A triangle whose middle was so far from all tips.
#[derive(Clone, Copy, Debug)]
struct Clearance {
    middle: Vector3<f64>,
    /// \[m\]
    distance: f64,
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
    clearances: Vec<Clearance>,
    slots: Vec<[Slot; 6]>,
    active: ActiveElements,
}

impl TipContact {
    /// Returns contact of `facets` with those `tips` of the body; its pressure acts over `hardness`
    /// times their area.
    pub(crate) fn new(body: Body, tips: Tips, facets: Vec<Facet>, hardness: f64) -> Self {
        let never = Clearance {
            middle: Vector3::repeat(f64::INFINITY),
            distance: 0.0,
        };
        Self {
            body,
            tips,
            clearances: vec![never; facets.len()],
            facets,
            hardness,
            slots: Vec::new(),
            active: ActiveElements::default(),
        }
    }

    /// Returns true if triangle `k` may reach a tip.
    fn is_near(&mut self, k: usize, corners: &[Vector3<f64>; 3]) -> bool {
        let middle = corners.iter().sum::<Vector3<f64>>() / 3.0;
        let far = corners.iter().map(|corner| (corner - middle).norm());
        let needed = far.fold(0.0, f64::max) + chord::OFFSET;
        let known = self.clearances[k];
        // Infinite where nothing was looked for yet.
        if (middle - known.middle).norm() < known.distance - needed {
            return false;
        }
        let distance = self.tips.distance(&middle, FAR * needed);
        self.clearances[k] = Clearance { middle, distance };
        distance < needed
    }

    /// Calls `run` with every place of an acting triangle near a tip that is in the layer.
    fn for_each_touching(&mut self, x: &[Vector3<f64>], mut run: impl FnMut(&Touch<'_>)) {
        let active = self.active.clone();
        active.for_each(self.facets.len(), |number| {
            let facet = self.facets[number];
            let corners = facet.corners.map(|i| x[i]);
            if !self.is_near(number, &corners) {
                return;
            }
            for parts in &PLACES {
                let sample = self.body.sample(&place(&corners, parts));
                let Some(sample) = sample.filter(|sample| sample.distance < chord::OFFSET) else {
                    continue;
                };
                run(&Touch {
                    number,
                    corners: &facet.corners,
                    parts,
                    // A tip may be narrower than what lies between two places.
                    area: facet.area / 3.0 * self.hardness,
                    depth: chord::OFFSET - sample.distance,
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
        let slots = std::mem::take(&mut self.slots);
        self.for_each_touching(x, |touch| {
            let BodySample {
                normal, curvature, ..
            } = touch.sample;
            let mut block = normal * normal.transpose() * layer::slope(touch.depth);
            block -= curvature * ((1.0 - hessian_modification) * layer::pressure(touch.depth));
            block *= touch.area;
            for (&(i, j), &slot) in PAIRS.iter().zip(&slots[touch.number]) {
                hessian.add(slot, &(block * (touch.parts[i] * touch.parts[j])));
            }
        });
        self.slots = slots;
    }

    fn narrow(&mut self, moving: Option<&[bool]>) {
        let facets = &self.facets;
        self.active.narrow(moving, facets.len(), |k, moving| {
            facets[k].corners.iter().any(|&i| moving[i])
        });
    }

    fn add_stiffness_bound(&self, _stiffness: &mut [f64]) {
        // Few triangles are near tips, and what is there is kept off by particles as well.
    }
}
