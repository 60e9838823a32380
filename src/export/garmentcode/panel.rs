//! A panel as a loop of edges between vertices.

use super::curve::EdgeCurve;
use super::fit::Fitter;
use super::numbers::neat;
use crate::pattern::outline::ring_of;
use crate::pattern::point::Point2;
use crate::pattern::polyline::signed_area;
use crate::pattern::{Face, Panel};
use serde_json::{Map, Value, json};

/// A panel as a specification draws it: a loop, counter-clockwise where its drawn side is out or
/// nothing is said of it.
pub(super) struct DrawnPanel {
    /// The edges in the order of the loop; each ends where the next begins.
    edges: Vec<DrawnEdge>,
    /// Stored edge by stored edge, the one edge that it is drawn as; `None` where it takes several.
    index_of: Vec<Option<usize>>,
    /// True if the loop runs against the order in which edges are stored.
    pub(super) reversed: bool,
    /// The greatest distance between the curves and the lines of the outline \[m\].
    pub(super) deviation: f64,
}

/// An edge of the loop.
struct DrawnEdge {
    from: Point2,
    curve: EdgeCurve,
    label: Option<String>,
}

impl DrawnPanel {
    /// Draws the outline of a panel.
    pub(super) fn of(panel: &Panel, fitter: &mut Fitter) -> Self {
        let is_stored_ccw = signed_area(&ring_of(&panel.edges)) > 0.0;
        let is_wanted_ccw = panel.face != Some(Face::Down);
        let mut drawn = Self {
            edges: Vec::new(),
            index_of: vec![None; panel.edges.len()],
            reversed: is_stored_ccw != is_wanted_ccw,
            deviation: 0.0,
        };
        for i in 0..panel.edges.len() {
            let stored = if drawn.reversed {
                panel.edges.len() - 1 - i
            } else {
                i
            };
            drawn.add(panel, stored, fitter);
        }
        drawn
    }

    /// Adds a stored edge to the loop.
    fn add(&mut self, panel: &Panel, stored: usize, fitter: &mut Fitter) {
        let edge = &panel.edges[stored];
        let mut points = edge.points.clone();
        if self.reversed {
            points.reverse();
        }
        if points.len() < 2 {
            return;
        }
        let curves = fitter.curves(&points);
        self.index_of[stored] = (curves.len() == 1).then_some(self.edges.len());
        let mut from = 0;
        for part in curves {
            self.deviation = self.deviation.max(part.deviation);
            self.edges.push(DrawnEdge {
                from: points[from],
                curve: part.curve,
                label: edge.label.clone(),
            });
            from = part.end;
        }
    }

    /// Returns the index in the loop of a stored edge that is drawn as one.
    pub(super) fn index_of(&self, stored: usize) -> Option<usize> {
        self.index_of.get(stored).copied().flatten()
    }

    /// Returns the number of stored edges that are drawn as several.
    pub(super) fn divided_count(&self) -> usize {
        self.index_of.iter().filter(|index| index.is_none()).count()
    }

    /// Returns the fields of the panel: vertices, edges and label.
    pub(super) fn written(&self, panel: &Panel, scale: f64) -> Map<String, Value> {
        let in_units = |p: Point2| p.map(|c| neat(c / scale));
        let vertices: Vec<Point2> = self.edges.iter().map(|edge| in_units(edge.from)).collect();
        let count = self.edges.len();
        let edge = |i: usize| {
            let (edge, next) = (&self.edges[i], &self.edges[(i + 1) % count]);
            let mut fields = Map::new();
            fields.insert("endpoints".to_owned(), json!([i, (i + 1) % count]));
            let curvature = edge.curve.written([edge.from, next.from], scale);
            fields.extend(curvature.map(|curve| ("curvature".to_owned(), curve)));
            let label = edge.label.as_ref();
            fields.extend(label.map(|label| ("label".to_owned(), json!(label))));
            Value::Object(fields)
        };
        let mut fields = Map::new();
        fields.insert("vertices".to_owned(), json!(vertices));
        let edges: Vec<Value> = (0..count).map(edge).collect();
        fields.insert("edges".to_owned(), json!(edges));
        let label = panel.label.as_ref();
        fields.extend(label.map(|label| ("label".to_owned(), json!(label))));
        fields
    }
}
