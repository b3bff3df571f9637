//! A quantity that is known at every sample, and how it becomes a colour between them.
//!
//! Quantities, not colours, are interpolated between samples: a coast stays a line, and NaN is left
//! out instead of being mixed in. Classes take the side with most weight.

use super::palette::{self, Ramp, Rgba, classes};
use crate::crust::CrustKind;
use crate::math;

/// A quantity at every sample.
pub(super) enum OverlayField {
    /// Numbers on a ramp from `low` to `high`; NaN where there is no value.
    Scalar {
        values: Vec<f32>,
        ramp: Ramp,
        low: f32,
        high: f32,
    },
    /// Axes: the doubled azimuth as a vector, so that opposite directions mix; zero where there is
    /// no axis.
    Axis(Vec<[f32; 2]>),
    /// Classes that do not mix, by their colours.
    Classes(Vec<Rgba>),
    /// Colours that mix.
    Colors(Vec<Rgba>),
}

/// A place in the triangle of three samples.
#[derive(Clone, Copy)]
pub(super) struct Barycentric {
    /// The samples.
    pub(super) vertices: [u32; 3],
    /// Their weights; the sum is 1.
    pub(super) weights: [f32; 3],
}

impl Barycentric {
    /// The weighted mean of a number given at the samples.
    pub(super) fn interpolate(&self, value: impl Fn(usize) -> f32) -> f32 {
        (0..3)
            .map(|c| self.weights[c] * value(self.vertices[c] as usize))
            .sum()
    }

    /// The entries of `column` at the three samples.
    pub(super) fn of<T: Copy>(&self, column: &[T]) -> [T; 3] {
        self.vertices.map(|v| column[v as usize])
    }
}

impl OverlayField {
    /// The colour at sample `i`; `kinds` are the crust's.
    pub(super) fn at_sample(&self, i: u32, kinds: &[CrustKind]) -> Rgba {
        let place = Barycentric {
            vertices: [i; 3],
            weights: [1.0, 0.0, 0.0],
        };
        self.at(&place, kinds)
    }

    /// The colour at a place between three samples; `kinds` are the crust's.
    pub(super) fn at(&self, place: &Barycentric, kinds: &[CrustKind]) -> Rgba {
        let weights = place.weights;
        match self {
            Self::Scalar {
                values,
                ramp,
                low,
                high,
            } => match mean(place.of(values), weights) {
                Some(value) => ramp.within(value, *low, *high),
                None => no_value(place.of(kinds), weights),
            },
            Self::Axis(axes) => match mean_azimuth(place.of(axes), weights) {
                Some(degrees) => palette::axis_hue(degrees),
                None => no_value(place.of(kinds), weights),
            },
            Self::Classes(colors) => majority(place.of(colors), weights).0,
            Self::Colors(colors) => blend(place.of(colors), weights),
        }
    }
}

/// Mean of the numbers among `values`, if they have at least half of the weight.
fn mean(values: [f32; 3], weights: [f32; 3]) -> Option<f32> {
    let (mut sum, mut known) = (0.0, 0.0);
    for (value, weight) in values.into_iter().zip(weights) {
        if !value.is_nan() {
            sum += weight * value;
            known += weight;
        }
    }
    (known >= 0.5).then(|| sum / known)
}

/// Mean azimuth of axes in degrees, if those that are known have at least half of the weight.
fn mean_azimuth(axes: [[f32; 2]; 3], weights: [f32; 3]) -> Option<f64> {
    let known: f32 = (0..3)
        .filter(|&c| axes[c] != [0.0; 2])
        .map(|c| weights[c])
        .sum();
    if known < 0.5 {
        return None;
    }
    // Doubled azimuths are a full turn for half of one; the mean is halved again.
    let part = |k: usize| (0..3).map(|c| weights[c] * axes[c][k]).sum::<f32>();
    Some(0.5 * math::atan2(part(1).into(), part(0).into()).to_degrees())
}

/// Weighted mean of colours, rounded.
fn blend(colors: [Rgba; 3], weights: [f32; 3]) -> Rgba {
    [0, 1, 2, 3].map(|k| {
        let channel: f32 = (0..3).map(|c| weights[c] * f32::from(colors[c][k])).sum();
        (channel + 0.5) as u8
    })
}

/// The class with most weight, and by how much it leads. At a tie the first corner wins.
pub(super) fn majority<T: Copy + PartialEq>(classes: [T; 3], weights: [f32; 3]) -> (T, f32) {
    let mut best = (classes[0], weight_of(classes[0], classes, weights));
    let mut second = 0.0;
    for class in [classes[1], classes[2]] {
        // Its weight is counted already.
        if class == best.0 {
            continue;
        }
        let weight = weight_of(class, classes, weights);
        if weight > best.1 {
            second = best.1;
            best = (class, weight);
        } else {
            second = weight.max(second);
        }
    }
    (best.0, best.1 - second)
}

/// Weight of all corners of a class.
fn weight_of<T: PartialEq>(class: T, classes: [T; 3], weights: [f32; 3]) -> f32 {
    (0..3)
        .filter(|&c| classes[c] == class)
        .map(|c| weights[c])
        .sum()
}

/// The colour of a place without a value.
fn no_value(kinds: [CrustKind; 3], weights: [f32; 3]) -> Rgba {
    match majority(kinds, weights).0 {
        CrustKind::Oceanic => classes::NO_VALUE_OCEAN,
        CrustKind::Continental => classes::NO_VALUE_LAND,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_values_are_left_out() {
        let mixed = mean([2.0, f32::NAN, 4.0], [0.5, 0.25, 0.25]);
        assert_eq!(mixed, Some(8.0 / 3.0));
        assert_eq!(mean([f32::NAN, f32::NAN, 4.0], [0.4, 0.3, 0.3]), None);
    }

    #[test]
    fn most_weight_wins() {
        assert_eq!(majority(['a', 'b', 'b'], [0.4, 0.3, 0.3]).0, 'b');
        assert_eq!(majority(['a', 'b', 'c'], [0.4, 0.3, 0.3]).0, 'a');
        let (class, lead) = majority(['a', 'b', 'c'], [0.2, 0.5, 0.3]);
        assert!(class == 'b' && (lead - 0.2).abs() < 1e-6);
    }
}
