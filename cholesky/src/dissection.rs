//! An order of elimination with little fill: nested dissection of the graph of particles that act
//! on each other.
//!
//! A. George, "Nested dissection of a regular finite element mesh", SIAM J. Numer. Anal. 10(2),
//! 1973; A. George, J. W.-H. Liu, "An automatic nested dissection algorithm for irregular finite
//! element problems", SIAM J. Numer. Anal. 15(5), 1978. A part of the graph is cut in two by few
//! vertices, the separator, which are eliminated last. Candidates are fronts of a breadth-first
//! search from several ends of the part, and of the difference of the distances to both ends; the
//! thinnest and most even cut is taken.

use crate::graph::Graph;

/// Parts with no more vertices are eliminated as they are.
const LEAF: usize = 16;
/// The same of whole components, which touch no others.
const LONE_LEAF: usize = 48;
/// Ends from which a part is looked at.
const ATTEMPTS: usize = 3;
/// Least share of a part on one side of its cut, in hundredths.
const LEAST_SHARE: usize = 38;

/// Vertices that are eliminated together: a separator or a leaf.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Part {
    pub(crate) vertices: Vec<usize>,
    /// The separator that cuts this part from others; none for the last of a connected graph.
    pub(crate) parent: Option<usize>,
}

/// Returns the parts that are left of `parts` where only some vertices are: `place` is the number
/// of each vertex among them. A dissection of a graph is one of each part of it.
pub(crate) fn restrict(parts: &[Part], place: &[Option<usize>]) -> Vec<Part> {
    let left = |part: &Part| -> Vec<usize> {
        let places = part.vertices.iter().map(|&v| place[v]);
        places.flatten().collect()
    };
    let mut restricted: Vec<Part> = parts
        .iter()
        .map(|part| Part {
            vertices: left(part),
            parent: None,
        })
        .collect();
    let kept = restricted.iter().filter(|part| !part.vertices.is_empty());
    let mut number = kept.count();
    // For each part itself, or the next above it that is not empty.
    let mut target: Vec<Option<usize>> = vec![None; parts.len()];
    for (i, part) in parts.iter().enumerate().rev() {
        let above = part.parent.and_then(|parent| target[parent]);
        restricted[i].parent = above;
        target[i] = above;
        if !restricted[i].vertices.is_empty() {
            number -= 1;
            target[i] = Some(number);
        }
    }
    restricted.retain(|part| !part.vertices.is_empty());
    restricted
}

/// Returns the parts of a graph, each before its parent.
pub(crate) fn dissect(graph: &Graph) -> Vec<Part> {
    let count = graph.vertex_count();
    let mut dissection = Dissection {
        graph,
        domain: vec![0; count],
        next_domain: 1,
        visit: vec![0; count],
        next_visit: 1,
        distance: vec![0; count],
        position: vec![0; count],
        parts: Vec::new(),
    };
    dissection.dissect((0..count).collect(), LONE_LEAF);
    dissection.parts
}

/// Two sides of a cut, and the vertices between them.
struct Cut {
    separator: Vec<usize>,
    sides: [Vec<usize>; 2],
}

/// A sequence of vertices, and where it is cut.
struct Candidate {
    sequence: Vec<usize>,
    /// Number of vertices before the cut.
    first: usize,
    /// True if the separator is taken from the vertices before the cut.
    is_before: bool,
    /// Size of the separator, dearer where the sides are uneven.
    cost: f64,
}

struct Dissection<'g> {
    graph: &'g Graph,
    /// The set of vertices that each was last put in.
    domain: Vec<usize>,
    next_domain: usize,
    /// The search that each vertex was last reached by.
    visit: Vec<usize>,
    next_visit: usize,
    /// Steps from the root of the last search.
    distance: Vec<usize>,
    /// Position of each vertex in the last sequence.
    position: Vec<usize>,
    parts: Vec<Part>,
}

impl Dissection<'_> {
    /// Adds the parts of `vertices`, of which those with no more than `leaf` are not cut; returns
    /// those without a parent.
    fn dissect(&mut self, vertices: Vec<usize>, leaf: usize) -> Vec<usize> {
        let domain = self.mark(&vertices);
        let mut roots = Vec::new();
        // One component after the other, so that recursion is no deeper than halving.
        for component in self.components(&vertices, domain) {
            roots.push(self.dissect_component(component, domain, leaf));
        }
        roots
    }

    fn dissect_component(&mut self, component: Vec<usize>, domain: usize, leaf: usize) -> usize {
        let cut = (component.len() > leaf).then(|| {
            let candidate = self.best_candidate(&component, domain);
            self.cut(&candidate, domain)
        });
        let cut = cut.filter(|cut| cut.sides.iter().all(|side| !side.is_empty()));
        let Some(Cut { separator, sides }) = cut else {
            return self.push(component, &[]);
        };
        let children: Vec<usize> = sides
            .into_iter()
            .flat_map(|side| self.dissect(side, LEAF))
            .collect();
        self.push(separator, &children)
    }

    /// Adds a part; returns its index.
    fn push(&mut self, vertices: Vec<usize>, children: &[usize]) -> usize {
        let index = self.parts.len();
        for &child in children {
            self.parts[child].parent = Some(index);
        }
        self.parts.push(Part {
            vertices,
            parent: None,
        });
        index
    }

    fn components(&mut self, vertices: &[usize], domain: usize) -> Vec<Vec<usize>> {
        let before = self.next_visit;
        let mut components = Vec::new();
        for &v in vertices {
            if self.visit[v] < before {
                components.push(self.search(v, domain));
            }
        }
        components
    }

    fn best_candidate(&mut self, component: &[usize], domain: usize) -> Candidate {
        let last = component.len() - 1;
        let starts = (0..ATTEMPTS).map(|attempt| component[last * (ATTEMPTS - attempt) / ATTEMPTS]);
        let mut best: Option<Candidate> = None;
        for start in starts {
            for sequence in self.sequences(start, domain) {
                let candidate = self.thinnest(sequence, domain);
                if best.as_ref().is_none_or(|best| candidate.cost < best.cost) {
                    best = Some(candidate);
                }
            }
        }
        best.expect("several were tried")
    }

    /// Returns the cut of a sequence that is the cheapest: one pass counts, for every place of the
    /// cut, the vertices on either side that touch the other.
    fn thinnest(&mut self, sequence: Vec<usize>, domain: usize) -> Candidate {
        let count = sequence.len();
        for (i, &v) in sequence.iter().enumerate() {
            self.position[v] = i;
        }
        // Changes of those numbers from one place to the next.
        let (mut before, mut after) = (vec![0_isize; count + 1], vec![0_isize; count + 1]);
        for (i, &v) in sequence.iter().enumerate() {
            let neighbors = self.graph.neighbors(v).iter();
            let in_domain = neighbors.filter(|&&w| self.domain[w] == domain);
            let (mut least, mut most) = (i, i);
            for &w in in_domain {
                least = least.min(self.position[w]);
                most = most.max(self.position[w]);
            }
            // It is before the cut and touches what is after it at the places i + 1 to most.
            before[i + 1] += 1;
            before[most + 1] -= 1;
            after[least + 1] += 1;
            after[i + 1] -= 1;
        }
        let least_first = (count * LEAST_SHARE / 100).max(1);
        let (mut of_before, mut of_after) = (0, 0);
        let mut best = (0, false, f64::INFINITY);
        for first in 0..=count - least_first {
            of_before += before[first];
            of_after += after[first];
            if first < least_first {
                continue;
            }
            let larger = first.max(count - first) as f64 / count as f64;
            let cost = of_before.min(of_after) as f64 * (0.5 + larger);
            if cost < best.2 {
                best = (first, of_before <= of_after, cost);
            }
        }
        let (first, is_before, cost) = best;
        Candidate {
            sequence,
            first,
            is_before,
            cost,
        }
    }

    /// Returns the vertices of a component by their distance from one of its ends, and by the
    /// difference of their distances to both: fronts of the latter are straighter.
    fn sequences(&mut self, start: usize, domain: usize) -> [Vec<usize>; 2] {
        // The last reached is at the rim; from there once more, it is at the end of the longest
        // way.
        let rim = self.search(start, domain);
        let along = self.search(rim[rim.len() - 1], domain);
        let from_first: Vec<usize> = along.iter().map(|&v| self.distance[v]).collect();
        self.search(along[along.len() - 1], domain);
        let farthest = along.len();
        let mut between: Vec<(usize, usize, usize)> = along
            .iter()
            .zip(from_first)
            .enumerate()
            .map(|(i, (&v, first))| (farthest + first - self.distance[v], i, v))
            .collect();
        between.sort_unstable();
        let between = between.into_iter().map(|(_, _, v)| v).collect();
        [along, between]
    }

    /// Cuts a sequence: the separator are those of one side that touch the other, less those that
    /// need not be there.
    fn cut(&mut self, candidate: &Candidate, domain: usize) -> Cut {
        let (head, tail) = candidate.sequence.split_at(candidate.first);
        let tail_domain = self.mark(tail);
        let (side, rim, other) = if candidate.is_before {
            (head, self.touching(head, tail_domain), tail)
        } else {
            (tail, self.touching(tail, domain), head)
        };
        let rim_domain = self.mark(&rim);
        let near = side.iter().filter(|&&v| self.domain[v] != rim_domain);
        let mut sides = [near.copied().collect(), other.to_vec()];
        let separator = self.thin(rim, &mut sides);
        Cut { separator, sides }
    }

    /// Returns the vertices that touch `domain`.
    fn touching(&self, vertices: &[usize], domain: usize) -> Vec<usize> {
        let touches = |&v: &usize| {
            let mut neighbors = self.graph.neighbors(v).iter();
            neighbors.any(|&w| self.domain[w] == domain)
        };
        vertices.iter().copied().filter(touches).collect()
    }

    /// Returns the vertices of a separator that touch both sides; the others join a side.
    fn thin(&mut self, separator: Vec<usize>, sides: &mut [Vec<usize>; 2]) -> Vec<usize> {
        let domains = sides.each_ref().map(|side| self.mark(side));
        let mut kept = Vec::with_capacity(separator.len());
        for v in separator {
            let [near, far] = domains.map(|domain| {
                let mut neighbors = self.graph.neighbors(v).iter();
                neighbors.any(|&w| self.domain[w] == domain)
            });
            if near && far {
                kept.push(v);
                continue;
            }
            let joined = usize::from(far);
            self.domain[v] = domains[joined];
            sides[joined].push(v);
        }
        kept
    }

    /// Puts vertices into a new domain.
    fn mark(&mut self, vertices: &[usize]) -> usize {
        let domain = self.next_domain;
        self.next_domain += 1;
        for &v in vertices {
            self.domain[v] = domain;
        }
        domain
    }

    /// Returns the vertices of a domain that hang together with `root`, nearest first.
    fn search(&mut self, root: usize, domain: usize) -> Vec<usize> {
        let visit = self.next_visit;
        self.next_visit += 1;
        let mut reached = vec![root];
        self.visit[root] = visit;
        self.distance[root] = 0;
        let mut next = 0;
        while next < reached.len() {
            let v = reached[next];
            for &w in self.graph.neighbors(v) {
                if self.domain[w] == domain && self.visit[w] != visit {
                    self.visit[w] = visit;
                    self.distance[w] = self.distance[v] + 1;
                    reached.push(w);
                }
            }
            next += 1;
        }
        reached
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(count: usize) -> Graph {
        Graph::from_pairs(count, (1..count).map(|i| (i - 1, i)))
    }

    #[test]
    fn every_vertex_comes_once_also_in_components() {
        // A row of 40, and another of 30 that does not hang on it.
        let pairs = (0..39).chain(40..69).map(|i| (i, i + 1));
        let parts = dissect(&Graph::from_pairs(70, pairs));
        let mut all: Vec<usize> = parts.iter().flat_map(|p| p.vertices.clone()).collect();
        all.sort_unstable();
        assert!(all.into_iter().eq(0..70));
        let roots = parts.iter().filter(|part| part.parent.is_none());
        assert_eq!(roots.count(), 2);
    }

    #[test]
    fn what_separates_two_halves_comes_last() {
        let parts = dissect(&path(100));
        let [middle] = parts[parts.len() - 1].vertices[..] else {
            panic!("one vertex separates a path");
        };
        assert!((38..62).contains(&middle), "{middle}");
    }

    #[test]
    fn parts_below_a_separator_do_not_touch_each_other() {
        let grid = |i: usize| (i % 20, i / 20);
        let beside = |i: usize| {
            let (x, y) = grid(i);
            [
                (x + 1 < 20).then_some((i, i + 1)),
                (y + 1 < 20).then_some((i, i + 20)),
            ]
        };
        let graph = Graph::from_pairs(400, (0..400).flat_map(beside).flatten());
        let parts = dissect(&graph);
        let mut part_of = vec![0; 400];
        for (i, part) in parts.iter().enumerate() {
            part.vertices.iter().for_each(|&v| part_of[v] = i);
        }
        let ancestors = |i: usize| std::iter::successors(Some(i), |&i| parts[i].parent);
        for v in 0..400 {
            for &w in graph.neighbors(v) {
                let (low, high) = (part_of[v].min(part_of[w]), part_of[v].max(part_of[w]));
                assert!(ancestors(low).any(|i| i == high), "{v} touches {w}");
            }
        }
    }
}
