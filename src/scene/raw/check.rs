//! Validation of a raw scene: all of its faults at once.

use super::raw_scene::RawScene;
use crate::config::Limits;
use crate::fault::{Fault, Faults, SceneCode};
use std::collections::BTreeMap;

/// Coordinates up to this are read \[m\]; beyond, rounding would be felt in the forces.
const FAR: f64 = 1e4;
/// Springs for each vertex that `Limits` allows: a net of structural, shear and bend springs has
/// six.
const SPRINGS_PER_VERTEX: usize = 16;
/// Triangles for each vertex that `Limits` allows: an endless mesh has two.
const TRIANGLES_PER_VERTEX: usize = 3;
/// Largest coefficient of friction.
const ROUGHEST: f64 = 10.0;
/// Faults told of one list; a scene wrong throughout is not worth a longer answer.
const TOLD: usize = 20;

/// Returns all faults of `scene`.
pub(super) fn check(scene: &RawScene, limits: &Limits) -> Result<(), Faults> {
    let mut found = SceneCheck {
        vertex_count: scene.start_m.len(),
        faults: Vec::new(),
    };
    if found.sizes(scene, limits) {
        found.vertices(scene);
        found.triangles(scene);
        found.springs(scene);
        found.stitches(scene);
        found.each("/pins", &scene.pins, |found, &pin| found.no_vertex(pin));
    }
    found.world(scene);
    Faults(found.faults).or(())
}

/// A kind of fault with what is wrong.
type Defect = (SceneCode, String);

struct SceneCheck {
    vertex_count: usize,
    faults: Vec<Fault>,
}

impl SceneCheck {
    fn add(&mut self, (code, detail): Defect, pointer: String) {
        self.faults.push(Fault::new(code, pointer, detail));
    }

    /// Looks at each entry of the list at `pointer`.
    fn each<T>(&mut self, pointer: &str, list: &[T], defect: impl Fn(&Self, &T) -> Option<Defect>) {
        let defects: Vec<_> = list
            .iter()
            .enumerate()
            .filter_map(|(i, entry)| Some((i, defect(self, entry)?)))
            .take(TOLD)
            .collect();
        for (i, defect) in defects {
            self.add(defect, format!("{pointer}/{i}"));
        }
    }

    /// Returns true if the lists are as long as each other and as the limits allow, so that their
    /// entries can be looked at.
    fn sizes(&mut self, scene: &RawScene, limits: &Limits) -> bool {
        let (count, most) = (self.vertex_count, limits.mesh_vertices);
        let longest = [
            ("/start_m", count, most),
            (
                "/triangles",
                scene.triangles.len(),
                TRIANGLES_PER_VERTEX * most,
            ),
            ("/springs", scene.springs.len(), SPRINGS_PER_VERTEX * most),
            ("/stitches", scene.stitches.len(), most),
            ("/pins", scene.pins.len(), most),
        ];
        for (pointer, length, most) in longest {
            if length > most {
                let detail = format!("{length} entries; at most {most} are read");
                self.add((SceneCode::TooLarge, detail), pointer.to_owned());
            }
        }
        if count == 0 {
            let detail = "the scene has no vertices".to_owned();
            self.add((SceneCode::NoVertices, detail), "/start_m".to_owned());
        }
        let mut lists = vec![("/mass_kg", scene.mass_kg.len())];
        if !(scene.uv_m.is_empty() && scene.triangles.is_empty()) {
            lists.push(("/uv_m", scene.uv_m.len()));
        }
        for (pointer, length) in lists.into_iter().filter(|list| list.1 != count) {
            let detail = format!("{length} entries for {count} vertices");
            self.add((SceneCode::Length, detail), pointer.to_owned());
        }
        self.faults.is_empty()
    }

    fn vertices(&mut self, scene: &RawScene) {
        self.each("/start_m", &scene.start_m, |_, p| far(p));
        self.each("/uv_m", &scene.uv_m, |_, p| far(p));
        self.each("/mass_kg", &scene.mass_kg, |_, &mass| {
            not_positive("a mass", mass, "kg")
        });
    }

    fn triangles(&mut self, scene: &RawScene) {
        self.each("/triangles", &scene.triangles, |found, triangle| {
            if let Some(defect) = triangle.iter().find_map(|&v| found.no_vertex(v)) {
                return Some(defect);
            }
            let [p, q, r] = triangle.map(|v| scene.uv_m[v]);
            let twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
            // so written that a NaN is not called a defect of the triangle: it is told of the
            // vertex
            (twice <= 0.0).then(|| {
                let detail = format!(
                    "triangle {triangle:?} has no area or runs clockwise in uv_m: give its vertices counter-clockwise"
                );
                (SceneCode::Triangle, detail)
            })
        });
    }

    fn springs(&mut self, scene: &RawScene) {
        self.each("/springs", &scene.springs, |found, spring| {
            found
                .pair([spring.a, spring.b])
                .or_else(|| not_positive("a rest length", spring.rest_length_m, "m"))
                .or_else(|| not_positive("a stiffness", spring.stiffness_n_m, "N/m"))
        });
    }

    fn stitches(&mut self, scene: &RawScene) {
        let mut first = BTreeMap::new();
        for (i, &[a, b]) in scene.stitches.iter().enumerate().rev() {
            first.insert((a.min(b), a.max(b)), i);
        }
        let numbered: Vec<_> = scene.stitches.iter().copied().enumerate().collect();
        self.each("/stitches", &numbered, |found, &(i, [a, b])| {
            found.pair([a, b]).or_else(|| {
                let before = first[&(a.min(b), a.max(b))];
                (before < i).then(|| {
                    let detail =
                        format!("vertices {a} and {b} are sewn by stitch {before} already");
                    (SceneCode::StitchTwice, detail)
                })
            })
        });
    }

    /// Checks what does not belong to a vertex.
    fn world(&mut self, scene: &RawScene) {
        if let Some(body) = &scene.body {
            self.faults.extend(body.check("/body"));
        }
        let friction = (!(0.0..=ROUGHEST).contains(&scene.friction)).then(|| {
            (
                SceneCode::Friction,
                format!("friction of {} is not 0 to {ROUGHEST}", scene.friction),
            )
        });
        let drag = scene.drag_1_s.filter(|drag| !(0.0..=FAR).contains(drag));
        let drag = drag.map(|drag| {
            (
                SceneCode::Drag,
                format!("drag of {drag} 1/s is not 0 to {FAR}"),
            )
        });
        let axis = scene.fixed_axis.filter(|&axis| axis > 2).map(|axis| {
            (
                SceneCode::HeldAxis,
                format!("there is no axis {axis}: 0 is x, 1 y, 2 z"),
            )
        });
        let defects = [
            ("/gravity_m_s2", far(&scene.gravity_m_s2)),
            ("/wind_m_s", scene.wind_m_s.and_then(|wind| far(&wind))),
            ("/friction", friction),
            ("/drag_1_s", drag),
            ("/held_axis", axis),
        ];
        for (pointer, defect) in defects {
            if let Some(defect) = defect {
                self.add(defect, pointer.to_owned());
            }
        }
    }

    fn no_vertex(&self, v: usize) -> Option<Defect> {
        (v >= self.vertex_count).then(|| {
            let last = self.vertex_count - 1;
            (
                SceneCode::NoVertex,
                format!("there is no vertex {v}: the last is {last}"),
            )
        })
    }

    fn pair(&self, [a, b]: [usize; 2]) -> Option<Defect> {
        self.no_vertex(a).or_else(|| self.no_vertex(b)).or_else(|| {
            (a == b).then(|| (SceneCode::Itself, format!("vertex {a} is tied to itself")))
        })
    }
}

fn far(numbers: &[f64]) -> Option<Defect> {
    let wrong = numbers.iter().find(|c| c.is_nan() || c.abs() > FAR)?;
    Some((
        SceneCode::Number,
        format!("{wrong} is not a number from -{FAR} to {FAR}"),
    ))
}

fn not_positive(what: &str, value: f64, unit: &str) -> Option<Defect> {
    (!(value > 0.0 && value.is_finite())).then(|| {
        (
            SceneCode::NotPositive,
            format!("{what} of {value} {unit} is not above 0"),
        )
    })
}
