//! What rain does on the ground: wetness and runoff.
//!
//! What could evaporate in a year is 58.93 mm per °C of biotemperature (Holdridge 1967), here bent
//! off for cold places, whose summers are warmer than their mean. Of the rain P as much evaporates
//! as Turc (1954) and Pike (1964) found on hundreds of catchments: E = P / sqrt(1 + (P / E_p)²).
//! What is left runs off.

/// Evaporation per °C and year, mm.
const HOLDRIDGE: f32 = 58.93;

/// Half of what the curve bends by where the mean is 0 °C, mm per year: cold places have summers.
const COLD: f32 = 350.0;

/// Open water loses more than ground with plants (ratio of pan to reference evaporation, Allen et
/// al. 1998: 1.2 to 1.5).
pub const OPEN_WATER: f32 = 1.3;

/// What could evaporate in a year at a mean temperature in °C, mm.
pub fn evaporation(temperature: f32) -> f32 {
    // Summers of cold places are warmer than the mean: the straight line bends off to the floor.
    let line = HOLDRIDGE * temperature.min(32.0);
    0.5 * (line + (line * line + 4.0 * COLD * COLD).sqrt())
}

/// Rain in mm that runs off.
pub fn runoff(rain: f32, evaporation: f32) -> f32 {
    let ratio = rain / evaporation.max(1.0);
    rain - rain / (1.0 + ratio * ratio).sqrt()
}

/// Wetness W: 0 in deserts, 0.67 where rain and evaporation could balance, near 1 in rain forests.
pub fn wetness(rain: f32, evaporation: f32) -> f32 {
    1.0 - crate::math::exp_f32(-1.1 * rain / evaporation.max(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runoff_is_that_of_known_climates() {
        // Amazon: 2.2 m of rain, about 1.1 m of runoff. Sahara: next to nothing. Siberia: 450 mm,
        // 200 mm.
        let of = |rain, t| runoff(rain, evaporation(t));
        assert!(
            (800.0..1300.0).contains(&of(2200.0, 26.0)),
            "{}",
            of(2200.0, 26.0)
        );
        assert!(of(50.0, 25.0) < 1.0);
        assert!(
            (120.0..320.0).contains(&of(450.0, -3.0)),
            "{}",
            of(450.0, -3.0)
        );
        assert_eq!(of(0.0, 10.0), 0.0);
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
