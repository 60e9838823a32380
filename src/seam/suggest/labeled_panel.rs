//! A panel as a part of a garment: its kind, and which of its edges are its hem, its side, its
//! armhole.

use super::darts::Dart;
use super::edge_chain::{EdgeChain, EdgeStep, WHOLE, reversed};
use super::labels::{DrawnSide, EdgeRole, FrontBack, Laterality, PanelKind};
use super::outline_features::OutlineFeatures;
use std::rc::Rc;

/// Edges of one role, one after another.
#[derive(Clone, Debug)]
pub(super) struct RoleSegment {
    pub(super) role: EdgeRole,
    pub(super) drawn_side: DrawnSide,
    /// In order of numbers; darts between them are left out.
    pub(super) edges: Vec<usize>,
    /// The role before it.
    pub(super) before: EdgeRole,
}

/// A panel whose edges have roles.
#[derive(Clone, Debug)]
pub(super) struct LabeledPanel {
    /// Its index in the pattern; mirrored copies that the suggestion adds come after all of the
    /// pattern's own.
    pub(super) panel: usize,
    pub(super) kind: PanelKind,
    /// Other kinds that its name says: the sleeve or the leg of a cuff.
    pub(super) of: Vec<PanelKind>,
    /// Its place in a row of such panels.
    pub(super) number: u32,
    pub(super) front_back: Option<FrontBack>,
    pub(super) laterality: Option<Laterality>,
    /// True if its name says left or right.
    pub(super) laterality_named: bool,
    /// True if it covers one side of the body only.
    pub(super) half: bool,
    /// True if it is drawn as seen through the body: not with its outer side up.
    pub(super) drawn_from_inside: bool,
    /// Kind that it is read beside: a front or back that ends at a yoke, or at a side panel.
    pub(super) beside: Option<PanelKind>,
    pub(super) features: Rc<OutlineFeatures>,
    pub(super) segments: Vec<RoleSegment>,
    /// Misfit with what such a panel usually looks like; 0 is best.
    pub(super) cost: f64,
    /// True if its name says its kind, or front or back.
    pub(super) named: bool,
    /// True if its name says its kind, not only front or back.
    pub(super) kind_named: bool,
}

impl LabeledPanel {
    /// Returns the wearer's side on which a side of the drawing lies: a front with its outer side
    /// up has the wearer's right on its left.
    pub(super) fn laterality_of(&self, drawn_side: DrawnSide) -> Laterality {
        let behind = self.front_back == Some(FrontBack::Back);
        if (drawn_side == DrawnSide::Left) == (behind != self.drawn_from_inside) {
            Laterality::Left
        } else {
            Laterality::Right
        }
    }

    /// Returns the side of the drawing at which a segment on the upper edge begins, in order of
    /// numbers.
    pub(super) fn first_drawn_side(&self) -> DrawnSide {
        if self.features.mirrored {
            DrawnSide::Right
        } else {
            DrawnSide::Left
        }
    }

    /// Returns the side of the drawing that lies on this side of the wearer.
    pub(super) fn drawn_side_of(&self, laterality: Laterality) -> DrawnSide {
        if self.laterality_of(DrawnSide::Left) == laterality {
            DrawnSide::Left
        } else {
            DrawnSide::Right
        }
    }

    /// Returns the segments of a role.
    pub(super) fn segments_of(&self, role: EdgeRole) -> impl Iterator<Item = &RoleSegment> {
        self.segments.iter().filter(move |s| s.role == role)
    }

    /// Returns the segment of a role, on one side of the drawing if there are two.
    pub(super) fn segment(
        &self,
        role: EdgeRole,
        drawn_side: Option<DrawnSide>,
    ) -> Option<&RoleSegment> {
        self.segments_of(role)
            .find(|s| drawn_side.is_none_or(|drawn_side| s.drawn_side == drawn_side))
    }

    /// Returns a segment in order of numbers.
    pub(super) fn chain(&self, segment: &RoleSegment) -> EdgeChain {
        let step = |&edge: &usize| EdgeStep {
            panel: self.panel,
            hole: None,
            edge,
            forward: true,
            length: self.features.edges[edge].length,
            span: WHOLE,
        };
        segment.edges.iter().map(step).collect()
    }

    /// Returns a segment from where it meets `role`.
    pub(super) fn chain_from(&self, segment: &RoleSegment, role: EdgeRole) -> EdgeChain {
        let chain = self.chain(segment);
        if segment.before == role {
            chain
        } else {
            reversed(&chain)
        }
    }

    /// Returns the segment of a role as [`Self::segment`] finds it, from where it meets `from`.
    pub(super) fn role_chain(
        &self,
        role: EdgeRole,
        drawn_side: Option<DrawnSide>,
        from: EdgeRole,
    ) -> Option<EdgeChain> {
        let segment = self.segment(role, drawn_side)?;
        Some(self.chain_from(segment, from))
    }

    /// Returns the chain of one edge.
    pub(super) fn edge_chain(&self, edge: usize, forward: bool) -> EdgeChain {
        vec![EdgeStep {
            panel: self.panel,
            hole: None,
            edge,
            forward,
            length: self.features.edges[edge].length,
            span: WHOLE,
        }]
    }

    /// Returns the legs of a dart, each from the mouth to the tip.
    pub(super) fn dart_legs(&self, dart: Dart) -> [EdgeChain; 2] {
        let [inward, outward] = dart.legs(self.features.edges.len());
        [(inward, true), (outward, false)].map(|(edges, forward)| {
            let steps = edges.into_iter().map(|edge| self.edge_chain(edge, forward));
            steps.flatten().collect()
        })
    }

    /// Returns the segments on both sides of a segment: the one that it begins at in order of
    /// numbers, and the one that it ends at.
    pub(super) fn beside(&self, segment: &RoleSegment) -> Option<[&RoleSegment; 2]> {
        let count = self.segments.len();
        let at = self
            .segments
            .iter()
            .position(|s| s.edges == segment.edges)?;
        Some([
            &self.segments[(at + count - 1) % count],
            &self.segments[(at + 1) % count],
        ])
    }

    /// Returns all edges of a role.
    pub(super) fn role_edges(&self, role: EdgeRole) -> Vec<usize> {
        let segments = self.segments_of(role);
        segments.flat_map(|s| s.edges.iter().copied()).collect()
    }

    /// Returns the length of all segments of a role together \[m\].
    pub(super) fn role_length(&self, role: EdgeRole) -> f64 {
        let segments = self.segments_of(role);
        segments.map(|s| self.features.length(&s.edges)).sum()
    }

    /// Returns the mean length of the segments of a role \[m\]; 0 where there are none.
    pub(super) fn mean_length(&self, role: EdgeRole) -> f64 {
        self.role_length(role) / self.segments_of(role).count().max(1) as f64
    }

    /// Returns the length that it has of a role on one side of the wearer \[m\].
    pub(super) fn one_side_length(&self, role: EdgeRole) -> f64 {
        self.role_length(role) / self.sides()
    }

    /// Returns the number of sides of the wearer that it covers: a half one, a whole panel two.
    pub(super) fn sides(&self) -> f64 {
        if self.half { 1.0 } else { 2.0 }
    }
}
