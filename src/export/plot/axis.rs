//! A logarithmic axis with its grid.

use super::style::{GRID, text};

/// Labels at most; more powers of ten than that get a label every other one or fewer.
const LABELS: i32 = 8;

/// Powers of ten over a stretch of the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct LogAxis {
    /// Exponents of ten at both ends.
    ends: [i32; 2],
    /// Places of the ends \[px\].
    stretch: [f64; 2],
}

impl LogAxis {
    /// Returns the axis that has all `values`, which are positive, and at least two powers of ten.
    pub(super) fn over(values: impl Iterator<Item = f64>, stretch: [f64; 2]) -> Self {
        let (least, most) = values.fold((f64::INFINITY, 0.0_f64), |(l, m), v| (l.min(v), m.max(v)));
        let ends = if least <= most {
            [
                exponent(least.log10().floor()),
                exponent(most.log10().ceil()),
            ]
        } else {
            [0, 1]
        };
        Self {
            ends: [ends[0], ends[1].max(ends[0] + 1)],
            stretch,
        }
    }

    /// Returns the place of a value \[px\].
    pub(super) fn place(&self, value: f64) -> f64 {
        let [from, to] = self.ends.map(f64::from);
        let share = (value.log10() - from) / (to - from);
        self.stretch[0] + share * (self.stretch[1] - self.stretch[0])
    }

    /// Draws lines across the picture between `sides` at powers of ten, with their labels; thin
    /// ones at 2 and 5 if there is room.
    pub(super) fn grid(&self, sides: [f64; 2], upright: bool) -> String {
        let [from, to] = self.ends;
        let every = (to - from - 1) / LABELS + 1;
        let mut out = String::new();
        for power in from..=to {
            let at = self.place(10f64.powi(power));
            out += &line(at, sides, upright, 1.0);
            if (power - from) % every == 0 {
                out += &label(&name(power), at, sides[0], upright);
            }
            if power < to && to - from <= 3 {
                for share in [2.0, 5.0] {
                    let at = self.place(share * 10f64.powi(power));
                    out += &line(at, sides, upright, 0.4);
                }
            }
        }
        out
    }
}

/// Returns the exponent of a positive `f64` as an integer.
#[expect(
    clippy::cast_possible_truncation,
    reason = "exponents of f64 are small"
)]
fn exponent(power: f64) -> i32 {
    power as i32
}

fn line(at: f64, [from, to]: [f64; 2], upright: bool, width: f64) -> String {
    let [x1, y1, x2, y2] = if upright {
        [from, at, to, at]
    } else {
        [at, from, at, to]
    };
    format!(
        "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"{GRID}\" stroke-width=\"{width}\"/>\n"
    )
}

fn label(name: &str, at: f64, side: f64, upright: bool) -> String {
    if upright {
        text(name, [side - 8.0, at + 4.0], 12.0, "end")
    } else {
        text(name, [at, side + 18.0], 12.0, "middle")
    }
}

/// Returns a power of ten in words: 0.01, 0.1, 1, 10, 100 as they are, others as 10⁻⁵.
fn name(power: i32) -> String {
    if (-2..=2).contains(&power) {
        return format!("{}", 10f64.powi(power));
    }
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or('?'),
    };
    let exponent: String = power.to_string().chars().map(raised).collect();
    format!("10{exponent}")
}
