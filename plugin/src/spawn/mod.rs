//! Making a planet: from a recipe or a save to an entity with plates.
//!
//! ```text
//! warnings   whatever a recipe asks for and its planet will not have
//! state      PlanetState: a planet before it is in a world
//! mapped     a planet of a user's maps, without a simulation
//! prepare    what follows from the state, found before the planet enters its world
//! events     PlanetReady, PlanetFailed
//! build      building a planet on an entity, at once or in the background
//! commands   commands.spawn_planet(recipe)
//! ```
//!
//! Games spawn a [`PlanetRecipe`](crate::planet::PlanetRecipe) and hear of [`PlanetReady`]. Tools
//! and tests, which would rather wait, use [`PlanetState::new`] and [`PlanetState::spawn`]. Both
//! ways give the same bits.

mod warnings;

mod state;

mod mapped;

mod events;

mod prepare;

mod build;

mod commands;

pub use build::{PlanetTask, SpawnPlugin};
pub use commands::SpawnPlanet;
pub use events::{PlanetFailed, PlanetReady};
pub use state::PlanetState;
pub use warnings::RecipeWarning;

#[cfg(test)]
mod tests;
