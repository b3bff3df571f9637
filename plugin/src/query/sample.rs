//! All there is to know of one point of the ground, and the normals that it takes.

use super::check::check_radius;
use super::error::GroundError;
use super::level::spacing;
use super::surface::{ClimateSample, GroundConditions, GroundSurface, classify};
use crate::math::{self, east_north};
use bevy::math::DVec3;
use bevy::reflect::Reflect;

/// The ground at one point.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct Sample {
    /// Height of the ground above sea level in m.
    pub height_m: f32,
    /// Level of the water in m; the height of the ground where it is dry.
    pub water_m: f32,
    /// Unit normal of the ground, in the planet's axes.
    pub normal: DVec3,
    /// Material of the ground.
    pub surface: GroundSurface,
}

impl Sample {
    /// The sample of known parts at the unit direction `up`.
    pub(super) fn new(
        up: DVec3,
        height_m: f32,
        water_m: f32,
        normal: DVec3,
        climate: ClimateSample,
    ) -> Self {
        let slope_deg = math::angle_between(up, normal).to_degrees() as f32;
        let surface = classify(&GroundConditions {
            height_m,
            water_m,
            slope_deg,
            climate,
        });
        Self {
            height_m,
            water_m,
            normal,
            surface,
        }
    }
}

/// The four points from whose heights a normal follows: one edge of a level to the east, west,
/// north and south.
pub(super) struct NormalStencil {
    up: DVec3,
    radius_m: f64,
    /// Unit directions of the points.
    pub(super) around: [DVec3; 4],
}

impl NormalStencil {
    /// The points around a unit direction.
    ///
    /// # Errors
    /// [`GroundError::Radius`].
    pub(super) fn new(up: DVec3, radius_m: f64, level: u8) -> Result<Self, GroundError> {
        check_radius(radius_m)?;
        let (east, north) = east_north(up);
        let step = spacing(radius_m, level) / radius_m;
        let sides = [east, -east, north, -north];
        Ok(Self {
            up,
            radius_m,
            around: sides.map(|side| (up + side * step).normalize()),
        })
    }

    /// Unit normal of the surface through the points, at their heights in m.
    pub(super) fn normal(&self, heights: [f32; 4]) -> DVec3 {
        let corner = |k: usize| self.around[k] * (self.radius_m + f64::from(heights[k]));
        // From west to east, and from south to north: their cross product points up.
        let normal = (corner(0) - corner(1)).cross(corner(2) - corner(3));
        normal.try_normalize().unwrap_or(self.up)
    }
}
