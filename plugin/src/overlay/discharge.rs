//! The colour of a river's discharge, on a logarithmic ramp.
//!
//! Small planets have small rivers: discharges are compared as they would be on an Earth-sized
//! planet, and the ramp of a small planet ends at smaller ones.

use super::palette::{self, Rgba};
use crate::climate::EARTH_RADIUS;
use crate::math;

/// Discharge in m³/s at the end of the ramp, on an Earth-sized planet: that of the Amazon.
const DISCHARGE_MAX: f64 = 200_000.0;

/// Position on [`palette::DISCHARGE`] of a discharge in m³/s, as it would be on an Earth-sized
/// planet. The ramp starts at 1 m³/s.
pub(super) fn discharge_position(earth_like: f64) -> f64 {
    math::ln(earth_like.max(1.0)) / math::ln(DISCHARGE_MAX)
}

/// The colour of a discharge in m³/s, as it would be on an Earth-sized planet.
pub(super) fn discharge_color(earth_like: f64) -> Rgba {
    palette::DISCHARGE.at(discharge_position(earth_like) as f32)
}

/// Powers of ten in m³/s that lie on the ramp on a planet of `radius` km, and their colours.
pub(super) fn discharge_decades(radius: f64) -> impl Iterator<Item = (i32, Rgba)> {
    let scale = EARTH_RADIUS / radius;
    let earth_like = move |power: i32| math::pow(10.0, f64::from(power)) * scale * scale;
    let on_ramp = move |&power: &i32| (1.0..=DISCHARGE_MAX).contains(&earth_like(power));
    (-8..=8)
        .filter(on_ramp)
        .map(move |power| (power, discharge_color(earth_like(power))))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn powers(radius: f64) -> Vec<i32> {
        discharge_decades(radius).map(|(power, _)| power).collect()
    }

    #[test]
    fn the_ramp_of_discharge_ends_at_smaller_rivers_on_smaller_planets() {
        assert_eq!(powers(EARTH_RADIUS), [0, 1, 2, 3, 4, 5]);
        assert_eq!(powers(EARTH_RADIUS / 100.0), [-4, -3, -2, -1, 0, 1]);
    }

    #[test]
    fn colours_beyond_the_ramp_are_those_of_its_ends() {
        let (start, end) = (palette::DISCHARGE.at(0.0), palette::DISCHARGE.at(1.0));
        let first = discharge_decades(EARTH_RADIUS).next();
        assert_eq!(first, Some((0, start)));
        assert_eq!(discharge_color(0.0), start);
        assert_eq!([200_000.0, 1e9].map(discharge_color), [end; 2]);
    }
}
