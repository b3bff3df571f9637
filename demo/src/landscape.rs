//! The amplified ground as a picture.

use crate::offscreen::{Offscreen, OffscreenError};
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::amplification::{GroundColours, GroundStatus, GroundView};
use bevy_pangaea::control::PlanetBake;
use bevy_pangaea::overlay::Raster;
use bevy_pangaea::query::{Ground, PlanetGround, Rules};

/// Least height of a camera over the ground or the water, metres.
const LEAST_HEIGHT_M: f64 = 0.5;

/// Level of the ground that a camera may not stand in.
const FINEST: u8 = 17;

/// A camera over the ground.
pub struct Landscape {
    /// Its direction from the planet's centre.
    pub up: DVec3,
    /// Its place from there, metres.
    pub place: DVec3,
    /// Its height above the sea, metres.
    pub altitude_m: f64,
    /// Where the sun stands.
    pub sun: DVec3,
    /// Edges of triangles in pixels.
    pub pixels: f32,
    /// The meaning of the colours.
    pub colours: GroundColours,
    /// Whether the triangles' edges are drawn.
    pub wireframe: bool,
}

impl Landscape {
    /// The component of the camera that sees it.
    fn view(&self, planet: Entity) -> GroundView {
        GroundView {
            place: Some(self.place),
            pixels: self.pixels,
            sun: self.sun,
            colours: self.colours,
            wireframe: self.wireframe,
            ..GroundView::of(planet)
        }
    }

    /// Refuses a camera in the ground or under water.
    fn check(&self, bake: &PlanetBake) -> Result<(), OffscreenError> {
        let refused = |error: String| OffscreenError::Planet(error);
        let ground = PlanetGround::of_bake(&bake.0, Rules::default());
        let ground = ground.map_err(|error| refused(error.to_string()))?;
        let here = ground.sample(self.up, FINEST);
        let here = here.map_err(|error| refused(error.to_string()))?;
        let surface = f64::from(here.height_m.max(here.water_m));
        let least = surface + LEAST_HEIGHT_M;
        if self.altitude_m < least {
            return Err(refused(format!(
                "the ground under the camera is {surface:.1} m high, so its altitude must be \
                 {least:.1} at least"
            )));
        }
        Ok(())
    }
}

impl Offscreen {
    /// The ground as the camera at `view` sees it.
    ///
    /// # Errors
    /// As [`Offscreen::picture`]; [`OffscreenError::Planet`] for a camera in the ground, too.
    pub fn landscape(
        &mut self,
        view: Transform,
        landscape: &Landscape,
    ) -> Result<Raster, OffscreenError> {
        let planet = self.planet()?;
        self.bake(planet)?;
        let world = self.world();
        if let Some(bake) = world.get::<PlanetBake>(planet) {
            landscape.check(bake)?;
        }
        world.insert_resource(ClearColor(sky(landscape.altitude_m)));
        world.entity_mut(planet).insert(Visibility::Hidden);
        let ground = landscape.view(planet);
        let camera = self.look(view, ground);
        self.run(|world| match world.get::<GroundStatus>(camera) {
            Some(GroundStatus::Failed(reason)) => Err(OffscreenError::Renderer(reason.clone())),
            Some(GroundStatus::Drawn(_)) => Ok(true),
            _ => Ok(false),
        })?;
        self.read_back()
    }
}

/// The colour of the sky at an altitude in metres: blue by the ground, black in space.
pub fn sky(altitude_m: f64) -> Color {
    let air = (-altitude_m / 30_000.0).exp() as f32;
    LinearRgba::rgb(0.001, 0.0012, 0.003)
        .mix(&LinearRgba::rgb(0.36, 0.5, 0.72), air)
        .into()
}
