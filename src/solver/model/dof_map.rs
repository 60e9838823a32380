//! The particle of each vertex: one of its own while sewing, one for all vertices of a stitch once
//! it is welded.

use nalgebra::Vector3;

/// Map from vertices to particles, the degrees of freedom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct DofMap {
    /// Particle of each vertex; `#V`.
    pub(crate) of_vertex: Vec<usize>,
    /// Number of particles.
    pub(crate) count: usize,
}

impl DofMap {
    /// Returns the map that makes every vertex a particle of its own.
    pub(crate) fn identity(vertex_count: usize) -> Self {
        Self {
            of_vertex: (0..vertex_count).collect(),
            count: vertex_count,
        }
    }

    /// Returns the map that makes vertices one particle which are connected by `pairs`.
    pub(crate) fn welded(vertex_count: usize, pairs: impl Iterator<Item = (usize, usize)>) -> Self {
        let mut parent: Vec<usize> = (0..vertex_count).collect();
        for (a, b) in pairs {
            let (a, b) = (root(&mut parent, a), root(&mut parent, b));
            // The lower index stays, so that particles are numbered in the order of vertices.
            parent[a.max(b)] = a.min(b);
        }
        let mut of_vertex = vec![0; vertex_count];
        let mut count = 0;
        for v in 0..vertex_count {
            let r = root(&mut parent, v);
            of_vertex[v] = if r == v {
                count += 1;
                count - 1
            } else {
                of_vertex[r]
            };
        }
        Self { of_vertex, count }
    }

    /// Returns the particles of each pair of vertices, without pairs that are one particle.
    pub(crate) fn pairs(&self, of_vertices: &[(usize, usize)]) -> Vec<(usize, usize)> {
        let pairs = of_vertices.iter();
        pairs
            .map(|&(a, b)| (self.of_vertex[a], self.of_vertex[b]))
            .filter(|(a, b)| a != b)
            .collect()
    }

    /// Returns triangles of vertices with particles for their corners.
    pub(crate) fn triangles(&self, of_vertices: &[[usize; 3]]) -> Vec<[usize; 3]> {
        let of_vertex = |t: &[usize; 3]| t.map(|v| self.of_vertex[v]);
        of_vertices.iter().map(of_vertex).collect()
    }

    /// Returns the sum over the vertices of each particle; `#P`.
    pub(crate) fn sum(&self, of_vertex: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.count];
        for (&particle, value) in self.of_vertex.iter().zip(of_vertex) {
            sum[particle] += value;
        }
        sum
    }

    /// Returns the mean over the vertices of each particle; `#P`.
    pub(crate) fn average(&self, of_vertex: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        let mut mean = vec![Vector3::zeros(); self.count];
        let mut number = vec![0.0; self.count];
        for (&particle, value) in self.of_vertex.iter().zip(of_vertex) {
            mean[particle] += value;
            number[particle] += 1.0;
        }
        mean.iter_mut().zip(&number).for_each(|(m, n)| *m /= *n);
        mean
    }

    /// Returns the value of each vertex's particle; `#V`.
    pub(crate) fn scatter(&self, of_particle: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        self.of_vertex
            .iter()
            .map(|&particle| of_particle[particle])
            .collect()
    }
}

fn root(parent: &mut [usize], mut v: usize) -> usize {
    while parent[v] != v {
        parent[v] = parent[parent[v]];
        v = parent[v];
    }
    v
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_of_pairs_become_one_particle() {
        let dof_map = DofMap::welded(5, [(4, 2), (2, 0)].into_iter());
        assert_eq!(dof_map.of_vertex, [0, 1, 0, 2, 0]);
        assert_eq!(dof_map.count, 3);
        assert_eq!(dof_map.sum(&[1.0; 5]), [3.0, 1.0, 1.0]);
    }
}
