//! The fixed points of a panel: its outline and holes, divided, and the internal lines that are
//! sewn to.

use super::geometry;
use super::panel_division::PanelDivision;
use crate::pattern::Panel;
use crate::pattern::point::Point2;
use std::ops::Range;

/// The number of a point that lies on another edge, until that edge is known.
const UNKNOWN: usize = usize::MAX;

/// A panel's boundary as closed rings of points, the outline first, then the holes; after them its
/// sewn lines.
#[derive(Debug)]
pub(super) struct Boundary {
    /// \[m\]
    pub(super) points: Vec<Point2>,
    /// The points of each ring.
    pub(super) rings: Vec<Range<usize>>,
    /// The point at which each edge of the outline begins.
    pub(super) edge_starts: Vec<usize>,
    /// The points of each edge, both ends included; see [`super::slots::Slots`].
    edges: Vec<Vec<usize>>,
    /// The edges that are internal lines: their index in the panel and in `edges`.
    lines: Vec<(usize, usize)>,
}

impl Boundary {
    /// Places the points of a panel's boundary by its division.
    pub(super) fn new(panel: &Panel, divided: &PanelDivision) -> Self {
        let mut boundary = Self {
            points: vec![],
            rings: vec![],
            edge_starts: vec![],
            edges: vec![],
            lines: vec![],
        };
        for ring in &divided.slots.rings {
            boundary.add_ring(panel, divided, ring.clone());
        }
        let outline = boundary.edges.iter().take(panel.edges.len());
        boundary.edge_starts = outline.map(|edge| edge[0]).collect();
        let first_line = divided.slots.first_line();
        for (place, &line) in divided.slots.lines.iter().enumerate() {
            boundary.add_line(panel, divided, first_line + place);
            boundary.lines.push((line, first_line + place));
        }
        boundary.join(divided);
        boundary
    }

    /// Closed rings of points, the outline first, without edges or lines.
    pub(super) fn of_rings(points: Vec<Point2>, rings: Vec<Range<usize>>) -> Self {
        Self {
            points,
            rings,
            edge_starts: vec![],
            edges: vec![],
            lines: vec![],
        }
    }

    /// Mesh edges along the rings, each as two point indices.
    pub(super) fn ring_segments(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.rings.iter().flat_map(|ring| {
            let (first, last) = (ring.start, ring.end - 1);
            (first..last).map(|i| [i, i + 1]).chain([[last, first]])
        })
    }

    /// Mesh edges along the sewn lines, with the index of the line.
    pub(super) fn line_segments(&self) -> impl Iterator<Item = (usize, [usize; 2])> + '_ {
        self.lines.iter().flat_map(|&(line, edge)| {
            let points = self.edges[edge].windows(2);
            points.map(move |pair| (line, [pair[0], pair[1]]))
        })
    }

    /// Mesh edges that must be there.
    pub(super) fn segments(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let lines = self.line_segments().map(|(_, segment)| segment);
        self.ring_segments().chain(lines)
    }

    /// Number of points of the rings; those of the lines follow.
    pub(super) fn ring_point_count(&self) -> usize {
        self.rings.last().map_or(0, |ring| ring.end)
    }

    /// The point at the beginning of a part of an edge; one past the last part is the edge's end.
    pub(super) fn vertex(&self, edge: usize, part: usize) -> usize {
        self.edges[edge][part]
    }

    /// Returns its mirror image, x to -x.
    pub(super) fn reflected(mut self) -> Self {
        for point in &mut self.points {
            *point = geometry::reflected(*point);
        }
        self
    }

    fn add_ring(&mut self, panel: &Panel, divided: &PanelDivision, edges: Range<usize>) {
        let first = self.points.len();
        let first_edge = self.edges.len();
        for edge in edges {
            let division = &divided.divisions[edge];
            let start = self.points.len();
            let at = division.starts().map(|fraction| fraction * division.length);
            self.points
                .extend(geometry::resample(divided.points(panel, edge), at));
            self.edges.push((start..=self.points.len()).collect());
        }
        let end = self.points.len();
        for point in self.edges[first_edge..].iter_mut().flatten() {
            if *point == end {
                *point = first;
            }
        }
        self.rings.push(first..end);
    }

    /// Adds a line's points; those at its joints are known to [`Self::join`] only.
    fn add_line(&mut self, panel: &Panel, divided: &PanelDivision, edge: usize) {
        let division = &divided.divisions[edge];
        let points = divided.points(panel, edge);
        let first = self.points.len();
        let joint = |last| {
            divided
                .joints
                .iter()
                .any(|j| (j.line, j.last) == (edge, last))
        };
        let at = division.starts().map(|fraction| fraction * division.length);
        let starts = geometry::resample(points, at);
        let mut numbers = vec![];
        for (i, point) in starts.into_iter().enumerate() {
            if i == 0 && joint(false) {
                numbers.push(UNKNOWN);
                continue;
            }
            numbers.push(self.points.len());
            self.points.push(point);
        }
        if divided.is_closed(panel, edge) {
            numbers.push(first);
        } else if joint(true) {
            numbers.push(UNKNOWN);
        } else {
            numbers.push(self.points.len());
            self.points.extend(points.last());
        }
        self.edges.push(numbers);
    }

    /// Gives the ends of lines that lie on other edges the points of those. Joints come in the
    /// order of lines, so that of lines that meet end to end the one is known that the other is
    /// joined to.
    fn join(&mut self, divided: &PanelDivision) {
        for joint in &divided.joints {
            let part = divided.divisions[joint.on].part_at(joint.at);
            let point = self.edges[joint.on][part];
            let ends = &mut self.edges[joint.line];
            let end = if joint.last { ends.len() - 1 } else { 0 };
            ends[end] = point;
        }
    }
}
