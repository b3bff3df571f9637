//! Events of making a planet, triggered on its entity.

use crate::planet::PlanetError;
use bevy::prelude::*;

/// A planet is there: its components are on the entity, its plates are spawned.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn greet(event: On<PlanetReady>, planets: Query<&Plates>) -> Result {
///     info!("a planet of {} plates", planets.get(event.planet)?.iter().count());
///     Ok(())
/// }
/// # App::new().add_observer(greet);
/// ```
#[derive(EntityEvent, Clone, Debug, PartialEq, Eq, Reflect)]
#[reflect(Event)]
pub struct PlanetReady {
    /// The planet.
    #[event_target]
    pub planet: Entity,
}

/// A recipe is refused. It stays on the entity, which is no planet, or still the planet that it
/// was.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn explain(event: On<PlanetFailed>) {
///     warn!("there will be no planet: {}", event.error);
/// }
/// # App::new().add_observer(explain);
/// ```
#[derive(EntityEvent, Clone, Debug, PartialEq)]
pub struct PlanetFailed {
    /// The entity with the recipe.
    #[event_target]
    pub planet: Entity,
    /// Which value is refused, and why.
    pub error: PlanetError,
}
