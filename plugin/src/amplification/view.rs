//! A camera that sees the ground.

use bevy::math::DVec3;
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use pangaea_shaders::gpu::GroundColours;
use std::sync::{Arc, Mutex, PoisonError};

/// Lets a camera see the ground of a planet: down to half a metre where the camera is near.
///
/// The planet needs a bake: give it [`BakeSettings`](crate::control::BakeSettings). Its
/// [`Globe`](crate::render::Globe) is not hidden; whoever adds this component to a camera that
/// comes near hides it.
#[derive(Component, Clone, Debug, PartialEq, Reflect)]
#[reflect(Component, Clone, Debug, PartialEq)]
#[require(GroundStatus)]
pub struct GroundView {
    /// The planet.
    pub planet: Entity,
    /// The camera's place in metres from the planet's centre, in the planet's axes. `None` takes it
    /// from the transforms, whose numbers of 32 bits hold half a metre on an Earth-sized planet.
    pub place: Option<DVec3>,
    /// Edges of triangles in pixels, 1..=64; longer where `leaves` allow no more of them.
    pub pixels: f32,
    /// Most leaves of the ground, 50,000..=4,000,000: they set how much memory of the GPU it takes,
    /// 260 bytes a leaf, and what the control mesh has.
    pub leaves: u32,
    /// Direction to the sun in the planet's axes, a unit vector.
    pub sun: DVec3,
    /// The meaning of the colours.
    #[reflect(ignore)]
    pub colours: GroundColours,
    /// Whether the triangles' edges are drawn.
    pub wireframe: bool,
}

impl GroundView {
    /// The ground of a planet in edges of 8 pixels, in the light of a forenoon.
    pub const fn of(planet: Entity) -> Self {
        Self {
            planet,
            place: None,
            pixels: 8.0,
            leaves: 2_500_000,
            sun: DVec3::new(0.0, 0.0, 1.0),
            colours: GroundColours::Natural,
            wireframe: false,
        }
    }
}

/// How far the ground of a camera is.
#[derive(Component, Clone, Debug, Default, PartialEq, Eq, Reflect)]
#[reflect(Component, Clone, Debug, PartialEq)]
pub enum GroundStatus {
    /// The planet's bake, or the shaders are not ready.
    #[default]
    Waiting,
    /// The ground of a view is drawn; runs so far.
    Drawn(u64),
    /// It cannot be drawn, and why.
    Failed(String),
}

/// Messages of the render world about cameras.
#[derive(Resource, Clone, Default)]
pub(super) struct Reports(Arc<Mutex<HashMap<Entity, GroundStatus>>>);

impl Reports {
    /// Says how far the ground of a camera is.
    pub(super) fn say(&self, camera: Entity, status: GroundStatus) {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        all.insert(camera, status);
    }

    /// All that was said since the last time.
    fn take(&self) -> HashMap<Entity, GroundStatus> {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        core::mem::take(&mut *all)
    }
}

/// Writes what the render world has said into the cameras.
pub(super) fn report(reports: Res<Reports>, mut cameras: Query<&mut GroundStatus>) {
    for (camera, said) in reports.take() {
        if let Ok(mut status) = cameras.get_mut(camera) {
            status.set_if_neq(said);
        }
    }
}
