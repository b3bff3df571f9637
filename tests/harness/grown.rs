//! Planets that have grown and were amplified: their surface, their ground, sites of their relief.

use crate::shape::small;
use crate::world::{get, planet_app, steps, surface};
use bevy_pangaea::control::{PlanetBake, bake_now};
use bevy_pangaea::crust::Surface;
use bevy_pangaea::prelude::*;
use bevy_pangaea::query::{PlanetGround, Rules};
use bevy_pangaea::relief_stats::SiteInput;
use bevy_pangaea::sphere::SphereMesh;
use std::sync::Arc;

/// A grown planet.
pub struct GrownPlanet {
    /// Its samples.
    pub mesh: Arc<SphereMesh>,
    /// Its surface.
    pub surface: Arc<Surface>,
    /// Elevation of every sample in km.
    pub elevation: Vec<f32>,
    /// The ground that was amplified from it.
    pub ground: PlanetGround,
    seed: u64,
}

impl GrownPlanet {
    /// A small planet of a seed and so many samples after `count` steps.
    pub fn new(seed: u64, samples: u32, count: u64) -> Self {
        let (mut app, planet) = planet_app(&small(seed, samples));
        steps(&mut app, planet, count);
        let surface = surface(&mut app, planet);
        bake_now(app.world_mut(), planet).expect("a bake");
        let bake = &get::<PlanetBake>(&app, planet).0;
        Self {
            mesh: get::<Lattice>(&app, planet).0.clone(),
            elevation: (0..surface.len()).map(|i| surface.elevation(i)).collect(),
            ground: PlanetGround::of_bake(bake, Rules::default()).expect("a ground"),
            surface,
            seed,
        }
    }

    /// The planet as sites of classes are drawn on it.
    pub fn site_input(&self) -> SiteInput<'_> {
        SiteInput {
            mesh: &self.mesh,
            elevation: &self.elevation,
            orogeny: &self.surface.crust.orogeny,
            orogeny_age: &self.surface.crust.orogeny_age,
            seed: self.seed,
        }
    }
}
