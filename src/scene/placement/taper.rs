//! The taper of what is rolled about a limb.
//!
//! Rolled to a tube as wide as its biceps line, a sleeve stays open by a third of a turn at the
//! wrist. Its edges there are beside the hand, not below it, and close through it.

use nalgebra::Vector2;

/// Share of a panel's height from its lower end at which its width there is measured: hems have
/// slits and shaped edges.
const NEAR_HEM: f64 = 0.1;
/// Steps in the height at which a width is measured.
const STEPS: u32 = 40;

/// Radii and middles of a tube by the height on the drawing: straight from the widest line of the
/// panel down to its hem, as its width, but no less than what is round the limb.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Taper {
    /// Height on the turned drawing below which the panel narrows \[m\].
    widest: f64,
    /// Loss of radius, and way of the panel's middle to the side, per height.
    slope: f64,
    aside: f64,
    /// Heights of the panel's upper and lower end on the turned drawing, and the least radii there
    /// \[m\].
    ends: [f64; 2],
    least: [f64; 2],
    /// Length of what is below the widest line as it starts, over that on the drawing.
    shortened: f64,
}

impl Taper {
    /// The taper of a panel with these lines, with `radius` at its widest one, for a limb that
    /// reaches `least` from the axis at its upper and lower end \[m\]; none where it does not
    /// narrow downward.
    pub(super) fn of(lines: &Lines, radius: f64, least: [f64; 2]) -> Option<Self> {
        let at_hem = radius * width(lines.hem.1) / width(lines.widest.1);
        let middle = |[left, right]: [f64; 2]| 0.5 * (left + right);
        let taper = Self::between(lines, [radius, at_hem], least, middle);
        taper.filter(|taper| taper.slope > 0.0)
    }

    /// The taper of a part of a tube with such radii at the widest line and at the hem, the second
    /// no larger: beside the axis is the place that is picked from how far a line reaches to its
    /// two sides.
    pub(super) fn between(
        lines: &Lines,
        [radius, at_hem]: [f64; 2],
        least: [f64; 2],
        place: impl Fn([f64; 2]) -> f64,
    ) -> Option<Self> {
        let (widest, most) = lines.widest;
        let (hem, least_wide) = lines.hem;
        (widest > hem).then(|| Self {
            widest,
            slope: (radius - at_hem) / (widest - hem),
            aside: (place(least_wide) - place(most)) / (widest - hem),
            ends: lines.ends,
            least,
            shortened: 1.0,
        })
    }

    /// The same taper of a panel that starts shorter than it is drawn by this factor, below its
    /// widest line.
    pub(super) fn shortened(self, shortened: f64) -> Self {
        Self { shortened, ..self }
    }

    /// Height on the turned drawing that starts, where nothing is shortened, at the height at which
    /// this one does \[m\].
    pub(super) fn start_height(&self, height: f64) -> f64 {
        let below = (self.widest - height).max(0.0);
        height + below * (1.0 - self.shortened)
    }

    /// Radius at a height on the turned drawing, of a tube of this radius at its widest line \[m\].
    pub(super) fn radius(&self, radius: f64, height: f64) -> f64 {
        let [top, bottom] = self.ends;
        let down = ((top - height) / (top - bottom)).clamp(0.0, 1.0);
        let least = self.least[0] + (self.least[1] - self.least[0]) * down;
        let narrowed = radius - self.slope * (self.widest - height).max(0.0);
        narrowed.max(least).min(radius)
    }

    /// Way of the panel's middle to the side at a height, from that of its widest line \[m\].
    pub(super) fn aside(&self, height: f64) -> f64 {
        self.aside * (self.widest - height).max(0.0)
    }
}

/// The lines across a closed outline that its taper is told by: a height, and how far the outline
/// reaches to its two sides there \[m\].
pub(super) struct Lines {
    pub(super) widest: (f64, [f64; 2]),
    /// Near the lower end.
    pub(super) hem: (f64, [f64; 2]),
    /// Heights of the upper and the lower end \[m\].
    pub(super) ends: [f64; 2],
}

impl Lines {
    pub(super) fn of(outline: &[Vector2<f64>]) -> Self {
        let [bottom, top] = heights(outline);
        let line = |share: f64| {
            let height = bottom + (top - bottom) * share;
            (height, sides(outline, height))
        };
        let shares = (1..STEPS).map(|k| f64::from(k) / f64::from(STEPS));
        let widest = shares.map(line).fold((top, [0.0; 2]), |widest, line| {
            if width(line.1) > width(widest.1) {
                line
            } else {
                widest
            }
        });
        Self {
            widest,
            hem: line(NEAR_HEM),
            ends: [top, bottom],
        }
    }
}

/// Width of a line that reaches so far to its two sides \[m\].
pub(super) fn width([left, right]: [f64; 2]) -> f64 {
    right - left
}

/// Returns the heights of the lowest and the highest point \[m\].
fn heights(outline: &[Vector2<f64>]) -> [f64; 2] {
    let heights = outline.iter().map(|p| p.y);
    heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], y| {
        [low.min(y), high.max(y)]
    })
}

/// Returns how far a closed outline reaches to its two sides at a height \[m\].
fn sides(outline: &[Vector2<f64>], height: f64) -> [f64; 2] {
    let next = outline.iter().cycle().skip(1);
    let crossing = |(p, q): (&Vector2<f64>, &Vector2<f64>)| {
        let [from, to] = [p.y - height, q.y - height];
        ((from >= 0.0) != (to >= 0.0)).then(|| p.x + (q.x - p.x) * (from / (from - to)))
    };
    let xs = outline.iter().zip(next).filter_map(crossing);
    xs.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        [low.min(x), high.max(x)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    /// A sleeve with a cap: 0.4 m wide at the biceps line, 0.22 m at the wrist.
    fn sleeve() -> Vec<Vector2<f64>> {
        let corners = [
            [-0.11, 0.0],
            [-0.2, 0.45],
            [0.0, 0.6],
            [0.2, 0.45],
            [0.11, 0.0],
        ];
        corners.map(Vector2::from).to_vec()
    }

    #[test]
    fn a_sleeve_is_round_the_arm_alike_from_the_biceps_to_the_wrist() {
        let outline = sleeve();
        let radius = 0.4 / TAU;
        let taper = Taper::of(&Lines::of(&outline), radius, [0.0; 2]).expect("it narrows");
        for height in [0.05, 0.15, 0.3, 0.44] {
            let [left, right] = sides(&outline, height);
            let turn = (right - left) / taper.radius(radius, height);
            assert!((turn / TAU - 1.0).abs() < 0.02, "{turn} at {height}");
            assert!(taper.aside(height).abs() < 1e-12);
        }
        // The cap is as wide a tube as the line below it.
        assert!((taper.radius(radius, 0.6) - radius).abs() < 1e-12);
    }

    /// Half a sleeve: straight along the arm, slanted below it.
    #[test]
    fn the_middle_of_half_a_sleeve_leads_aside() {
        let half = [[0.0, 0.0], [0.0, 0.45], [0.2, 0.45], [0.11, 0.0]].map(Vector2::from);
        let taper = Taper::of(&Lines::of(&half), 0.2 / PI, [0.0; 2]).expect("it narrows");
        let way = taper.aside(0.1) - taper.aside(0.4);
        let [high, low] = [0.4, 0.1].map(|height| {
            let [left, right] = sides(&half, height);
            0.5 * (left + right)
        });
        assert!((way - (low - high)).abs() < 1e-12);
    }

    #[test]
    fn no_tube_is_narrower_than_the_limb() {
        let radius = 0.4 / TAU;
        let taper = Taper::of(&Lines::of(&sleeve()), radius, [0.055, 0.046]).expect("it narrows");
        assert!((taper.radius(radius, 0.0) - 0.046).abs() < 1e-12);
        // A tenth up the sleeve, where its width alone would make 39 mm.
        assert!((taper.radius(radius, 0.06) - 0.0469).abs() < 1e-12);
    }

    #[test]
    fn a_strip_and_a_flared_sleeve_have_none() {
        let strip = [[0.0, 0.0], [0.0, 0.3], [0.2, 0.3], [0.2, 0.0]].map(Vector2::from);
        assert_eq!(Taper::of(&Lines::of(&strip), 0.04, [0.0; 2]), None);
        let flared = [[-0.3, 0.0], [-0.2, 0.3], [0.2, 0.3], [0.3, 0.0]].map(Vector2::from);
        assert_eq!(Taper::of(&Lines::of(&flared), 0.07, [0.0; 2]), None);
    }
}
