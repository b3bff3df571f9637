//! The panels, one file each. A panel reads the [`ShownView`](super::view::ShownView), keeps the
//! values that are being typed in a form of its own, and pushes wishes as an [`Action`].

pub mod cursor;
pub mod draft;
pub mod drag;
pub mod help;
pub mod legend;
pub mod messages;
pub mod overlays;
pub mod paint;
pub mod params;
pub mod planet;
pub mod plate;
pub mod status;
pub mod time;
pub mod timings;

use super::state::Action;
use bevy_pangaea::prelude::TectonicCommand;

/// The wishes of a frame.
#[derive(Default)]
pub struct Outbox(pub Vec<Action>);

impl Outbox {
    /// Asks for something.
    pub fn ask(&mut self, action: Action) {
        self.0.push(action);
    }

    /// Sends a command to the planet.
    pub fn command(&mut self, command: TectonicCommand) {
        self.ask(Action::Tectonic(command));
    }
}
