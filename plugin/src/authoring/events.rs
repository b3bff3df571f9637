//! Events of commands, triggered on the planet's entity.

use super::command::TectonicCommand;
use super::error::CommandError;
use bevy::prelude::*;

/// A command took effect.
#[derive(EntityEvent, Clone, Debug)]
pub struct CommandApplied {
    /// The planet.
    #[event_target]
    pub planet: Entity,
    /// The command.
    pub command: TectonicCommand,
}

/// A command was refused; the planet is unchanged.
#[derive(EntityEvent, Clone, Debug)]
pub struct CommandRejected {
    /// The planet.
    #[event_target]
    pub planet: Entity,
    /// The command.
    pub command: TectonicCommand,
    /// Why.
    pub error: CommandError,
}
