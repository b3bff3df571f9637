//! `commands.spawn_planet(recipe)`.

use crate::planet::PlanetRecipe;
use bevy::prelude::*;

/// `commands.spawn_planet(recipe)`.
pub trait SpawnPlanet {
    /// Spawns an entity on which the planet of `recipe` grows; the same as spawning the recipe
    /// with a [`Name`].
    ///
    /// ```
    /// # use bevy::prelude::*;
    /// # use bevy_pangaea::prelude::*;
    /// fn setup(mut commands: Commands) {
    ///     commands
    ///         .spawn_planet(PlanetRecipe { seed: 7, ..default() })
    ///         .insert(ClockControls { paused: true, ..default() })
    ///         .observe(|_: On<PlanetReady>| info!("it is there"));
    /// }
    /// # bevy::ecs::system::assert_is_system(setup);
    /// ```
    fn spawn_planet(&mut self, recipe: PlanetRecipe) -> EntityCommands<'_>;
}

impl SpawnPlanet for Commands<'_, '_> {
    fn spawn_planet(&mut self, recipe: PlanetRecipe) -> EntityCommands<'_> {
        self.spawn((Name::new("planet"), recipe))
    }
}
