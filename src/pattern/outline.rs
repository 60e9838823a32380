//! An outline: corners, the edges between them, and notches on these.

use super::point::{Point2, distance};
use super::polyline::{PolylineFoot, length};
use super::{Corner, Edge, Notch, NotchKind};

/// An outline: its corners and the edges between them.
pub(crate) struct Outline {
    /// Its corners.
    pub(crate) corners: Vec<Corner>,
    /// From corner to corner, as many as corners.
    pub(crate) edges: Vec<Edge>,
}

impl Outline {
    /// Cuts a closed polyline at its corners, the first of which must be point 0.
    pub(crate) fn cut(points: &[Point2], is_corner: &[bool]) -> Self {
        let at: Vec<usize> = (0..points.len()).filter(|i| is_corner[*i]).collect();
        let count = at.len();
        let corners = at
            .iter()
            .enumerate()
            .map(|(index, i)| Corner {
                index,
                x: points[*i][0],
                y: points[*i][1],
            })
            .collect();
        let edges = (0..count)
            .map(|index| {
                let end = at.get(index + 1).copied().unwrap_or(points.len());
                let mut points_on: Vec<Point2> = points[at[index]..end].to_vec();
                points_on.push(points[end % points.len()]);
                Edge {
                    index,
                    from: index,
                    to: (index + 1) % count,
                    length_m: length(&points_on),
                    points: points_on,
                    label: None,
                }
            })
            .collect();
        Self { corners, edges }
    }
}

/// Returns the corners that edges leave.
pub(crate) fn corners_of(edges: &[Edge]) -> Vec<Corner> {
    let corner = |edge: &Edge| {
        let [x, y] = edge.points[0];
        let index = edge.index;
        Corner { index, x, y }
    };
    edges.iter().map(corner).collect()
}

/// Returns the closed polyline that edges make up.
pub(crate) fn ring_of(edges: &[Edge]) -> Vec<Point2> {
    edges
        .iter()
        .flat_map(|edge| {
            edge.points[..edge.points.len().saturating_sub(1)]
                .iter()
                .copied()
        })
        .collect()
}

/// Returns the notch at a foot on the closed polyline that `edges` make up.
pub(crate) fn notch_at(edges: &[Edge], foot: PolylineFoot, kind: NotchKind, index: usize) -> Notch {
    let mut segment = foot.segment;
    for edge in edges {
        let count = edge.points.len().saturating_sub(1);
        if segment < count {
            let before = length(&edge.points[..=segment]);
            let part = foot.at * distance(edge.points[segment], edge.points[segment + 1]);
            let at = ((before + part) / edge.length_m).clamp(0.0, 1.0);
            return Notch {
                index,
                edge: edge.index,
                at,
                kind,
                depth_m: None,
            };
        }
        segment -= count;
    }
    Notch {
        index,
        edge: 0,
        at: 0.0,
        kind,
        depth_m: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::polyline::{nearest, segments};

    #[test]
    fn edges_run_from_corner_to_corner() {
        let points = [[0.0, 0.0], [0.0, 1.0], [0.5, 1.1], [1.0, 1.0], [1.0, 0.0]];
        let found = Outline::cut(&points, &[true, true, false, true, true]);
        assert_eq!(
            found
                .edges
                .iter()
                .map(|e| (e.from, e.to))
                .collect::<Vec<_>>(),
            [(0, 1), (1, 2), (2, 3), (3, 0)]
        );
        assert_eq!(found.edges[1].points, points[1..4]);
        assert_eq!(found.edges[3].points, [[1.0, 0.0], [0.0, 0.0]]);
        assert_eq!(ring_of(&found.edges), points);
    }

    #[test]
    fn notch_lies_at_its_fraction_of_the_edge() {
        let points = [[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0]];
        let found = Outline::cut(&points, &[true, false, true, true, true]);
        let foot = nearest(segments(&points), [0.01, 1.5]).expect("segments");
        let notch = notch_at(&found.edges, foot, NotchKind::V, 0);
        assert_eq!((notch.edge, notch.at), (0, 0.75));
    }
}
