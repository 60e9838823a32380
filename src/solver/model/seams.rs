//! Ways in which the two points of each stitch of a scene are joined.

use crate::scene::Scene;
use crate::solver::forces::SewingForce;
use crate::solver::model::dof_map::DofMap;
use crate::solver::options::{SeamClose, SolverOptions};

/// Joint of the two points of each stitch.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Seams {
    /// Springs that pull these pairs of vertices together (P9).
    Open {
        /// Pairs of vertices.
        stitches: Vec<(usize, usize)>,
        /// Stiffness of each spring \[N/m\].
        stiffness: f64,
        /// Greatest force of each spring \[N\].
        max_force: f64,
    },
    /// One particle for both points.
    Welded,
    /// Springs that keep the points of all stitches together.
    Stiff {
        /// Stiffness of each spring \[N/m\].
        stiffness: f64,
    },
    /// No joint: panels apart.
    Apart,
}

impl Seams {
    /// Returns closed seams as `options` ask for them, after springs of the stiffness `sewing`
    /// \[N/m\] have closed them.
    pub(crate) fn closed(options: &SolverOptions, sewing: f64) -> Self {
        match options.seam_close {
            SeamClose::Weld => Self::Welded,
            SeamClose::Spring => Self::Stiff {
                stiffness: options.closed_seam_stiffness(sewing),
            },
        }
    }

    /// Returns the particle of each vertex of `scene`.
    pub(crate) fn dof_map(&self, scene: &Scene) -> DofMap {
        match self {
            Self::Welded => DofMap::welded(scene.start.len(), stitches(scene)),
            Self::Open { .. } | Self::Stiff { .. } | Self::Apart => {
                DofMap::identity(scene.start.len())
            }
        }
    }

    /// Returns the springs between particles that join the stitches, if there are any.
    pub(crate) fn springs(&self, scene: &Scene, dof_map: &DofMap) -> Option<SewingForce> {
        let (pairs, stiffness, max_force) = match self {
            Self::Open {
                stitches,
                stiffness,
                max_force,
            } => (stitches.clone(), *stiffness, *max_force),
            Self::Stiff { stiffness } => (stitches(scene).collect(), *stiffness, f64::INFINITY),
            Self::Welded | Self::Apart => return None,
        };
        let springs = SewingForce::new(dof_map.pairs(&pairs), stiffness).with_max_force(max_force);
        (!pairs.is_empty()).then_some(springs)
    }
}

fn stitches(scene: &Scene) -> impl Iterator<Item = (usize, usize)> {
    scene.mesh.stitches.iter().map(|s| (s.a, s.b))
}
