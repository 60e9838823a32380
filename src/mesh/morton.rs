//! Vertices in the order of a Z-curve, so that neighbors in the plane are neighbors in memory.

use crate::pattern::Point2;

/// The indices of `points` in Morton order of a grid of 65536 by 65536 cells over their bounding
/// box.
pub(super) fn order(points: &[Point2]) -> Vec<usize> {
    let low = [0, 1].map(|k| points.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min));
    let high = [0, 1].map(|k| {
        points
            .iter()
            .map(|p| p[k])
            .fold(f64::NEG_INFINITY, f64::max)
    });
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    let code = |p: Point2| {
        let [x, y] = [0, 1].map(|k| cell((p[k] - low[k]) / size));
        spread(x) | spread(y) << 1
    };
    let mut order: Vec<_> = (0..points.len()).collect();
    order.sort_by_key(|&i| code(points[i]));
    order
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a share of 0 to 1; the cast saturates"
)]
fn cell(share: f64) -> u16 {
    (share * f64::from(u16::MAX)) as u16
}

/// Puts a zero bit before every bit.
fn spread(x: u16) -> u32 {
    let mut x = u32::from(x);
    for (shift, mask) in [
        (8, 0x00ff_00ff),
        (4, 0x0f0f_0f0f),
        (2, 0x3333_3333),
        (1, 0x5555_5555),
    ] {
        x = (x | x << shift) & mask;
    }
    x
}
