//! Continental erosion (paper 000 §4.5), and how eroded or thickened crust floats.
//!
//! ```text
//! z' = z - z / z_c  eps_c dt        where z > 0: below the sea it would lift the shelves
//! z' = z + (z_iso(e) - z) (1 - exp(-dt / tau))
//! ```
//!
//! Reads and writes: elevation, thickness.

use crate::params::TectonicParams;

/// Share of its elevation that land loses in one step.
pub fn wear(params: &TectonicParams) -> f32 {
    // However long the step, land loses no more than its elevation.
    (params.erosion / params.summit_elevation * params.time_step).min(1.0) as f32
}

/// Elevation in km that erosion takes from crust at `z` km in one step; not negative.
#[inline]
pub fn eroded(wear: f32, z: f32) -> f32 {
    z.max(0.0) * wear
}

/// Share of the distance to isostatic balance that is made good in one step.
pub fn adjustment(params: &TectonicParams) -> f32 {
    (1.0 - crate::math::exp(-params.time_step / params.isostasy_time)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn erosion_takes_the_same_share_of_land_each_step_and_nothing_under_water() {
        let params = TectonicParams::default();
        let mut z = 5.0_f32;
        for _ in 0..100 {
            z -= eroded(wear(&params), z);
        }
        let share = params.erosion / params.summit_elevation * params.time_step;
        let expected = 5.0 * crate::math::pow(1.0 - share, 100.0);
        assert!((f64::from(z) / expected - 1.0).abs() < 1e-5);
        assert_eq!(eroded(wear(&params), -0.2), 0.0);
        assert_eq!(eroded(wear(&params), 0.0), 0.0);
    }
}
