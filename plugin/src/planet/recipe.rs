//! Recipes: all that a planet is grown from.

use crate::params::{OutOfRange, ParamError, TectonicParams, within};
use crate::sphere::SphereError;
use bevy::asset::ReflectAsset;
use bevy::math::DVec3;
use bevy::prelude::*;
use thiserror::Error;

/// All that a planet is grown from. Spawn it, and the planet grows on the same entity.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn setup(mut commands: Commands) {
///     commands.spawn(PlanetRecipe { seed: 7, land: 0.4, ..default() });
/// }
/// # bevy::ecs::system::assert_is_system(setup);
/// ```
///
/// The planet is built in the background. [`PlanetReady`](crate::spawn::PlanetReady) is triggered
/// when it is there, [`PlanetFailed`](crate::spawn::PlanetFailed) when the recipe is refused.
/// Inserted again, a recipe grows its planet anew; the present one lives on until the new one is
/// ready. The component is immutable, since a planet that has grown does not change with its
/// recipe: its parameters are [`TectonicParams`] from then on, and what is done to it is its
/// [`Recording`](crate::authoring::Recording).
///
/// It is also the content of a `*.planet.ron` preset, in which fields that are left out have their
/// defaults, and an [`Asset`]: see [`PlanetPreset`](crate::io::PlanetPreset).
#[derive(
    Component, Asset, Clone, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize,
)]
#[serde(default, deny_unknown_fields)]
#[component(immutable)]
#[reflect(Component, Asset, Default, Serialize, Deserialize)]
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
    /// Small blocks of random continental crust besides the continents, from the size of Greenland
    /// down to that of New Zealand, 0..=200; they share the same part of the land, however many.
    pub islands: u32,
    /// Strength of the noise of coasts relative to the Earth's, 0..=2: at 0 continents are rounded
    /// discs.
    pub coast_roughness: f64,
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
            islands: 14,
            coast_roughness: 1.0,
            plates: Vec::new(),
            continents: Vec::new(),
            params: TectonicParams::default(),
        }
    }
}

/// A plate of a preset.
///
/// ```
/// use bevy_pangaea::prelude::*;
///
/// // Two hemispheres that part along the meridian of Greenwich.
/// let plate = |lon: f64, speed| PlateRecipe {
///     centroid: (0.0, lon),
///     pole: Some((90.0, 0.0)),
///     speed,
/// };
/// let plates = vec![plate(-90.0, -30.0), plate(90.0, 30.0)];
/// let recipe = PlanetRecipe { plates, samples: 500, ..Default::default() };
/// assert_eq!(PlanetState::new(&recipe)?.plates.len(), 2);
/// # Ok::<(), PlanetError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[reflect(Default, Serialize, Deserialize)]
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
///
/// ```
/// use bevy_pangaea::prelude::*;
///
/// // One continent about the north pole; the rest is sea.
/// let continents = vec![DiscRecipe { center: (90.0, 0.0), radius: 3000.0 }];
/// let recipe = PlanetRecipe { continents, samples: 2000, ..Default::default() };
/// let state = PlanetState::new(&recipe)?;
/// let is_land = |lat: f64| {
///     let sample = state.lattice.nearest(bevy_pangaea::math::direction(lat, 0.0));
///     state.crust.elevation[sample as usize] > 0.0
/// };
/// assert!(is_land(90.0) && !is_land(-90.0));
/// # Ok::<(), PlanetError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[reflect(Serialize, Deserialize)]
pub struct DiscRecipe {
    /// Latitude and longitude of the centre in degrees.
    pub center: (f64, f64),
    /// Radius in km.
    pub radius: f64,
}

/// Why a planet cannot be made.
///
/// ```
/// use bevy_pangaea::prelude::*;
///
/// let recipe = PlanetRecipe { land: 2.0, ..Default::default() };
/// let refused = recipe.validate().unwrap_err();
/// assert_eq!(refused.to_string(), "land = 2 is outside of 0..=0.9");
/// ```
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PlanetError {
    /// The samples or their triangulation are refused.
    #[error(transparent)]
    Sphere(#[from] SphereError),
    /// A parameter is refused.
    #[error(transparent)]
    Param(#[from] ParamError),
    /// A number of the recipe is outside of its limits.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
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
        within("samples", f64::from(self.samples), 100.0, 2_000_000.0)?;
        within("radius", self.radius, 50.0, 100_000.0)?;
        within("land", self.land, 0.0, 0.9)?;
        within("islands", f64::from(self.islands), 0.0, 200.0)?;
        within("coast_roughness", self.coast_roughness, 0.0, 2.0)?;
        self.check_plate_count()?;
        self.params.validate()?;
        self.plates
            .iter()
            .try_for_each(|plate| plate.check(self.params.max_speed))?;
        self.continents.iter().try_for_each(DiscRecipe::check)
    }

    /// A plate needs ten samples to have an inside and a border.
    fn check_plate_count(&self) -> Result<(), PlanetError> {
        let plates = if self.plates.is_empty() {
            self.plate_count as usize
        } else {
            self.plates.len()
        };
        within("plates", plates as f64, 2.0, Self::MAX_PLATES as f64)?;
        let needed = plates * 10;
        if needed > self.samples as usize {
            return Err(PlanetError::TooManyPlates {
                plates,
                needed,
                samples: self.samples,
            });
        }
        Ok(())
    }
}

impl PlateRecipe {
    fn check(&self, max_speed: f64) -> Result<(), PlanetError> {
        within("plate latitude", self.centroid.0, -90.0, 90.0)?;
        within("plate longitude", self.centroid.1, -360.0, 360.0)?;
        within("plate speed", self.speed, -max_speed, max_speed)?;
        if let Some((lat, lon)) = self.pole {
            within("pole latitude", lat, -90.0, 90.0)?;
            within("pole longitude", lon, -360.0, 360.0)?;
        }
        Ok(())
    }
}

impl DiscRecipe {
    fn check(&self) -> Result<(), PlanetError> {
        within("continent latitude", self.center.0, -90.0, 90.0)?;
        within("continent longitude", self.center.1, -360.0, 360.0)?;
        Ok(within("continent radius", self.radius, 1.0, 20_000.0)?)
    }

    /// Unit direction of the centre.
    pub fn direction(&self) -> DVec3 {
        crate::math::direction(self.center.0, self.center.1)
    }
}
