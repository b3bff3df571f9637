//! Building a planet in the background, on the entity that has a recipe.

use super::events::{PlanetFailed, PlanetReady};
use super::prepare::PreparedPlanet;
use super::state::PlanetState;
use crate::authoring::Inbox;
use crate::parallel;
use crate::planet::{PlanetError, PlanetRecipe};
use bevy::prelude::*;
use bevy::tasks::{AsyncComputeTaskPool, Task, TaskPool, futures::check_ready};

/// Builds a planet on every entity that gets a [`PlanetRecipe`].
///
/// The planet is built on [`AsyncComputeTaskPool`], by threads of its own for the parallel parts,
/// and put onto its entity in [`PreUpdate`], in the frame in which it is found ready.
pub struct SpawnPlugin;

impl Plugin for SpawnPlugin {
    fn build(&self, app: &mut App) {
        app.add_observer(start).add_systems(PreUpdate, finish);
    }
}

/// A planet that is being built. Removing it, or its entity, cancels the work.
#[derive(Component)]
pub struct PlanetTask(Task<Result<PreparedPlanet, PlanetError>>);

impl PlanetTask {
    fn start(recipe: PlanetRecipe) -> Self {
        let pool = AsyncComputeTaskPool::get_or_init(TaskPool::new);
        Self(pool.spawn(async move {
            parallel::in_background(|| PlanetState::new(&recipe).map(PlanetState::prepare))
        }))
    }
}

/// Starts to build what an inserted recipe describes. A task for an earlier recipe is cancelled;
/// commands may be sent at once, and wait for the planet.
fn start(event: On<Insert, PlanetRecipe>, recipes: Query<&PlanetRecipe>, mut commands: Commands) {
    if let Ok(recipe) = recipes.get(event.entity) {
        let task = PlanetTask::start(recipe.clone());
        commands
            .entity(event.entity)
            .insert(task)
            .insert_if_new(Inbox::default());
    }
}

/// Puts planets that are built onto their entities.
fn finish(mut tasks: Query<(Entity, &mut PlanetTask)>, mut commands: Commands) {
    for (planet, mut task) in &mut tasks {
        let Some(built) = check_ready(&mut task.0) else {
            continue;
        };
        commands.entity(planet).remove::<PlanetTask>();
        commands.queue(move |world: &mut World| match built {
            Ok(prepared) => take_over(world, planet, prepared),
            Err(error) => {
                error!("there is no planet of this recipe: {error}");
                world.trigger(PlanetFailed { planet, error });
            }
        });
    }
}

fn take_over(world: &mut World, planet: Entity, prepared: PreparedPlanet) {
    if prepared.insert(world, planet) {
        world.trigger(PlanetReady { planet });
    }
}
