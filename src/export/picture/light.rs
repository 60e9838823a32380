//! Light: how much of its color a surface shows, by Lambert's cosine law.

use nalgebra::Vector3;

/// Light from everywhere, of a whole of 1.
const AMBIENT: f64 = 0.40;
/// Lights that stand beside the viewer, so that every view is lit alike: direction (right, up,
/// towards the viewer) and strength.
const LIGHTS: [([f64; 3], f64); 2] = [([-0.5, 0.7, 0.7], 0.58), ([0.8, 0.1, 0.6], 0.22)];

/// Returns the share of its color that a surface shows whose unit normal is `normal` (right, up,
/// towards the viewer).
pub(super) fn tone(normal: &Vector3<f64>) -> f64 {
    let lights = LIGHTS.iter().map(|(direction, strength)| {
        let cosine = Vector3::from(*direction).normalize().dot(normal);
        strength * cosine.max(0.0)
    });
    AMBIENT + lights.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_surface_shows_more_than_its_color_or_less_than_the_ambient_light() {
        let steps = || (-10..=10).map(f64::from);
        for (x, y) in steps().flat_map(|x| steps().map(move |y| (x, y))) {
            let tone = tone(&Vector3::new(x, y, 3.0).normalize());
            assert!((AMBIENT..=1.1).contains(&tone), "{tone}");
        }
    }

    #[test]
    fn what_faces_the_viewer_is_brighter_than_what_is_turned_away() {
        let facing = tone(&Vector3::z());
        assert!(facing > tone(&Vector3::new(1.0, 0.0, 0.1).normalize()));
        assert!(facing > tone(&-Vector3::y()));
    }
}
