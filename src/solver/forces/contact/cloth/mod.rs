//! Contact of cloth with cloth.
//!
//! Vertices and triangles, and edges, that come nearer to each other than the cloth is thick press
//! each other apart as `law.rs` says, over the cloth area of the vertex or of the edges. Distances
//! have no sign: what was apart must not pass through each other, so every move of the particles is
//! cut where it would (`confine.rs`), each particle for itself. What passes through each other at
//! the start is pulled out first (`untangle.rs`).
//!
//! Cloth that does not move, such as that of a garment worn beneath, is part of the surface: its
//! vertices are numbered after the particles, and nothing is added for them to forces and Hessians
//! (`fixed.rs`).
//!
//! Layers that touch stick to each other and slip (`friction.rs`), unless they have no friction.
//!
//! # Limitations
//! Features that meet in the first place, and cannot be pulled apart, do not press on each other.

mod advance;
mod boxes;
mod candidates;
mod confine;
mod coupling;
mod fixed;
mod friction;
mod law;
mod proximity;
mod separate;
mod surface;
mod swept_boxes;
mod untangle;

pub(crate) use self::surface::{ClothSurface, LayerOrder};

use self::candidates::{Candidates, FeaturePair};
use self::coupling::{add_blocks, is_coupled};
use self::fixed::AllPositions;
use self::friction::LayerFriction;
use self::law::respond;
use self::proximity::{Features, Proximity, sine_squared};
use self::surface::ContactSurface;
use self::swept_boxes::SweptMotion;
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::Vector3;

/// Sine squared of the angle between edges from which on they act in full. Parallel edges have no
/// closest points; the vertices at their ends act for them.
const NOT_PARALLEL: f64 = 1e-2;
/// Distance beside its way that a particle may move before pairs are sought anew: the thickness,
/// and at least so much \[m\].
const LEAST_SLACK: f64 = 1e-3;
/// Distance beyond the thickness within which pairs are coupled in the matrices: the thickness
/// again, and at least so much \[m\].
const LEAST_MARGIN: f64 = 5e-4;

/// Distance below which features have no direction in which to press each other apart \[m\]: they
/// met in the first place.
const NONE: f64 = 1e-15;

/// Contact of a garment with itself, and with cloth that does not move.
pub(crate) struct ClothContact {
    surface: ContactSurface,
    particle_count: usize,
    /// Where a move begins, or the shape at hand, with fixed cloth.
    at: AllPositions,
    /// Where a move ends, with fixed cloth.
    end: AllPositions,
    /// Cloth area of each particle \[m²\]; `#P + #F`.
    area: Vec<f64>,
    /// The last accepted shape \[m\], of which the weights are; `#P + #F`.
    accepted: Vec<Vector3<f64>>,
    candidates: Candidates,
    /// The particles that alone move, if not all do.
    moving: Option<Vec<bool>>,
    /// Candidates with a particle that moves.
    active: Vec<usize>,
    /// Corners of the pairs that touch in the accepted shape.
    touching: Vec<[usize; 4]>,
    /// Corners of the pairs that are coupled in the matrices.
    coupled: Vec<[usize; 4]>,
    friction: Option<LayerFriction>,
    sparsity: Option<Sparsity>,
    has_outgrown: bool,
}

impl ClothContact {
    /// Returns the contact of a surface whose particles stand for `area` each \[m²\].
    pub(crate) fn new(surface: ClothSurface, area: Vec<f64>) -> Self {
        let particles = area.len() - surface.fixed.len();
        let positions = AllPositions::new(particles, &surface.fixed);
        Self {
            surface: ContactSurface::new(surface),
            particle_count: particles,
            at: positions.clone(),
            end: positions,
            area,
            accepted: vec![],
            candidates: Candidates::default(),
            moving: None,
            active: vec![],
            touching: vec![],
            coupled: vec![],
            friction: None,
            sparsity: None,
            has_outgrown: false,
        }
    }

    /// Returns the same contact with friction of this coefficient at each particle, if any.
    pub(crate) fn with_friction(mut self, coefficient: Option<Vec<f64>>) -> Self {
        self.friction = coefficient.map(LayerFriction::new);
        self
    }

    /// Sees to it that all pairs are known that may meet between `from` and `to`.
    fn cover(&mut self, from: &[Vector3<f64>], to: &[Vector3<f64>]) {
        if self.candidates.cover(from) && self.candidates.cover(to) {
            return;
        }
        let slack = self.surface.most_thickness().max(LEAST_SLACK);
        let motion = SweptMotion { from, to, slack };
        let stayed = self.candidates.update(&self.surface, &motion);
        if self.accepted.is_empty() {
            self.accepted = from.to_vec();
        }
        self.weigh(stayed);
        self.select();
    }

    /// Computes the weights of the candidates from number `first` on in the accepted shape: like
    /// the normal forces of friction, they stay as they are within a step.
    fn weigh(&mut self, first: usize) {
        for pair in &mut self.candidates.pairs[first..] {
            pair.weight = match pair.features {
                Features::VertexTriangle => self.area[pair.corners[0]],
                Features::Edges => {
                    let [a, b, c, d] = pair.corners.map(|i| self.area[i]);
                    let sine = sine_squared(&pair.gather(&self.accepted));
                    let share = (sine / NOT_PARALLEL).min(1.0);
                    0.5 * (a + b).min(c + d) * share * share * (3.0 - 2.0 * share)
                }
            };
        }
    }

    /// Selects the candidates with a particle that moves.
    fn select(&mut self) {
        let pairs = self.candidates.pairs.iter().enumerate();
        let moves = |pair: &FeaturePair| match &self.moving {
            None => true,
            // Fixed cloth, which comes after the particles, does not.
            Some(moving) => pair.corners.iter().any(|&i| moving.get(i) == Some(&true)),
        };
        let active = pairs.filter(|(_, pair)| moves(pair));
        self.active = active.map(|(k, _)| k).collect();
    }

    /// Runs `look` on the positions of the particles, which are `x`, and of fixed cloth \[m\].
    fn with_fixed<T>(
        &mut self,
        x: &[Vector3<f64>],
        look: impl FnOnce(&mut Self, &[Vector3<f64>]) -> T,
    ) -> T {
        let mut at = std::mem::take(&mut self.at);
        let result = look(self, at.with(x));
        self.at = at;
        result
    }

    /// Calls `run` with every acting pair that touches at `x` and its closest points.
    fn for_each_touching(
        &mut self,
        x: &[Vector3<f64>],
        mut run: impl FnMut(&FeaturePair, &Proximity),
    ) {
        self.cover(x, x);
        let moved = self.candidates.moved(x);
        for &k in &self.active {
            let pair = &self.candidates.pairs[k];
            if pair.distance - pair.approach(&moved) >= pair.thickness {
                continue;
            }
            let proximity = pair.proximity(x);
            if (NONE..pair.thickness).contains(&proximity.distance()) {
                run(pair, &proximity);
            }
        }
    }

    /// Ties the pairs that touch at `x`; returns true if any slipped on the way there.
    fn tie(&mut self, x: &[Vector3<f64>]) -> bool {
        let Some(mut friction) = self.friction.take() else {
            return false;
        };
        let mut renewal = friction.renew(x);
        self.for_each_touching(x, |pair, proximity| renewal.tie(pair, proximity));
        let slipped = renewal.finish();
        self.friction = Some(friction);
        slipped
    }

    /// Takes stock of the pairs that touch at `x`, and of those that are to be coupled with them.
    fn couple(&mut self, x: &[Vector3<f64>]) {
        self.touching.clear();
        let margin = self.surface.most_thickness().max(LEAST_MARGIN);
        let moved = self.candidates.moved(x);
        let mut near = vec![];
        for pair in &self.candidates.pairs {
            let reach = pair.thickness + margin;
            if pair.distance - pair.approach(&moved) >= reach {
                continue;
            }
            let distance = pair.proximity(x).distance();
            if distance < reach {
                near.push(pair.corners);
            }
            if distance < pair.thickness {
                self.touching.push(pair.corners);
            }
        }
        // Pairs are in the order in which they were found.
        self.touching.sort_unstable();
        let is_coupled = |corners: &[usize; 4]| {
            let sparsity = self.sparsity.as_ref();
            sparsity.is_some_and(|sparsity| is_coupled(sparsity, corners))
        };
        self.has_outgrown = !self.touching.iter().all(is_coupled);
        if self.has_outgrown {
            self.coupled = near;
        }
    }
}

/// Adds the second derivative of a pair's energy to `hessian`.
fn add_pair(
    (pair, proximity): (&FeaturePair, &Proximity),
    hessian_modification: f64,
    sparsity: &Sparsity,
    hessian: &mut BlockMatrix,
) {
    let response = respond(proximity.distance(), pair.thickness);
    let normal = proximity.normal();
    let across = normal * normal.transpose();
    let stiff = pair.weight * response.slope;
    let pushed = pair.weight * response.pressure / proximity.distance();
    let bent = (1.0 - hessian_modification) * pushed;
    let c = proximity.coefficients;
    let block = |i: usize, j: usize| {
        let of_normal = across * (c[i] * c[j]);
        let turning = proximity.half_square_block(i, j) - of_normal;
        of_normal * stiff - turning * bent
    };
    // (sum c_i d_i)² <= sum |c_i| sum |c_i| d_i², and the first sum is 2.
    let bound = |i: usize| across * (2.0 * c[i].abs() * stiff);
    add_blocks((sparsity, hessian), &pair.corners, block, bound);
}

impl Potential for ClothContact {
    fn kind(&self) -> TermKind {
        TermKind::SelfContact
    }

    fn add_coupled_pairs(&self, pairs: &mut Vec<(usize, usize)>) {
        let count = self.particle_count;
        for corners in &self.coupled {
            for i in (0..4).filter(|i| corners[*i] < count) {
                let others = corners[..i].iter().filter(|j| **j < count);
                pairs.extend(others.map(|j| (corners[i], *j)));
            }
        }
    }

    fn bind(&mut self, sparsity: &Sparsity) {
        self.sparsity = Some(sparsity.clone());
        self.has_outgrown = false;
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        self.with_fixed(x, |contact, x| {
            let mut sum = 0.0;
            contact.for_each_touching(x, |pair, proximity| {
                sum += pair.weight * respond(proximity.distance(), pair.thickness).energy;
            });
            sum + contact.friction.as_ref().map_or(0.0, |f| f.energy(x))
        })
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        self.with_fixed(x, |contact, x| {
            contact.for_each_touching(x, |pair, proximity| {
                let pressure = respond(proximity.distance(), pair.thickness).pressure;
                let push = proximity.normal() * (pair.weight * pressure);
                for (&i, c) in pair.corners.iter().zip(proximity.coefficients) {
                    if let Some(force) = force.get_mut(i) {
                        *force += push * c;
                    }
                }
            });
            if let Some(friction) = &contact.friction {
                friction.add_force(x, force);
            }
        });
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        let Some(sparsity) = self.sparsity.take() else {
            return;
        };
        self.with_fixed(x, |contact, x| {
            contact.for_each_touching(x, |pair, proximity| {
                add_pair((pair, proximity), hessian_modification, &sparsity, hessian);
            });
            if let Some(friction) = &contact.friction {
                friction.add_hessian(x, &sparsity, hessian);
            }
        });
        self.sparsity = Some(sparsity);
    }

    fn narrow(&mut self, moving: Option<&[bool]>) {
        self.moving = moving.map(<[bool]>::to_vec);
        self.select();
        if let Some(friction) = &mut self.friction {
            friction.narrow(moving);
        }
    }

    /// Adds nothing: in the rest shape nothing touches, and explicit steps have no such contact.
    fn add_stiffness_bound(&self, _stiffness: &mut [f64]) {}

    /// Takes new weights, and ties what touches; returns true if other pairs touch than before, or
    /// any slipped.
    fn accept(&mut self, x: &[Vector3<f64>]) -> bool {
        self.with_fixed(x, |contact, x| {
            contact.accepted.clear();
            contact.accepted.extend_from_slice(x);
            contact.cover(x, x);
            contact.weigh(0);
            let before = std::mem::take(&mut contact.touching);
            contact.couple(x);
            let slipped = contact.tie(x);
            slipped || contact.touching != before
        })
    }

    fn has_outgrown(&self) -> bool {
        self.has_outgrown
    }

    fn confine(&mut self, from: &[Vector3<f64>], to: &mut [Vector3<f64>]) {
        let mut end = std::mem::take(&mut self.end);
        self.with_fixed(from, |contact, from| {
            end.edit(to, |to| {
                contact.cover(from, to);
                confine::confine(&contact.candidates, &contact.active, from, to);
            });
        });
        self.end = end;
    }

    fn untangle(&mut self, x: &mut [Vector3<f64>], is_fixed: &[bool]) -> bool {
        let surface = &self.surface;
        let mut all_fixed = is_fixed.to_vec();
        all_fixed.resize(self.area.len(), true);
        let is_fixed = &*all_fixed;
        self.end.edit(x, |x| {
            let was_tangled = untangle::untangle(surface, x, is_fixed);
            separate::separate(surface, x, is_fixed);
            was_tangled
        })
    }
}

#[cfg(test)]
mod candidate_tests;
#[cfg(test)]
mod fixed_tests;
#[cfg(test)]
mod tests;
