//! "Continentality": how far in rad a sample lies inside the continents' lobes, with fractal noise.
//!
//! The coast is a level line of this field. A lobe's noise is limited by its radius, so that a
//! small island is rough but not blown away; short wavelengths are strong in some regions and weak
//! in others, so that there are smooth coasts and broken ones.

use super::lobes::{Continents, Lobe};
use crate::math;
use crate::noise::Noise;
use crate::parallel::map_chunks;
use crate::planet::PlanetRecipe;
use crate::random::Purpose;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

/// Most octaves of the coast.
const MAX_OCTAVES: usize = 9;
/// Periods per rad of the first octave: 4,000 km on Earth.
const FREQUENCY: f64 = 1.6;
/// Amplitude of the first octave in rad.
const AMPLITUDE: f64 = 0.40;
/// Amplitude of an octave relative to the one before.
const PERSISTENCE: f64 = 0.58;
/// Largest amplitude of an octave relative to the radius of a lobe.
const SHARE_OF_RADIUS: f64 = 0.8;
/// Noise of a given disc relative to that of a random lobe: its maker wants it where it was put.
const GIVEN_NOISE: f64 = 0.8;
/// Octaves that suffice far from the coast.
const COARSE: usize = 4;
/// Depth in rad of what is far from the coast: more than the finer octaves ever add.
const FAR: f64 = 0.15;
/// Samples that the size of the lobes is fitted on.
const FIT_SAMPLES: usize = 4096;

/// The noise of the coast at one sample, by octave.
struct Ripple {
    /// Sum of the first k octaves, each with amplitude 1.
    plain: [f64; MAX_OCTAVES + 1],
    /// Sum of the octaves from k on, each with its own amplitude.
    scaled: [f64; MAX_OCTAVES + 1],
}

/// Makes the noise of the coast.
struct Coast {
    noise: Noise,
    roughness: Noise,
    octaves: usize,
}

impl Coast {
    fn new(recipe: &PlanetRecipe, mesh: &SphereMesh) -> Self {
        let resolved = |&o: &usize| FREQUENCY * f64::from(1_u32 << o) <= 0.4 / mesh.spacing();
        Self {
            noise: Noise::new(recipe.seed, Purpose::Coast, 0),
            roughness: Noise::new(recipe.seed, Purpose::Coast, 1),
            octaves: (0..MAX_OCTAVES).take_while(resolved).count(),
        }
    }

    /// The first `count` octaves at `p`.
    fn ripple(&self, p: DVec3, count: usize) -> Ripple {
        let rough = 0.35 + 1.1 * math::smoothstep(0.5 + 1.3 * self.roughness.fractal(p, 2.2, 2));
        let mut ripple = Ripple {
            plain: [0.0; MAX_OCTAVES + 1],
            scaled: [0.0; MAX_OCTAVES + 1],
        };
        let mut octaves = [0.0; MAX_OCTAVES];
        for (o, value) in octaves.iter_mut().enumerate().take(count.min(self.octaves)) {
            let q = p * (FREQUENCY * f64::from(1_u32 << o)) + DVec3::splat(17.3 * (o + 1) as f64);
            *value = self.noise.octave(q) * if o < 2 { 1.0 } else { rough };
        }
        for o in 0..MAX_OCTAVES {
            ripple.plain[o + 1] = ripple.plain[o] + octaves[o];
            let k = MAX_OCTAVES - 1 - o;
            ripple.scaled[k] = ripple.scaled[k + 1] + amplitude(k) * octaves[k];
        }
        ripple
    }
}

fn amplitude(octave: usize) -> f64 {
    (0..octave).fold(AMPLITUDE, |a, _| a * PERSISTENCE)
}

/// A lobe, ready to be evaluated.
struct Disc {
    center: DVec3,
    radius: f64,
    /// Largest amplitude of an octave, and the number of octaves that it limits.
    limit: f64,
    limited: usize,
    /// Factor of all noise.
    noise: f64,
    /// Width over which the lobe melts into others.
    melt: f64,
}

impl Disc {
    fn new(lobe: &Lobe, scale: f64, noise: f64) -> Self {
        let radius = lobe.radius * scale;
        let limit = SHARE_OF_RADIUS * radius;
        let limited = (0..MAX_OCTAVES)
            .take_while(|&o| amplitude(o) > limit)
            .count();
        Self {
            center: lobe.center,
            radius,
            limit,
            limited,
            noise,
            melt: (0.5 * radius).min(0.08),
        }
    }

    fn depth(&self, p: DVec3, ripple: &Ripple) -> f64 {
        let noise = self.limit * ripple.plain[self.limited] + ripple.scaled[self.limited];
        self.radius - arc((p - self.center).length()) + self.noise * noise
    }
}

/// Angle in rad that belongs to a chord: within 1 % up to 128 degrees, 14 % too small for opposite
/// points.
pub(super) fn arc(chord: f64) -> f64 {
    let x = 0.25 * chord * chord;
    chord * (1.0 + x * (1.0 / 6.0 + x * (3.0 / 40.0 + x * (5.0 / 112.0 + x * 0.06))))
}

/// Greatest depth in any of the discs, rounded off where two are equal.
fn depth(discs: &[Disc], p: DVec3, ripple: &Ripple) -> f64 {
    let join = |deepest: f64, disc: &Disc| {
        let depth = disc.depth(p, ripple);
        let near = (disc.melt - (deepest - depth).abs()).max(0.0);
        deepest.max(depth) + near * near / (4.0 * disc.melt)
    };
    discs.iter().fold(-math::PI, join)
}

/// The field of every sample, in rad. Land is where it exceeds a level near 0.
pub(super) fn continentality(
    recipe: &PlanetRecipe,
    mesh: &SphereMesh,
    continents: &Continents,
) -> Vec<f64> {
    let coast = Coast::new(recipe, mesh);
    let (scale, noise) = if recipe.continents.is_empty() {
        (fit(recipe, mesh, continents, &coast), 1.0)
    } else {
        (1.0, GIVEN_NOISE)
    };
    let disc = |lobe: &Lobe| Disc::new(lobe, scale, noise);
    let discs: Vec<_> = continents.lobes.iter().map(disc).collect();
    let parts = map_chunks(mesh.len(), |range| {
        let field = |i: usize| {
            let p = mesh.point(i as u32);
            let coarse = depth(&discs, p, &coast.ripple(p, COARSE));
            // Far from every coast finer octaves do not matter.
            if coarse.abs() > FAR {
                coarse
            } else {
                depth(&discs, p, &coast.ripple(p, MAX_OCTAVES))
            }
        };
        range.map(field).collect::<Vec<_>>()
    });
    parts.concat()
}

/// The factor of the lobes' radii that gives about the wanted share of land.
fn fit(recipe: &PlanetRecipe, mesh: &SphereMesh, continents: &Continents, coast: &Coast) -> f64 {
    let stride = mesh.len().div_ceil(FIT_SAMPLES);
    let points: Vec<_> = mesh
        .points()
        .iter()
        .step_by(stride)
        .map(|&p| (p, coast.ripple(p, COARSE)))
        .collect();
    let wanted = (recipe.land * points.len() as f64) as usize;
    let (mut low, mut high) = (0.1, 6.0);
    for _ in 0..16 {
        let scale = 0.5 * (low + high);
        let disc = |lobe: &Lobe| Disc::new(lobe, scale, 1.0);
        let discs: Vec<_> = continents.lobes.iter().map(disc).collect();
        let land = points
            .iter()
            .filter(|(p, ripple)| depth(&discs, *p, ripple) > 0.0)
            .count();
        *if land < wanted { &mut low } else { &mut high } = scale;
    }
    0.5 * (low + high)
}
