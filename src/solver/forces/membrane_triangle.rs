//! A triangle of orthotropic membrane: the continuum that cloth is.
//!
//! Saint Venant-Kirchhoff triangles of constant strain, which for an isotropic cloth are the
//! biquadratic triangular springs with coupling terms of H. Delingette, "Triangular Springs for
//! Modeling Nonlinear Membranes" (IEEE TVCG 14(2), 2008). With F = \[f1 f2\] the deformed images of
//! the unit vectors along warp and weft, E11 = (f1·f1 - 1)/2, E22 likewise and γ = f1·f2, the
//! energy of a triangle is A/2 (Kw E11² + Kf E22² + G γ²): warp, weft and shear moduli per width,
//! no Poisson coupling.
//!
//! Thin cloth that is pressed together along a thread does not shorten but folds. Folds narrower
//! than a triangle have no shape on the mesh, so the triangle has their energy instead: beyond the
//! compression at which a strip as long as the mesh edges l buckles, π² B / (K l²) (L. Euler), the
//! pressure rises as that of the strip does, by half of itself for a shortening of all its length
//! (the elastica). With ever finer meshes the threshold goes to infinity, and what is left is the
//! continuum above.

use nalgebra::{Matrix2, Vector3};

/// Rise of the load of a buckled strip with its shortening, over the load at which it buckles: that
/// of the elastica near there.
pub(crate) const AFTER_BUCKLING: f64 = 0.5;

/// A triangle of membrane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MembraneTriangle {
    pub(crate) particles: [usize; 3],
    /// Derivatives of the three shape functions along warp and weft \[1/m\].
    pub(crate) gradients: [[f64; 2]; 3],
    /// \[m²\]
    pub(crate) area: f64,
    /// Warp, weft and shear modulus \[N/m\].
    pub(crate) moduli: [f64; 3],
    /// Compression at which cloth buckles within the triangle: warp, weft.
    pub(crate) critical: [f64; 2],
}

impl MembraneTriangle {
    /// Returns the triangle with these rest positions in warp-weft coordinates \[m\]; `None` if it
    /// has no area.
    pub(crate) fn new(
        particles: [usize; 3],
        rest: [[f64; 2]; 3],
        moduli: [f64; 3],
    ) -> Option<Self> {
        let [p, q, r] = rest;
        let edges = Matrix2::new(q[0] - p[0], r[0] - p[0], q[1] - p[1], r[1] - p[1]);
        let inverse = edges.try_inverse()?;
        let (gq, gr) = (
            [inverse[(0, 0)], inverse[(0, 1)]],
            [inverse[(1, 0)], inverse[(1, 1)]],
        );
        let gp = [-gq[0] - gr[0], -gq[1] - gr[1]];
        Some(Self {
            particles,
            gradients: [gp, gq, gr],
            area: 0.5 * edges.determinant().abs(),
            moduli,
            critical: [f64::INFINITY; 2],
        })
    }

    /// Returns the same triangle of a cloth of these bending rigidities along warp and weft
    /// \[N m\], that buckles where it is pressed together into folds as wide as the edges of the
    /// mesh \[m\]. With one width for all, even strain is even stress.
    pub(crate) fn with_buckling(mut self, rigidity: [f64; 2], edge: f64) -> Self {
        let euler = (std::f64::consts::PI / edge).powi(2);
        self.critical = [0, 1].map(|i| euler * rigidity[i] / self.moduli[i]);
        self
    }

    /// Returns the images of the unit vectors along warp and weft.
    pub(crate) fn deformation(&self, x: &[Vector3<f64>]) -> [Vector3<f64>; 2] {
        let mut f = [Vector3::zeros(); 2];
        for (&particle, g) in self.particles.iter().zip(&self.gradients) {
            f[0] += x[particle] * g[0];
            f[1] += x[particle] * g[1];
        }
        f
    }

    /// Returns the Green strain: warp, weft, and twice the shear.
    pub(crate) fn strain(f: &[Vector3<f64>; 2]) -> [f64; 3] {
        [
            0.5 * (f[0].norm_squared() - 1.0),
            0.5 * (f[1].norm_squared() - 1.0),
            f[0].dot(&f[1]),
        ]
    }

    /// Adds the forces of the triangle \[N\]; `taut` if it is taken not to buckle.
    pub(crate) fn add_force(&self, x: &[Vector3<f64>], force: &mut [Vector3<f64>], taut: bool) {
        let f = self.deformation(x);
        let strain = Self::strain(&f);
        let s = if taut {
            [0, 1, 2].map(|i| self.moduli[i] * strain[i])
        } else {
            self.stress(strain)
        };
        let p = [
            (f[0] * s[0] + f[1] * s[2]) * self.area,
            (f[1] * s[1] + f[0] * s[2]) * self.area,
        ];
        for (&particle, g) in self.particles.iter().zip(&self.gradients) {
            force[particle] -= p[0] * g[0] + p[1] * g[1];
        }
    }

    /// Returns the energy per area \[J/m²\].
    pub(crate) fn energy(&self, strain: [f64; 3]) -> f64 {
        let along = |i: usize| {
            let (e, limit) = (strain[i], self.critical[i]);
            let beyond = -e - limit;
            if beyond > 0.0 {
                limit * (0.5 * limit + beyond * (1.0 + 0.5 * AFTER_BUCKLING * beyond))
            } else {
                0.5 * e * e
            }
        };
        self.moduli[0] * along(0)
            + self.moduli[1] * along(1)
            + 0.5 * self.moduli[2] * strain[2].powi(2)
    }

    /// Returns the stress \[N/m\]: warp, weft, shear.
    pub(crate) fn stress(&self, strain: [f64; 3]) -> [f64; 3] {
        let along = |i: usize| {
            let beyond = -strain[i] - self.critical[i];
            if beyond > 0.0 {
                -self.critical[i] * (1.0 + AFTER_BUCKLING * beyond)
            } else {
                strain[i]
            }
        };
        [
            self.moduli[0] * along(0),
            self.moduli[1] * along(1),
            self.moduli[2] * strain[2],
        ]
    }

    /// Returns the derivatives of the stresses by their strains \[N/m\].
    pub(crate) fn tangent(&self, strain: [f64; 3]) -> [f64; 3] {
        let along = |i: usize| {
            if strain[i] < -self.critical[i] {
                self.critical[i] * AFTER_BUCKLING
            } else {
                1.0
            }
        };
        [
            self.moduli[0] * along(0),
            self.moduli[1] * along(1),
            self.moduli[2],
        ]
    }
}
