//! All fields of the climate, each from the model or from a user's map.

use super::field::ClimateField;
use super::map::EquirectMap;
use super::rain::rain;
use super::temperature::mean_temperature;
use super::wetness::{open_water_loss, potential_evaporation, runoff, wetness};
use super::wind::Winds;
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::prelude::*;
use bevy::reflect::{ReflectDeserialize, ReflectSerialize};
use core::ops::RangeInclusive;

/// Annual means at every vertex of a mesh.
#[derive(Clone, Debug, Default, PartialEq, Reflect)]
pub struct Climate {
    /// Temperature at the ground in °C.
    pub temperature: Vec<f32>,
    /// Rain and snow in mm per year.
    pub rain: Vec<f32>,
    /// Wetness W of paper 002 §3: 0 in deserts, 1 in rain forests.
    pub wetness: Vec<f32>,
    /// Part of the rain that runs off, in mm per year.
    pub runoff: Vec<f32>,
    /// Evaporation of a water surface less the rain on it, in mm per year; negative where lakes
    /// gain water.
    pub open_water_loss: Vec<f32>,
}

/// Maps that replace fields of the climate, but for their voids, where the field is the planet's
/// own: a component of the planet, and part of its state, so that a save holds them.
#[derive(
    Component, Clone, Debug, Default, PartialEq, Reflect, serde::Serialize, serde::Deserialize,
)]
#[reflect(Component, Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ClimateMaps {
    /// Temperature at the ground in °C, -150..=150.
    pub temperature: Option<EquirectMap>,
    /// Rain in mm per year, at least 0.
    pub rain: Option<EquirectMap>,
    /// Wetness W, 0..=1.
    pub wetness: Option<EquirectMap>,
}

/// Most rain of a map in mm per year that has an effect: with more, the discharge of the greatest
/// rivers would not fit into 64 bits on the largest planets.
const MAX_RAIN_MM: f32 = 30_000.0;

/// Elevation in km of vertices that were given none: sea.
const MISSING_ELEVATION_KM: f32 = -1.0;

impl Climate {
    /// The climate of a planet with elevations in km at the vertices of `mesh`, whose `winds` are
    /// known. Elevations beyond the mesh's vertices are ignored, missing ones are sea.
    ///
    /// ```
    /// use bevy_pangaea::climate::{Climate, ClimateMaps, Winds};
    /// use bevy_pangaea::sphere::SphereMesh;
    ///
    /// let mesh = SphereMesh::fibonacci(1000)?;
    /// let plain = vec![0.2; mesh.len()];
    /// let climate = Climate::new(&mesh, &Winds::new(&mesh), &plain, &ClimateMaps::default());
    ///
    /// let at = |p| mesh.nearest(p) as usize;
    /// let [equator, pole] = [at(bevy::math::DVec3::X), at(bevy::math::DVec3::Z)];
    /// assert!(climate.temperature[equator] > climate.temperature[pole] + 30.0);
    /// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
    /// ```
    pub fn new(mesh: &SphereMesh, winds: &Winds, elevation: &[f32], maps: &ClimateMaps) -> Self {
        let n = mesh.len();
        let mut height = elevation.to_vec();
        height.resize(n, MISSING_ELEVATION_KM);

        // Each field follows from those before it, given or not.
        let degrees = ClimateField::Temperature.range();
        let temperature = given_or(&maps.temperature, mesh, degrees, || {
            parallel::map(n, |i| mean_temperature(mesh.point(i).z, height[i as usize]))
        });
        let rain = given_or(&maps.rain, mesh, 0.0..=MAX_RAIN_MM, || {
            rain(mesh, winds, &temperature, &height)
        });
        let evaporation = parallel::map(n, |i| potential_evaporation(temperature[i as usize]));
        let wetness = given_or(&maps.wetness, mesh, ClimateField::Wetness.range(), || {
            by_vertex(wetness, &rain, &evaporation)
        });
        Self {
            temperature,
            wetness,
            runoff: by_vertex(runoff, &rain, &evaporation),
            open_water_loss: by_vertex(open_water_loss, &rain, &evaporation),
            rain,
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

/// A law of rain and potential evaporation at every vertex.
fn by_vertex(law: fn(f32, f32) -> f32, rain: &[f32], evaporation: &[f32]) -> Vec<f32> {
    parallel::map(rain.len(), |i| {
        law(rain[i as usize], evaporation[i as usize])
    })
}

/// A field at the vertices of a mesh: the values of a given map, clamped to a range, and the
/// planet's `own` where the map is void or not given.
fn given_or(
    map: &Option<EquirectMap>,
    mesh: &SphereMesh,
    range: RangeInclusive<f32>,
    own: impl FnOnce() -> Vec<f32>,
) -> Vec<f32> {
    let Some(map) = map else { return own() };
    // A whole map spares the work.
    let own = if map.voids() > 0 { own() } else { Vec::new() };
    let (low, high) = range.into_inner();
    parallel::map(mesh.len(), |i| match map.at(mesh.point(i)) {
        Some(value) => value.clamp(low, high),
        None => own[i as usize],
    })
}

#[cfg(test)]
#[path = "fields_tests.rs"]
mod tests;
