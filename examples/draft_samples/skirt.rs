//! A-line skirt: front, back and a straight waistband that opens at the centre back.
//!
//! Without darts: the waist is shaped in the side seams, and the waistline drops towards the centre so that it meets
//! them square. All pieces lie face up, so the right of the front is the wearer's left, and the right of the back the right.

use super::body::Body;
use super::curve::{Point, fair, joined, length, mirrored};
use super::garment::Draft;
use super::piece::{Piece, Style};

/// Waistband longer than the waist by this \[mm\].
const WAIST_EASE: f64 = 20.0;
const HIP_EASE: f64 = 56.0;
/// Share of the widening from waist to hip that lies in its upper half: a body widens little just below the waist.
const UPPER_SHARE: f64 = 0.53;
/// Down the centre front, below the waistband.
const SKIRT_LENGTH: f64 = 550.0;
const HEM_GIRTH: f64 = 1360.0;
const BAND_DEPTH: f64 = 35.0;
/// A quarter of the front is wider than one of the back by twice this.
const BALANCE: f64 = 2.5;
/// The waistline of the back lies lower by this.
const BACK_DROP: f64 = 5.0;

/// All pieces.
pub(crate) fn draft(body: &Body) -> Style {
    let waist = body.waist + WAIST_EASE;
    let side = SideSeam::draft(body, waist / 4.0);
    let front = Quarter::draft(&side, waist / 4.0 + BALANCE, 0.0);
    let back = Quarter::draft(&side, waist / 4.0 - BALANCE, BACK_DROP);
    let band = waistband(length(&front.waist), length(&back.waist));
    Style {
        name: "A-LINE SKIRT",
        pieces: vec![front.front_piece(), back.back_piece(), band],
    }
}

/// Seams and placements.
pub(crate) fn garment() -> Draft {
    let (front, back, band) = ("skirt-front", "skirt-back", "waistband");
    Draft {
        seams: vec![
            ("side-left", (front, 1, 2), (back, 0, 4)),
            ("side-right", (front, 0, 3), (back, 2, 3)),
            ("waistband-back", (band, 1, 2), (band, 0, 5)),
            ("waist-front", (band, 4, 3), (front, 0, 1)),
            ("waist-back-left", (band, 2, 3), (back, 1, 0)),
            ("waist-back-right", (band, 5, 4), (back, 1, 2)),
        ],
        placements: vec![
            (front, "skirt_front"),
            (back, "skirt_back"),
            (band, "waist"),
        ],
    }
}

/// The side seam that front and back share, from its upper end at (0, 0) downwards.
struct SideSeam {
    line: Vec<Point>,
    /// Index of the hip point in it.
    hip: usize,
    /// Outwards for each unit down, at the upper end.
    upper_slope: f64,
    /// The same below the hip.
    flare: f64,
    /// How far its upper end lies above the waistline's centre.
    rise: f64,
}

impl SideSeam {
    /// `waist` is a quarter of the skirt's.
    fn draft(body: &Body, waist: f64) -> Self {
        let hip = (body.hip + HIP_EASE) / 4.0;
        let flare = (HEM_GIRTH / 4.0 - hip) / (SKIRT_LENGTH - body.waist_to_hip);
        let half_way = [UPPER_SHARE * (hip - waist), -body.waist_to_hip / 2.0];
        let hip_point = [hip - waist, -body.waist_to_hip];
        // A curve is fair where the mean of its end slopes is its mean slope.
        let mean = |from: Point, to: Point| (to[0] - from[0]) / (from[1] - to[1]);
        let middle_slope = 2.0 * mean(half_way, hip_point) - flare;
        let upper_slope = 2.0 * mean([0.0, 0.0], half_way) - middle_slope;
        // A waistline that is square to the side and to the centre is nearly an arc.
        let rise = waist * upper_slope / 2.0;
        let down = |slope: f64| [slope, -1.0];
        let upper = fair([0.0, 0.0], down(upper_slope), half_way, down(middle_slope));
        let lower = fair(half_way, down(middle_slope), hip_point, down(flare));
        let mut line = joined(upper, &lower);
        let hip_index = line.len() - 1;
        line.push(below_hip(hip_point, waist, rise, flare));
        Self {
            line,
            hip: hip_index,
            upper_slope,
            flare,
            rise,
        }
    }
}

/// Lower end of the side seam: where the hem, square to it and to the centre, ends.
///
/// Down by `h` from the hip the seam is `x0 + flare h` from the centre line, and the hem has risen by half of `flare` times that.
fn below_hip(hip: Point, waist: f64, rise: f64, flare: f64) -> Point {
    let (x0, y0) = (waist + hip[0], rise + hip[1]);
    let h = (y0 + SKIRT_LENGTH - x0 * flare / 2.0) / (1.0 + flare * flare / 2.0);
    [hip[0] + flare * h, hip[1] - h]
}

/// The right half of the front or back, from the centre line at x = 0.
struct Quarter {
    /// From the centre outwards.
    waist: Vec<Point>,
    /// Downwards.
    side: Vec<Point>,
    /// From the side inwards.
    hem: Vec<Point>,
    hip: Point,
}

impl Quarter {
    /// With a waistline of length `waist` that drops by `drop` at the centre.
    fn draft(side: &SideSeam, waist: f64, drop: f64) -> Self {
        let line = |width: f64| {
            fair(
                [0.0, -drop],
                [1.0, 0.0],
                [width, side.rise],
                [1.0, side.upper_slope],
            )
        };
        let waist = line(width_for(waist, |width| length(&line(width))));
        let corner = waist[waist.len() - 1];
        let side_line: Vec<Point> = side
            .line
            .iter()
            .map(|p| [corner[0] + p[0], corner[1] + p[1]])
            .collect();
        let lower = side_line[side_line.len() - 1];
        let hem = fair(
            lower,
            [-1.0, -side.flare],
            [0.0, -SKIRT_LENGTH],
            [-1.0, 0.0],
        );
        Self {
            waist,
            hip: side_line[side.hip],
            side: side_line,
            hem,
        }
    }

    /// Corners: 0, 1 waist; 2, 3 hem.
    fn front_piece(self) -> Piece {
        let waist = joined(mirrored(&self.waist), &self.waist);
        self.piece("SKIRT FRONT", vec![waist], [0.0, 0.0])
    }

    /// Corners: 0, 1 (centre), 2 waist; 3, 4 hem.
    fn back_piece(self) -> Piece {
        let waist = vec![mirrored(&self.waist), self.waist.clone()];
        self.piece("SKIRT BACK", waist, [800.0, 0.0])
    }

    fn piece(self, name: &'static str, mut runs: Vec<Vec<Point>>, origin: Point) -> Piece {
        let centre = self.waist[0];
        runs.push(self.side.clone());
        runs.push(joined(self.hem.clone(), &mirrored(&self.hem)));
        runs.push(mirrored(&self.side));
        let hip = self.hip;
        Piece {
            name,
            runs,
            notches: vec![centre, hip, [0.0, -SKIRT_LENGTH], [-hip[0], hip[1]]],
            grain: [[0.0, -400.0], [0.0, -150.0]],
            origin,
        }
    }
}

/// The strip, from the centre back over the wearer's right, front and left. Corners: 0, 1 above; 2 left half of the centre
/// back, 3 left side, 4 right side, 5 right half of the centre back below.
fn waistband(half_front: f64, half_back: f64) -> Piece {
    let total = 2.0 * (half_front + half_back);
    let upper = [[0.0, BAND_DEPTH], [total, BAND_DEPTH]];
    let lower = [total, total - half_back, half_back, 0.0].map(|x| [x, 0.0]);
    let turns = [
        upper[0], upper[1], lower[0], lower[1], lower[2], lower[3], upper[0],
    ];
    let middle = total / 2.0;
    Piece {
        name: "WAISTBAND",
        runs: turns.windows(2).map(<[Point]>::to_vec).collect(),
        notches: vec![lower[1], lower[2]],
        grain: [
            [middle - 100.0, BAND_DEPTH / 2.0],
            [middle + 100.0, BAND_DEPTH / 2.0],
        ],
        origin: [0.0, 150.0],
    }
}

/// The width at which a line that grows with it has the `wanted` length, by bisection.
fn width_for(wanted: f64, length_at: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 2.0 * wanted);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if length_at(middle) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}
