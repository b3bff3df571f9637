//! Colours, in sRGB: ramps for quantities, fixed colours for classes, and the mixing of both.
//!
//! Hues of classes and directions are taken from a circle of equal lightness in the OKLCH space
//! (Ottosson 2020), on which no hue stands out.

pub mod classes;

mod axis;
mod ramps;

pub use axis::axis_hue;
pub use ramps::{AGE, AMOUNT, DISCHARGE, DIVERGING, HYPSOMETRIC, RAIN, STEEPNESS, TEMPERATURE};

use crate::math;

/// Colour as stored in pictures: red, green, blue in sRGB, opacity.
pub type Rgba = [u8; 4];

/// A ramp: positions in ascending order, and their colours. Two stops at one position are a step.
#[derive(Clone, Copy, Debug)]
pub struct Ramp(pub &'static [(f32, [u8; 3])]);

impl Ramp {
    /// The colour at position `x`; beyond the ends, that of the end; NaN has that of the start.
    pub fn at(&self, x: f32) -> Rgba {
        let stops = self.0;
        // One by one: stops are few, and maps ask a hundred million times. NaN is beyond no stop.
        let after = stops.iter().take_while(|stop| stop.0 <= x).count();
        if after == 0 {
            return opaque(stops[0].1);
        }
        if after == stops.len() {
            return opaque(stops[after - 1].1);
        }
        let (a, low) = stops[after - 1];
        let (b, high) = stops[after];
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
///
/// ```
/// use bevy_pangaea::overlay::palette::{HYPSOMETRIC, mix};
///
/// let (sea, land) = (HYPSOMETRIC.at(-5.0), HYPSOMETRIC.at(1.0));
/// assert_eq!(mix(sea, land, 0.0), sea);
/// ```
pub fn mix(a: Rgba, b: Rgba, t: f32) -> Rgba {
    let channel = |k: usize| mix_channel(a[k], b[k], t);
    [channel(0), channel(1), channel(2), channel(3)]
}

/// [`mix`] of colours without opacity.
fn mix_rgb(a: [u8; 3], b: [u8; 3], t: f32) -> [u8; 3] {
    core::array::from_fn(|k| mix_channel(a[k], b[k], t))
}

/// The value of one channel the share `t` of the way from `a` to `b`, rounded.
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
    // OKLab to the cone responses, and from those to linear sRGB.
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
    // The golden ratio spreads hues evenly, however many there are; three steps of lightness tell
    // near hues apart.
    let lightness = [0.70, 0.60, 0.78][n as usize % 3];
    oklch(lightness, 0.115, turn)
}

#[cfg(test)]
mod tests;
