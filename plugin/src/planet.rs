//! A planet: the entity, its clock, and the recipe it is grown from.

use crate::params::{ParamError, TectonicParams};
use crate::sphere::{SphereError, SphereMesh};
use bevy::math::DVec3;
use bevy::prelude::*;
use core::time::Duration;
use std::sync::Arc;
use thiserror::Error;

/// A tectonic planet. Several may live in one world.
#[derive(Component, Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(Component)]
pub struct Planet {
    /// Radius R in km; 6370 in paper 000, Appendix A.
    pub radius: f64,
    /// Seed of everything random on the planet.
    pub seed: u64,
}

/// The samples of the sphere and their triangles, shared by everything that reads the planet.
#[derive(Component, Clone, Deref)]
pub struct Lattice(pub Arc<SphereMesh>);

/// Geological time and how fast it passes.
#[derive(Component, Clone, Debug, PartialEq, Reflect)]
#[reflect(Component)]
pub struct GeologicClock {
    /// Time since the planet was made in My.
    pub time: f64,
    /// Steps taken.
    pub step: u64,
    /// Steps taken since the last resampling.
    pub since_resample: u32,
    /// Time of the last resampling in My.
    pub last_resample: f64,
    /// Whether a user wants a resampling at the next step.
    pub resample_requested: bool,
    /// Next free number for a plate.
    pub next_plate: u32,
    /// Wanted speed in My per second of wall clock; the machine may be slower.
    pub speed: f64,
    /// Whether time stands still; single steps still run.
    pub paused: bool,
    /// Steps asked for while paused.
    pub single_steps: u32,
    /// Time in My at which the clock pauses by itself.
    pub until: Option<f64>,
    /// Longest that the simulation may hold one frame.
    pub frame_budget: Duration,
}

impl Default for GeologicClock {
    fn default() -> Self {
        Self {
            time: 0.0,
            step: 0,
            since_resample: 0,
            last_resample: 0.0,
            resample_requested: false,
            next_plate: 0,
            speed: 10.0,
            paused: false,
            single_steps: 0,
            until: None,
            frame_budget: Duration::from_millis(8),
        }
    }
}

/// The recipe of a planet, also the content of a `*.planet.ron` preset.
///
/// Fields that a preset leaves out have their defaults.
#[derive(Asset, Clone, Debug, PartialEq, TypePath, serde::Serialize, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PlanetRecipe {
    /// Seed of everything random.
    pub seed: u64,
    /// Number of samples, 100..=2,000,000.
    pub samples: u32,
    /// Radius in km, 50..=100,000.
    pub radius: f64,
    /// Number of initial plates, 2..=1000; replaced by `plates` where that is given.
    pub plate_count: u32,
    /// Share of land, 0..=0.9; replaced by the plates' and discs' crust where those are given.
    pub land: f64,
    /// Plates given one by one; empty for random ones.
    pub plates: Vec<PlateRecipe>,
    /// Continents given one by one, as discs with warped coasts; empty for random ones.
    pub continents: Vec<DiscRecipe>,
    /// Parameters of the model.
    pub params: TectonicParams,
}

impl Default for PlanetRecipe {
    fn default() -> Self {
        Self {
            seed: 1,
            samples: 60_000,
            radius: 6370.0,
            plate_count: 40,
            land: 0.3,
            plates: Vec::new(),
            continents: Vec::new(),
            params: TectonicParams::default(),
        }
    }
}

/// A plate of a preset.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlateRecipe {
    /// Latitude and longitude of the centroid in degrees.
    pub centroid: (f64, f64),
    /// Latitude and longitude of the pole of rotation in degrees; none for a random motion.
    #[serde(default)]
    pub pole: Option<(f64, f64)>,
    /// Speed at 90 degrees from the pole in km/My (mm/y); negative turns the other way.
    #[serde(default)]
    pub speed: f64,
}

/// A disc on the sphere.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DiscRecipe {
    /// Latitude and longitude of the centre in degrees.
    pub center: (f64, f64),
    /// Radius in km.
    pub radius: f64,
}

/// Why a planet cannot be made.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PlanetError {
    /// The samples or their triangulation are refused.
    #[error(transparent)]
    Sphere(#[from] SphereError),
    /// A parameter is refused.
    #[error(transparent)]
    Param(#[from] ParamError),
    /// A number of the recipe is outside of its limits.
    #[error("{field} = {} is outside of {min}..={max}", crate::params::shown(*value))]
    OutOfRange {
        /// The field of the recipe.
        field: &'static str,
        /// The refused value.
        value: f64,
        /// Smallest allowed value.
        min: f64,
        /// Largest allowed value.
        max: f64,
    },
    /// More plates than there can be with so few samples.
    #[error("{plates} plates need at least {needed} samples, not {samples}")]
    TooManyPlates {
        /// Plates asked for.
        plates: usize,
        /// Samples needed.
        needed: usize,
        /// Samples asked for.
        samples: u32,
    },
}

impl PlanetRecipe {
    /// Most plates that a recipe may ask for.
    pub const MAX_PLATES: usize = 1000;

    /// Checks every number.
    ///
    /// # Errors
    /// The first value outside of its limits.
    pub fn validate(&self) -> Result<(), PlanetError> {
        let within = |field, value: f64, min: f64, max: f64| {
            if value >= min && value <= max {
                Ok(())
            } else {
                Err(PlanetError::OutOfRange {
                    field,
                    value,
                    min,
                    max,
                })
            }
        };
        within("samples", f64::from(self.samples), 100.0, 2_000_000.0)?;
        within("radius", self.radius, 50.0, 100_000.0)?;
        within("land", self.land, 0.0, 0.9)?;
        let plates = if self.plates.is_empty() {
            self.plate_count as usize
        } else {
            self.plates.len()
        };
        within("plates", plates as f64, 2.0, Self::MAX_PLATES as f64)?;
        if plates * 10 > self.samples as usize {
            return Err(PlanetError::TooManyPlates {
                plates,
                needed: plates * 10,
                samples: self.samples,
            });
        }
        self.params.validate()?;
        for plate in &self.plates {
            within("plate latitude", plate.centroid.0, -90.0, 90.0)?;
            within("plate longitude", plate.centroid.1, -360.0, 360.0)?;
            within(
                "plate speed",
                plate.speed,
                -self.params.max_speed,
                self.params.max_speed,
            )?;
            if let Some((lat, lon)) = plate.pole {
                within("pole latitude", lat, -90.0, 90.0)?;
                within("pole longitude", lon, -360.0, 360.0)?;
            }
        }
        for disc in &self.continents {
            within("continent latitude", disc.center.0, -90.0, 90.0)?;
            within("continent longitude", disc.center.1, -360.0, 360.0)?;
            within("continent radius", disc.radius, 1.0, 20_000.0)?;
        }
        Ok(())
    }
}

impl DiscRecipe {
    /// Unit direction of the centre.
    pub fn direction(&self) -> DVec3 {
        crate::math::direction(self.center.0, self.center.1)
    }
}

/// Radius of a planet in km; that of the Earth for an entity without [`Planet`].
pub(crate) fn planet_radius(world: &World, planet: Entity) -> f64 {
    world
        .get::<Planet>(planet)
        .map_or(6370.0, |planet| planet.radius)
}
