//! What an importer needs of a drawing: paths, points, texts and inserts, in drawing units, curves as polylines.

use crate::pattern::Point2;

/// One entity.
#[derive(Clone, Debug)]
pub(super) struct Entity {
    /// The layer it lies on.
    pub(super) layer: String,
    /// The line of the file it begins at.
    pub(super) line: usize,
    /// What it is.
    pub(super) shape: Shape,
}

/// What an entity is.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// A mark, with its z: how deep a notch is cut.
    Point(Point2, f64),
    /// A text with the point it is put at.
    Text(Point2, String),
    /// A stretch of line.
    Path(Path),
    /// A block put in.
    Insert(Insert),
}

/// A polyline, or a curve as one.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// Its points; a closed path does not repeat the first.
    pub(super) points: Vec<Point2>,
    /// Whether it runs on from the last point to the first.
    pub(super) closed: bool,
    /// Whether it is a single straight line.
    pub(super) straight: bool,
    /// Which points are not of the file but made for a curve, point by point; empty where all are of the file.
    pub(super) made: Vec<bool>,
}

/// A block put in, once or as an array.
#[derive(Clone, Debug)]
pub(super) struct Insert {
    /// Name of the block.
    pub(super) name: String,
    /// Where its base point goes.
    pub(super) at: Point2,
    /// Scale of x and y; negative mirrors.
    pub(super) scale: Point2,
    /// Counter-clockwise, after scaling \[radians\].
    pub(super) angle: f64,
    /// Columns and rows, at least 1.
    pub(super) count: [u32; 2],
    /// Distance of columns and of rows.
    pub(super) spacing: Point2,
    /// Whether the whole is seen from behind (extrusion along -z).
    pub(super) flipped: bool,
}

/// An affine map of the plane: `m` times the point plus `t`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Map {
    /// Rows of the linear part.
    pub(super) m: [Point2; 2],
    /// Translation.
    pub(super) t: Point2,
}

impl Map {
    /// The same scale in x and y.
    pub(super) fn scale(s: f64) -> Self {
        Self {
            m: [[s, 0.0], [0.0, s]],
            t: [0.0, 0.0],
        }
    }

    /// A shift.
    pub(super) fn shift(t: Point2) -> Self {
        Self {
            m: [[1.0, 0.0], [0.0, 1.0]],
            t,
        }
    }

    /// First `inner`, then `self`.
    pub(super) fn after(&self, inner: &Self) -> Self {
        let a = self.m;
        let b = inner.m;
        let row = |r: Point2| {
            [
                r[0] * b[0][0] + r[1] * b[1][0],
                r[0] * b[0][1] + r[1] * b[1][1],
            ]
        };
        Self {
            m: [row(a[0]), row(a[1])],
            t: self.apply(inner.t),
        }
    }

    /// The image of a point.
    pub(super) fn apply(&self, p: Point2) -> Point2 {
        [
            self.m[0][0] * p[0] + self.m[0][1] * p[1] + self.t[0],
            self.m[1][0] * p[0] + self.m[1][1] * p[1] + self.t[1],
        ]
    }

    /// By how much lengths grow, on average over all directions.
    fn stretch(&self) -> f64 {
        (self.m[0][0] * self.m[1][1] - self.m[0][1] * self.m[1][0])
            .abs()
            .sqrt()
    }

    /// The image of an entity that is no insert.
    pub(super) fn entity(&self, entity: &Entity) -> Entity {
        let shape = match &entity.shape {
            Shape::Point(p, z) => Shape::Point(self.apply(*p), z * self.stretch()),
            Shape::Text(p, text) => Shape::Text(self.apply(*p), text.clone()),
            Shape::Path(path) => Shape::Path(Path {
                points: path.points.iter().map(|p| self.apply(*p)).collect(),
                made: path.made.clone(),
                ..*path
            }),
            Shape::Insert(insert) => Shape::Insert(insert.clone()),
        };
        Entity {
            layer: entity.layer.clone(),
            line: entity.line,
            shape,
        }
    }
}

impl Insert {
    /// How many copies it puts in.
    pub(super) fn cells(&self) -> usize {
        self.count[0] as usize * self.count[1] as usize
    }

    /// Where the copy in `column` and `row` of a block with base point `base` goes.
    pub(super) fn map(&self, base: Point2, column: u32, row: u32) -> Map {
        let (sin, cos) = self.angle.sin_cos();
        let turn = Map {
            m: [[cos, -sin], [sin, cos]],
            t: [0.0, 0.0],
        };
        let scale = Map {
            m: [[self.scale[0], 0.0], [0.0, self.scale[1]]],
            t: [0.0, 0.0],
        };
        let cell = [
            f64::from(column) * self.spacing[0],
            f64::from(row) * self.spacing[1],
        ];
        let own = Map::shift(self.at)
            .after(&turn)
            .after(&Map::shift(cell))
            .after(&scale)
            .after(&Map::shift([-base[0], -base[1]]));
        if self.flipped {
            Map {
                m: [[-1.0, 0.0], [0.0, 1.0]],
                t: [0.0, 0.0],
            }
            .after(&own)
        } else {
            own
        }
    }
}
