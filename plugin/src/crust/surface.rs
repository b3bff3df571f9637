//! The surface of the planet as it is now, at every sample of the lattice.
//!
//! Globe, maps, statistics, bakes and the resample all read this one projection of the frames, so a
//! resample is invisible: it makes the surface of that moment the new state.

use super::columns::Crust;
use crate::ids::PlateId;
use crate::sphere::{Location, SphereMesh};
use bevy::math::DVec3;
use bevy::prelude::*;
use std::sync::Arc;

/// How a point of the surface is covered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Reflect)]
#[repr(u8)]
pub enum Cover {
    /// One frame covers it.
    #[default]
    One = 0,
    /// Several frames cover it; the stored crust is that of the one on top.
    Several = 1,
    /// No frame covers it, and its plates diverge: provisional ridge crust.
    Ridge = 2,
    /// No frame covers it, and its plates do not diverge: filled from its neighbours.
    Filled = 3,
}

/// The last projection of a planet. Who reads it on another thread clones the pointer: a projection
/// is never changed, the next one takes its place.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// /// The elevation in km at a place.
/// fn look(planets: Query<(&PlanetSurface, &Lattice)>) {
///     let here = bevy_pangaea::math::direction(48.0, 11.0);
///     for (surface, lattice) in planets.iter().filter(|(surface, _)| !surface.is_empty()) {
///         info!("{:.2} km", surface.at(lattice, here).elevation);
///     }
/// }
/// # bevy::ecs::system::assert_is_system(look);
/// ```
#[derive(Component, Clone, Debug, Default, Deref)]
pub struct PlanetSurface(pub Arc<Surface>);

/// The projected surface. Vectors and positions are in world coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Geological time of the projection in My.
    pub time: f64,
    /// Counts projections: a change means that pictures are out of date.
    pub version: u64,
    /// The crust at every sample. Its `frame` column is the frame on top (the nearest for new
    /// crust).
    pub crust: Crust,
    /// The plate at every sample.
    pub plate: Vec<PlateId>,
    /// How each sample is covered.
    pub cover: Vec<Cover>,
    /// Bend of the subducting crust towards the trench in km, not positive. Never part of the
    /// state.
    pub trench: Vec<f32>,
}

/// The surface at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The nearest sample, from which categories are taken.
    pub sample: u32,
    /// Elevation in km, trench included.
    pub elevation: f32,
    /// Thickness in km.
    pub thickness: f32,
    /// Age of the ocean floor in My.
    pub ocean_age: f32,
    /// Time since the last folding in My.
    pub orogeny_age: f32,
}

impl Surface {
    /// Number of samples.
    pub fn len(&self) -> usize {
        self.plate.len()
    }

    /// Whether nothing was projected yet.
    pub fn is_empty(&self) -> bool {
        self.plate.is_empty()
    }

    /// Elevation of sample `i` in km, trench included.
    #[inline]
    pub fn elevation(&self, i: usize) -> f32 {
        self.crust.elevation[i] + self.trench[i]
    }

    /// The surface at the unit direction `p`: values are interpolated, categories nearest.
    pub fn at(&self, mesh: &SphereMesh, p: DVec3) -> SurfacePoint {
        let at = mesh.locate(p);
        SurfacePoint {
            sample: at.nearest,
            elevation: interpolated(&at, |i| self.elevation(i)),
            thickness: interpolated(&at, |i| self.crust.thickness[i]),
            ocean_age: interpolated(&at, |i| self.crust.ocean_age[i]),
            orogeny_age: interpolated(&at, |i| self.crust.orogeny_age[i]),
        }
    }
}

/// The barycentric mean of a column.
fn interpolated(at: &Location, column: impl Fn(usize) -> f32) -> f32 {
    let corner = |k: usize| at.weights[k] * f64::from(column(at.vertices[k] as usize));
    (corner(0) + corner(1) + corner(2)) as f32
}
