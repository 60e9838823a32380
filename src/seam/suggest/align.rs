//! Segmental alignment: divides the outline of a panel into the edge roles of a template, at the
//! least misfit.
//!
//! A template is the cycle of roles round a panel, each with the length, the bend and the corner
//! that it usually has. Every way to divide the outline into these roles is compared by dynamic
//! programming, from every edge and in both directions, so that it does not matter how the panel is
//! turned in its drawing.

use super::edge_templates::{EdgeTemplate, PanelTemplate};
use super::labeled_panel::RoleSegment;
use super::labels::{DrawnSide, EdgeRole};
use super::outline_features::{MAX_EDGES, OutlineFeatures};
use serde::Deserialize;

/// An outline divided into roles.
#[derive(Clone, Debug)]
pub(super) struct Alignment {
    pub(super) segments: Vec<RoleSegment>,
    /// Mean misfit of a role.
    pub(super) cost: f64,
}

/// Weights of the misfit of an alignment.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AlignmentWeights {
    /// Most that a single feature may cost.
    max_misfit: f64,
    /// Turn up to which a corner inside a role costs nothing \[degrees\].
    smooth_corner_deg: f64,
    /// Turn beyond that which costs one half; the cost grows with its square \[degrees\].
    sharp_corner_deg: f64,
    /// Most that a sharp corner inside a role may cost, as a share of `max_misfit`: necks may be
    /// square and hems and waists have slits, shoulders are straight.
    sharp_corner_neck: f64,
    sharp_corner_hem: f64,
    sharp_corner_other: f64,
    /// Usual difference of two sides of a panel, as a logarithm.
    unevenness: f64,
    /// Weight of that difference for a symmetric panel.
    symmetric_weight: f64,
}

impl AlignmentWeights {
    fn misfit(&self, value: f64, [mean, spread]: [f64; 2]) -> f64 {
        (0.5 * ((value - mean) / spread).powi(2)).min(self.max_misfit)
    }

    /// Returns the cost of a corner inside an edge of this role \[turn in degrees\].
    fn corner_cost(&self, role: EdgeRole, turn: f64) -> f64 {
        let sharp = (turn.abs() - self.smooth_corner_deg).max(0.0) / self.sharp_corner_deg;
        let share = match role {
            EdgeRole::Neck => self.sharp_corner_neck,
            EdgeRole::Hem | EdgeRole::Waist => self.sharp_corner_hem,
            _ => self.sharp_corner_other,
        };
        (0.5 * sharp.powi(2)).min(share * self.max_misfit)
    }

    /// Returns the cost of segments of one role that differ in length.
    fn unevenness_cost(&self, features: &OutlineFeatures, segments: &[RoleSegment]) -> f64 {
        let mut cost = 0.0;
        // Of a leg in one piece the crotch is longer behind than in front.
        let is_alike = |s: &&RoleSegment| s.role != EdgeRole::Crotch;
        for (i, a) in segments.iter().enumerate().filter(|(_, s)| is_alike(s)) {
            for b in segments[i + 1..].iter().filter(|b| b.role == a.role) {
                let ratio = (features.length(&a.edges) / features.length(&b.edges)).ln();
                cost += self.misfit(ratio, [0.0, self.unevenness]);
            }
        }
        cost
    }
}

/// Returns the alignments of an outline with `template`, the best first: several for each first
/// edge and direction.
pub(super) fn align(
    features: &OutlineFeatures,
    template: &PanelTemplate,
    weights: &AlignmentWeights,
) -> Vec<Alignment> {
    let ring_edges = features.ring.len();
    let roles = template.edges.len();
    if ring_edges < roles || ring_edges > MAX_EDGES {
        return vec![];
    }
    let symmetric = features.is_symmetric();
    let readings: &[bool] = if template.half {
        &[true, false]
    } else {
        &[true]
    };
    let ways = readings.iter().flat_map(|forward| {
        (0..ring_edges).map(move |start| SegmentalAligner {
            features,
            templates: &template.edges,
            weights,
            forward: *forward,
            start,
            symmetric,
        })
    });
    let mut found: Vec<Alignment> = ways
        .flat_map(|reading| reading.alignments(template.half))
        .collect();
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    found
}

/// Aligns an outline with a template from one edge on, in one direction.
#[derive(Clone, Copy)]
struct SegmentalAligner<'a> {
    features: &'a OutlineFeatures,
    templates: &'a [EdgeTemplate],
    weights: &'a AlignmentWeights,
    forward: bool,
    start: usize,
    /// True if the panel is its own mirror image.
    symmetric: bool,
}

impl SegmentalAligner<'_> {
    /// Returns the template of the `k`th role in order of numbers.
    fn edge_template(&self, k: usize) -> EdgeTemplate {
        let count = self.templates.len();
        if self.forward {
            self.templates[k]
        } else {
            self.templates[count - 1 - k]
        }
    }

    /// Returns the usual corner after the `k`th role, as mean and spread \[degrees\].
    fn corner(&self, k: usize) -> [f64; 2] {
        let count = self.templates.len();
        if self.forward {
            self.templates[k].corner
        } else {
            self.templates[(2 * count - 2 - k) % count].corner
        }
    }

    fn ring(&self, place: usize) -> usize {
        (self.start + place) % self.features.ring.len()
    }

    /// Returns the division of least misfit: the place after the last edge of each role.
    fn best(&self) -> Option<Vec<usize>> {
        let (edges, roles) = (self.features.ring.len(), self.templates.len());
        let mut table = vec![vec![(f64::INFINITY, 0usize); edges + 1]; roles + 1];
        table[0][0].0 = 0.0;
        for k in 0..roles {
            for from in k..edges {
                let so_far = table[k][from].0;
                if !so_far.is_finite() {
                    continue;
                }
                let mut run = SegmentFeatures::default();
                let last = edges - (roles - 1 - k);
                let ends = table[k + 1].iter_mut().enumerate();
                for (to, best) in ends.take(last + 1).skip(from + 1) {
                    self.lengthen(&mut run, k, (from, to));
                    let cost = so_far + self.role_cost(&run, k, to);
                    if cost < best.0 {
                        *best = (cost, from);
                    }
                }
            }
        }
        let mut ends = vec![edges; roles];
        for k in (1..roles).rev() {
            ends[k - 1] = table[k + 1][ends[k]].1;
        }
        table[roles][edges].0.is_finite().then_some(ends)
    }

    /// Returns the best alignment, and those in which one role ends an edge earlier or later.
    fn alignments(&self, half: bool) -> Vec<Alignment> {
        let Some(best) = self.best() else {
            return vec![];
        };
        let mut all = vec![best.clone()];
        for k in 0..best.len() - 1 {
            for moved in [best[k] - 1, best[k] + 1] {
                let before = if k == 0 { 0 } else { best[k - 1] };
                if before < moved && moved < best[k + 1] {
                    let mut ends = best.clone();
                    ends[k] = moved;
                    all.push(ends);
                }
            }
        }
        if !half && best.len() % 2 == 0 {
            for ends in evened(&best) {
                if !all.contains(&ends) {
                    all.push(ends);
                }
            }
        }
        all.iter().map(|ends| self.with_cost(ends, half)).collect()
    }

    fn with_cost(&self, ends: &[usize], half: bool) -> Alignment {
        let mut from = 0;
        let mut cost = 0.0;
        for (k, &to) in ends.iter().enumerate() {
            let mut run = SegmentFeatures::default();
            for next in from + 1..=to {
                self.lengthen(&mut run, k, (from, next));
            }
            cost += self.role_cost(&run, k, to);
            from = to;
        }
        let segments = self.segments(ends, half);
        if !half {
            let weight = if self.symmetric {
                self.weights.symmetric_weight
            } else {
                1.0
            };
            cost += weight * self.weights.unevenness_cost(self.features, &segments);
        }
        #[expect(clippy::cast_precision_loss, reason = "a handful of roles")]
        let count = self.templates.len() as f64;
        Alignment {
            segments,
            cost: cost / count,
        }
    }

    /// Adds the edge before `to` to a segment of the `k`th role that begins at `from`.
    fn lengthen(&self, run: &mut SegmentFeatures, k: usize, (from, to): (usize, usize)) {
        let edge = self.features.edges[self.features.ring[self.ring(to - 1)]];
        run.length += edge.length;
        run.bend += edge.bend;
        if to - 1 > from {
            let joint = self.features.joints[self.ring(to - 2)];
            run.bend += joint;
            let role = self.edge_template(k).role;
            run.corners += self.weights.corner_cost(role, joint.to_degrees());
        }
    }

    /// Returns the misfit of a segment that ends before `to` as the `k`th role, with the corner
    /// after it.
    fn role_cost(&self, run: &SegmentFeatures, k: usize, to: usize) -> f64 {
        let template = self.edge_template(k);
        let corner = self.features.joints[self.ring(to - 1)].to_degrees();
        let length = (run.length.max(1e-6) / self.features.size.max(1e-6)).ln();
        run.corners
            + self.weights.misfit(length, template.length)
            + self.weights.misfit(run.bend.to_degrees(), template.bend)
            + self.weights.misfit(corner, self.corner(k))
    }

    fn segments(&self, ends: &[usize], half: bool) -> Vec<RoleSegment> {
        let roles = ends.len();
        let mut segments: Vec<RoleSegment> = vec![];
        let mut from = 0;
        for (k, &to) in ends.iter().enumerate() {
            let role = self.edge_template(k).role;
            let second = if half {
                !self.forward
            } else {
                segments.iter().any(|s| s.role == role)
            };
            let drawn_side = if second {
                DrawnSide::Right
            } else {
                DrawnSide::Left
            };
            segments.push(RoleSegment {
                role,
                drawn_side: if self.features.mirrored {
                    drawn_side.other()
                } else {
                    drawn_side
                },
                edges: (from..to)
                    .map(|place| self.features.ring[self.ring(place)])
                    .collect(),
                before: self.edge_template((k + roles - 1) % roles).role,
            });
            from = to;
        }
        segments
    }
}

/// Returns a division with as many edges in each role on the right as on the left, and the other
/// way round.
fn evened(ends: &[usize]) -> Vec<Vec<usize>> {
    let roles = ends.len();
    let size = |k: usize| ends[k] - if k == 0 { 0 } else { ends[k - 1] };
    let total: usize = ends.last().copied().unwrap_or_default();
    let even = |from_left: bool| -> Option<Vec<usize>> {
        let mut sizes: Vec<usize> = (0..roles).map(size).collect();
        for k in 1..roles.div_ceil(2) {
            let (to, from) = if from_left {
                (roles - k, k)
            } else {
                (k, roles - k)
            };
            sizes[to] = size(from);
        }
        let middle = roles / 2;
        let others: usize = (0..roles).filter(|k| *k != middle).map(|k| sizes[k]).sum();
        sizes[middle] = total.checked_sub(others).filter(|left| *left > 0)?;
        let mut end = 0;
        Some(
            sizes
                .iter()
                .map(|size| {
                    end += size;
                    end
                })
                .collect(),
        )
    };
    [even(true), even(false)].into_iter().flatten().collect()
}

/// Features of edges that are to have one role.
#[derive(Clone, Copy, Debug, Default)]
struct SegmentFeatures {
    length: f64,
    bend: f64,
    /// Misfit of the corners inside it.
    corners: f64,
}
