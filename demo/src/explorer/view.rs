//! The planet on show, as panels and marks read it.

use super::state::ShownPlanet;
use bevy::ecs::system::SystemParam;
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::control::{Bake, PlanetBake};
use bevy_pangaea::overlay::OverlayInput;
use bevy_pangaea::plate::PlateTable;
use bevy_pangaea::plate::plate_table;
use bevy_pangaea::prelude::*;
use bevy_pangaea::schedule::StageTimings;
use bevy_pangaea::sphere::SphereMesh;
use bevy_pangaea::view::PlanetQuery;

/// The plates of the planet on show, in order of their numbers.
#[derive(Resource, Clone, Debug, Default)]
pub struct ShownPlates(pub PlateTable);

/// Lists the plates of the planet on show, once per frame.
pub fn list_plates(world: &mut World) {
    let shown = world.resource::<ShownPlanet>().0;
    let plates = shown.map(|planet| plate_table(world, planet));
    world.resource_mut::<ShownPlates>().0 = plates.unwrap_or_default();
}

/// The planet on show.
pub struct ShownView<'a> {
    /// The planet's entity.
    pub entity: Entity,
    /// Radius and seed.
    pub planet: &'a Planet,
    /// Samples.
    pub mesh: &'a SphereMesh,
    /// The surface as it is now.
    pub surface: &'a Surface,
    /// The clock.
    pub clock: &'a GeologicClock,
    /// How time passes.
    pub controls: &'a ClockControls,
    /// Parameters.
    pub params: &'a TectonicParams,
    /// Milliseconds per stage.
    pub timings: &'a StageTimings,
    /// Plates in order of their numbers.
    pub plates: &'a PlateTable,
    /// Climate and rivers, as they were when they were last made.
    pub bake: Option<&'a Bake>,
}

impl ShownView<'_> {
    /// The planet as overlays read it.
    pub fn overlay_input(&self) -> OverlayInput<'_> {
        OverlayInput {
            planet: self.planet,
            mesh: self.mesh,
            surface: self.surface,
            plates: self.plates,
            params: self.params,
            bake: self.bake,
        }
    }

    /// The plate at a unit direction.
    pub fn plate_at(&self, direction: DVec3) -> Option<PlateId> {
        let sample = self.mesh.nearest(direction) as usize;
        self.surface.plate.get(sample).copied()
    }
}

/// Reads the planet on show.
#[derive(SystemParam)]
pub struct PlanetReader<'w, 's> {
    shown: Res<'w, ShownPlanet>,
    plates: Res<'w, ShownPlates>,
    planets: Query<
        'w,
        's,
        (
            PlanetQuery,
            &'static PlanetSurface,
            &'static GeologicClock,
            &'static ClockControls,
            &'static StageTimings,
            Option<&'static PlanetBake>,
        ),
    >,
}

impl PlanetReader<'_, '_> {
    /// The planet on show, `None` before the first one is there.
    pub fn view(&self) -> Option<ShownView<'_>> {
        let entity = self.shown.0?;
        let (planet, surface, clock, controls, timings, bake) = self.planets.get(entity).ok()?;
        if surface.is_empty() {
            return None;
        }
        Some(ShownView {
            entity,
            planet: planet.planet,
            mesh: planet.lattice,
            surface,
            clock,
            controls,
            params: planet.params,
            timings,
            plates: &self.plates.0,
            bake: bake.map(|bake| &*bake.0),
        })
    }
}
