//! Affine maps of the drawing plane, which put the entities of a block in place.

use super::geometry::{BlockInsert, DxfEntity, EntityPath, EntityShape};
use crate::pattern::Point2;

/// An affine map of the plane: `linear` times the point plus `shift`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AffineMap {
    /// Rows of the linear part.
    linear: [[f64; 2]; 2],
    /// Translation.
    shift: Point2,
}

impl AffineMap {
    /// Returns the map that scales x and y by `factors`.
    pub(crate) fn scale(factors: [f64; 2]) -> Self {
        Self {
            linear: [[factors[0], 0.0], [0.0, factors[1]]],
            shift: [0.0, 0.0],
        }
    }

    /// Returns the map that moves points by a vector.
    pub(crate) fn translation(shift: Point2) -> Self {
        Self {
            linear: [[1.0, 0.0], [0.0, 1.0]],
            shift,
        }
    }

    /// Returns the map that turns points about the origin by an angle \[rad\].
    fn rotation(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self {
            linear: [[cos, -sin], [sin, cos]],
            shift: [0.0, 0.0],
        }
    }

    /// Returns the map of the copy of a block with base point `base` that an INSERT puts into the
    /// cell (column, row) of its array.
    pub(crate) fn of_insert(insert: &BlockInsert, base: Point2, cell: [u32; 2]) -> Self {
        let offset = [
            f64::from(cell[0]) * insert.spacing[0],
            f64::from(cell[1]) * insert.spacing[1],
        ];
        let map = Self::translation(insert.at)
            .after(&Self::rotation(insert.angle))
            .after(&Self::translation(offset))
            .after(&Self::scale(insert.scale))
            .after(&Self::translation([-base[0], -base[1]]));
        if insert.flipped {
            Self::scale([-1.0, 1.0]).after(&map)
        } else {
            map
        }
    }

    /// Returns the map that applies first `inner`, then `self`.
    pub(crate) fn after(&self, inner: &Self) -> Self {
        let [a, b] = inner.linear;
        let row = |r: [f64; 2]| [r[0] * a[0] + r[1] * b[0], r[0] * a[1] + r[1] * b[1]];
        Self {
            linear: self.linear.map(row),
            shift: self.apply(inner.shift),
        }
    }

    /// Returns the map without its translation.
    pub(crate) fn without_shift(self) -> Self {
        Self {
            shift: [0.0, 0.0],
            ..self
        }
    }

    /// Returns true if it turns over what it maps.
    pub(crate) fn mirrors(&self) -> bool {
        let [x, y] = self.linear;
        x[0] * y[1] - x[1] * y[0] < 0.0
    }

    /// Returns the image of a point.
    pub(crate) fn apply(&self, p: Point2) -> Point2 {
        let [x, y] = self.linear;
        [
            x[0] * p[0] + x[1] * p[1] + self.shift[0],
            y[0] * p[0] + y[1] * p[1] + self.shift[1],
        ]
    }

    /// Returns the factor by which lengths grow, on average over all directions.
    fn mean_stretch(&self) -> f64 {
        let [x, y] = self.linear;
        (x[0] * y[1] - x[1] * y[0]).abs().sqrt()
    }

    /// Returns the image of an entity; an INSERT stays as it is.
    pub(crate) fn apply_to(&self, entity: &DxfEntity) -> DxfEntity {
        let shape = match &entity.shape {
            EntityShape::Point(p, z) => EntityShape::Point(self.apply(*p), z * self.mean_stretch()),
            EntityShape::Text(p, text) => EntityShape::Text(self.apply(*p), text.clone()),
            EntityShape::Path(path) => EntityShape::Path(EntityPath {
                points: path.points.iter().map(|p| self.apply(*p)).collect(),
                sampled: path.sampled.clone(),
                ..*path
            }),
            EntityShape::Insert(insert) => EntityShape::Insert(insert.clone()),
        };
        DxfEntity {
            layer: entity.layer.clone(),
            line: entity.line,
            shape,
        }
    }
}
