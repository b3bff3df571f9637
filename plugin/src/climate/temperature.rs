//! Temperature from latitude and altitude.
//!
//! At sea level T = T_0 + T_2 P_2(sin φ), the two-term Legendre form of energy balance models
//! (North 1975), fitted to Earth's annual zonal means: 28 °C at the equator, 20 at 30°, 5 at 50°,
//! -15 at the poles. The air cools by 6.5 K per km (ICAO standard atmosphere). Under water the
//! temperature is that of the surface.

/// T_0: global mean at sea level in °C.
const GLOBAL_MEAN_C: f64 = 13.7;

/// T_2 in K: minus two thirds of the contrast between equator and poles.
const LEGENDRE_2_K: f64 = -28.7;

/// Cooling of the air with height in K per km (ICAO standard atmosphere).
pub const LAPSE_RATE_K_PER_KM: f64 = 6.5;

/// Mean temperature of the year in °C at the sine of a latitude and an elevation in km.
///
/// ```
/// use bevy_pangaea::climate::mean_temperature;
///
/// let (equator, summit) = (mean_temperature(0.0, 0.0), mean_temperature(0.0, 4.0));
/// assert!((equator - summit - 26.0).abs() < 1e-4);
/// ```
pub fn mean_temperature(sin_latitude: f64, elevation: f32) -> f32 {
    let p2 = 1.5 * sin_latitude * sin_latitude - 0.5;
    let cooling = LAPSE_RATE_K_PER_KM * f64::from(elevation.max(0.0));
    (GLOBAL_MEAN_C + LEGENDRE_2_K * p2 - cooling) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    #[test]
    fn zonal_means_are_those_of_the_earth() {
        for (latitude, low, high) in [
            (0.0_f64, 26.0, 29.0),
            (30.0, 17.0, 22.0),
            (50.0, 2.0, 8.0),
            (90.0, -25.0, -12.0),
        ] {
            let t = mean_temperature(math::sin(latitude.to_radians()), -3.0);
            assert!((low..=high).contains(&t), "{latitude}: {t}");
        }
        let cooling = mean_temperature(0.3, 0.0) - mean_temperature(-0.3, 2.0);
        assert!((cooling - 13.0).abs() < 1e-4);
    }
}
