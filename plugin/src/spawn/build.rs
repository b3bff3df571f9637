//! Building a planet on an entity: at once from a state, in the background from a recipe.

use super::events::{PlanetFailed, PlanetReady};
use super::prepare::PreparedPlanet;
use super::state::PlanetState;
use crate::authoring::Inbox;
use crate::background::{BackgroundJob, BackgroundPool};
use crate::climate::ClimateMaps;
use crate::planet::{PlanetError, PlanetRecipe};
use bevy::prelude::*;

impl PlanetState {
    /// Puts the planet into a world. Returns its entity.
    pub fn spawn(self, world: &mut World) -> Entity {
        let planet = world.spawn_empty().id();
        self.insert(world, planet);
        planet
    }

    /// Puts the planet onto an entity, in place of the planet that it may have been; what does not
    /// belong to its state stays as it is: the clock's controls, the inbox, how it is drawn. Where
    /// a task is building another planet on that entity, it is cancelled. Then [`PlanetReady`] is
    /// triggered.
    ///
    /// Nothing happens if the entity is gone.
    pub fn insert(self, world: &mut World, planet: Entity) {
        let Ok(mut entity) = world.get_entity_mut(planet) else {
            return;
        };
        entity.remove::<PlanetTask>();
        enter(world, planet, self.prepare());
    }
}

/// Builds a planet on every entity that gets a [`PlanetRecipe`]. Where there are [`ClimateMaps`] on
/// it already, they are those of the planet.
///
/// The planet is built by threads that no frame waits for, half as many as the machine has, and put
/// onto its entity in [`PreUpdate`], in the frame in which it is found ready.
pub struct SpawnPlugin;

impl Plugin for SpawnPlugin {
    fn build(&self, app: &mut App) {
        app.add_observer(start).add_systems(PreUpdate, finish);
    }
}

/// A planet that is being built. Removing it, or its entity, cancels the work.
#[derive(Component)]
pub struct PlanetTask(BackgroundJob<Result<PreparedPlanet, PlanetError>>);

impl PlanetTask {
    fn start(recipe: PlanetRecipe) -> Self {
        static POOL: BackgroundPool = BackgroundPool::new("planet", |cores| cores.div_ceil(2));
        Self(POOL.start(move || PlanetState::new(&recipe).map(PlanetState::prepare)))
    }
}

/// Starts to build what an inserted recipe describes. A task for an earlier recipe is cancelled;
/// commands may be sent at once, and wait for the planet.
fn start(event: On<Insert, PlanetRecipe>, recipes: Query<&PlanetRecipe>, mut commands: Commands) {
    if let Ok(recipe) = recipes.get(event.entity) {
        for warning in recipe.warnings() {
            warn!("{warning}");
        }
        let task = PlanetTask::start(recipe.clone());
        commands
            .entity(event.entity)
            .insert(task)
            .insert_if_new(Inbox::default());
    }
}

/// Puts planets that are built onto their entities.
fn finish(world: &mut World, tasks: &mut QueryState<(Entity, &PlanetTask)>) {
    // One after the other: whoever hears that a planet is there may start to build others.
    while let Some((planet, built)) = next_built(world, tasks) {
        world.entity_mut(planet).remove::<PlanetTask>();
        match built {
            Ok(mut prepared) => {
                // A recipe says nothing of maps: those that the game gave stay.
                if let Some(maps) = world.get::<ClimateMaps>(planet) {
                    prepared.set_climate(maps.clone());
                }
                enter(world, planet, prepared);
            }
            Err(error) => {
                error!("there is no planet of this recipe: {error}");
                world.trigger(PlanetFailed { planet, error });
            }
        }
    }
}

fn next_built(
    world: &World,
    tasks: &mut QueryState<(Entity, &PlanetTask)>,
) -> Option<(Entity, Result<PreparedPlanet, PlanetError>)> {
    tasks
        .iter(world)
        .find_map(|(planet, task)| Some((planet, task.0.take()?)))
}

fn enter(world: &mut World, planet: Entity, prepared: PreparedPlanet) {
    if prepared.insert(world, planet) {
        world.trigger(PlanetReady { planet });
    }
}
