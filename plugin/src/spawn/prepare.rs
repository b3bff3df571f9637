//! Caches of a new planet, found before the planet enters the world of its game: most of the time
//! that a planet takes to appear is spent here, and none of it needs that world.

use super::state::PlanetState;
use crate::authoring::{Inbox, Recording, Scenario};
use crate::climate::ClimateMaps;
use crate::crust::{Crust, Frames, Ledger, PlanetSurface};
use crate::hydrology::TerrainMaps;
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet, PlateNumbers};
use crate::plate::boundary::Rim;
use crate::plate::census::{TerraneCensus, recount_terranes};
use crate::plate::contact::Contacts;
use crate::plate::front::FrontField;
use crate::plate::overlap::OverlapIndex;
use crate::plate::polarity::PolarityMemory;
use crate::plate::{
    Plate, PlateOf, PlateRow, PlateStats, Plates, Terrane, TerraneOf, Terranes, caches, plate_table,
};
use crate::process::relief_noise::ReliefNoise;
use crate::resample::{Resampling, SurfaceProjection, project_now};
use crate::schedule::{StageTimings, StepCursor, TimeDebt};
use bevy::prelude::*;
use std::sync::Arc;

/// The state of a planet as components.
#[derive(Bundle)]
struct StateBundle {
    planet: Planet,
    lattice: Lattice,
    crust: Crust,
    frames: Frames,
    clock: GeologicClock,
    numbers: PlateNumbers,
    params: TectonicParams,
    ledger: Ledger,
    recording: Recording,
    polarity: PolarityMemory,
    fronts: FrontField,
    climate: ClimateMaps,
}

/// All that follows from the state or is worked on in time slices: never saved.
#[derive(Bundle, Default)]
struct CacheBundle {
    overlap: OverlapIndex,
    rim: Rim,
    contacts: Contacts,
    noise: ReliefNoise,
    terranes: TerraneCensus,
    resampling: Resampling,
    surface: PlanetSurface,
}

/// How far a planet has come in its step.
#[derive(Bundle, Default)]
struct ProgressBundle {
    cursor: StepCursor,
    timings: StageTimings,
    debt: TimeDebt,
}

/// A planet in a small world of its own, complete but for what belongs to its game.
pub(super) struct PreparedPlanet {
    world: World,
    planet: Entity,
    pending: Scenario,
    terrain: Option<TerrainMaps>,
}

impl PlanetState {
    /// Finds what follows from the state, and projects the surface.
    pub(super) fn prepare(self) -> PreparedPlanet {
        let state = StateBundle {
            planet: self.planet,
            lattice: self.lattice,
            crust: self.crust,
            frames: self.frames,
            clock: self.clock,
            numbers: self.numbers,
            params: self.params,
            ledger: self.ledger,
            recording: self.recording,
            polarity: self.polarity,
            fronts: self.fronts,
            climate: self.climate,
        };
        let (caches, progress) = (CacheBundle::default(), ProgressBundle::default());
        let mut world = World::new();
        let planet = world.spawn((state, caches, progress)).id();
        let mut plates = Vec::with_capacity(self.plates.len());
        for (id, motion, born) in self.plates {
            let unknown = PlateStats::default();
            let plate = (PlateOf(planet), Plate { born }, id, motion, unknown);
            plates.push(world.spawn(plate).id());
        }
        find_caches(&mut world, planet);
        // Plates that have no crust are gone by now.
        for (plate, stats) in plates.into_iter().zip(self.stats) {
            if let Ok(mut plate) = world.get_entity_mut(plate) {
                plate.insert(stats);
            }
        }
        PreparedPlanet {
            world,
            planet,
            pending: self.pending,
            terrain: self.terrain,
        }
    }
}

/// Finds what a planet derives from its state, after it was made or loaded, and projects its
/// surface.
fn find_caches(world: &mut World, planet: Entity) {
    caches::recompute_but_fronts(world, planet);
    caches::recompute_contacts(world, planet);
    recount_terranes(world, planet);
    project_now(world, planet);
}

impl PreparedPlanet {
    /// Gives the planet maps that replace fields of its climate.
    pub(super) fn set_climate(&mut self, maps: ClimateMaps) {
        self.world.entity_mut(self.planet).insert(maps);
    }

    /// Moves the planet onto an entity of another world, in place of the planet that it may have
    /// been. Returns whether the entity is there to take it.
    pub(super) fn insert(mut self, world: &mut World, planet: Entity) -> bool {
        let Ok(mut entity) = world.get_entity_mut(planet) else {
            return false;
        };
        let parts = self
            .world
            .entity_mut(self.planet)
            .take::<(StateBundle, CacheBundle)>();
        let Some((state, mut caches)) = parts else {
            return false;
        };
        // By the version of its surface, whoever looks at the planet sees that it is another one.
        let shown = entity
            .get::<PlanetSurface>()
            .map_or(0, |surface| surface.version);
        Arc::make_mut(&mut caches.surface.0).version += shown;
        entity.despawn_related::<Plates>();
        entity.insert((state, caches, ProgressBundle::default()));
        entity.insert_if_new((
            Name::new("planet"),
            Inbox::default(),
            SurfaceProjection::default(),
        ));
        match self.terrain {
            Some(maps) => entity.insert(maps),
            None => entity.remove::<TerrainMaps>(),
        };
        if !self.pending.0.is_empty() {
            entity.insert(self.pending);
        }
        for row in plate_table(&self.world, self.planet).rows() {
            spawn_plate(world, planet, row, terranes(&self.world, row.entity));
        }
        true
    }
}

fn terranes(world: &World, plate: Entity) -> Vec<Terrane> {
    world
        .get::<Terranes>(plate)
        .into_iter()
        .flat_map(|terranes| terranes.iter())
        .filter_map(|terrane| world.get(terrane).cloned())
        .collect()
}

fn spawn_plate(world: &mut World, planet: Entity, row: &PlateRow, terranes: Vec<Terrane>) {
    let name = Name::new(format!("plate {}", row.id.0));
    let born = Plate { born: row.born };
    let plate = (name, PlateOf(planet), born, row.id, row.motion, row.stats);
    let plate = world.spawn(plate).id();
    for terrane in terranes {
        world.spawn((TerraneOf(plate), terrane));
    }
}
