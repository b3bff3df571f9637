//! Coherent noise of low frequency that raises and lowers continents (paper 000 §4.5).
//!
//! Two patterns take turns over `noise_period`: what one raises the other lowers again, so that
//! no relief grows without end.

use crate::math::{PI, sin_cos};
use crate::noise::Noise;
use crate::parallel::CHUNK;
use crate::params::TectonicParams;
use crate::random::Purpose;
use crate::view::PlanetView;
use bevy::prelude::*;
use core::ops::Range;
use rayon::prelude::*;

/// Octaves of a pattern.
const OCTAVES: u32 = 3;

/// Samples whose noise is evaluated between two looks at the clock.
const SAMPLES_PER_TIME_SLICE: usize = 8 * CHUNK;

/// Two patterns of noise, one value per sample; they depend on seed and wavelength only.
#[derive(Component, Clone, Debug, Default)]
pub struct ReliefNoise {
    wavelength: f64,
    patterns: [Vec<f32>; 2],
}

impl ReliefNoise {
    /// Evaluates the patterns, unless they are there already. Returns early, with false, where
    /// `stop` says so; the next call goes on. True when they are complete.
    pub fn prepare(&mut self, planet: &PlanetView, stop: impl Fn() -> bool) -> bool {
        let mesh = planet.mesh;
        let wavelength = planet.params.noise_wavelength;
        // Patterns of another wavelength or of a larger mesh are of no use.
        if self.wavelength != wavelength || self.patterns[0].len() > mesh.len() {
            *self = Self {
                wavelength,
                ..default()
            };
        }
        let frequency = planet.radius / wavelength;
        let noise = [0, 1].map(|id| Noise::new(planet.seed, Purpose::Relief, id));
        while self.patterns[1].len() < mesh.len() {
            let start = self.patterns[1].len();
            let end = (start + SAMPLES_PER_TIME_SLICE).min(mesh.len());
            let points = &mesh.points()[start..end];
            for (noise, pattern) in noise.iter().zip(&mut self.patterns) {
                pattern.par_extend(
                    points
                        .par_iter()
                        .with_min_len(CHUNK)
                        .map(|&p| noise.fractal(p, frequency, OCTAVES) as f32),
                );
            }
            // Each call does some of the work, or one that is late would never end.
            if stop() && self.patterns[1].len() < mesh.len() {
                return false;
            }
        }
        true
    }

    /// The patterns over a run of samples, if they are complete there.
    pub(super) fn patterns(&self, samples: Range<usize>) -> Option<[&[f32]; 2]> {
        let [a, b] = &self.patterns;
        Some([a.get(samples.clone())?, b.get(samples)?])
    }
}

/// Weights of the two patterns in km at `time` My.
pub(super) fn weights(params: &TectonicParams, time: f64) -> [f32; 2] {
    if !params.processes.noise {
        return [0.0; 2];
    }
    // Both weights sum to 0 over a period.
    let (s, c) = sin_cos(2.0 * PI * time / params.noise_period);
    let amplitude = params.noise_amplitude * params.time_step;
    [(amplitude * c) as f32, (amplitude * s) as f32]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_take_turns_over_the_period() {
        let params = TectonicParams {
            noise_period: 80.0,
            noise_amplitude: 0.01,
            ..TectonicParams::default()
        };
        // 0.01 km a My for 2 My, a quarter of a period apart.
        for (time, expected) in [
            (0.0, [0.02, 0.0]),
            (20.0, [0.0, 0.02]),
            (40.0, [-0.02, 0.0]),
        ] {
            let [a, b] = weights(&params, time);
            assert!((a - expected[0]).abs() < 1e-8 && (b - expected[1]).abs() < 1e-8);
        }
    }
}
