//! Colour ramps, in sRGB.
//!
//! Sequential ramps grow steadily in lightness, so that they read in print and to the colour-blind.
//! Hues of classes and directions are taken from a circle of equal lightness in the OKLCH space
//! (Ottosson 2020), on which no hue stands out.

use crate::math;

/// Colour as stored in pictures: red, green, blue in sRGB, opacity.
pub type Rgba = [u8; 4];

/// A ramp: positions in ascending order, and their colours. Two stops at one position are a step.
#[derive(Clone, Copy, Debug)]
pub struct Ramp(pub &'static [(f32, [u8; 3])]);

/// Heights above the sea in km: abyss, shelf, lowland, highland, snow.
pub const HYPSOMETRIC: Ramp = Ramp(&[
    (-11.0, [6, 9, 30]),
    (-9.0, [10, 16, 52]),
    (-7.0, [14, 28, 78]),
    (-6.0, [18, 42, 100]),
    (-5.0, [24, 60, 124]),
    (-3.8, [34, 86, 150]),
    (-2.5, [50, 116, 174]),
    (-1.2, [78, 152, 196]),
    (-0.4, [114, 190, 210]),
    (-0.12, [146, 212, 218]),
    (0.0, [168, 224, 222]),
    (0.0, [88, 134, 88]),
    (0.2, [104, 148, 92]),
    (0.55, [138, 170, 104]),
    (1.1, [178, 190, 124]),
    (1.8, [206, 194, 142]),
    (2.7, [196, 164, 116]),
    (3.7, [168, 128, 90]),
    (4.8, [136, 102, 80]),
    (6.0, [146, 126, 114]),
    (7.2, [194, 186, 182]),
    (8.5, [238, 237, 238]),
    (10.0, [255, 255, 255]),
]);

/// From young and hot to old and cold.
pub const AGE: Ramp = Ramp(&[
    (0.0, [255, 243, 184]),
    (0.12, [253, 212, 124]),
    (0.28, [244, 162, 88]),
    (0.45, [222, 108, 84]),
    (0.62, [176, 66, 104]),
    (0.78, [118, 48, 118]),
    (0.9, [68, 40, 108]),
    (1.0, [34, 30, 82]),
]);

/// From little and dark to much and light.
pub const AMOUNT: Ramp = Ramp(&[
    (0.0, [20, 22, 48]),
    (0.16, [28, 54, 92]),
    (0.34, [26, 98, 120]),
    (0.52, [40, 142, 126]),
    (0.7, [116, 184, 106]),
    (0.86, [204, 216, 108]),
    (1.0, [254, 243, 176]),
]);

/// From level and pale to steep and dark.
pub const STEEPNESS: Ramp = Ramp(&[
    (0.0, [246, 244, 236]),
    (0.15, [228, 216, 188]),
    (0.35, [206, 172, 126]),
    (0.55, [176, 118, 86]),
    (0.75, [126, 68, 66]),
    (1.0, [56, 26, 44]),
]);

/// From below (blue) over nothing (pale) to above (red).
pub const DIVERGING: Ramp = Ramp(&[
    (-1.0, [28, 46, 104]),
    (-0.6, [58, 108, 168]),
    (-0.25, [150, 188, 212]),
    (0.0, [242, 240, 234]),
    (0.25, [228, 176, 142]),
    (0.6, [192, 90, 70]),
    (1.0, [104, 26, 40]),
]);

/// From frost (blue) over mild (pale) to heat (red); 8/15 is 0 °C.
pub const TEMPERATURE: Ramp = Ramp(&[
    (0.0, [52, 34, 92]),
    (0.2, [58, 84, 160]),
    (0.4, [120, 174, 214]),
    (0.533, [226, 236, 236]),
    (0.65, [206, 220, 156]),
    (0.78, [242, 204, 104]),
    (0.9, [222, 120, 66]),
    (1.0, [140, 32, 44]),
]);

/// From dry (sand) over moist (green) to wet (blue and violet).
pub const RAIN: Ramp = Ramp(&[
    (0.0, [248, 238, 206]),
    (0.03, [236, 216, 156]),
    (0.08, [214, 204, 118]),
    (0.15, [166, 196, 110]),
    (0.28, [88, 164, 110]),
    (0.5, [34, 122, 132]),
    (0.75, [26, 72, 132]),
    (1.0, [52, 20, 92]),
]);

/// From springs (the paper of a map) over rivers (blue) to the greatest streams (violet).
pub const DISCHARGE: Ramp = Ramp(&[
    (0.0, [238, 233, 217]),
    (0.2, [214, 224, 210]),
    (0.4, [160, 203, 206]),
    (0.58, [88, 160, 196]),
    (0.74, [34, 106, 172]),
    (0.88, [28, 54, 130]),
    (1.0, [58, 12, 84]),
]);

impl Ramp {
    /// The colour at position `x`; beyond the ends, that of the end. Not a number: that of the
    /// start.
    pub fn at(&self, x: f32) -> Rgba {
        let stops = self.0;
        let after = stops.partition_point(|&(position, _)| position <= x);
        if after == 0 || x.is_nan() {
            return opaque(stops[0].1);
        }
        if after == stops.len() {
            return opaque(stops[after - 1].1);
        }
        let ((a, low), (b, high)) = (stops[after - 1], stops[after]);
        opaque(mix_rgb(low, high, (x - a) / (b - a)))
    }

    /// The colour of `value` if the ramp's 0..1 stands for `low..high`.
    pub fn within(&self, value: f32, low: f32, high: f32) -> Rgba {
        self.at((value - low) / (high - low))
    }
}

/// An opaque colour.
pub const fn opaque([r, g, b]: [u8; 3]) -> Rgba {
    [r, g, b, 255]
}

/// The colour that lies the share `t` (0..1) of the way from `a` to `b`.
pub fn mix(a: Rgba, b: Rgba, t: f32) -> Rgba {
    let channel = |k: usize| mix_channel(a[k], b[k], t);
    [channel(0), channel(1), channel(2), channel(3)]
}

fn mix_rgb(a: [u8; 3], b: [u8; 3], t: f32) -> [u8; 3] {
    core::array::from_fn(|k| mix_channel(a[k], b[k], t))
}

fn mix_channel(a: u8, b: u8, t: f32) -> u8 {
    let (a, b) = (f32::from(a), f32::from(b));
    (a + (b - a) * t.clamp(0.0, 1.0) + 0.5) as u8
}

/// `color` with its brightness multiplied by `factor`.
pub fn scaled(color: Rgba, factor: f32) -> Rgba {
    let channel = |k: usize| (f32::from(color[k]) * factor + 0.5).clamp(0.0, 255.0) as u8;
    [channel(0), channel(1), channel(2), color[3]]
}

/// The colour with OKLCH lightness (0..1), chroma (0..0.3) and hue in turns; colours that a screen
/// cannot show are clipped.
pub fn oklch(lightness: f64, chroma: f64, hue: f64) -> Rgba {
    let (sin, cos) = math::sin_cos(hue * math::TAU);
    let (a, b) = (chroma * cos, chroma * sin);
    let cube = |x: f64| x * x * x;
    let l = cube(lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b);
    let m = cube(lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b);
    let s = cube(lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b);
    let linear = [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ];
    opaque(linear.map(|x| (255.0 * encode(x.clamp(0.0, 1.0)) + 0.5) as u8))
}

/// The sRGB transfer function.
fn encode(x: f64) -> f64 {
    if x <= 0.003_130_8 {
        12.92 * x
    } else {
        1.055 * math::pow(x, 1.0 / 2.4) - 0.055
    }
}

/// A colour for the `n`-th of many things. Neighbours in number are far apart in hue.
pub fn distinct(n: u32) -> Rgba {
    let turn = f64::from(n.wrapping_mul(0x9e37_79b9)) / 4_294_967_296.0;
    let lightness = [0.70, 0.60, 0.78][n as usize % 3];
    oklch(lightness, 0.115, turn)
}

/// Hues of a half turn of azimuth: 0 and 180 degrees are the same axis and the same colour.
pub fn axis_hue(degrees: f64) -> Rgba {
    oklch(0.72, 0.125, 0.08 + degrees / 180.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ramps_ascend_and_pass_through_their_stops() {
        for ramp in [
            HYPSOMETRIC,
            AGE,
            AMOUNT,
            STEEPNESS,
            DIVERGING,
            TEMPERATURE,
            RAIN,
            DISCHARGE,
        ] {
            assert!(ramp.0.windows(2).all(|w| w[0].0 <= w[1].0));
            for (i, &(x, color)) in ramp.0.iter().enumerate() {
                let last_of_step = ramp.0.get(i + 1).is_none_or(|next| next.0 > x);
                assert!(!last_of_step || ramp.at(x) == opaque(color), "{x}");
            }
            assert_eq!(ramp.at(-1e9), opaque(ramp.0[0].1));
            assert_eq!(ramp.at(f32::INFINITY), opaque(ramp.0[ramp.0.len() - 1].1));
            assert_eq!(ramp.at(f32::NAN), opaque(ramp.0[0].1));
        }
    }

    #[test]
    fn the_sea_ends_where_land_begins() {
        let (sea, land) = (HYPSOMETRIC.at(-1e-4), HYPSOMETRIC.at(0.0));
        assert!(sea[2] > sea[0] && land[1] > land[2], "{sea:?} {land:?}");
    }

    #[test]
    fn sequential_ramps_change_steadily_in_lightness() {
        let luma = |c: Rgba| {
            0.2126 * f32::from(c[0]) + 0.7152 * f32::from(c[1]) + 0.0722 * f32::from(c[2])
        };
        for (ramp, sign) in [
            (AGE, -1.0),
            (AMOUNT, 1.0),
            (STEEPNESS, -1.0),
            (DISCHARGE, -1.0),
        ] {
            for i in 0..64 {
                let step = luma(ramp.at((i + 1) as f32 / 64.0)) - luma(ramp.at(i as f32 / 64.0));
                assert!(step * sign > -0.6, "{i}: {step}");
            }
        }
    }

    #[test]
    fn oklch_knows_black_white_and_red() {
        assert_eq!(oklch(0.0, 0.0, 0.0), [0, 0, 0, 255]);
        assert_eq!(oklch(1.0, 0.0, 0.3), [255, 255, 255, 255]);
        let red = oklch(0.627_955, 0.257_683, 29.2339 / 360.0);
        assert!(red[0] >= 254 && red[1] <= 2 && red[2] <= 2, "{red:?}");
    }

    #[test]
    fn an_axis_has_one_colour() {
        assert_eq!(axis_hue(0.0), axis_hue(180.0));
        assert_ne!(axis_hue(0.0), axis_hue(90.0));
    }
}
