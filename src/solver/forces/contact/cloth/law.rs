//! The pressure between two layers of cloth: it begins where their surfaces meet and grows without
//! bound as their middles do.
//!
//! At the share e of the thickness r by which they are pressed together the pressure is
//! P e / (1 - e)²: soft at first, as the hairs of fabric are, so that a solver may bring layers
//! together without feeling a wall.

/// Pressure scale P \[Pa\]: a few layers of cloth weigh as much at a tenth of the thickness.
const PRESSURE: f64 = 100.0;

/// Energy, pressure and its slope at one distance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Response {
    /// Energy per area \[J/m²\].
    pub(crate) energy: f64,
    /// Pressure \[Pa\].
    pub(crate) pressure: f64,
    /// Increase of the pressure per approach \[N/m³\].
    pub(crate) slope: f64,
}

/// Returns the response of layers of thickness `thickness` whose middles are `distance` apart \[m\],
/// the distance being less.
pub(crate) fn respond(distance: f64, thickness: f64) -> Response {
    let left = distance / thickness;
    let share = 1.0 - left;
    Response {
        energy: PRESSURE * thickness * (1.0 / left - 1.0 + left.ln()),
        pressure: PRESSURE * share / (left * left),
        slope: PRESSURE / thickness * (1.0 + share) / (left * left * left),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pressure_is_the_slope_of_the_energy_and_slope_that_of_the_pressure() {
        let (thickness, step) = (5e-4, 1e-9);
        for share in [0.05, 0.3, 0.7, 0.99] {
            let at = |by: f64| respond(share * thickness + by, thickness);
            let here = at(0.0);
            let (near, far) = (at(-step), at(step));
            let pressure = (near.energy - far.energy) / (2.0 * step);
            let slope = (near.pressure - far.pressure) / (2.0 * step);
            // The next term of the difference is (step / distance)² of it, and rounding.
            let part = (step / (share * thickness)).powi(2) * 10.0 + 1e-6;
            assert!((pressure - here.pressure).abs() <= part * here.pressure.max(1.0));
            assert!((slope - here.slope).abs() <= part * here.slope);
        }
        assert!(respond(thickness, thickness).energy.abs() < 1e-15);
    }
}
