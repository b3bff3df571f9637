//! "Continentality": how far in rad a sample lies inside the continents' lobes, with fractal noise.
//!
//! The coast is a level line of this field. A lobe's noise is limited by its radius, so that a
//! small island is rough but not blown away; short wavelengths are strong in some regions and weak
//! in others, so that there are smooth coasts and broken ones.

use super::lobes::{Continents, Lobe};
use crate::math;
use crate::noise::{Noise, octave_position};
use crate::parallel;
use crate::planet::PlanetRecipe;
use crate::random::Purpose;
use crate::sphere::{SphereMesh, angle_of_long_chord};
use bevy::math::DVec3;

/// Most octaves of the coast: the ninth has a wavelength of 16 km on Earth.
const MAX_OCTAVES: usize = 9;

/// Periods of the finest octave per spacing of the samples. Finer ones would only make specks.
const PERIODS_PER_SAMPLE: f64 = 0.4;

/// Periods per rad of the first octave: 4,000 km on Earth.
const FREQUENCY: f64 = 1.6;

/// Amplitude of the first octave in rad: 2,500 km on Earth.
const AMPLITUDE: f64 = 0.40;

/// Amplitude of an octave relative to the one before. 0.5 would give every wavelength the same
/// slopes; coasts are a little rougher than that.
const PERSISTENCE: f64 = 0.58;

/// Octaves that are equally strong on all coasts; finer ones are strong on broken coasts only.
const REGULAR_OCTAVES: usize = 2;

/// Largest amplitude of an octave relative to the radius of a lobe.
const SHARE_OF_RADIUS: f64 = 0.8;

/// Noise of a given disc relative to that of a random lobe: a disc that is given should stay
/// recognisable.
const GIVEN_NOISE: f64 = 0.8;

/// Octaves that suffice far from the coast.
const COARSE_OCTAVES: usize = 4;

/// Depth in rad, inwards or outwards, beyond which a sample counts as far from every coast: more
/// than the finer octaves ever add.
const FAR_FROM_COAST: f64 = 0.15;

/// Width in rad over which large lobes are rounded into each other.
const ROUNDING: f64 = 0.08;

/// Samples that the size of the lobes is fitted on. They meet the share of land roughly; the level
/// of the field meets it exactly.
const FIT_SAMPLES: usize = 4096;

/// Bisections of the fit: to a ten-thousandth of the radius.
const FIT_ROUNDS: usize = 16;

/// The noise of the coast at one sample, by octave.
struct OctaveSums {
    /// Sum of the first k octaves, each with amplitude 1.
    plain: [f64; MAX_OCTAVES + 1],
    /// Sum of the octaves from k on, each with its own amplitude.
    scaled: [f64; MAX_OCTAVES + 1],
}

impl OctaveSums {
    fn new(octaves: &[f64; MAX_OCTAVES]) -> Self {
        let mut sums = Self {
            plain: [0.0; MAX_OCTAVES + 1],
            scaled: [0.0; MAX_OCTAVES + 1],
        };
        // Sums from both ends, so that each disc can cut the octaves at its own place.
        for (o, octave) in octaves.iter().enumerate() {
            sums.plain[o + 1] = sums.plain[o] + octave;
        }
        for (o, octave) in octaves.iter().enumerate().rev() {
            sums.scaled[o] = sums.scaled[o + 1] + amplitude(o) * octave;
        }
        sums
    }
}

fn amplitude(octave: usize) -> f64 {
    (0..octave).fold(AMPLITUDE, |a, _| a * PERSISTENCE)
}

/// Makes the noise of the coast.
struct CoastNoise {
    noise: Noise,
    roughness: Noise,
    octaves: usize,
}

impl CoastNoise {
    fn new(recipe: &PlanetRecipe, mesh: &SphereMesh) -> Self {
        let finest = PERIODS_PER_SAMPLE / mesh.spacing();
        let resolved = |&o: &usize| FREQUENCY * f64::from(1_u32 << o) <= finest;
        Self {
            noise: Noise::new(recipe.seed, Purpose::Coast, 0),
            roughness: Noise::new(recipe.seed, Purpose::Coast, 1),
            octaves: (0..MAX_OCTAVES).take_while(resolved).count(),
        }
    }

    /// The first `count` octaves at `p`.
    fn at(&self, p: DVec3, count: usize) -> OctaveSums {
        // From 0.35 on smooth coasts to 1.45 on broken ones.
        let rough = 0.35 + 1.1 * math::smoothstep(0.5 + 1.3 * self.roughness.fractal(p, 2.2, 2));
        let mut octaves = [0.0; MAX_OCTAVES];
        for (o, value) in octaves.iter_mut().enumerate().take(count.min(self.octaves)) {
            let q = octave_position(p, FREQUENCY * f64::from(1_u32 << o), o as u32);
            *value = self.noise.octave(q) * if o < REGULAR_OCTAVES { 1.0 } else { rough };
        }
        OctaveSums::new(&octaves)
    }
}

/// A lobe, ready to be evaluated.
struct Disc {
    center: DVec3,
    radius: f64,
    /// Largest amplitude of an octave.
    limit: f64,
    /// Number of octaves that the limit cuts.
    limited: usize,
    /// Factor of all noise.
    noise: f64,
    /// Width over which the lobe is rounded into others.
    rounding: f64,
}

impl Disc {
    fn new(lobe: &Lobe, scale: f64, noise: f64) -> Self {
        let radius = lobe.radius * scale;
        let limit = SHARE_OF_RADIUS * radius;
        let cut = (0..MAX_OCTAVES).take_while(|&o| amplitude(o) > limit);
        Self {
            center: lobe.center,
            radius,
            limit,
            limited: cut.count(),
            noise,
            rounding: (0.5 * radius).min(ROUNDING),
        }
    }

    fn depth(&self, p: DVec3, coast: &OctaveSums) -> f64 {
        // Octaves that are too strong for this disc have its limit as amplitude, the others their
        // own.
        let noise = self.limit * coast.plain[self.limited] + coast.scaled[self.limited];
        self.radius - angle_of_long_chord((p - self.center).length()) + self.noise * noise
    }
}

fn discs(continents: &Continents, scale: f64, noise: f64) -> Vec<Disc> {
    let lobes = continents.lobes.iter();
    lobes.map(|lobe| Disc::new(lobe, scale, noise)).collect()
}

/// Greatest depth in any of the discs.
fn depth(discs: &[Disc], p: DVec3, coast: &OctaveSums) -> f64 {
    // No point lies farther outside than π.
    discs.iter().fold(-math::PI, |deepest, disc| {
        rounded_max(deepest, disc.depth(p, coast), disc.rounding)
    })
}

/// The greater of two values, rounded off where they differ by less than `width`: discs that touch
/// grow together instead of meeting in a notch.
fn rounded_max(a: f64, b: f64, width: f64) -> f64 {
    let near = (width - (a - b).abs()).max(0.0);
    // Smooth at both ends of `width`, and a quarter of it more where both are equal.
    a.max(b) + near * near / (4.0 * width)
}

/// The field of every sample, in rad. Land is where it exceeds a level near 0.
pub(super) fn continentality(
    recipe: &PlanetRecipe,
    mesh: &SphereMesh,
    continents: &Continents,
) -> Vec<f64> {
    let coast = CoastNoise::new(recipe, mesh);
    let roughness = recipe.coast_roughness;
    let discs = if recipe.continents.is_empty() {
        let scale = fitted_scale(recipe, mesh, continents, &coast);
        discs(continents, scale, roughness)
    } else {
        discs(continents, 1.0, GIVEN_NOISE * roughness)
    };
    let far_from_coast = FAR_FROM_COAST * roughness.max(1.0);
    parallel::map(mesh.len(), |i| {
        let p = mesh.point(i);
        let coarse = depth(&discs, p, &coast.at(p, COARSE_OCTAVES));
        // Far from every coast finer octaves do not matter.
        if coarse.abs() > far_from_coast {
            coarse
        } else {
            depth(&discs, p, &coast.at(p, MAX_OCTAVES))
        }
    })
}

/// The factor of the lobes' radii that gives about the wanted share of land.
fn fitted_scale(
    recipe: &PlanetRecipe,
    mesh: &SphereMesh,
    continents: &Continents,
    coast: &CoastNoise,
) -> f64 {
    let stride = mesh.len().div_ceil(FIT_SAMPLES);
    let samples = mesh.points().iter().step_by(stride);
    let points: Vec<_> = samples.map(|&p| (p, coast.at(p, COARSE_OCTAVES))).collect();
    let wanted = (recipe.land * points.len() as f64) as usize;
    let mut low = 0.1;
    let mut high = 6.0;
    // Land grows with the scale, so bisection finds it.
    for _ in 0..FIT_ROUNDS {
        let scale = 0.5 * (low + high);
        let discs = discs(continents, scale, recipe.coast_roughness);
        let is_land = |(p, coast): &&(DVec3, OctaveSums)| depth(&discs, *p, coast) > 0.0;
        if points.iter().filter(is_land).count() < wanted {
            low = scale;
        } else {
            high = scale;
        }
    }
    0.5 * (low + high)
}
