//! Corners of one shape, however its curves were sampled.

use super::read::imported;
use seamster::pattern::Point2;
use seamster_fixtures::dxf::DxfBuilder;
use std::f64::consts::PI;

/// An armhole of a back as a curve, with a shoulder and a side straight [mm].
fn bodice(chords: u32) -> Vec<Point2> {
    let mut points = vec![[-240.0, 0.0], [-240.0, 400.0], [0.0, 400.0]];
    points.extend((1..chords).map(|i| {
        let angle = PI + 0.5 * PI * f64::from(i) / f64::from(chords);
        [240.0 + 240.0 * angle.cos(), 400.0 + 180.0 * angle.sin()]
    }));
    points.extend([[240.0, 220.0], [260.0, 0.0]]);
    points
}

/// A line sampled anew, every `step` millimeters of each of its sides, moved by up to `noise`.
fn resampled(outline: &[Point2], step: f64, noise: f64) -> Vec<Point2> {
    let mut points = vec![];
    let mut state = 1_u32;
    let mut random = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        2.0 * f64::from(state >> 8) / f64::from(1 << 24) - 1.0
    };
    for (i, a) in outline.iter().enumerate() {
        let b = outline[(i + 1) % outline.len()];
        let count = ((b[0] - a[0]).hypot(b[1] - a[1]) / step).ceil();
        let mut at = 0.0;
        while at < count {
            let t = at / count;
            points.push([0, 1].map(|k| a[k] + t * (b[k] - a[k]) + noise * random()));
            at += 1.0;
        }
    }
    points
}

fn corners(outline: &[Point2]) -> Vec<Point2> {
    let pattern = imported(DxfBuilder::metric().run("0", true, outline));
    let corners = pattern.panels[0].corners.iter();
    corners
        .map(|corner| [1000.0 * corner.x, 1000.0 * corner.y])
        .collect()
}

#[test]
fn corners_do_not_depend_on_the_spacing_of_points() {
    for chords in [8, 12, 20, 40] {
        let outline = bodice(chords);
        let expected = corners(&outline);
        assert_eq!(expected.len(), 5, "{chords} chords: {expected:?}");
        for step in [1.0, 2.0, 3.0, 5.0, 10.0] {
            for noise in [0.0, 0.02] {
                let found = corners(&resampled(&outline, step, noise));
                assert_eq!(
                    found.len(),
                    5,
                    "{chords} chords, {step} mm, {noise}: {found:?}"
                );
                for corner in &expected {
                    let near = |other: &Point2| {
                        (other[0] - corner[0]).hypot(other[1] - corner[1]) <= 2.0 * noise + 1e-9
                    };
                    assert!(found.iter().any(near), "{corner:?} of {found:?}");
                }
            }
        }
    }
}
