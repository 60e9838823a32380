//! A hierarchy of ever coarser meshes of one scene, and the interpolation of shapes from each to
//! the next finer one.

use crate::scene::{CoarserScene, Scene, coarser};
use crate::solver::drape::continuation::softened_scenes;
use nalgebra::Vector3;

/// A scene and its coarser versions.
pub(crate) struct MeshHierarchy<'s> {
    finest: &'s Scene,
    /// Ever coarser.
    coarser: Vec<CoarserScene>,
}

impl<'s> MeshHierarchy<'s> {
    /// Makes a hierarchy of the scene alone.
    pub(crate) fn single(finest: &'s Scene) -> Self {
        Self {
            finest,
            coarser: vec![],
        }
    }

    /// Makes all levels worth having; of stiff cloth, softer ones of the same mesh come before the
    /// scene itself.
    pub(crate) fn new(finest: &'s Scene) -> Self {
        let same_mesh = |scene: Scene| CoarserScene {
            finer: (0..scene.start.len()).collect(),
            weights: vec![],
            scene,
        };
        let mut levels: Vec<CoarserScene> =
            softened_scenes(finest).into_iter().map(same_mesh).collect();
        while let Some(next) = coarser(levels.last().map_or(finest, |level| &level.scene)) {
            levels.push(next);
        }
        Self {
            finest,
            coarser: levels,
        }
    }

    /// Returns the number of the coarsest level; the finest is 0.
    pub(crate) fn coarsest(&self) -> usize {
        self.coarser.len()
    }

    /// Returns the number of vertices of each level, coarsest first.
    pub(crate) fn sizes(&self) -> Vec<usize> {
        let levels = (0..=self.coarsest()).rev();
        levels.map(|level| self.scene(level).start.len()).collect()
    }

    /// Returns true if a level has the mesh of the next finer one, of softer cloth.
    pub(crate) fn is_softer(&self, level: usize) -> bool {
        level > 0 && self.coarser[level - 1].weights.is_empty()
    }

    /// Returns the scene on a level.
    pub(crate) fn scene(&self, level: usize) -> &Scene {
        match level.checked_sub(1) {
            None => self.finest,
            Some(index) => &self.coarser[index].scene,
        }
    }

    /// Interpolates the shape `x` of level `level` on the next finer one.
    ///
    /// Within each coarse triangle the image of p is `sum w_i (x_i + G_i (p - p_i) / 2)`, `G_i` the
    /// mean deformation gradient at corner i: exact for quadratic shapes where the gradients are,
    /// so that bent cloth is handed on bent and not faceted.
    pub(crate) fn refine(&self, level: usize, x: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        let coarse = &self.coarser[level - 1];
        if self.is_softer(level) {
            return x.to_vec();
        }
        let fine = self.scene(level - 1);
        let gradients = gradients(&coarse.scene, x);
        let rest = &coarse.scene.mesh.uv;
        let image = |(corners, p): (&[(usize, f64); 3], &[f64; 2])| {
            corners
                .iter()
                .map(|&(v, w)| {
                    let [u, t] = gradients[v];
                    let d = [p[0] - rest[v][0], p[1] - rest[v][1]];
                    (x[v] + (u * d[0] + t * d[1]) * 0.5) * w
                })
                .sum()
        };
        coarse
            .weights
            .iter()
            .zip(&fine.mesh.uv)
            .map(image)
            .collect()
    }

    /// Interpolates the shape `x` of level `level` on the finest one.
    pub(crate) fn to_finest(&self, level: usize, x: Vec<Vector3<f64>>) -> Vec<Vector3<f64>> {
        (1..=level).rev().fold(x, |x, level| self.refine(level, &x))
    }
}

/// Returns the deformation gradient at each vertex, the images of the two unit vectors of the
/// pattern: the mean over its triangles, weighted by area.
fn gradients(scene: &Scene, x: &[Vector3<f64>]) -> Vec<[Vector3<f64>; 2]> {
    let uv = &scene.mesh.uv;
    let mut sum = vec![[Vector3::zeros(); 2]; x.len()];
    let mut area = vec![0.0; x.len()];
    for &[a, b, c] in &scene.mesh.triangles {
        let (u, v) = (
            [uv[b][0] - uv[a][0], uv[b][1] - uv[a][1]],
            [uv[c][0] - uv[a][0], uv[c][1] - uv[a][1]],
        );
        let (e, f) = (x[b] - x[a], x[c] - x[a]);
        // Twice the area times the gradient: no division by a small number.
        let along = [e * v[1] - f * u[1], f * u[0] - e * v[0]];
        let twice = u[0] * v[1] - u[1] * v[0];
        for w in [a, b, c] {
            sum[w][0] += along[0];
            sum[w][1] += along[1];
            area[w] += twice;
        }
    }
    for (sum, area) in sum.iter_mut().zip(&area) {
        *sum = sum.map(|g| if *area == 0.0 { g } else { g / *area });
    }
    sum
}
