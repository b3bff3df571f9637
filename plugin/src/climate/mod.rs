//! Climate: annual means of temperature, rain and wetness on a mesh with elevations.
//!
//! In: a [`SphereMesh`] and the elevation of its vertices. Out: [`Climate`]. Cheap, smooth and
//! deterministic; two seasons, no currents, no weather.
//!
//! ```text
//! map           equirectangular maps of a user, which replace any field
//! temperature   latitude and altitude
//! wind          the prevailing winds of six belts, and what lies upwind of each vertex
//! rain          moisture carried along the wind: distance to the sea, uplift, rain shadow
//! wetness       rain against what could evaporate; runoff
//! ```
//!
//! Lengths along the ground are those of an Earth-sized planet ([`EARTH_RADIUS`]): a small planet
//! has the same belts, deserts and shadows as a large one. Heights are true kilometres.
//!
//! Policies. *Sea* is what lies below 0, lakes included: they moisten the air as little as they
//! matter. *A field that a map gives* is used as it is, and the others follow from it: rain that is
//! given still makes wetness.

pub mod map;

pub mod temperature;

pub mod wind;

pub mod rain;

pub mod wetness;

pub use map::{EquirectMap, MapError};
pub use wind::Winds;

use crate::parallel;
use crate::sphere::SphereMesh;

/// Radius of the Earth in km, on which lengths of the model are given.
pub const EARTH_RADIUS: f64 = 6370.0;

/// Annual means at every vertex of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Climate {
    /// Temperature at the ground in °C.
    pub temperature: Vec<f32>,
    /// Rain and snow in mm per year.
    pub rain: Vec<f32>,
    /// Wetness W of paper 002: 0 in deserts, 1 in rain forests.
    pub wetness: Vec<f32>,
    /// What runs off of the rain, in mm per year.
    pub runoff: Vec<f32>,
    /// What a water surface loses to the air beyond the rain that it gets, in mm per year; negative
    /// where it gains.
    pub open_water_loss: Vec<f32>,
}

/// Maps that replace fields of the climate.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClimateMaps {
    /// Temperature at the ground in °C, -150..=150.
    pub temperature: Option<EquirectMap>,
    /// Rain in mm per year, at least 0.
    pub rain: Option<EquirectMap>,
    /// Wetness W, 0..=1.
    pub wetness: Option<EquirectMap>,
}

impl ClimateMaps {
    /// Refuses maps of what no climate is.
    ///
    /// # Errors
    /// [`MapError::Range`].
    pub fn check(&self) -> Result<(), MapError> {
        let Self {
            temperature,
            rain,
            wetness,
        } = self;
        let hot = -HOTTEST..=HOTTEST;
        EquirectMap::check(
            temperature.as_ref(),
            "the temperature",
            hot,
            "from -150 to 150 °C",
        )?;
        EquirectMap::check(
            rain.as_ref(),
            "the rain",
            0.0..=f32::INFINITY,
            "at least 0 mm per year",
        )?;
        EquirectMap::check(wetness.as_ref(), "the wetness", 0.0..=1.0, "from 0 to 1")
    }
}

/// Highest temperature of a map in °C, and its lowest below 0.
const HOTTEST: f32 = 150.0;

/// Most rain in mm per year that has an effect: more would not fit into the numbers of the greatest
/// rivers.
const WETTEST: f32 = 30_000.0;

impl Climate {
    /// The climate of a planet with elevations in km at the vertices of `mesh`, whose `winds` are
    /// known. Elevations beyond the mesh's vertices are ignored, missing ones are sea.
    pub fn new(mesh: &SphereMesh, winds: &Winds, elevation: &[f32], maps: &ClimateMaps) -> Self {
        let height = |i: u32| elevation.get(i as usize).copied().unwrap_or(-1.0);
        let given = |map: &Option<EquirectMap>, low: f32, high: f32| {
            map.as_ref()
                .map(|map| parallel::map(mesh.len(), |i| map.at(mesh.point(i)).clamp(low, high)))
        };
        let temperature = given(&maps.temperature, -HOTTEST, HOTTEST).unwrap_or_else(|| {
            parallel::map(mesh.len(), |i| {
                temperature::temperature(mesh.point(i).z, height(i))
            })
        });
        let rain = given(&maps.rain, 0.0, WETTEST)
            .unwrap_or_else(|| rain::rain(mesh, winds, &temperature, &height));
        let demand = |i: u32| wetness::evaporation(temperature[i as usize]);
        let wetness = given(&maps.wetness, 0.0, 1.0).unwrap_or_else(|| {
            parallel::map(mesh.len(), |i| {
                wetness::wetness(rain[i as usize], demand(i))
            })
        });
        let runoff = parallel::map(mesh.len(), |i| wetness::runoff(rain[i as usize], demand(i)));
        let open_water_loss = parallel::map(mesh.len(), |i| {
            wetness::OPEN_WATER * demand(i) - rain[i as usize]
        });
        Self {
            temperature,
            rain,
            wetness,
            runoff,
            open_water_loss,
        }
    }

    /// Number of vertices.
    pub fn len(&self) -> usize {
        self.rain.len()
    }

    /// Whether there are no vertices.
    pub fn is_empty(&self) -> bool {
        self.rain.is_empty()
    }
}

#[cfg(test)]
#[path = "climate_tests.rs"]
mod tests;
