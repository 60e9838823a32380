//! Corners that a file does not have: a pattern whose edges are cut where a seam must end, and the
//! way back from its seams to those of the file.
//!
//! The seam of a sleeve may run into its cap, and a shoulder into a wide neck, without a corner.

use crate::pattern::{Corner, Edge, Notch, OutlineRun, Panel, Pattern, Place, Point2, Side};

/// Cuts nearer to a corner than this are the corner \[m\].
const MIN_PART_M: f64 = 0.008;

/// A place where an edge is cut: panel, edge, and share of its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cut {
    pub(super) panel: usize,
    pub(super) edge: usize,
    pub(super) at: f64,
}

/// A pattern with cut edges.
pub(super) struct CutPattern {
    pub(super) pattern: Pattern,
    /// For each panel and edge, the edge of the file and the part of it.
    origins: Vec<Vec<(usize, [f64; 2])>>,
}

impl CutPattern {
    /// Cuts the edges of a pattern, but for cuts too near to corners.
    pub(super) fn new(pattern: &Pattern, cuts: &[Cut]) -> Self {
        let mut cut = pattern.clone();
        let mut origins = vec![];
        // Copies have the numbers of their sources, and keep them.
        let source = |index: usize| {
            let of = pattern.panels[index].copy_of.as_deref();
            of.and_then(|id| pattern.panel_index(id)).unwrap_or(index)
        };
        for (index, panel) in cut.panels.iter_mut().enumerate() {
            let is_own = |c: &&Cut| source(c.panel) == source(index);
            let own: Vec<Cut> = cuts.iter().filter(is_own).copied().collect();
            origins.push(cut_panel(panel, &own));
        }
        Self {
            pattern: cut,
            origins,
        }
    }

    /// Returns a side of a seam by the corners and edges of the file.
    pub(super) fn restored(&self, side: &Side) -> Side {
        match side {
            Side::One(run) => Side::One(self.restored_run(run)),
            Side::Many(runs) => Side::Many(runs.iter().map(|run| self.restored_run(run)).collect()),
        }
    }

    fn restored_run(&self, run: &OutlineRun) -> OutlineRun {
        let source = run.panel.strip_suffix(crate::pattern::MIRROR);
        let own = self.pattern.panel_index(&run.panel);
        let index = own.or_else(|| self.pattern.panel_index(source?));
        let Some(origins) = index.map(|index| &self.origins[index]) else {
            return run.clone();
        };
        let place = |place: Place| match place {
            Place::Corner(corner) => on(origins[corner], 0.0),
            Place::OnEdge { edge, at } => on(origins[edge], at),
            other => other,
        };
        OutlineRun {
            from: place(run.from),
            to: place(run.to),
            ..run.clone()
        }
    }
}

/// Returns a place on a part of an edge of the file.
fn on((edge, [from, to]): (usize, [f64; 2]), at: f64) -> Place {
    let at = from + at * (to - from);
    if at == 0.0 {
        Place::Corner(edge)
    } else {
        Place::OnEdge { edge, at }
    }
}

/// Cuts the edges of a panel; returns where each of its edges comes from.
fn cut_panel(panel: &mut Panel, cuts: &[Cut]) -> Vec<(usize, [f64; 2])> {
    let mut edges: Vec<Edge> = vec![];
    let mut origins = vec![];
    for edge in &panel.edges {
        let least = MIN_PART_M / edge.length_m.max(MIN_PART_M);
        let inside = |at: &f64| *at > least && *at < 1.0 - least;
        let own = cuts.iter().filter(|c| c.edge == edge.index).map(|c| c.at);
        let mut ends: Vec<f64> = own.filter(inside).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|b, a| *b - *a < least);
        ends.push(1.0);
        let mut from = 0.0;
        for to in ends {
            edges.push(Edge {
                points: part(&edge.points, [from, to]),
                length_m: edge.length_m * (to - from),
                ..edge.clone()
            });
            origins.push((edge.index, [from, to]));
            from = to;
        }
    }
    let count = edges.len();
    for (index, edge) in edges.iter_mut().enumerate() {
        (edge.index, edge.from, edge.to) = (index, index, (index + 1) % count.max(1));
    }
    panel.corners = edges
        .iter()
        .filter_map(|edge| {
            let [x, y] = *edge.points.first()?;
            let index = edge.index;
            Some(Corner { index, x, y })
        })
        .collect();
    panel.edges = edges;
    panel.notches = panel
        .notches
        .iter()
        .filter_map(|notch| moved(notch, &origins))
        .collect();
    origins
}

/// Returns a notch on the part of its edge on which it lies.
fn moved(notch: &Notch, origins: &[(usize, [f64; 2])]) -> Option<Notch> {
    let holds = |(edge, [from, to]): &(usize, [f64; 2])| {
        *edge == notch.edge && (*from..=*to).contains(&notch.at)
    };
    let edge = origins.iter().position(holds)?;
    let [from, to] = origins[edge].1;
    let at = (notch.at - from) / (to - from).max(f64::MIN_POSITIVE);
    Some(Notch { edge, at, ..*notch })
}

/// Returns the part of a line between two shares of its length.
fn part(points: &[Point2], [from, to]: [f64; 2]) -> Vec<Point2> {
    let step = |p: &[Point2]| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]);
    let whole: f64 = points.windows(2).map(step).sum();
    let mut so_far = 0.0;
    let mut found: Vec<Point2> = vec![];
    for pair in points.windows(2) {
        let long = step(pair);
        let share = |at: f64| ((at * whole - so_far) / long.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        let [a, b] = [share(from), share(to)];
        let at = |t: f64| [0, 1].map(|i| pair[0][i] + t * (pair[1][i] - pair[0][i]));
        if b > a {
            if found.is_empty() {
                found.push(at(a));
            }
            found.push(at(b));
        }
        so_far += long;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn part_of_a_line_begins_and_ends_within_its_chords() {
        let line = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
        let found = part(&line, [0.25, 0.75]);
        assert_eq!(found, [[0.5, 0.0], [1.0, 0.0], [1.0, 0.5]]);
        assert_eq!(part(&line, [0.0, 1.0]), line);
    }
}
