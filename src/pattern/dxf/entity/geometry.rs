//! The entities that a pattern is made of: points, texts, paths and inserts, with curves as
//! polylines.

use crate::pattern::Point2;

/// One entity.
#[derive(Clone, Debug)]
pub(crate) struct DxfEntity {
    /// The layer it lies on.
    pub(crate) layer: String,
    /// The line of the file it begins at.
    pub(crate) line: usize,
    /// Its geometry.
    pub(crate) shape: EntityShape,
}

/// The geometry of an entity.
#[derive(Clone, Debug)]
pub(crate) enum EntityShape {
    /// A mark, with its z: the depth of a notch.
    Point(Point2, f64),
    /// A text with its insertion point.
    Text(Point2, String),
    /// A line or a curve.
    Path(EntityPath),
    /// A block put in.
    Insert(BlockInsert),
}

impl EntityShape {
    /// Returns the path, if it is one.
    pub(crate) fn path(&self) -> Option<&EntityPath> {
        match self {
            Self::Path(path) => Some(path),
            _ => None,
        }
    }

    /// Returns the number of its points, at least 1 for what is no path.
    pub(crate) fn point_count(&self) -> usize {
        self.path().map_or(1, |path| path.points.len())
    }
}

/// A polyline, or a curve as one.
#[derive(Clone, Debug)]
pub(crate) struct EntityPath {
    /// Its points; a closed path does not repeat the first.
    pub(crate) points: Vec<Point2>,
    /// True if it runs on from the last point to the first.
    pub(crate) closed: bool,
    /// True if it is a single straight line.
    pub(crate) straight: bool,
    /// Point by point, true if it is not of the file but a sample of a curve; empty where all
    /// points are of the file.
    pub(crate) sampled: Vec<bool>,
}

impl EntityPath {
    /// Returns the straight line between two points.
    pub(crate) fn line(from: Point2, to: Point2) -> Self {
        Self {
            points: vec![from, to],
            closed: false,
            straight: true,
            sampled: Vec::new(),
        }
    }

    /// Returns an open curve, all of whose points are samples.
    pub(crate) fn curve(points: Vec<Point2>) -> Self {
        Self {
            sampled: vec![true; points.len()],
            points,
            closed: false,
            straight: false,
        }
    }

    /// Returns the path with x negated where it is seen from behind.
    pub(crate) fn flipped_if(mut self, from_behind: bool) -> Self {
        if from_behind {
            for point in &mut self.points {
                point[0] = -point[0];
            }
        }
        self
    }
}

/// A block put in, once or as an array.
#[derive(Clone, Debug)]
pub(crate) struct BlockInsert {
    /// Name of the block.
    pub(crate) name: String,
    /// The place of its base point.
    pub(crate) at: Point2,
    /// Scale of x and y; negative mirrors.
    pub(crate) scale: [f64; 2],
    /// Rotation, counter-clockwise, after scaling \[rad\].
    pub(crate) angle: f64,
    /// Number of columns and of rows, at least 1.
    pub(crate) count: [u32; 2],
    /// Distance of columns and of rows.
    pub(crate) spacing: [f64; 2],
    /// True if the whole is seen from behind (extrusion along -z).
    pub(crate) flipped: bool,
}

impl BlockInsert {
    /// Returns the number of copies that it puts in.
    pub(crate) fn cell_count(&self) -> usize {
        self.count[0] as usize * self.count[1] as usize
    }

    /// Returns the column and row of each copy, row by row.
    pub(crate) fn cells(&self) -> impl Iterator<Item = [u32; 2]> + use<> {
        let [columns, rows] = self.count;
        (0..rows).flat_map(move |row| (0..columns).map(move |column| [column, row]))
    }
}
