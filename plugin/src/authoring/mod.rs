//! What a user may do to a planet: commands in, at any moment, recorded with their time.
//!
//! Player, modder, replay and test use the same door. Commands wait in an [`Inbox`] and take effect
//! between two steps; a [`Recording`] of them, replayed on the same recipe, gives the same bits.

pub mod command;

mod error;

mod check;

mod events;

pub mod scenario;

mod paint;

mod apply;

mod plugin;

pub use apply::apply_pending;
pub use command::{Brush, PaintTarget, TectonicCommand};
pub use error::CommandError;
pub use events::{CommandApplied, CommandRejected};
pub use plugin::AuthoringPlugin;
pub use scenario::{Recording, Scenario, TimedCommand};

use bevy::prelude::*;

/// Commands that wait for the end of the present step, in order of arrival.
#[derive(Component, Clone, Debug, Default)]
pub struct Inbox(pub Vec<TectonicCommand>);

/// `commands.entity(planet).tectonic(command)`.
pub trait TectonicCommandsExt {
    /// Sends a command to the planet; it takes effect at the next step boundary.
    fn tectonic(&mut self, command: TectonicCommand) -> &mut Self;
}

impl TectonicCommandsExt for EntityCommands<'_> {
    fn tectonic(&mut self, command: TectonicCommand) -> &mut Self {
        self.entry::<Inbox>()
            .or_default()
            .and_modify(move |mut inbox| inbox.0.push(command));
        self
    }
}
