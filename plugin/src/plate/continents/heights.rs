//! Elevation of the new planet: interior, coast, shelf, slope and rise.
//!
//! Everything is a smooth function of the distance to the coast, so no margin is a cliff, whatever
//! the field's gradient at the coast.

use super::belts::Belts;
use crate::math;
use crate::noise::Noise;
use crate::parallel;
use crate::planet::PlanetRecipe;
use crate::random::Purpose;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

/// Radius in km below which distances shrink with the planet: Earth's.
const EARTH_RADIUS_KM: f64 = 6370.0;

/// Least height of land above the sea, and least depth of the sea, in km, so that the coast stays
/// where the field has it.
const SHORE_KM: f64 = 0.015;

/// Distance from the coast in km in which land rises to 63 % of its interior elevation: coastal
/// plains are a few hundred km wide.
const RISE_LENGTH_KM: f64 = 350.0;

/// Depth of the outer edge of a shelf in km; 130 m on Earth.
const SHELF_DEPTH_KM: f64 = 0.14;

/// Narrowest and widest shelf in km; 75 km in the mean on Earth.
const SHELF_WIDTH_KM: [f64; 2] = [25.0, 190.0];

/// Width of slope and rise together, relative to the parameter `margin_width`, which is that of the
/// rise.
const SLOPE_PER_RISE: f64 = 2.0;

/// Distances of neighbours that a slope spans at least, so that no step between two of them is a
/// cliff.
const LEAST_SLOPE_SAMPLES: f64 = 5.5;

/// Height of old belts in km: that of the Urals or the Appalachians.
const BELT_HEIGHT_KM: f64 = 0.75;

/// The functions of one planet.
pub(super) struct Heights {
    /// Planet radius in km.
    radius: f64,
    /// Distances relative to those of Earth.
    scale: f64,
    /// Width of slope and rise in km.
    slope_km: f64,
    interior: Noise,
    shelf: Noise,
    pub(super) belts: Belts,
}

impl Heights {
    pub(super) fn new(recipe: &PlanetRecipe, mesh: &SphereMesh) -> Self {
        let noise = |id| Noise::new(recipe.seed, Purpose::Coast, id);
        let scale = (recipe.radius / EARTH_RADIUS_KM).min(1.0);
        let resolved = LEAST_SLOPE_SAMPLES * mesh.spacing() * recipe.radius;
        Self {
            radius: recipe.radius,
            scale,
            slope_km: (SLOPE_PER_RISE * recipe.params.margin_width * scale).max(resolved),
            interior: noise(2),
            shelf: noise(3),
            belts: Belts::new(recipe.radius, scale, noise(4), noise(5)),
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
        parallel::map(mesh.len(), |i| {
            let p = mesh.point(i);
            let i = i as usize;
            let z = if land[i] {
                self.land(p, coast[i])
            } else {
                self.sea(p, coast[i], floor[i])
            };
            z as f32
        })
    }

    /// Plains of 0.1 to 0.7 km that rise from the coast, and worn belts on them.
    fn land(&self, p: DVec3, coast: f64) -> f64 {
        let inland = 1.0 - math::exp(-coast * self.radius / (RISE_LENGTH_KM * self.scale));
        let broad = math::smoothstep(0.5 + 0.8 * self.interior.fractal(p, 3.0, 3));
        // Waves of 450 km on Earth over waves of 2,100 km.
        let fine = self.interior.fractal(p, 14.0, 3);
        let plain = inland * (0.13 + 0.5 * broad + 0.14 * fine);
        let belt = self.belts.at(p, coast);
        (plain + BELT_HEIGHT_KM * belt.strength * (1.0 + 0.5 * fine)).max(SHORE_KM)
    }

    /// A shelf that slopes gently to its edge, then a smooth fall to the ocean floor.
    fn sea(&self, p: DVec3, coast: f64, floor: f32) -> f64 {
        let d = coast * self.radius;
        // Most of the ocean is far away and saves the noise.
        if d > SHELF_WIDTH_KM[1] * self.scale + self.slope_km {
            return f64::from(floor);
        }
        let width = self.shelf_width(p);
        let shelf = -SHORE_KM - (SHELF_DEPTH_KM - SHORE_KM) * (d / width).min(1.0);
        let fall = math::smoothstep((d - width) / self.slope_km);
        shelf + (f64::from(floor) - shelf) * fall
    }

    /// Width of the shelf off the coast near `p` in km.
    pub(super) fn shelf_width(&self, p: DVec3) -> f64 {
        let [narrow, wide] = SHELF_WIDTH_KM;
        let broad = math::smoothstep(0.5 + 1.2 * self.shelf.fractal(p, 3.0, 2));
        self.scale * (narrow + (wide - narrow) * broad)
    }
}
