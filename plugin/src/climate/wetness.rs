//! The fate of rain on the ground: wetness and runoff.
//!
//! The evaporation that the warmth of a year allows is 58.93 mm per °C of biotemperature
//! (Holdridge 1967), here bent off for cold places, whose summers are warmer than their mean. Of
//! the rain P as much evaporates as Turc (1954) and Pike (1964) found on hundreds of catchments:
//! E = P / sqrt(1 + (P / E_p)²). The rest runs off.

use crate::math;

/// Potential evaporation per °C of biotemperature, mm per year (Holdridge 1967).
const HOLDRIDGE_MM_PER_C: f32 = 58.93;

/// Warmest mean in °C that still adds evaporation: plants close their leaves beyond it (Holdridge
/// counts no biotemperature above about 30 °C).
const HOTTEST_C: f32 = 32.0;

/// Potential evaporation where the mean is 0 °C, mm per year: cold places have summers. Fitted to
/// the runoff of Siberia's rivers.
const EVAPORATION_AT_FREEZING_MM: f32 = 350.0;

/// Evaporation of open water, relative to that of ground with plants (ratio of pan to reference
/// evaporation, Allen et al. 1998: 1.2 to 1.5).
const OPEN_WATER_FACTOR: f32 = 1.3;

/// How fast wetness saturates with the ratio of rain to evaporation: 0.67 where both are equal,
/// the border of dry and humid provinces.
const WETNESS_RATE: f32 = 1.1;

/// Potential evaporation of a year at a mean temperature in °C, mm.
pub(super) fn potential_evaporation(temperature: f32) -> f32 {
    // A hyperbola: Holdridge's line where it is warm, level where it is cold.
    let line = HOLDRIDGE_MM_PER_C * temperature.min(HOTTEST_C);
    let bend = EVAPORATION_AT_FREEZING_MM;
    0.5 * (line + (line * line + 4.0 * bend * bend).sqrt())
}

/// Runoff in mm of a rain and a potential evaporation in mm.
pub(super) fn runoff(rain: f32, evaporation: f32) -> f32 {
    let ratio = rain / evaporation.max(1.0);
    rain - rain / (1.0 + ratio * ratio).sqrt()
}

/// Evaporation of open water less the rain on it, in mm of a rain and a potential evaporation in
/// mm.
pub(super) fn open_water_loss(rain: f32, evaporation: f32) -> f32 {
    OPEN_WATER_FACTOR * evaporation - rain
}

/// Wetness W: 0 in deserts, 0.67 where rain and evaporation could balance, near 1 in rain forests.
pub(super) fn wetness(rain: f32, evaporation: f32) -> f32 {
    1.0 - math::exp_f32(-WETNESS_RATE * rain / evaporation.max(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runoff in mm of a rain in mm at a mean temperature in °C.
    fn runoff_at(rain: f32, temperature: f32) -> f32 {
        runoff(rain, potential_evaporation(temperature))
    }

    #[test]
    fn runoff_is_that_of_known_climates() {
        // Amazon: 2.2 m of rain, about 1.1 m of runoff. Sahara: next to nothing. Siberia: 450 mm,
        // 200 mm.
        let amazon = runoff_at(2200.0, 26.0);
        assert!((800.0..1300.0).contains(&amazon), "{amazon}");
        assert!(runoff_at(50.0, 25.0) < 1.0);
        let siberia = runoff_at(450.0, -3.0);
        assert!((120.0..320.0).contains(&siberia), "{siberia}");
        assert_eq!(runoff_at(0.0, 10.0), 0.0);
    }

    #[test]
    fn wetness_and_runoff_grow_with_rain_and_stay_in_bounds() {
        let (mut w, mut r) = (-1.0, -1.0);
        for k in 0..100 {
            let rain = k as f32 * 80.0;
            let (wet, run) = (wetness(rain, 900.0), runoff(rain, 900.0));
            assert!(wet > w && run > r && wet <= 1.0 && run <= rain);
            (w, r) = (wet, run);
        }
    }
}
