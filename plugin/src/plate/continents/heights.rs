//! Elevation of the new planet: interior, coast, shelf, slope and rise, and old worn belts.
//!
//! Everything is a smooth function of the distance to the coast, so no margin is a cliff, whatever
//! the field's gradient at the coast.

use crate::math;
use crate::noise::Noise;
use crate::parallel::map_chunks;
use crate::planet::PlanetRecipe;
use crate::random::Purpose;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

/// Strength above which crust counts as folded.
pub(super) const FOLDED: f64 = 0.15;
/// Radius in km below which distances shrink with the planet.
const EARTH: f64 = 6370.0;
/// Lowest land in km.
const SHORE: f64 = 0.015;
/// Distance in km in which land rises to 63 % of its interior elevation.
const RISE: f64 = 350.0;
/// Depth of the outer edge of a shelf in km; 130 m on Earth.
const SHELF_DEPTH: f64 = 0.14;
/// Narrowest and widest shelf in km.
const SHELF: [f64; 2] = [25.0, 190.0];
/// Width of slope and rise together, relative to the parameter `margin_width`, which is that of the
/// rise.
const SLOPE: f64 = 2.0;
/// Distance of neighbours that a slope spans at least.
const SLOPE_SAMPLES: f64 = 5.5;
/// Height of old belts in km; that of the Urals or the Appalachians.
const BELT_HEIGHT: f64 = 0.75;
/// Half-width of old belts in km.
const BELT_WIDTH: f64 = 140.0;
/// Periods per rad of the noise whose zero lines the belts follow.
const BELT_FREQUENCY: f64 = 2.0;

/// A place in an old belt.
#[derive(Clone, Copy, Debug)]
pub(super) struct Belt {
    /// 1 on the axis of a belt, 0 outside.
    pub(super) strength: f64,
    /// Across the belt: the direction of compression, a unit tangent vector where there is a belt.
    pub(super) fold: DVec3,
    /// Time since it was folded in My.
    pub(super) age: f64,
    /// Whether it was folded by a collision, or else above a subduction zone.
    pub(super) collision: bool,
}

/// The functions of one planet.
pub(super) struct Heights {
    radius: f64,
    scale: f64,
    slope: f64,
    interior: Noise,
    shelf: Noise,
    belts: Noise,
    extent: Noise,
}

impl Heights {
    pub(super) fn new(recipe: &PlanetRecipe, mesh: &SphereMesh) -> Self {
        let noise = |id| Noise::new(recipe.seed, Purpose::Coast, id);
        let scale = (recipe.radius / EARTH).min(1.0);
        let resolved = SLOPE_SAMPLES * mesh.spacing() * recipe.radius;
        Self {
            radius: recipe.radius,
            scale,
            slope: (SLOPE * recipe.params.margin_width * scale).max(resolved),
            interior: noise(2),
            shelf: noise(3),
            belts: noise(4),
            extent: noise(5),
        }
    }

    /// Elevation of every sample in km. `coast` is the distance to the coast in rad, `floor` the
    /// elevation of the ocean floor far from land in km.
    pub(super) fn elevation(
        &self,
        mesh: &SphereMesh,
        land: &[bool],
        coast: &[f64],
        floor: &[f32],
    ) -> Vec<f32> {
        let parts = map_chunks(mesh.len(), |range| {
            let elevation = |i: usize| {
                let p = mesh.point(i as u32);
                let z = if land[i] {
                    self.land(p, coast[i])
                } else {
                    self.sea(p, coast[i], floor[i])
                };
                z as f32
            };
            range.map(elevation).collect::<Vec<_>>()
        });
        parts.concat()
    }

    fn land(&self, p: DVec3, coast: f64) -> f64 {
        let inland = 1.0 - math::exp(-coast * self.radius / (RISE * self.scale));
        let broad = math::smoothstep(0.5 + 0.8 * self.interior.fractal(p, 3.0, 3));
        let fine = self.interior.fractal(p, 14.0, 3);
        let plain = inland * (0.13 + 0.5 * broad + 0.14 * fine);
        let belt = self.belt(p, coast);
        (plain + BELT_HEIGHT * belt.strength * (1.0 + 0.5 * fine)).max(SHORE)
    }

    fn sea(&self, p: DVec3, coast: f64, floor: f32) -> f64 {
        let d = coast * self.radius;
        if d > SHELF[1] * self.scale + self.slope {
            return f64::from(floor);
        }
        let width = self.shelf_width(p);
        let shelf = -SHORE - (SHELF_DEPTH - SHORE) * (d / width).min(1.0);
        let fall = math::smoothstep((d - width) / self.slope);
        shelf + (f64::from(floor) - shelf) * fall
    }

    /// Width of the shelf off the coast near `p` in km.
    pub(super) fn shelf_width(&self, p: DVec3) -> f64 {
        let broad = math::smoothstep(0.5 + 1.2 * self.shelf.fractal(p, 3.0, 2));
        self.scale * (SHELF[0] + (SHELF[1] - SHELF[0]) * broad)
    }

    /// The old belt at `p`, `coast` rad from the coast.
    pub(super) fn belt(&self, p: DVec3, coast: f64) -> Belt {
        const STEP: f64 = 1e-3;
        let present = math::smoothstep(2.5 * self.extent.fractal(p, 1.7, 2) + 0.1);
        if present == 0.0 {
            return Belt {
                strength: 0.0,
                fold: DVec3::ZERO,
                age: 0.0,
                collision: false,
            };
        }
        let value = |q: DVec3| self.belts.fractal(q, BELT_FREQUENCY, 2);
        let east = math::any_tangent(p);
        let north = p.cross(east);
        let here = value(p);
        let along = |t: DVec3| t * ((value(p + t * STEP) - here) / STEP);
        let gradient = along(east) + along(north);
        let steepness = gradient.length();
        // Distance to the zero line to first order; where the noise is flat there is no line near.
        let distance = here.abs() / steepness.max(0.3) * self.radius / (BELT_WIDTH * self.scale);
        let inland = math::smoothstep(coast * self.radius / (250.0 * self.scale));
        let mask = self.extent.fractal(-p, 0.8, 2);
        Belt {
            strength: math::exp(-distance * distance) * present * (0.25 + 0.75 * inland),
            fold: gradient.normalize_or(east),
            age: 300.0 + 100.0 * (2.0 * mask).clamp(-1.0, 1.0),
            collision: self.extent.fractal(p, 0.9, 1) > -0.1,
        }
    }
}
