//! Cloth kept off the body by a stiff layer on its skin, with Coulomb friction that sticks and
//! slips.
//!
//! A particle nearer to the body than `offset` is pressed out as `layer.rs` says, over the cloth
//! area of the particle. A particle in contact is tied to an anchor on the body by a tangential
//! spring that gives way at μ N (P. A. Cundall, O. D. L. Strack, "A discrete numerical model for
//! granular assemblies", Géotechnique 29(1), 1979): energy k/2 |u|² up to the slip s = μ N / k, μ N
//! (|u| - s/2) beyond. N and the anchors are those of the last accepted step (lagged), so that
//! within a step friction has an energy.

use crate::scene::Body;
use crate::solver::forces::active_elements::ActiveElements;
use crate::solver::forces::contact::layer;
use crate::solver::forces::contact::skin::Skin;
use crate::solver::forces::friction_anchors::{FrictionAnchor, FrictionAnchors};
use crate::solver::forces::{Potential, TermKind};
use crate::solver::linalg::block_matrix::{BlockMatrix, Sparsity};
use nalgebra::{Matrix3, Vector3};

/// Slip of one step that is more than rounding \[m\].
const SLIP_FELT: f64 = 1e-7;

/// Friction of the particles in contact.
#[derive(Clone, Debug)]
pub(crate) struct Friction {
    coefficient: f64,
    anchors: Vec<Option<FrictionAnchor>>,
}

impl Friction {
    pub(crate) fn new(coefficient: f64, particle_count: usize) -> Self {
        Self {
            coefficient,
            anchors: vec![None; particle_count],
        }
    }

    /// Returns the same friction with these anchors; with anchors of another number of particles it
    /// begins anew.
    pub(crate) fn with_anchors(mut self, anchors: &FrictionAnchors) -> Self {
        if anchors.0.len() == self.anchors.len() {
            self.anchors.clone_from(&anchors.0);
        }
        self
    }
}

/// Contact of all particles with the body.
pub(crate) struct BodyContact {
    skin: Skin,
    /// Cloth area of each particle \[m²\].
    area: Vec<f64>,
    friction: Option<Friction>,
    diagonals: Vec<usize>,
    active: ActiveElements,
}

impl BodyContact {
    /// Returns contact that keeps particles of cloth area `area` \[m²\] at `offset` \[m\] from the
    /// body.
    pub(crate) fn new(body: Body, offset: f64, area: &[f64]) -> Self {
        Self {
            skin: Skin::new(body, offset, area.len()),
            area: area.to_vec(),
            friction: None,
            diagonals: Vec::new(),
            active: ActiveElements::default(),
        }
    }

    /// Returns the same contact with friction.
    pub(crate) fn with_friction(mut self, friction: Option<Friction>) -> Self {
        self.friction = friction;
        self
    }

    /// Returns the same contact that carries each sample on for `reuse` \[m\]: for explicit steps,
    /// which are many and small.
    pub(crate) fn with_reuse(mut self, reuse: f64) -> Self {
        self.skin = self.skin.with_reuse(reuse);
        self
    }

    fn anchor(&self, i: usize) -> Option<FrictionAnchor> {
        self.friction.as_ref()?.anchors[i]
    }
}

fn tangential(v: &Vector3<f64>, normal: &Vector3<f64>) -> Vector3<f64> {
    v - normal * normal.dot(v)
}

impl Potential for BodyContact {
    fn kind(&self) -> TermKind {
        TermKind::Contact
    }

    fn add_coupled_pairs(&self, _pairs: &mut Vec<(usize, usize)>) {}

    fn bind(&mut self, sparsity: &Sparsity) {
        self.diagonals = (0..sparsity.particle_count())
            .map(|i| sparsity.diagonal(i))
            .collect();
    }

    fn energy(&mut self, x: &[Vector3<f64>]) -> f64 {
        let mut sum = 0.0;
        let active = self.active.clone();
        active.for_each(x.len(), |i| {
            let position = &x[i];
            let k = self.area[i] * layer::TANGENTIAL;
            if let Some(sample) = self.skin.touch(i, position) {
                sum += self.area[i] * layer::energy(self.skin.offset - sample.distance);
            }
            if let Some(anchor) = self.anchor(i) {
                let u = tangential(&(position - anchor.point), &anchor.normal).norm();
                let slip = anchor.limit / k;
                sum += if u <= slip {
                    0.5 * k * u * u
                } else {
                    anchor.limit * (u - 0.5 * slip)
                };
            }
        });
        sum
    }

    fn add_force(&mut self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        let active = self.active.clone();
        active.for_each(x.len(), |i| {
            let position = &x[i];
            let k = self.area[i] * layer::TANGENTIAL;
            if let Some(sample) = self.skin.touch(i, position) {
                force[i] += sample.normal
                    * (self.area[i] * layer::pressure(self.skin.offset - sample.distance));
            }
            if let Some(anchor) = self.anchor(i) {
                let u = tangential(&(position - anchor.point), &anchor.normal);
                let length = u.norm();
                force[i] -= u * if k * length <= anchor.limit {
                    k
                } else {
                    anchor.limit / length
                };
            }
        });
    }

    fn add_hessian(
        &mut self,
        x: &[Vector3<f64>],
        hessian_modification: f64,
        hessian: &mut BlockMatrix,
    ) {
        let active = self.active.clone();
        active.for_each(x.len(), |i| {
            let position = &x[i];
            let k = self.area[i] * layer::TANGENTIAL;
            if let Some(sample) = self.skin.touch(i, position) {
                let depth = self.skin.offset - sample.distance;
                let mut block = sample.normal * sample.normal.transpose() * layer::slope(depth);
                block -= sample.curvature * ((1.0 - hessian_modification) * layer::pressure(depth));
                block *= self.area[i];
                hessian.add_diagonal(self.diagonals[i], &block);
            }
            if let Some(anchor) = self.anchor(i) {
                let u = tangential(&(position - anchor.point), &anchor.normal);
                let length = u.norm();
                let mut block = Matrix3::identity() - anchor.normal * anchor.normal.transpose();
                if length == 0.0 || (k * length <= anchor.limit && !anchor.slipping) {
                    block *= k;
                } else {
                    let along = u / length;
                    block = (block - along * along.transpose()) * (anchor.limit / length);
                }
                hessian.add_diagonal(self.diagonals[i], &block);
            }
        });
    }

    fn narrow(&mut self, moving: Option<&[bool]>) {
        self.active
            .narrow(moving, self.area.len(), |i, moving| moving[i]);
    }

    fn add_stiffness_bound(&self, stiffness: &mut [f64]) {
        let sticking = if self.friction.is_some() {
            layer::TANGENTIAL
        } else {
            0.0
        };
        for (sum, area) in stiffness.iter_mut().zip(&self.area) {
            *sum += area * (layer::slope(layer::DEEP) + sticking);
        }
    }

    /// Takes new normal forces, and drags the anchors along by what slipped.
    fn accept(&mut self, x: &[Vector3<f64>]) -> bool {
        let mut slipped = false;
        let Some(mut friction) = self.friction.take() else {
            return slipped;
        };
        for (i, position) in x.iter().enumerate() {
            let Some(sample) = self.skin.touch(i, position) else {
                friction.anchors[i] = None;
                continue;
            };
            let stiffness = self.area[i] * layer::TANGENTIAL;
            let normal = sample.normal.normalize();
            let limit = friction.coefficient
                * self.area[i]
                * layer::pressure(self.skin.offset - sample.distance);
            let mut point = friction.anchors[i].map_or(*position, |a| a.point);
            let u = tangential(&(position - point), &normal);
            let slip = limit / stiffness;
            let slipping = u.norm() > slip;
            slipped |= u.norm() > slip + SLIP_FELT;
            point = position - if slipping { u * (slip / u.norm()) } else { u };
            friction.anchors[i] = Some(FrictionAnchor {
                point,
                normal,
                limit,
                slipping,
            });
        }
        self.friction = Some(friction);
        slipped
    }

    fn mark_touching(&mut self, x: &[Vector3<f64>], touching: &mut [bool]) {
        for (i, (position, is_touching)) in x.iter().zip(touching).enumerate() {
            *is_touching |= self.skin.touch(i, position).is_some();
        }
    }

    fn anchors(&self) -> Option<FrictionAnchors> {
        let friction = self.friction.as_ref()?;
        Some(FrictionAnchors(friction.anchors.clone()))
    }
}
