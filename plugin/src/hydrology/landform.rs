//! The relief around a vertex, by the age and kind of its crust.
//!
//! Crust is sampled every 50 to 200 km; between samples lies *relief*. It stands about the mean
//! elevation z of the crust: valleys a third of it below, summits two thirds above. So C, the level
//! that summits reach, is z + 0.65 R, and the base ground, on which rivers run, is z - 0.35 R. R
//! spans from the valley floors to the highest summits: in real belts that is the largest range
//! within 10 km, half again the median one: Karakoram 3.8 km, Everest 4.4; Patagonia 2.7, Aconcagua
//! 3.4; Appalachians and Scottish Highlands 1.1. Noise and low crust leave less of it, so it is 4.9
//! km in young Himalayan belts, 3.2 km in young Andean ones, 0.85 km once they are 200 My old, and
//! some tens of metres where nothing was folded. A low belt has no more of it than one and three
//! quarters of its mean elevation, however old (Scottish Highlands 1.2, Patagonia 1.75).
//!
//! - P, plateau: high, level crust of young belts, as behind the Andean and Himalayan fronts, less
//!   where ranges cross it. Its relief is two fifths of its belt's (Altiplano: 1.3 km, beside 2.1
//!   km at Aconcagua).
//! - B, hills: old belts, and the forelands of moderate height.
//!
//! Policies. Values are interpolated; ages and directions come from those corners that have them.
//! Directions have no sign: they are turned to the side of the heaviest corner first.
//!
//! Constants without another source are fitted to the measured tiles above.

use crate::crust::{Orogeny, Surface};
use crate::math;
use bevy::math::Vec3;

/// R in km of a young belt of subduction.
const SUBDUCTION_RELIEF_KM: f32 = 3.2;

/// R in km of a young belt of collision.
const COLLISION_RELIEF_KM: f32 = 4.9;

/// R in km of a belt that is worn down.
const WORN_RELIEF_KM: f32 = 0.85;

/// Age in My of belts that are worn down to hills.
const WORN_AGE_MY: f32 = 200.0;

/// Most relief of a belt per mean elevation: its valleys end at the sea.
const RELIEF_OF_MEAN: f32 = 1.75;

/// Share of the relief that a plateau lacks.
const LEVELLED: f32 = 0.6;

/// Share of the relief that lies below the mean elevation.
pub(super) const RELIEF_BELOW_MEAN: f32 = 0.35;

/// Least ground of valleys above the sea, as a share of the mean elevation.
const LOWEST_VALLEY: f32 = 0.4;

/// Roughness of slopes in km per unit of steepness: the height that they gain within an edge.
const SLOPE_ROUGHNESS_KM: f32 = 45.0;

/// Level of summits in km from which on ice and landslides take the more the higher they stand.
const LOWERED_FROM_KM: f32 = 5.0;

/// Level in km that no summit reaches.
const HIGHEST_SUMMIT_KM: f32 = 9.3;

/// The crust at a vertex.
#[derive(Clone, Copy, Default)]
pub(super) struct CrustSample {
    /// Mean elevation z in km.
    pub(super) elevation: f32,
    /// Share of crust that was folded.
    pub(super) folded: f32,
    /// Age of the folding in My.
    pub(super) age: f32,
    /// Share of the folded crust that continents folded by collision.
    pub(super) collision: f32,
    /// Share of oceanic crust.
    pub(super) oceanic: f32,
    /// Age of the oceanic crust in My.
    pub(super) ocean_age: f32,
    /// Fold direction, undirected.
    pub(super) fold: Vec3,
    /// Direction of the ridge that made the ocean floor, undirected.
    pub(super) ridge: Vec3,
    /// Factor of the noise that stands for relief between samples: 1, but 0 for maps, which have
    /// relief of their own.
    pub(super) noise: f32,
}

impl CrustSample {
    /// The crust between three samples of a surface, by their numbers and weights.
    pub(super) fn between(surface: &Surface, corners: ([usize; 3], [f32; 3])) -> Self {
        let (samples, weights) = corners;
        let corners = CornerSamples { samples, weights };
        let crust = &surface.crust;
        let folded = |i: usize| share_of(crust.orogeny[i] != Orogeny::None);
        let collision = |i: usize| share_of(crust.orogeny[i] == Orogeny::Himalayan);
        let oceanic = |i: usize| share_of(!crust.is_continental(i));
        Self {
            elevation: corners.mean(|i| surface.elevation(i)),
            folded: corners.mean(folded),
            age: corners.mean_among(folded, |i| crust.orogeny_age[i]),
            collision: corners.mean_among(folded, collision),
            oceanic: corners.mean(oceanic),
            ocean_age: corners.mean_among(oceanic, |i| crust.ocean_age[i]),
            fold: corners.axis(&crust.fold),
            ridge: corners.axis(&crust.ridge),
            noise: 1.0,
        }
    }

    /// How much of a young belt's relief is left, 0..=1.
    pub(super) fn youth(&self) -> f32 {
        1.0 - worn(self.age)
    }

    /// R in km.
    pub(super) fn relief(&self, plateau: f32) -> f32 {
        let z = self.elevation;
        // Even plains have banks and dunes: 50 m, and more on high ground.
        let plain = 0.05 + 0.08 * z.clamp(0.0, 3.0);
        let range = COLLISION_RELIEF_KM - SUBDUCTION_RELIEF_KM;
        let young = SUBDUCTION_RELIEF_KM + range * self.collision;
        // A belt is bounded by its own mean: valleys cannot be cut below the sea.
        let belt = WORN_RELIEF_KM + (young - WORN_RELIEF_KM) * self.youth();
        let belt = belt.min(RELIEF_OF_MEAN * z.abs());
        let relief = plain + (belt - plain).max(0.0) * self.folded;
        // Under water waves and sediment level the relief: none of it is left 300 m below the sea.
        relief * (1.0 - LEVELLED * plateau) * smoothstep((z + 0.3) / 0.4)
    }

    /// Base ground in km: valleys lie below the mean, and the noise of the base mesh makes them
    /// wind. On slopes it must be stronger, or rivers would run down side by side and never meet.
    pub(super) fn ground(&self, relief: f32, steepness: f32, noise: f32) -> f32 {
        let z = self.elevation;
        // 60 m of noise even on plains, or rivers would run along the triangles; on slopes at most
        // 900 m more.
        let rough = 0.06 + 0.2 * relief + SLOPE_ROUGHNESS_KM * steepness.min(0.02);
        // The deep floor gets its relief from the amplifier alone.
        let mean = z + self.noise * noise * rough * smoothstep((z + 1.5) / 1.3);
        // Shallow floors lie as far above their mean as valleys below theirs, and the noise comes
        // first: the land keeps its area.
        let depth = RELIEF_BELOW_MEAN * relief;
        if mean > 0.0 {
            (mean - depth).max(LOWEST_VALLEY * mean)
        } else {
            (mean + depth).min(LOWEST_VALLEY * mean)
        }
    }

    /// P. Tibet and the Altiplano rise by less than 200 m in 100 km, the flanks of their belts by 1
    /// to 4 km. Where the noise between samples is high a range crosses the plateau.
    pub(super) fn plateau(&self, steepness: f32, noise: f32) -> f32 {
        // High is from 1.8 to 3.4 km, level from 10 down to 2 m per km.
        let high = smoothstep((self.elevation - 1.8) / 1.6);
        let level = 1.0 - smoothstep((steepness - 0.002) / 0.008);
        let basin = 1.0 - smoothstep(self.noise * noise / 0.5);
        high * level * basin * self.folded * (0.3 + 0.7 * self.youth())
    }

    /// B: old belts wherever they stand above the sea, and unfolded forelands from 250 m on.
    pub(super) fn hills(&self) -> f32 {
        let z = self.elevation;
        let old = self.folded * (1.0 - self.youth()) * smoothstep(z / 0.3);
        let foreland = (1.0 - self.folded) * smoothstep((z - 0.25) / 0.5);
        (old + 0.7 * foreland).min(1.0)
    }
}

/// How far age has worn land that was folded so many My ago, 0..=1; 1 for an infinite age.
pub(crate) fn worn(age: f32) -> f32 {
    smoothstep(age / WORN_AGE_MY)
}

/// The height of summits, km, that would stand so high without ice, landslides and broken rock.
/// Denudation grows with the height above the snow line, and holds ranges to about that height
/// whatever lifts them (Brozović et al. 1997; Egholm et al. 2009).
pub(super) fn lowered_summits(km: f32) -> f32 {
    let range = HIGHEST_SUMMIT_KM - LOWERED_FROM_KM;
    let over = ((km - LOWERED_FROM_KM) / range).max(0.0);
    // Near the identity for low summits: |x| / (1 + x⁴)^¼.
    let square = over * over;
    let kept = over / (1.0 + square * square).sqrt().sqrt();
    km.min(LOWERED_FROM_KM) + range * kept
}

/// Three samples and their weights.
struct CornerSamples {
    samples: [usize; 3],
    weights: [f32; 3],
}

impl CornerSamples {
    /// The weighted sum of a value; the weights sum to 1.
    fn mean(&self, value: impl Fn(usize) -> f32) -> f32 {
        let parts = (0..3).map(|k| self.weights[k] * value(self.samples[k]));
        parts.sum::<f32>()
    }

    /// The mean of `value` over the corners, each weighted by its `share` as well; 0 where all
    /// shares are 0.
    fn mean_among(&self, share: impl Fn(usize) -> f32, value: impl Fn(usize) -> f32) -> f32 {
        let sum = self.mean(&share);
        if sum > 0.0 {
            self.mean(|i| share(i) * value(i)) / sum
        } else {
            0.0
        }
    }

    /// The mean of undirected vectors, each first turned to the side of the heaviest corner's
    /// vector; unit length, or zero.
    fn axis(&self, vectors: &[Vec3]) -> Vec3 {
        let heaviest = (0..3)
            .max_by(|&a, &b| self.weights[a].total_cmp(&self.weights[b]))
            .unwrap_or(0);
        let lead = vectors[self.samples[heaviest]];
        let mut sum = Vec3::ZERO;
        for (sample, weight) in self.samples.into_iter().zip(self.weights) {
            let v = vectors[sample];
            sum += weight * if v.dot(lead) < 0.0 { -v } else { v };
        }
        sum.normalize_or_zero()
    }
}

/// 1 for true, 0 for false.
fn share_of(is_such: bool) -> f32 {
    f32::from(u8::from(is_such))
}

fn smoothstep(x: f32) -> f32 {
    math::smoothstep(f64::from(x)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_summit_stands_above_nine_kilometres_and_low_ones_stay() {
        let heights = (0..200).map(|i| 0.1 * i as f32);
        for pair in heights.collect::<Vec<_>>().windows(2) {
            let [low, high] = [pair[0], pair[1]].map(lowered_summits);
            assert!(
                low < high && high < pair[1] + 1e-5 && high < 9.3,
                "{pair:?}"
            );
        }
        assert_eq!([0.3, 4.9].map(lowered_summits), [0.3, 4.9]);
        // As high as the Himalaya without a summit of 12 km.
        let [high, highest] = [7.0, 12.0].map(lowered_summits);
        assert!((6.9..7.0).contains(&high) && (9.0..9.3).contains(&highest));
    }

    #[test]
    fn the_shore_stays_where_the_crust_has_it() {
        for age in [10.0, 300.0] {
            for z in [0.02, 0.05, 0.1] {
                let ground = [z, -z].map(|z| {
                    let crust = belt(z, age, 1.0);
                    crust.ground(crust.relief(0.0), 0.0, 0.0)
                });
                assert!(ground[0] > 0.0 && ground[1] < 0.0, "{z} {ground:?}");
                // Half-way between land and sea of one height and depth.
                assert!((ground[0] + ground[1]).abs() < 0.3 * z, "{z} {ground:?}");
            }
        }
        let noisy = CrustSample {
            noise: 1.0,
            ..belt(-0.02, 300.0, 1.0)
        };
        assert!(noisy.ground(0.05, 0.0, 0.9) > 0.0 && noisy.ground(0.05, 0.0, -0.9) < -0.04);
    }

    fn belt(elevation: f32, age: f32, collision: f32) -> CrustSample {
        CrustSample {
            elevation,
            folded: 1.0,
            age,
            collision,
            ..CrustSample::default()
        }
    }

    #[test]
    fn belts_differ_by_kind_and_age() {
        let himalaya = belt(4.5, 10.0, 1.0).relief(0.0);
        let andes = belt(3.5, 10.0, 0.0).relief(0.0);
        let old = belt(1.0, 300.0, 1.0).relief(0.0);
        let plain = CrustSample {
            elevation: 0.2,
            ..CrustSample::default()
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
        let high = CrustSample {
            noise: 1.0,
            ..belt(4.5, 10.0, 1.0)
        };
        assert!(high.plateau(0.002, -0.1) > 0.9);
        assert_eq!(high.plateau(0.03, -0.1), 0.0);
        assert_eq!(high.plateau(0.002, 0.5), 0.0, "a range");
        assert_eq!(belt(0.5, 10.0, 1.0).plateau(0.0, 0.0), 0.0);
        assert!(belt(0.6, 400.0, 0.5).hills() > 0.9);
        assert!(belt(3.0, 5.0, 0.5).hills() < 0.1);
    }
}
