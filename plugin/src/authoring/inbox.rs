//! Commands on their way to a planet.

use super::command::TectonicCommand;
use super::error::CommandError;
use super::events::CommandRejected;
use super::scenario::Recording;
use bevy::prelude::*;

/// Commands that wait for the end of the present step, or for their planet to be built, in order of
/// arrival.
#[derive(Component, Clone, Debug, Default, PartialEq, Reflect)]
#[require(Recording)]
#[reflect(Component, Default)]
pub struct Inbox(pub Vec<TectonicCommand>);

/// `commands.entity(planet).tectonic(command)`.
pub trait TectonicCommandsExt {
    /// Sends a command to the planet; it takes effect at the next step boundary.
    ///
    /// An entity without a planet or a recipe refuses it with
    /// [`CommandRejected`] and a warning.
    ///
    /// ```
    /// # use bevy::prelude::*;
    /// # use bevy_pangaea::prelude::*;
    /// fn flood(mut commands: Commands, planet: Single<Entity, With<Planet>>) {
    ///     let lower = TectonicCommand::PaintCrust {
    ///         target: PaintTarget::Disc { center: (10.0, 20.0), radius: 800.0 },
    ///         brush: Brush::Raise(-0.5),
    ///     };
    ///     commands.entity(*planet).tectonic(lower).tectonic(TectonicCommand::Resample);
    /// }
    /// # bevy::ecs::system::assert_is_system(flood);
    /// ```
    fn tectonic(&mut self, command: TectonicCommand) -> &mut Self;
}

impl TectonicCommandsExt for EntityCommands<'_> {
    fn tectonic(&mut self, command: TectonicCommand) -> &mut Self {
        self.queue(
            move |mut entity: EntityWorldMut| match entity.get_mut::<Inbox>() {
                Some(mut inbox) => inbox.0.push(command),
                None => refuse(entity, command),
            },
        )
    }
}

fn refuse(entity: EntityWorldMut, command: TectonicCommand) {
    let planet = entity.id();
    let error = CommandError::NoPlanet;
    warn!("{planet} refuses a command: {error}");
    entity.into_world_mut().trigger(CommandRejected {
        planet,
        command,
        error,
    });
}

#[cfg(test)]
#[path = "inbox_tests.rs"]
mod tests;
