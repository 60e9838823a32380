//! The longest step that explicit methods stay stable with.
//!
//! The highest frequency ω is that of M⁻¹ H in the shape at hand. Its square is found by Lanczos iteration (C. Lanczos, J. Res.
//! Nat. Bur. Stand. 45(4), 1950) on differences of forces, so no matrix is needed. The iteration comes from below; from a random
//! start its mean relative error after k products with n unknowns is at most 0.103 (ln(n (k - 1)^4) / (k - 1))² (J. Kuczyński,
//! H. Woźniakowski, SIAM J. Matrix Anal. Appl. 13(4), 1992), which is added twice, as is what a shape may stiffen before it is
//! looked at again. Contact, which may not act yet, is added by its bound, and cloth that yields to pressure is taken as taut: it
//! may be in the next step (of poplin hung by two corners, slack at first, the limit is half of what the slack shape has). Gershgorin's bound, which needs no iteration, is
//! twice too high for cloth: its steps are 1.4 times shorter.

use crate::solver::model::system::System;
use nalgebra::Vector3;

/// Lanczos products.
const PRODUCTS: usize = 48;
/// Lanczos products at most where the highest frequency itself is wanted, and its relative change over a tenth of them at which
/// it counts as found.
const MOST_PRODUCTS: usize = 600;
const SETTLED: f64 = 1e-5;
/// Share by which ω² may grow until the limit is looked at again.
const STIFFENING: f64 = 0.05;
/// Furthest that a particle is moved to take differences of forces \[m\]: far below an edge, far above rounding.
const PROBE: f64 = 1e-7;
/// The same where the frequency at that very shape is wanted: cloth that yields to pressure is not linear further off.
const NEAR_PROBE: f64 = 1e-9;

/// A bound on the square of the highest frequency of `system` at `x` \[1/s²\].
pub(crate) fn max_eigenvalue(system: &mut System<'_>, x: &[Vector3<f64>]) -> f64 {
    let contact = contact_square(system);
    set_taut(system, true);
    let unknowns = 3.0 * x.len() as f64;
    let mut probe = Probe::new(system, x, false, PROBE);
    let (largest, products) = probe.lanczos(PRODUCTS, 0.0);
    set_taut(system, false);
    let k = products.max(2) as f64 - 1.0;
    let short = if (products as f64) < unknowns.min(PRODUCTS as f64) {
        // The iteration ended by itself: it has seen all there is.
        0.0
    } else {
        0.103 * ((unknowns * k.powi(4)).ln() / k).powi(2)
    };
    largest.max(0.0) * (1.0 + 2.0 * short + STIFFENING) + contact
}

fn set_taut(system: &mut System<'_>, taut: bool) {
    for term in &mut system.terms {
        term.force.set_taut(taut);
    }
}

/// The square of the highest frequency of `system` at `x` with what touches the body there \[1/s²\], to about `SETTLED`: no
/// bound, but what theory is compared by.
pub(crate) fn local_max_eigenvalue(system: &mut System<'_>, x: &[Vector3<f64>]) -> f64 {
    Probe::new(system, x, true, NEAR_PROBE)
        .lanczos(MOST_PRODUCTS, SETTLED)
        .0
}

/// Symplectic Euler with drag c is stable while h² ω² + 2 c h <= 4 \[s\].
pub(crate) fn symplectic_euler(max_eigenvalue: f64, drag: f64) -> f64 {
    if max_eigenvalue == 0.0 {
        if drag == 0.0 {
            f64::INFINITY
        } else {
            2.0 / drag
        }
    } else {
        ((drag * drag + 4.0 * max_eigenvalue).sqrt() - drag) / max_eigenvalue
    }
}

/// Verlet, with drag taken at both ends of the step, is stable while h ω <= 2 \[s\].
pub(crate) fn verlet(max_eigenvalue: f64) -> f64 {
    2.0 / max_eigenvalue.sqrt()
}

fn contact_square(system: &System<'_>) -> f64 {
    let Some(contact) = &system.contact else {
        return 0.0;
    };
    let mut stiffness = vec![0.0; system.mass.len()];
    crate::solver::forces::Force::add_stiffness(contact, &mut stiffness);
    let squares = stiffness.iter().zip(&system.mass).map(|(k, m)| k / m);
    squares.fold(0.0, f64::max)
}

/// Products of M^-½ H M^-½ with vectors, contact left out or not.
struct Probe<'s, 'a, 'x> {
    system: &'s mut System<'a>,
    x: &'x [Vector3<f64>],
    contact: bool,
    /// \[m\]
    reach: f64,
    moved: Vec<Vector3<f64>>,
    here: Vec<Vector3<f64>>,
    there: Vec<Vector3<f64>>,
}

impl<'s, 'a, 'x> Probe<'s, 'a, 'x> {
    fn new(system: &'s mut System<'a>, x: &'x [Vector3<f64>], contact: bool, reach: f64) -> Self {
        let zero = vec![Vector3::zeros(); x.len()];
        let mut probe = Self {
            system,
            x,
            contact,
            reach,
            moved: x.to_vec(),
            here: zero.clone(),
            there: zero,
        };
        probe.force_at_moved();
        std::mem::swap(&mut probe.here, &mut probe.there);
        probe
    }

    fn force_at_moved(&mut self) {
        self.there.fill(Vector3::zeros());
        for term in &mut self.system.terms {
            term.force.add_force(&self.moved, &mut self.there);
        }
        if let Some(contact) = self.system.contact.as_mut().filter(|_| self.contact) {
            crate::solver::forces::Force::add_force(contact, &self.moved, &mut self.there);
        }
        self.system.hold_still(&mut self.there);
    }

    /// `product` = M^-½ H M^-½ `z`.
    fn multiply(&mut self, z: &[Vector3<f64>], product: &mut [Vector3<f64>]) {
        let mass = &self.system.mass;
        let reach = z
            .iter()
            .zip(mass)
            .map(|(z, m)| z.amax() / m.sqrt())
            .fold(f64::MIN_POSITIVE, f64::max);
        let share = self.reach / reach;
        for (((moved, x), z), m) in self.moved.iter_mut().zip(self.x).zip(z).zip(mass) {
            *moved = x + z * (share / m.sqrt());
        }
        self.force_at_moved();
        let mass = &self.system.mass;
        for (((p, here), there), m) in product
            .iter_mut()
            .zip(&self.here)
            .zip(&self.there)
            .zip(mass)
        {
            *p = (here - there) / (share * m.sqrt());
        }
    }

    /// The largest Ritz value, and the products that it took: `most`, or so many that a tenth of them changed it by less than
    /// the share `settled`.
    fn lanczos(&mut self, most: usize, settled: f64) -> (f64, usize) {
        let look = most / 10;
        let mut seen = 0.0;
        let count = self.x.len();
        let mut z = scattered(count);
        self.system.hold_still(&mut z);
        normalise(&mut z);
        let mut before = vec![Vector3::zeros(); count];
        let mut product = before.clone();
        let (mut diagonal, mut beside) = (Vec::new(), Vec::new());
        for number in 1..=most.min(3 * count) {
            self.multiply(&z, &mut product);
            let alpha = dot(&z, &product);
            let beta = beside.last().copied().unwrap_or(0.0);
            for ((p, z), b) in product.iter_mut().zip(&z).zip(&before) {
                *p -= z * alpha + b * beta;
            }
            diagonal.push(alpha);
            let rest = normalise(&mut product);
            // Differences of forces carry about 1e-6 of rounding: a rest below that is none.
            if rest <= 1e-6 * largest_eigenvalue(&diagonal, &beside).abs() {
                break;
            }
            if settled > 0.0 && number % look == 0 {
                let largest = largest_eigenvalue(&diagonal, &beside);
                if largest - seen <= settled * largest {
                    break;
                }
                seen = largest;
            }
            beside.push(rest);
            std::mem::swap(&mut before, &mut z);
            std::mem::swap(&mut z, &mut product);
        }
        beside.truncate(diagonal.len().saturating_sub(1));
        (largest_eigenvalue(&diagonal, &beside), diagonal.len())
    }
}

/// A vector that favours no direction, the same every time.
pub(crate) fn scattered(count: usize) -> Vec<Vector3<f64>> {
    let mut seed = 1_u64;
    let mut number = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
    };
    (0..count)
        .map(|_| Vector3::new(number(), number(), number()))
        .collect()
}

fn dot(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}

/// Scales `z` to length 1; the length that it had.
fn normalise(z: &mut [Vector3<f64>]) -> f64 {
    let length = dot(z, z).sqrt();
    if length > 0.0 {
        z.iter_mut().for_each(|z| *z /= length);
    }
    length
}

/// The largest eigenvalue of a symmetric tridiagonal matrix, by bisection on the count of negative pivots (Sturm).
fn largest_eigenvalue(diagonal: &[f64], beside: &[f64]) -> f64 {
    let off = |i: usize| beside.get(i).copied().unwrap_or(0.0);
    let radius = |i: usize| if i == 0 { 0.0 } else { off(i - 1) } + off(i);
    let rows = || diagonal.iter().enumerate();
    let mut low = diagonal.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut high = rows().map(|(i, d)| d + radius(i)).fold(low, f64::max);
    let all_below = |value: f64| {
        let mut pivot = 1.0;
        rows().all(|(i, d)| {
            let carried = if i == 0 {
                0.0
            } else {
                off(i - 1).powi(2) / pivot
            };
            pivot = d - value - carried;
            pivot < 0.0
        })
    };
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if all_below(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The eigenvalues of the path's matrix (2, -1) are 2 - 2 cos(k π / (n + 1)).
    #[test]
    fn the_largest_eigenvalue_of_a_path_is_found() {
        let n = 10;
        let exact = 2.0 - 2.0 * (n as f64 * std::f64::consts::PI / (n as f64 + 1.0)).cos();
        let found = largest_eigenvalue(&[2.0; 10], &[-1.0; 9].map(f64::abs));
        assert!((found - exact).abs() < 1e-14 * exact, "{found} {exact}");
    }
}
