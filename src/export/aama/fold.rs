//! Halves on the fold: the half of an unfolded panel from which the importer makes the whole again,
//! with the same corners in the same order.
//!
//! The importer begins a whole outline where the drawn half leaves the fold, and numbers corners
//! clockwise from the first one after that. It puts images after what is drawn: of lines and drill
//! holes after all of them, of notches and cut-outs after each. A panel that is not its own image
//! in this sense (one that came as JSON may be anything) has no half.

use super::parts::{PanelParts, PlacedNotch};
use crate::pattern::Hole;
use crate::pattern::outline::ring_of;
use crate::pattern::point::{Point2, distance, dot, sub, turn};

/// Points this near to the fold lie on it, as the importer has it \[m\].
const ON: f64 = 2e-4;

/// Images are this near to what they are images of \[m\].
const SAME: f64 = 1e-6;

/// The importer makes the end of a fold a corner where the whole outline turns by this \[rad\].
const CORNER: f64 = 20.0 * std::f64::consts::PI / 180.0;

/// Returns the drawn half of a panel; `None` where it has none.
pub(super) fn half<'a>(whole: &PanelParts<'a>) -> Option<PanelParts<'a>> {
    let count = whole.outline.len();
    if count < 4 || !count.is_multiple_of(2) {
        return None;
    }
    // Corner 0 is the first after the fold, or lies on it.
    let last_corner = whole.is_corner.iter().rposition(|corner| *corner)?;
    // A mirror swaps corner 0 with the last one, if they do not lie on it: half way between them.
    let between = last_corner + count;
    let middle = between.is_multiple_of(2).then_some(between / 2);
    let mut starts = middle.into_iter().chain([0]);
    starts.find_map(|start| {
        let fold = Fold::of(whole, start)?;
        fold.is_axis_of(whole).then(|| fold.half(whole)).flatten()
    })
}

/// A line through two points of an outline, half way round from each other.
struct Fold {
    /// Index of the point at which the whole outline begins.
    start: usize,
    /// That point.
    at: Point2,
    /// The opposite point.
    to: Point2,
    /// Unit vector along it.
    along: Point2,
}

impl Fold {
    fn of(whole: &PanelParts<'_>, start: usize) -> Option<Self> {
        let outline = &whole.outline;
        let [at, to] = [start, (start + outline.len() / 2) % outline.len()].map(|i| outline[i]);
        let length = distance(at, to);
        let along = sub(to, at).map(|c| c / length);
        (length > ON).then_some(Self {
            start,
            at,
            to,
            along,
        })
    }

    fn mirror(&self, p: Point2) -> Point2 {
        let t = dot(sub(p, self.at), self.along);
        [0, 1].map(|k| 2.0 * (self.at[k] + t * self.along[k]) - p[k])
    }

    /// Returns the signed distance of a point, positive to the left \[m\].
    fn side(&self, p: Point2) -> f64 {
        let d = sub(p, self.at);
        self.along[0] * d[1] - self.along[1] * d[0]
    }

    fn contains(&self, p: Point2) -> bool {
        self.side(p).abs() <= ON
    }

    fn is_image(&self, a: Point2, b: Point2) -> bool {
        distance(self.mirror(a), b) <= SAME
    }

    /// Returns true if the outline is its own image, to the last corner, and the importer would see
    /// one half of it on one side.
    fn is_axis_of(&self, whole: &PanelParts<'_>) -> bool {
        let outline = &whole.outline;
        let (count, half) = (outline.len(), outline.len() / 2);
        let pair = |k: usize| [(self.start + k) % count, (self.start + count - k) % count];
        let is_symmetric = (1..half).map(pair).all(|[a, b]| {
            self.is_image(outline[a], outline[b]) && whole.is_corner[a] == whole.is_corner[b]
        });
        let is_seen_alike = |i: usize| {
            let [a, b, c] = [i + count - 1, i, i + 1].map(|i| outline[i % count]);
            (turn(a, b, c).abs() >= CORNER) == whole.is_corner[i]
        };
        let ends = [self.start, (self.start + half) % count];
        let inner = || (1..half).map(|k| self.side(outline[pair(k)[0]]));
        let is_one_sided = inner().all(|s| s >= -ON) || inner().all(|s| s <= ON);
        let leaves = [1, half - 1].map(|k| self.side(outline[pair(k)[0]]).abs() > ON);
        is_symmetric && is_one_sided && leaves == [true; 2] && ends.into_iter().all(is_seen_alike)
    }

    /// Returns one half of all parts; `None` where one of them is not its own image.
    fn half<'a>(&self, whole: &PanelParts<'a>) -> Option<PanelParts<'a>> {
        let cut_line = self.half_of_cut_line(&whole.cut_line)?;
        let mut cut_ends = cut_line.first().into_iter().chain(cut_line.last());
        let mut half = PanelParts {
            outline: Vec::new(),
            is_corner: Vec::new(),
            fold: Some([self.at, self.to]),
            is_cut_closed: cut_ends.all(|end| self.contains(*end)),
            notches: self.half_of_notches(&whole.notches)?,
            drills: self.half_of_drills(&whole.drills)?,
            holes: self.half_of_holes(whole)?,
            lines: self.half_of_lines(&whole.lines)?,
            cut_line,
        };
        let count = whole.outline.len();
        let is_forward = self.is_drawn_forward(whole, &half);
        for k in 0..=count / 2 {
            let i = (self.start + if is_forward { k } else { count - k }) % count;
            let is_end = k == 0 || k == count / 2;
            half.outline.push(whole.outline[i]);
            half.is_corner.push(whole.is_corner[i] || is_end);
        }
        Some(half)
    }

    /// Returns true if the drawn marks lie on the side on which the outline leaves the fold, or all
    /// on the fold.
    fn is_drawn_forward(&self, whole: &PanelParts<'_>, half: &PanelParts<'_>) -> bool {
        let corners = half.holes.iter().flat_map(|hole| &hole.corners);
        let lines = half.lines.iter().flat_map(|line| line.iter().copied());
        let marks = half.cut_line.iter().copied();
        let marks = marks.chain(half.notches.iter().map(|notch| notch.at));
        let marks = marks.chain(half.drills.iter().copied());
        let mut marks = marks.chain(corners.map(|c| [c.x, c.y])).chain(lines);
        let Some(mark) = marks.find(|p| !self.contains(*p)) else {
            return true;
        };
        let count = whole.outline.len();
        let forward = (1..count / 2).map(|k| whole.outline[(self.start + k) % count]);
        forward.map(|p| self.side(p)).sum::<f64>() * self.side(mark) > 0.0
    }

    /// Returns the half of a cut line that was set to its image, with its first point on the fold
    /// or off it; an open one ends off the fold.
    fn half_of_cut_line(&self, line: &[Point2]) -> Option<Vec<Point2>> {
        let count = line.len();
        let is_set = |shift: usize| {
            (shift..count).all(|k| self.is_image(line[k], line[count - 1 + shift - k]))
        };
        if count > 0 && self.contains(line[0]) && is_set(1) {
            Some(line[..=count / 2].to_vec())
        } else {
            is_set(0).then(|| line[..count.div_ceil(2)].to_vec())
        }
    }

    /// Returns every other notch, and those on the fold.
    fn half_of_notches(&self, notches: &[PlacedNotch]) -> Option<Vec<PlacedNotch>> {
        let mut drawn = Vec::new();
        let mut rest = notches.iter();
        while let Some(notch) = rest.next() {
            drawn.push(*notch);
            if self.contains(notch.at) {
                continue;
            }
            let image = rest.next()?;
            let is_alike = image.kind == notch.kind && image.depth_m == notch.depth_m;
            if !is_alike || !self.is_image(notch.at, image.at) {
                return None;
            }
        }
        Some(drawn)
    }

    /// Returns the drill holes before their images; those on the fold have none.
    fn half_of_drills(&self, drills: &[Point2]) -> Option<Vec<Point2>> {
        let on_fold = drills.iter().filter(|p| self.contains(**p)).count();
        let (drawn, images) = drills.split_at((drills.len() + on_fold) / 2);
        let off = drawn.iter().filter(|p| !self.contains(**p));
        let is_image = off.clone().zip(images).all(|(a, b)| self.is_image(*a, *b));
        (is_image && off.count() == images.len()).then(|| drawn.to_vec())
    }

    /// Returns every other hole.
    fn half_of_holes<'a>(&self, whole: &PanelParts<'a>) -> Option<Vec<&'a Hole>> {
        let pairs = whole.holes.chunks(2);
        let drawn = pairs.map(|pair| match pair {
            [hole, image] => {
                let ring = ring_of(&hole.edges).into_iter().map(|p| self.mirror(p));
                is_same_place(&ring.collect::<Vec<_>>(), &ring_of(&image.edges)).then_some(*hole)
            }
            _ => None,
        });
        drawn.collect()
    }

    /// Returns the lines before their images.
    fn half_of_lines<'a>(&self, lines: &[&'a Vec<Point2>]) -> Option<Vec<&'a Vec<Point2>>> {
        let (drawn, images) = lines.split_at(lines.len() / 2);
        let is_image = |a: &[Point2], b: &[Point2]| {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| self.is_image(*a, *b))
        };
        let are_images = drawn.iter().zip(images).all(|(a, b)| is_image(a, b));
        (drawn.len() == images.len() && are_images).then(|| drawn.to_vec())
    }
}

/// Returns true if two rings go through the same points, from any start and either way round.
fn is_same_place(a: &[Point2], b: &[Point2]) -> bool {
    let count = a.len();
    let is_same = |p: Point2, q: Point2| distance(p, q) <= SAME;
    let Some(first) = a.first() else {
        return b.is_empty();
    };
    let goes_along = |start: usize, step: usize| {
        let at = |k: usize| b[(start + k * step) % count];
        (1..count).all(|k| is_same(a[k], at(k)))
    };
    // A step of all but one point is one back.
    let mut starts = (0..count).filter(|start| b.get(*start).is_some_and(|q| is_same(*first, *q)));
    b.len() == count && starts.any(|start| goes_along(start, 1) || goes_along(start, count - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_are_compared_point_by_point() {
        let ring = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.2, 0.7]];
        let mut other = ring;
        other.rotate_left(2);
        assert!(is_same_place(&ring, &other));
        other.reverse();
        assert!(is_same_place(&ring, &other));
        // Of the same box and area.
        let twin = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.2, 0.3]];
        assert!(!is_same_place(&ring, &twin) && !is_same_place(&ring, &ring[..3]));
    }
}
