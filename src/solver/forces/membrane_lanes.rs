//! Forces of the membrane, four triangles at a time.
//!
//! Loops over lanes are written out so that they become vector instructions. Each lane does what
//! [`MembraneTriangle`] does for one triangle, in the same order, and nothing is contracted: the
//! same bytes with and without AVX2, and with one triangle at a time.

use crate::solver::forces::membrane_triangle::{AFTER_BUCKLING, MembraneTriangle};
use nalgebra::Vector3;
use pulp::{Arch, Simd, WithSimd};

/// Triangles worked on at a time: numbers of a vector register of AVX2.
const LANES: usize = 4;

type Lanes = [f64; LANES];
/// Three coordinates of each lane.
type Points = [Lanes; 3];

/// The triangles of a membrane in batches.
pub(crate) struct MembraneLanes {
    batches: Vec<Batch>,
    arch: Arch,
}

/// Up to [`LANES`] triangles.
struct Batch {
    /// Triangles in it.
    count: usize,
    particles: [[usize; LANES]; 3],
    gradients: [[Lanes; 2]; 3],
    area: Lanes,
    moduli: [Lanes; 3],
    critical: [Lanes; 2],
}

impl MembraneLanes {
    pub(crate) fn new(triangles: &[MembraneTriangle]) -> Self {
        Self {
            batches: triangles.chunks(LANES).map(Batch::new).collect(),
            arch: Arch::new(),
        }
    }

    /// Adds the forces of all triangles \[N\]; `taut` if none is taken to buckle.
    pub(crate) fn add_force(&self, x: &[Vector3<f64>], force: &mut [Vector3<f64>], taut: bool) {
        self.arch.dispatch(AddForce {
            batches: &self.batches,
            x,
            force,
            taut,
        });
    }
}

impl Batch {
    /// Lays out at most [`LANES`] triangles; lanes that are left over repeat the first.
    fn new(triangles: &[MembraneTriangle]) -> Self {
        let of = |lane: usize| triangles.get(lane).unwrap_or(&triangles[0]);
        let lanes = |get: &dyn Fn(&MembraneTriangle) -> f64| std::array::from_fn(|l| get(of(l)));
        Self {
            count: triangles.len(),
            particles: [0, 1, 2].map(|corner| std::array::from_fn(|l| of(l).particles[corner])),
            gradients: [0, 1, 2].map(|c| [0, 1].map(|axis| lanes(&|t| t.gradients[c][axis]))),
            area: lanes(&|t| t.area),
            moduli: [0, 1, 2].map(|i| lanes(&|t| t.moduli[i])),
            critical: [0, 1].map(|i| lanes(&|t| t.critical[i])),
        }
    }

    /// Returns the images of the unit vectors along warp and weft.
    #[inline(always)]
    fn deformation(&self, x: &[Vector3<f64>]) -> [Points; 2] {
        let mut f = [[[0.0; LANES]; 3]; 2];
        for (particles, gradients) in self.particles.iter().zip(&self.gradients) {
            let mut at = [[0.0; LANES]; 3];
            for l in 0..LANES {
                for (at, coordinate) in at.iter_mut().zip(&x[particles[l]]) {
                    at[l] = *coordinate;
                }
            }
            for (f, gradient) in f.iter_mut().zip(gradients) {
                for (f, at) in f.iter_mut().zip(&at) {
                    for l in 0..LANES {
                        f[l] += at[l] * gradient[l];
                    }
                }
            }
        }
        f
    }

    /// Returns the stress \[N/m\]: warp, weft, shear.
    #[inline(always)]
    fn stress<const TAUT: bool>(&self, [f0, f1]: &[Points; 2]) -> [Lanes; 3] {
        let mut stress = [dot(f0, f0), dot(f1, f1), dot(f0, f1)];
        for (strain, critical) in stress.iter_mut().zip(&self.critical) {
            for l in 0..LANES {
                let e = 0.5 * (strain[l] - 1.0);
                let beyond = -e - critical[l];
                let buckled = -critical[l] * (1.0 + AFTER_BUCKLING * beyond);
                strain[l] = if !TAUT && beyond > 0.0 { buckled } else { e };
            }
        }
        for (stress, moduli) in stress.iter_mut().zip(&self.moduli) {
            for l in 0..LANES {
                stress[l] *= moduli[l];
            }
        }
        stress
    }

    #[inline(always)]
    fn add_force<const TAUT: bool>(&self, x: &[Vector3<f64>], force: &mut [Vector3<f64>]) {
        let f = self.deformation(x);
        let s = self.stress::<TAUT>(&f);
        let mut p = [[[0.0; LANES]; 3]; 2];
        for axis in 0..3 {
            for l in 0..LANES {
                let (f0, f1) = (f[0][axis][l], f[1][axis][l]);
                p[0][axis][l] = (f0 * s[0][l] + f1 * s[2][l]) * self.area[l];
                p[1][axis][l] = (f1 * s[1][l] + f0 * s[2][l]) * self.area[l];
            }
        }
        let mut pull = [[[0.0; LANES]; 3]; 3];
        for (pull, [warp, weft]) in pull.iter_mut().zip(&self.gradients) {
            for axis in 0..3 {
                for l in 0..LANES {
                    pull[axis][l] = p[0][axis][l] * warp[l] + p[1][axis][l] * weft[l];
                }
            }
        }
        // Triangle by triangle: two of them may share a particle.
        for l in 0..self.count {
            for (particles, pull) in self.particles.iter().zip(&pull) {
                for (force, pull) in force[particles[l]].iter_mut().zip(pull) {
                    *force -= pull[l];
                }
            }
        }
    }
}

#[inline(always)]
fn dot(a: &Points, b: &Points) -> Lanes {
    std::array::from_fn(|l| a[0][l] * b[0][l] + a[1][l] * b[1][l] + a[2][l] * b[2][l])
}

/// The sum over all batches, compiled for each instruction set that the machine may have.
struct AddForce<'f> {
    batches: &'f [Batch],
    x: &'f [Vector3<f64>],
    force: &'f mut [Vector3<f64>],
    taut: bool,
}

impl WithSimd for AddForce<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _simd: S) {
        let Self {
            batches,
            x,
            force,
            taut,
        } = self;
        for batch in batches {
            if taut {
                batch.add_force::<true>(x, force);
            } else {
                batch.add_force::<false>(x, force);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seven triangles in a strip, some pressed together beyond buckling.
    fn strip() -> (Vec<MembraneTriangle>, Vec<Vector3<f64>>) {
        let rest = |i: usize| [0.013 * i as f64, 0.01 * (i % 2) as f64];
        let triangles = (0..7).map(|i| {
            let corners = [i, i + 1, i + 2];
            let triangle = MembraneTriangle::new(corners, corners.map(rest), [900.0, 700.0, 300.0]);
            let triangle = triangle.expect("it has an area");
            triangle.with_buckling([1e-5, 2e-5], 0.013)
        });
        let mut seed = 1.0_f64;
        let mut random = || {
            seed = (seed * 16807.0) % 2_147_483_647.0;
            seed / 2_147_483_647.0 - 0.5
        };
        let x = (0..9).map(|i| {
            let [u, v] = rest(i);
            Vector3::new(u, v, 0.0) + Vector3::from_fn(|_, _| 0.004 * random())
        });
        (triangles.collect(), x.collect())
    }

    #[test]
    fn forces_are_those_of_one_triangle_at_a_time_to_the_last_bit() {
        let (triangles, x) = strip();
        for taut in [false, true] {
            let mut one_at_a_time = vec![Vector3::zeros(); x.len()];
            for triangle in &triangles {
                triangle.add_force(&x, &mut one_at_a_time, taut);
            }
            for arch in [Arch::new(), Arch::Scalar] {
                let lanes = MembraneLanes {
                    arch,
                    ..MembraneLanes::new(&triangles)
                };
                let mut force = vec![Vector3::zeros(); x.len()];
                lanes.add_force(&x, &mut force, taut);
                assert_eq!(force, one_at_a_time, "{arch:?}, taut: {taut}");
            }
        }
        let buckles = |t: &MembraneTriangle| {
            MembraneTriangle::strain(&t.deformation(&x))[..2]
                .iter()
                .any(|e| *e < -0.01)
        };
        assert!(
            triangles.iter().any(buckles),
            "the test needs one that does"
        );
    }
}
