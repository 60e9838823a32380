//! The pressure between two layers of cloth: it begins where their surfaces meet and hardens as
//! their middles come near each other.
//!
//! At the share e of the thickness r by which they are pressed together the pressure is
//! P e / (1 - e)²: soft at first, as the hairs of fabric are, so that a solver may bring layers
//! together without feeling a wall, and so hard in the end that stitches which pull panels across
//! each other leave room between them to slide. Only beyond e = 0.999 it grows no steeper.

/// Pressure scale P \[Pa\]: a few layers of cloth weigh as much at a tenth of the thickness.
const PRESSURE: f64 = 100.0;
/// Distance over the thickness below which the pressure is linear.
const LINEAR: f64 = 1e-3;

/// Energy, pressure and its slope at one distance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Response {
    /// Energy per area \[J/m²\].
    pub(super) energy: f64,
    /// Pressure \[Pa\].
    pub(super) pressure: f64,
    /// Increase of the pressure per approach \[N/m³\].
    pub(super) slope: f64,
}

/// Returns the response of layers of thickness `thickness` whose middles are `distance`, less than
/// that, apart \[m\].
pub(super) fn respond(distance: f64, thickness: f64) -> Response {
    let least = LINEAR * thickness;
    let left = distance.max(least) / thickness;
    let share = 1.0 - left;
    let at = Response {
        energy: PRESSURE * thickness * (1.0 / left - 1.0 + left.ln()),
        pressure: PRESSURE * share / (left * left),
        slope: PRESSURE / thickness * (1.0 + share) / (left * left * left),
    };
    let nearer = (least - distance).max(0.0);
    Response {
        energy: at.energy + nearer * (at.pressure + 0.5 * nearer * at.slope),
        pressure: at.pressure + nearer * at.slope,
        slope: at.slope,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pressure_is_the_slope_of_the_energy_and_slope_that_of_the_pressure() {
        let (thickness, step) = (5e-4, 1e-10);
        for share in [0.0, 5e-4, 0.04, 0.3, 0.7, 0.99] {
            let at = |by: f64| respond(share * thickness + by, thickness);
            let here = at(0.0);
            let (near, far) = (at(-step), at(step));
            let pressure = (near.energy - far.energy) / (2.0 * step);
            let slope = (near.pressure - far.pressure) / (2.0 * step);
            // The next term of the difference is (step / distance)² of it, and rounding.
            let distance: f64 = thickness * share.max(LINEAR);
            let part = (step / distance).powi(2) * 10.0 + 1e-6;
            assert!((pressure - here.pressure).abs() <= part * here.pressure.max(1.0));
            assert!((slope - here.slope).abs() <= part * here.slope);
        }
    }

    #[test]
    fn layers_that_just_touch_do_not_press() {
        let touching = respond(5e-4, 5e-4);
        assert!(touching.energy.abs() < 1e-15 && touching.pressure.abs() < 1e-12);
        assert!(touching.slope > 0.0);
    }
}
