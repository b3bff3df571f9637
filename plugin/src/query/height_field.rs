//! Heights that a user gives at a place, over those of a planet (paper 002 §8, "prescription of
//! height fields at user-specified locations").
//!
//! In the field the ground has the field's height, from the middle of the field out to its rim,
//! where it passes smoothly into the planet's. Levels that are finer than the field's pixels lay
//! their own roughness upon it: what the planet's ground has there beyond the level of the pixels.

use super::check::{check_length, check_position, checked};
use super::error::GroundError;
use super::ground::{Ground, check_same_length};
use super::level::level_for;
use super::projection::AzimuthalEquidistant;
use super::raster::HeightGrid;
use super::surface::ClimateSample;
use crate::math;
use bevy::math::{DVec2, DVec3};

/// Most height in m that roughness of finer levels adds or takes.
const ROUGHNESS_M: f64 = 1000.0;

/// Heights at a place, north up.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightField {
    about: AzimuthalEquidistant,
    grid: HeightGrid,
    rim_m: f64,
}

impl HeightField {
    /// A field of heights above sea level in m about the middle of a projection. Within `rim_m` of
    /// its sides, at most half of the shorter one, it blends into the ground around it.
    ///
    /// # Errors
    /// [`GroundError::Unavailable`] if a height is infinite or NaN, or if there is not one for each
    /// pixel; [`GroundError::Length`] for a rim that is too wide.
    pub fn new(
        about: AzimuthalEquidistant,
        grid: HeightGrid,
        rim_m: f64,
    ) -> Result<Self, GroundError> {
        let refuse = |reason: &str| Err(GroundError::Unavailable(reason.into()));
        if grid.values.is_empty() || grid.values.len() != grid.width * grid.height {
            return refuse("a height field needs one height for each pixel");
        }
        if grid.values.iter().any(|z| !z.is_finite()) {
            return refuse("a height of the field is not a number");
        }
        let field = Self { about, grid, rim_m };
        let half = field.half();
        check_position(half.extend(0.0))?;
        check_length(
            "the rim of the height field",
            rim_m,
            [0.0, half.min_element()],
        )?;
        Ok(field)
    }

    /// Half its sides in m.
    fn half(&self) -> DVec2 {
        let [across, down] = self.grid.pixel_m;
        0.5 * DVec2::new(
            across * self.grid.width as f64,
            down * self.grid.height as f64,
        )
    }

    /// The level whose edges are as long as its pixels: coarser ones show the field, finer ones add
    /// to it.
    fn level(&self) -> u8 {
        let [across, down] = self.grid.pixel_m;
        level_for(self.about.radius_m(), across.min(down))
    }

    /// Height of the field in m at a unit direction, and how much it counts there, 0..=1; `None`
    /// outside of it.
    fn at(&self, direction: DVec3) -> Option<(f64, f64)> {
        // Behind the horizon of its middle no place lies in it, and the plane's is far away.
        let place = self.about.plane(direction);
        let inside = (self.half() - place.abs()).min_element();
        if inside <= 0.0 {
            return None;
        }
        let weight = math::smoothstep(inside / self.rim_m.max(f64::MIN_POSITIVE));
        Some((self.interpolated(place), weight))
    }

    /// Height in m at a place, between the centres of pixels; beyond the outer ones theirs.
    fn interpolated(&self, place: DVec2) -> f64 {
        let [across, down] = self.grid.pixel_m;
        let half = self.half();
        let x = cell((place.x + half.x) / across, self.grid.width);
        let y = cell((half.y - place.y) / down, self.grid.height);
        let value = |column: usize, row: usize| f64::from(self.grid.row(row)[column]);
        let row = |row: usize| value(x.0, row) + x.2 * (value(x.1, row) - value(x.0, row));
        row(y.0) + y.2 * (row(y.1) - row(y.0))
    }
}

/// The pixels on both sides of a place that is given in pixels, and the share of the second.
fn cell(pixels: f64, count: usize) -> (usize, usize, f64) {
    let place = (pixels - 0.5).clamp(0.0, count as f64 - 1.0);
    let first = place.floor();
    let next = (first as usize + 1).min(count - 1);
    (first as usize, next, place - first)
}

/// A ground with a height field in it. Of several, the one laid on last lies on top.
///
/// Rivers and lakes rise and sink with their ground; where the field lies below sea level there is
/// sea.
///
/// ```
/// use bevy_pangaea::query::{
///     AzimuthalEquidistant, FieldGround, Ground, HeightField, HeightGrid, PlanetGround, Rules,
/// };
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let planet = PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default())?;
/// // A table of 8 km, 500 m high, with a rim of 1 km.
/// let grid = HeightGrid { width: 8, height: 8, values: vec![500.0; 64], pixel_m: [1000.0; 2] };
/// let about = AzimuthalEquidistant::new(30.0, -12.0, 6_370_000.0)?;
/// let ground = FieldGround::new(planet.clone(), HeightField::new(about, grid, 1000.0)?);
/// assert_eq!(ground.height(about.centre(), 3)?, 500.0);
/// assert_eq!(ground.height(-about.centre(), 3)?, planet.height(-about.centre(), 3)?);
/// # Ok::<(), bevy_pangaea::query::GroundError>(())
/// ```
#[derive(Clone, Debug)]
pub struct FieldGround<G> {
    ground: G,
    field: HeightField,
}

impl<G: Ground> FieldGround<G> {
    /// Lays a field upon a ground.
    pub fn new(ground: G, field: HeightField) -> Self {
        Self { ground, field }
    }
}

impl<G: Ground> Ground for FieldGround<G> {
    fn radius_m(&self) -> f64 {
        self.ground.radius_m()
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let mut height = [0.0];
        self.heights(&[direction], level, &mut height)?;
        Ok(height[0])
    }

    fn heights(
        &self,
        directions: &[DVec3],
        level: u8,
        heights: &mut [f32],
    ) -> Result<(), GroundError> {
        check_same_length(directions, heights)?;
        self.ground.heights(directions, level, heights)?;
        let (mut places, mut inside) = (Vec::new(), Vec::new());
        for (i, direction) in directions.iter().enumerate() {
            let unit = checked(*direction, level)?;
            if let Some(given) = self.field.at(unit) {
                places.push((i, given));
                inside.push(unit);
            }
        }
        let mut coarse = vec![0.0; inside.len()];
        let field_level = self.field.level().min(level);
        self.ground.heights(&inside, field_level, &mut coarse)?;
        for (&(i, given), &coarse) in places.iter().zip(&coarse) {
            heights[i] = blended(given, heights[i], heights[i] - coarse);
        }
        Ok(())
    }

    fn water(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let own = self.ground.height(direction, level)?;
        let water = self.ground.water(direction, level)?;
        let height = self.height(direction, level)?;
        // The sea keeps its level, other water its depth.
        let depth = if water > 0.0 { water - own } else { 0.0 };
        let given = height + depth.max(0.0);
        Ok(if height == own { water } else { given.max(0.0) })
    }

    fn climate(&self, direction: DVec3, height_m: f32) -> Result<ClimateSample, GroundError> {
        self.ground.climate(direction, height_m)
    }

    fn bounds_m(&self) -> [f64; 2] {
        let [low, high] = self.ground.bounds_m();
        let [least, most] = self.field.grid.range().unwrap_or([0.0; 2]).map(f64::from);
        [low.min(least - ROUGHNESS_M), high.max(most + ROUGHNESS_M)]
    }
}

/// Height in m where a field has a height that counts so much, the ground alone has `own` at a
/// level, and `rough` of it beyond the level of the field.
fn blended((height, weight): (f64, f64), own: f32, rough: f32) -> f32 {
    let given = height + f64::from(rough);
    (f64::from(own) + weight * (given - f64::from(own))) as f32
}

#[cfg(test)]
#[path = "height_field_tests.rs"]
mod tests;
