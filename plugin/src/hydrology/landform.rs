//! What the crust at a vertex says about the relief around it.
//!
//! Crust is sampled every 50 to 200 km; what lies between is *relief*. It stands about the mean
//! elevation z of the crust: valleys a third of it below, summits two thirds above. So C, the level
//! that summits reach, is z + 0.65 R, and the base ground, on which rivers run, is z - 0.35 R. R
//! spans from the valley floors to the highest summits: in real belts that is the largest range
//! within 10 km, half again the median one: Karakoram 3.8 km, Everest 4.4; Patagonia 2.7, Aconcagua
//! 3.4; Appalachians and Scottish Highlands 1.1. Noise and low crust leave less of it, so it is 4.9
//! km in young Himalayan belts, 3.2 km in young Andean ones, 0.85 km once they are 200 My old, and
//! some tens of metres where nothing was folded. A low belt has no more of it than one and three
//! quarters of its mean elevation, however old (Scottish Highlands
//! 1.2, Patagonia 1.75).
//!
//! - P, plateau: high, level crust of young belts: what lies behind the Andean and Himalayan
//!   fronts, less where ranges
//!   cross it. Its relief is two fifths of its belt's (Altiplano: 1.3 km, beside 2.1 km at
//! Aconcagua).
//! - B, hills: old belts, and the forelands of moderate height.
//!
//! Policies. Values are interpolated; ages and directions come from those corners that have them.
//! Directions have no sign: they are turned to the side of the heaviest corner first.

use crate::crust::{Orogeny, Surface};
use crate::math;
use bevy::math::Vec3;

/// R in km of a young belt of subduction, of a young belt of collision, and of a worn one.
const SUBDUCTION: f32 = 3.2;
const COLLISION: f32 = 4.9;
const WORN: f32 = 0.85;

/// Age in My of belts that are worn down to hills.
const OLD: f32 = 200.0;

/// Most relief of a belt per mean elevation: its valleys end at the sea.
const RELIEF_OF_MEAN: f32 = 1.75;

/// Share of the relief that a plateau lacks.
const LEVELLED: f32 = 0.6;

/// Share of the relief that lies below the mean elevation.
pub(super) const BELOW: f32 = 0.35;

/// Roughness of slopes in km per unit of steepness: the height that they gain within an edge.
const SLOPE_ROUGHNESS: f32 = 45.0;

/// What is known of the crust at a vertex.
#[derive(Clone, Copy, Default)]
pub(super) struct Crustal {
    pub(super) elevation: f32,
    pub(super) folded: f32,
    pub(super) age: f32,
    pub(super) collision: f32,
    pub(super) oceanic: f32,
    pub(super) ocean_age: f32,
    pub(super) fold: Vec3,
    pub(super) ridge: Vec3,
    /// Share of the noise between samples that is added: none to maps, which bring relief of their
    /// own.
    pub(super) noise: f32,
}

impl Crustal {
    pub(super) fn between(surface: &Surface, (corners, weights): ([usize; 3], [f32; 3])) -> Self {
        let crust = &surface.crust;
        let total = |value: &dyn Fn(usize) -> f32| {
            (0..3).map(|k| weights[k] * value(corners[k])).sum::<f32>()
        };
        let mean_of = |weight: &dyn Fn(usize) -> f32, value: &dyn Fn(usize) -> f32| {
            let sum = total(weight);
            if sum > 0.0 {
                total(&|i| weight(i) * value(i)) / sum
            } else {
                0.0
            }
        };
        let folded = |i: usize| f32::from(u8::from(crust.orogeny[i] != Orogeny::None));
        let oceanic = |i: usize| if crust.is_continental(i) { 0.0 } else { 1.0 };
        let axis = |vectors: &[Vec3]| {
            let heaviest = (0..3)
                .max_by(|&a, &b| weights[a].total_cmp(&weights[b]))
                .unwrap_or(0);
            let lead = vectors[corners[heaviest]];
            let sum: Vec3 = (0..3)
                .map(|k| {
                    let v = vectors[corners[k]];
                    weights[k] * if v.dot(lead) < 0.0 { -v } else { v }
                })
                .sum();
            sum.normalize_or_zero()
        };
        Self {
            elevation: total(&|i| surface.elevation(i)),
            folded: total(&folded),
            age: mean_of(&folded, &|i| crust.orogeny_age[i]),
            collision: mean_of(&folded, &|i| {
                f32::from(u8::from(crust.orogeny[i] == Orogeny::Himalayan))
            }),
            oceanic: total(&oceanic),
            ocean_age: mean_of(&oceanic, &|i| crust.ocean_age[i]),
            fold: axis(&crust.fold),
            ridge: axis(&crust.ridge),
            noise: 1.0,
        }
    }

    /// How much of a young belt's relief is left, 0..=1.
    pub(super) fn youth(&self) -> f32 {
        1.0 - smooth(self.age / OLD)
    }

    /// R in km.
    pub(super) fn relief(&self, plateau: f32) -> f32 {
        let z = self.elevation;
        let plain = 0.05 + 0.08 * z.clamp(0.0, 3.0);
        let young = SUBDUCTION + (COLLISION - SUBDUCTION) * self.collision;
        let belt = (WORN + (young - WORN) * self.youth()).min(RELIEF_OF_MEAN * z);
        let relief = plain + (belt - plain).max(0.0) * self.folded;
        relief * (1.0 - LEVELLED * plateau) * smooth((z + 0.3) / 0.4)
    }

    /// Base ground in km: valleys lie below the mean, and the noise of the base mesh makes them
    /// wind. On slopes it must be stronger, or rivers would run down side by side and never meet.
    pub(super) fn ground(&self, relief: f32, steepness: f32, noise: f32) -> f32 {
        let z = self.elevation;
        let low = if z > 0.0 {
            (z - BELOW * relief).max(0.4 * z)
        } else {
            z
        };
        // Deep floor is the amplifier's alone.
        let rough = 0.06 + 0.2 * relief + SLOPE_ROUGHNESS * steepness.min(0.02);
        low + self.noise * noise * rough * smooth((z + 1.5) / 1.3)
    }

    /// P. Tibet and the Altiplano rise by less than 200 m in 100 km, the flanks of their belts by 1
    /// to 4 km. Where the noise between samples is high a range crosses the plateau.
    pub(super) fn plateau(&self, steepness: f32, noise: f32) -> f32 {
        let high = smooth((self.elevation - 1.8) / 1.6);
        let level = 1.0 - smooth((steepness - 0.002) / 0.008);
        let basin = 1.0 - smooth(self.noise * noise / 0.5);
        high * level * basin * self.folded * (0.3 + 0.7 * self.youth())
    }

    pub(super) fn hills(&self) -> f32 {
        let z = self.elevation;
        let old = self.folded * (1.0 - self.youth()) * smooth(z / 0.3);
        let foreland = (1.0 - self.folded) * smooth((z - 0.25) / 0.5);
        (old + 0.7 * foreland).min(1.0)
    }
}

fn smooth(x: f32) -> f32 {
    math::smoothstep(f64::from(x)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn belt(elevation: f32, age: f32, collision: f32) -> Crustal {
        Crustal {
            elevation,
            folded: 1.0,
            age,
            collision,
            ..Crustal::default()
        }
    }

    #[test]
    fn belts_differ_by_kind_and_age() {
        let himalaya = belt(4.5, 10.0, 1.0).relief(0.0);
        let andes = belt(3.5, 10.0, 0.0).relief(0.0);
        let old = belt(1.0, 300.0, 1.0).relief(0.0);
        let plain = Crustal {
            elevation: 0.2,
            ..Crustal::default()
        }
        .relief(0.0);
        // Largest relief within 10 km of measured tiles: Karakoram to Annapurna, Patagonia to the
        // Andes of Chile, and no more than the Appalachians.
        assert!(
            (3.8..5.6).contains(&himalaya) && (2.6..4.0).contains(&andes),
            "{himalaya} {andes}"
        );
        assert!((0.7..1.06).contains(&old) && plain < 0.1, "{old} {plain}");
        assert!(belt(4.5, 10.0, 1.0).relief(1.0) < 0.5 * himalaya);
        assert_eq!(belt(-4.0, 10.0, 1.0).relief(0.0), 0.0);
    }

    #[test]
    fn low_belts_keep_their_valleys_above_the_sea() {
        for age in [10.0, 100.0, 300.0] {
            for z in [0.05, 0.2, 0.5, 1.0, 2.0] {
                let low = belt(z, age, 1.0);
                let relief = low.relief(0.0);
                assert!(
                    relief <= RELIEF_OF_MEAN * z + 0.06 && low.ground(relief, 0.0, 0.0) > 0.0,
                    "{z} km, {age} My: {relief}"
                );
            }
        }
        // The Scottish Highlands: 0.54 km high in the mean.
        assert!(belt(0.54, 400.0, 1.0).relief(0.0) > 0.66);
    }

    #[test]
    fn plateaus_are_high_and_level_and_hills_are_old() {
        let high = Crustal {
            noise: 1.0,
            ..belt(4.5, 10.0, 1.0)
        };
        assert!(high.plateau(0.002, -0.1) > 0.9);
        assert_eq!(high.plateau(0.03, -0.1), 0.0);
        assert_eq!(high.plateau(0.002, 0.5), 0.0, "a range");
        assert_eq!(belt(0.5, 10.0, 1.0).plateau(0.0, 0.0), 0.0);
        assert!(belt(0.6, 400.0, 0.5).hills() > 0.9 && belt(3.0, 5.0, 0.5).hills() < 0.1);
    }
}
