//! Events of commands, triggered on the planet's entity.

use super::command::TectonicCommand;
use super::error::CommandError;
use bevy::prelude::*;

/// A command took effect.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn log(event: On<CommandApplied>) {
///     info!("done: {:?}", event.command);
/// }
/// # App::new().add_observer(log);
/// ```
#[derive(EntityEvent, Clone, Debug, PartialEq, Reflect)]
#[reflect(Event)]
pub struct CommandApplied {
    /// The planet.
    #[event_target]
    pub planet: Entity,
    /// The command.
    pub command: TectonicCommand,
}

/// A command was refused; the planet is unchanged. An entity that is no planet refuses all.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn complain(event: On<CommandRejected>) {
///     warn!("{:?} is refused: {}", event.command, event.error);
/// }
/// # App::new().add_observer(complain);
/// ```
#[derive(EntityEvent, Clone, Debug, PartialEq)]
pub struct CommandRejected {
    /// The entity that the command was sent to.
    #[event_target]
    pub planet: Entity,
    /// The command.
    pub command: TectonicCommand,
    /// Why it was refused.
    pub error: CommandError,
}
