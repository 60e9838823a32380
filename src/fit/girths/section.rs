//! Panels cut by a plane: how long the cloth is there, and how far it may be stretched.

use crate::mesh::ClothMesh;
use crate::scene::Scene;
use nalgebra::Vector3;
use std::collections::{BTreeMap, BTreeSet};

/// A plane that a garment is cut by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    /// A point of it \[m\].
    pub(super) point: Vector3<f64>,
    /// Its unit normal.
    pub(super) normal: Vector3<f64>,
}

/// Returns the level plane at a height \[m\].
pub(super) fn level(height: f64) -> Plane {
    Plane {
        point: Vector3::new(0.0, height, 0.0),
        normal: Vector3::y(),
    }
}

/// Returns numbers from one to another, a step apart.
pub(super) fn steps([from, to]: [f64; 2], step: f64) -> impl Iterator<Item = f64> {
    let at = move |number: u32| from + f64::from(number) * step;
    (0..).map(at).take_while(move |at| *at <= to)
}

/// The line in which a plane cuts some panels.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Section {
    /// Length on the pattern \[m\].
    pub(super) rest_m: f64,
    /// Length in space \[m\].
    pub(super) shape_m: f64,
    /// Length of it as far stretched as the cloth gives \[m\].
    pub(super) stretched_m: f64,
    /// True if it ends nowhere: it crosses both sides of each seam as often.
    pub(super) is_closed: bool,
}

/// Edges and seams of a garment's panels, of which sections are made.
pub(super) struct Sections<'a> {
    scene: &'a Scene,
    borders: BTreeSet<[usize; 2]>,
    sewn: BTreeMap<usize, Vec<SeamSide>>,
    /// Seams of which both sides are edges of the cloth: the others are sewn to a line within it.
    of_edges: BTreeSet<usize>,
}

/// A side of a seam.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct SeamSide {
    seam: usize,
    is_a: bool,
}

impl<'a> Sections<'a> {
    pub(super) fn new(scene: &'a Scene) -> Self {
        let mut sewn: BTreeMap<usize, Vec<SeamSide>> = BTreeMap::new();
        for stitch in &scene.mesh.stitches {
            for (vertex, is_a) in [(stitch.a, true), (stitch.b, false)] {
                let side = SeamSide {
                    seam: stitch.seam,
                    is_a,
                };
                let sides = sewn.entry(vertex).or_default();
                if !sides.contains(&side) {
                    sides.push(side);
                }
            }
        }
        let borders = borders(&scene.mesh);
        let along = |edge: &[usize; 2]| common_sides(&sewn, *edge).collect::<Vec<_>>();
        let sides: BTreeSet<SeamSide> = borders.iter().flat_map(along).collect();
        let is_edge = |side: &&SeamSide| {
            sides.contains(&SeamSide {
                is_a: !side.is_a,
                ..**side
            })
        };
        Self {
            of_edges: sides.iter().filter(is_edge).map(|side| side.seam).collect(),
            scene,
            borders,
            sewn,
        }
    }

    /// Returns the section of the panels of these indices with their vertices at `positions`
    /// \[m\].
    pub(super) fn of(&self, plane: Plane, panels: &[usize], positions: &[Vector3<f64>]) -> Section {
        let mut section = Section::default();
        let above = |v: usize| (positions[v] - plane.point).dot(&plane.normal);
        let mut ends = vec![];
        for &panel in panels {
            let range = &self.scene.mesh.panels[panel];
            for triangle in &self.scene.mesh.triangles[range.triangles.clone()] {
                let [Some(one), Some(other)] = crossed_edges(triangle, above) else {
                    continue;
                };
                section.add(self.piece(panel, positions, [one, other]));
                ends.extend([one.edge, other.edge]);
            }
        }
        section.is_closed = !ends.is_empty() && self.are_closed(&ends);
        section
    }

    /// Returns true if a section that crosses these edges crosses no edge of the cloth that is not
    /// sewn, and both sides of each seam as often: a plane through a dart that lies level crosses
    /// one of its legs.
    fn are_closed(&self, edges: &[[usize; 2]]) -> bool {
        let is_border = |&&[a, b]: &&[usize; 2]| self.borders.contains(&[a.min(b), a.max(b)]);
        let mut balance: BTreeMap<usize, i64> = BTreeMap::new();
        for &edge in edges.iter().filter(is_border) {
            if edge.iter().any(|vertex| !self.sewn.contains_key(vertex)) {
                return false;
            }
            for side in common_sides(&self.sewn, edge).filter(|s| self.of_edges.contains(&s.seam)) {
                *balance.entry(side.seam).or_default() += if side.is_a { 1 } else { -1 };
            }
        }
        balance.values().all(|difference| *difference == 0)
    }

    /// Returns the lengths of the piece between two crossed edges of a triangle.
    fn piece(&self, panel: usize, positions: &[Vector3<f64>], ends: [Crossing; 2]) -> Section {
        let scene = self.scene;
        let [rest, other_rest] = ends.map(|end| {
            let [a, b] = end.edge.map(|v| nalgebra::Vector2::from(scene.mesh.uv[v]));
            a.lerp(&b, end.share)
        });
        let [from, to] = ends.map(|end| {
            let [a, b] = end.edge.map(|v| positions[v]);
            a.lerp(&b, end.share)
        });
        let cut = &scene.cut[panel];
        let along = other_rest - rest;
        let from_warp = along.y.atan2(along.x) - cut.warp_angle;
        let extension = scene.fabrics[cut.fabric].extension(from_warp);
        Section {
            rest_m: along.norm(),
            shape_m: (to - from).norm(),
            stretched_m: along.norm() * (1.0 + extension),
            is_closed: false,
        }
    }
}

impl Section {
    fn add(&mut self, piece: Self) {
        self.rest_m += piece.rest_m;
        self.shape_m += piece.shape_m;
        self.stretched_m += piece.stretched_m;
    }
}

/// An edge that a plane crosses, and the share of it from its first end to the plane.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    edge: [usize; 2],
    share: f64,
}

fn crossed_edges(triangle: &[usize; 3], above: impl Fn(usize) -> f64) -> [Option<Crossing>; 2] {
    let [a, b, c] = *triangle;
    let mut crossed = [[a, b], [b, c], [c, a]].into_iter().filter_map(|edge| {
        let [from, to] = edge.map(&above);
        // A vertex in the plane counts as above it, so a triangle has two crossed edges or none.
        ((from < 0.0) != (to < 0.0)).then(|| Crossing {
            edge,
            share: from / (from - to),
        })
    });
    [crossed.next(), crossed.next()]
}

/// Returns the sides of seams that both ends of an edge are on.
fn common_sides(
    sewn: &BTreeMap<usize, Vec<SeamSide>>,
    edge: [usize; 2],
) -> impl Iterator<Item = SeamSide> + '_ {
    let [of_a, of_b] = edge.map(|v| sewn.get(&v).map_or(&[][..], Vec::as_slice));
    of_a.iter().filter(|side| of_b.contains(side)).copied()
}

/// Returns the edges of one triangle alone, the smaller vertex first.
fn borders(mesh: &ClothMesh) -> BTreeSet<[usize; 2]> {
    let mut count: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    for &[a, b, c] in &mesh.triangles {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            *count.entry([from.min(to), from.max(to)]).or_default() += 1;
        }
    }
    let alone = count.into_iter().filter(|(_, count)| *count == 1);
    alone.map(|(edge, _)| edge).collect()
}
