use super::*;
use crate::random::{Purpose, Stream};

/// A wave of the plane.
struct Wave {
    /// Angles in radians per m to the east and to the south.
    vector: [f64; 2],
    /// Sine and cosine of the phase.
    phase: (f64, f64),
    amplitude: f64,
}

impl Wave {
    /// Wave `i` of a surface whose power falls as k^-β: amplitudes k^(-β/2) over a density of waves
    /// that grows with k, as in the plane. Waves are drawn in the logarithm of k, so each stands
    /// for k² waves of the plane.
    fn random(stream: &Stream, i: u64, beta: f64) -> Self {
        let (shortest, longest) = (math::ln(500.0), math::ln(60_000.0));
        let wavelength = math::exp(stream.range(4 * i, shortest, longest));
        let (sin, cos) = math::sin_cos(TAU * stream.unit(4 * i + 1));
        Self {
            vector: [cos * TAU / wavelength, sin * TAU / wavelength],
            phase: math::sin_cos(TAU * stream.unit(4 * i + 2)),
            amplitude: math::pow(wavelength, 0.5 * beta - 1.0),
        }
    }
}

/// Sine and cosine of every wave at `distance` m along an axis.
fn sines(waves: &[Wave], axis: usize, distance: f64) -> Vec<(f64, f64)> {
    let angles = waves.iter().map(|wave| wave.vector[axis] * distance);
    angles.map(math::sin_cos).collect()
}

/// sin(a + b) and cos(a + b) of the sines and cosines of a and b.
fn sine_of_sum((sin_a, cos_a): (f64, f64), (sin_b, cos_b): (f64, f64)) -> (f64, f64) {
    (sin_a * cos_b + cos_a * sin_b, cos_a * cos_b - sin_a * sin_b)
}

/// The sum of all waves, from the sines and cosines of their angles in both axes.
fn sum_of_waves(column: &[(f64, f64)], row: &[(f64, f64)], waves: &[Wave]) -> f32 {
    let parts = column.iter().zip(row).zip(waves);
    let sum: f64 = parts
        .map(|((&x, &y), wave)| wave.amplitude * sine_of_sum(x, y).0)
        .sum();
    sum as f32
}

/// A surface of many random waves whose power falls as k^-β.
fn fractal(beta: f64, pixel_m: [f64; 2], seed: u64) -> HeightGrid {
    let (width, height) = (500, 400);
    let stream = Stream::new(seed, Purpose::ReliefSites, 0);
    let waves: Vec<Wave> = (0..600).map(|i| Wave::random(&stream, i, beta)).collect();
    // A table of sines for each axis, and sums of angles: no sine for every pixel.
    let columns: Vec<_> = (0..width)
        .map(|x| sines(&waves, 0, x as f64 * pixel_m[0]))
        .collect();
    let mut values = Vec::with_capacity(width * height);
    for y in 0..height {
        let row = sines(&waves, 1, y as f64 * pixel_m[1])
            .into_iter()
            .zip(&waves);
        let shifted: Vec<(f64, f64)> = row
            .map(|(angle, wave)| sine_of_sum(angle, wave.phase))
            .collect();
        let heights = columns
            .iter()
            .map(|column| sum_of_waves(column, &shifted, &waves));
        values.extend(heights);
    }
    HeightGrid {
        width,
        height,
        values,
        pixel_m,
    }
}

#[test]
fn surfaces_of_known_exponent_have_it() {
    for (beta, pixel) in [
        (2.0, [120.0, 150.0]),
        (3.0, [150.0, 120.0]),
        (4.0, [120.0; 2]),
    ] {
        let found = [1, 2, 3].map(|seed| spectral_exponent(&fractal(beta, pixel, seed)).unwrap());
        let mean = found.iter().sum::<f64>() / 3.0;
        assert!((mean - beta).abs() < 0.25, "{beta}: {found:?}");
    }
}
