//! The colours of axes, whose hue is their azimuth.

use super::{Rgba, oklch};
use std::sync::LazyLock;

/// Steps of the half turn in the table of hues: about ten for each step of a channel.
const STEPS: usize = 16_384;

/// Hues at the beginning of every step, and at the end of the last one.
static HUES: LazyLock<Vec<Rgba>> = LazyLock::new(|| {
    let hues = (0..=STEPS).map(|k| hue(k as f64 / STEPS as f64));
    hues.collect()
});

/// Hues of a half turn of azimuth: 0 and 180 degrees are the same axis and the same colour.
pub fn axis_hue(degrees: f64) -> Rgba {
    let turn = degrees / 180.0;
    let place = (turn - turn.floor()) * STEPS as f64;
    // NaN and rounding up to the end come out as steps that there are.
    let step = (place as usize).min(STEPS - 1);
    let (begin, end) = (HUES[step], HUES[step + 1]);
    // Maps have millions of axes, and three powers each are slow. Between two equal colours there
    // is no other: only where a channel changes the hue is worked out.
    if begin == end { begin } else { hue(turn) }
}

/// The hue of a share of the half turn.
fn hue(turn: f64) -> Rgba {
    oklch(0.72, 0.125, 0.08 + turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_has_one_colour() {
        assert_eq!(axis_hue(0.0), axis_hue(180.0));
        assert_eq!(axis_hue(-45.0), axis_hue(135.0));
        assert_ne!(axis_hue(0.0), axis_hue(90.0));
    }

    #[test]
    fn hues_of_the_table_are_those_of_the_formula() {
        for k in -100_000..=100_000 {
            let degrees = f64::from(k) * 0.001_8;
            assert_eq!(axis_hue(degrees), hue(degrees / 180.0), "{degrees}");
        }
    }
}
