//! A body of one surface: the torso, with arms and legs that grow out of holes in it.
//!
//! Torso and limbs are meshed by rings. Between the edge of a hole and the first ring of a limb,
//! each column of vertices follows a cubic that leaves the torso in its tangent plane and arrives
//! along the limb; then the bending energy of these patches is brought down. Measured places lie
//! outside of them.

use super::arm::{Arm, ArmRoot};
use super::form::{DressForm, Pose, shoulder_line};
use super::half_mesh::HalfMesh;
use super::leg::Leg;
use super::limb::{Limb, LimbAxis};
use super::torso::{HEIGHT, Torso, share};
use super::tube::hermite;
use super::{Avatar, TriangleMesh, rings};
use nalgebra::Vector3;

/// Edges of half a ring of the torso.
const COLUMNS: usize = 40;
/// Edges along the crotch, from the back to the front. A multiple of 4 together with the others, so
/// that one column of a foot is on the floor.
const SEAM: usize = 20;
/// Depth of the torso's lowest ring under the hip on a body of 1.68 m \[m\].
const UNDER_HIP: f64 = 0.007;
/// Depth of the hole of an arm below where the arm parts from the torso, likewise \[m\].
const UNDER_ARM: f64 = 0.014;
/// Rounds of fairing, and rows of a patch.
const FAIRING: usize = 300;
const ARM_ROWS: usize = 10;
/// Vertices of the torso about the hole of an arm that are faired as well.
const AROUND: usize = 2;
const LEG_ROWS: usize = 12;

/// A surface with the places of its limbs, on the left.
pub(super) struct Figure {
    pub(super) surface: TriangleMesh,
    arm: Option<LimbAxis>,
    leg: Option<LimbAxis>,
    armpit: Option<Vector3<f64>>,
    crotch: Option<Vector3<f64>>,
}

/// Rings of the left half of a torso, from the front over the left to the back.
struct Grid {
    mesh: HalfMesh,
    rows: Vec<Vec<usize>>,
    /// Vertices of the patches.
    free: Vec<usize>,
}

/// Rows and columns of a torso between which an arm grows.
struct Hole {
    rows: [usize; 2],
    columns: [usize; 2],
}

impl Figure {
    /// A body of a torso that has the form's measures.
    pub(super) fn new(form: &DressForm, torso: &Torso) -> Self {
        let scale = form.height_m / HEIGHT;
        let limbs = form.limbs.unwrap_or_default();
        let [_, tip] = shoulder_line(torso);
        let tip = Vector3::from(tip);
        let pit = share::ARMPIT * form.height_m - UNDER_ARM * scale;
        let end = if limbs.legs {
            torso.parameter(share::HIP * form.height_m - UNDER_HIP * scale)
        } else {
            Torso::END
        };
        let marks = [torso.parameter(tip.y), torso.parameter(pit), end];
        let mut grid = Grid::new(torso, &marks);
        let hole = limbs.arms.then(|| grid.hole([tip.y, pit], 0.050 * scale));
        grid.skin(hole.as_ref());
        let arm = hole.map(|hole| grid.arm(form, tip, &hole));
        let leg = limbs.legs.then(|| grid.legs(form));
        if leg.is_none() {
            grid.bottom(torso);
        }
        let free = std::mem::take(&mut grid.free);
        grid.mesh.fair(&free, FAIRING);
        let (arm, under) = arm.unzip();
        let (leg, crotch) = leg.unzip();
        let highest = |column: Vec<usize>| {
            let points = column.into_iter().map(|v| grid.mesh.point(v));
            points.max_by(|p, q| p.y.total_cmp(&q.y))
        };
        Self {
            arm,
            leg,
            armpit: under.and_then(highest),
            crotch: crotch.map(|v| grid.mesh.point(v)),
            surface: grid.mesh.mirrored(),
        }
    }

    /// Adds to an avatar of this surface what is known of the limbs.
    pub(super) fn describe(self, avatar: &mut Avatar) {
        if let Some(p) = self.armpit {
            avatar.add_pair("armpit", p);
        }
        if let Some(p) = self.crotch {
            avatar.landmarks.insert("crotch".to_owned(), p);
        }
        let arm = [Limb::ArmLeft, Limb::ArmRight];
        let leg = [Limb::LegLeft, Limb::LegRight];
        for (axis, [left, right], names) in [
            (self.arm, arm, ["shoulder_joint", "elbow", "wrist"]),
            (self.leg, leg, ["hip_joint", "knee", "ankle"]),
        ] {
            let Some(axis) = axis else { continue };
            for (name, point) in names.iter().zip(&axis.points) {
                avatar.add_pair(name, *point);
            }
            avatar.limbs.insert(right, axis.mirrored());
            avatar.limbs.insert(left, axis);
        }
    }
}

/// Returns the parameters with `marks` in place of those nearest to them, none beyond the last.
fn with_marks(mut heights: Vec<f64>, marks: &[f64; 3]) -> Vec<f64> {
    if marks[2] >= Torso::END {
        return with_nearest(heights, &marks[..2]);
    }
    let near = heights.partition_point(|t| *t <= marks[2]);
    heights.truncate(near + 1);
    with_nearest(heights, marks)
        .into_iter()
        .filter(|t| *t <= marks[2])
        .collect()
}

fn with_nearest(mut heights: Vec<f64>, marks: &[f64]) -> Vec<f64> {
    for mark in marks {
        let nearest = heights
            .iter_mut()
            .min_by(|a, b| (**a - mark).abs().total_cmp(&(**b - mark).abs()));
        if let Some(nearest) = nearest {
            *nearest = *mark;
        }
    }
    heights
}

impl Grid {
    /// The rings of a torso, some at these parameters, the last of which is the lowest.
    fn new(torso: &Torso, marks: &[f64; 3]) -> Self {
        let size = torso.size();
        let heights = with_marks(rings::heights(torso, size), marks);
        let mut mesh = HalfMesh::default();
        let mut rows = Vec::new();
        for t in heights {
            let section = torso.section(t);
            let half = section.half();
            let density = rings::densities(&half, size);
            let total: f64 = density.iter().sum();
            // just below the whole number of edges, which is rounded up
            let share = (COLUMNS as f64 - 0.5) / total;
            let density: Vec<f64> = density.iter().map(|d| d * share).collect();
            let points: Vec<_> = rings::spread(&density)
                .iter()
                .map(|&mark| {
                    let [x, z] = rings::between(&half, mark);
                    Vector3::new(x, section.y, z)
                })
                .collect();
            rows.push(mesh.row(&points));
        }
        let [y, z] = torso.middle(0.0);
        let pole = mesh.row(&[Vector3::new(0.0, y, z)])[0];
        for pair in rows[0].clone().windows(2) {
            mesh.triangle([pole, pair[0], pair[1]]);
        }
        Self {
            mesh,
            rows,
            free: Vec::new(),
        }
    }

    /// The hole between two heights, `half` deep to the front and to the back \[m\].
    fn hole(&self, [top, bottom]: [f64; 2], half: f64) -> Hole {
        let row_at = |y: f64| {
            let off = |row: &Vec<usize>| (self.mesh.point(row[0]).y - y).abs();
            let rows = self.rows.iter().enumerate();
            rows.min_by(|a, b| off(a.1).total_cmp(&off(b.1)))
                .map_or(0, |(i, _)| i)
        };
        let rows = [row_at(top), row_at(bottom)];
        let middle = &self.rows[usize::midpoint(rows[0], rows[1])];
        let widest = (0..=COLUMNS)
            .max_by(|a, b| {
                let x = |j: usize| self.mesh.point(middle[j]).x;
                x(*a).total_cmp(&x(*b))
            })
            .unwrap_or(COLUMNS / 2);
        let z = |j: usize| self.mesh.point(middle[j]).z;
        let front = (1..widest).rev().find(|&j| z(j) > z(widest) + half);
        let back = (widest..COLUMNS).find(|&j| z(j) < z(widest) - half);
        let front = front.unwrap_or(1).max(1 + AROUND);
        let mut back = back.unwrap_or(COLUMNS - 1).min(COLUMNS - 1 - AROUND);
        // an even number of columns, so that one is in the middle
        back -= (back - front) % 2;
        Hole {
            rows,
            columns: [front, back],
        }
    }

    /// The skin of the torso, without the hole.
    fn skin(&mut self, hole: Option<&Hole>) {
        for i in 0..self.rows.len() - 1 {
            for j in 0..COLUMNS {
                let is_open = hole.is_some_and(|hole| {
                    (hole.rows[0]..hole.rows[1]).contains(&i)
                        && (hole.columns[0]..hole.columns[1]).contains(&j)
                });
                if !is_open {
                    let [above, below] = [i, i + 1].map(|i| [self.rows[i][j], self.rows[i][j + 1]]);
                    self.mesh.quad(above, below);
                }
            }
        }
    }

    /// The lower end of a torso without legs.
    fn bottom(&mut self, torso: &Torso) {
        let [y, z] = torso.middle(Torso::END);
        let pole = self.mesh.row(&[Vector3::new(0.0, y, z)])[0];
        for pair in self.rows[self.rows.len() - 1].clone().windows(2) {
            self.mesh.triangle([pair[0], pole, pair[1]]);
        }
    }

    /// Adds the left arm; returns its axis and the vertices on its lower side, in the patch.
    fn arm(&mut self, form: &DressForm, tip: Vector3<f64>, hole: &Hole) -> (LimbAxis, Vec<usize>) {
        let scale = form.height_m / HEIGHT;
        let (edge, inward) = self.edge(hole);
        let points: Vec<_> = edge.iter().map(|&v| self.mesh.point(v)).collect();
        let count = edge.len();
        let under = points[count / 2];
        let root = ArmRoot {
            tip,
            armpit: under + Vector3::new(0.008, UNDER_ARM, 0.0) * scale,
            angle: match form.pose {
                Pose::A => 40.0_f64,
                Pose::T => 90.0,
                Pose::I => 12.0,
            }
            .to_radians(),
            scale,
        };
        let arm = Arm::new(&root, &form.arm_measures(), count);
        let patch = self.patch(
            &edge,
            &inward,
            [&arm.rings[0], &arm.rings[1]],
            (ARM_ROWS, 0.7),
        );
        let under = patch.iter().map(|row| row[count / 2]).collect();
        self.free_around(hole);
        self.limb(patch, &arm.rings, arm.tip);
        (arm.axis, under)
    }

    /// Frees the vertices of the torso at the sides of a hole and below it, not those of the
    /// shoulder.
    fn free_around(&mut self, hole: &Hole) {
        let [top, bottom] = hole.rows;
        let [front, back] = hole.columns;
        for i in top + 1..=bottom + AROUND {
            for j in (front - AROUND.min(front))..=back + AROUND {
                let is_open = (top + 1..bottom).contains(&i) && (front + 1..back).contains(&j);
                if !is_open {
                    self.free.push(self.rows[i][j]);
                }
            }
        }
    }

    /// The vertices on the edge of a hole, from the middle of its top over the back, and the
    /// directions in which the torso's surface goes on into the hole.
    fn edge(&self, hole: &Hole) -> (Vec<usize>, Vec<Vector3<f64>>) {
        let [top, bottom] = hole.rows;
        let [front, back] = hole.columns;
        let middle = usize::midpoint(front, back);
        let mut places = Vec::new();
        places.extend((middle..back).map(|j| (top, j)));
        places.extend((top..bottom).map(|i| (i, back)));
        places.extend((front + 1..=back).rev().map(|j| (bottom, j)));
        places.extend((top + 1..=bottom).rev().map(|i| (i, front)));
        places.extend((front..middle).map(|j| (top, j)));
        let inside = |at: usize, [low, high]: [usize; 2]| at.clamp(low + 1, high - 1);
        let directions = places.iter().map(|&(i, j)| {
            let next = self.rows[inside(i, hole.rows)][inside(j, hole.columns)];
            (self.mesh.point(next) - self.mesh.point(self.rows[i][j])).normalize()
        });
        let directions = directions.collect();
        let edge = places.iter().map(|&(i, j)| self.rows[i][j]).collect();
        (edge, directions)
    }

    /// Adds the legs' left one; returns its axis and the vertex at the crotch.
    fn legs(&mut self, form: &DressForm) -> (LimbAxis, usize) {
        let scale = form.height_m / HEIGHT;
        let measures = form.leg_measures();
        let last = self.rows.len() - 1;
        let ring = self.rows[last].clone();
        let points: Vec<_> = ring.iter().map(|&v| self.mesh.point(v)).collect();
        let [front, back] = [points[0], points[COLUMNS]];
        let seam: Vec<_> = (1..SEAM)
            .map(|m| {
                let s = 2.0 * m as f64 / SEAM as f64 - 1.0;
                let y = measures.inside + (front.y - measures.inside) * s.abs().powi(3);
                Vector3::new(0.0, y, back.z + (front.z - back.z) * 0.5 * (1.0 + s))
            })
            .collect();
        let seam = self.mesh.row(&seam);
        let mut edge = ring.clone();
        edge.extend(&seam);
        let mut directions: Vec<_> = (0..=COLUMNS)
            .map(|j| {
                let above = self.mesh.point(self.rows[last - 1][j]);
                let down = (points[j] - above).normalize();
                let to_end = j.min(COLUMNS - j) as f64 / 4.0;
                (down + Vector3::x() * (-to_end * to_end).exp()).normalize()
            })
            .collect();
        directions.extend((1..SEAM).map(|m| {
            let s = 2.0 * m as f64 / SEAM as f64 - 1.0;
            Vector3::new(1.0, -0.25 - 0.75 * s * s, 0.0).normalize()
        }));
        // from the outer side over the back
        edge.rotate_left(COLUMNS / 2);
        directions.rotate_left(COLUMNS / 2);
        let middle_z = 0.5 * (front.z + back.z) - 0.004 * scale;
        let leg = Leg::new(&measures, [measures.inside, middle_z], edge.len());
        let patch = self.patch(
            &edge,
            &directions,
            [&leg.rings[0], &leg.rings[1]],
            (LEG_ROWS, 0.0),
        );
        self.limb(patch, &leg.rings, leg.tip);
        (leg.axis, seam[SEAM / 2 - 1])
    }

    /// The rows of vertices between an edge and the first two rings of a limb.
    fn patch(
        &mut self,
        edge: &[usize],
        directions: &[Vector3<f64>],
        [first, second]: [&[Vector3<f64>]; 2],
        (count, straight): (usize, f64),
    ) -> Vec<Vec<usize>> {
        let starts: Vec<_> = edge.iter().map(|&v| self.mesh.point(v)).collect();
        let mut patch = vec![edge.to_vec()];
        for row in 1..count {
            let t = row as f64 / count as f64;
            let points: Vec<_> = (0..edge.len())
                .map(|k| {
                    let (p, q) = (starts[k], first[k]);
                    let length = 1.15 * (q - p).norm();
                    let chord = (q - p).normalize();
                    let leave = (directions[k] + chord * straight).normalize() * length;
                    let arrive = (second[k] - q).normalize() * length;
                    Vector3::from_fn(|i, _| hermite([p[i], leave[i], q[i], arrive[i]], t))
                })
                .collect();
            let row = self.mesh.row(&points);
            self.free.extend(&row);
            patch.push(row);
        }
        patch
    }

    /// Adds the skin of a patch and of a limb.
    fn limb(&mut self, mut rows: Vec<Vec<usize>>, rings: &[Vec<Vector3<f64>>], tip: Vector3<f64>) {
        rows.extend(rings.iter().map(|ring| self.mesh.row(ring)));
        for pair in rows.windows(2) {
            self.mesh.band(&pair[0], &pair[1]);
        }
        self.mesh.cap(&rows[rows.len() - 1], tip);
    }
}
