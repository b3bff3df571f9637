//! Commands: all that a user may do to a planet, at any moment, recorded with their time.
//!
//! Player, modder, replay and test send the same commands in the same way. Commands wait in an
//! [`Inbox`] and take effect between two steps; a [`Recording`] of them, replayed on the same
//! recipe, gives the same bits.
//!
//! ```text
//! command    the commands
//! error      why one is refused
//! check      checks of a command that need no planet
//! change     the commands that lead from some parameters to others
//! events     a command took effect, or was refused
//! scenario   commands with their times
//! inbox      commands on their way
//! paint      brushes on the crust
//! apply      carrying commands out, between two steps
//! ```

pub mod command;

mod error;

mod check;

mod change;

mod events;

pub mod scenario;

mod inbox;

mod paint;

mod apply;

mod plugin;

pub use apply::{apply_now, apply_pending};
pub use command::{Brush, PaintTarget, TectonicCommand};
pub use error::CommandError;
pub use events::{CommandApplied, CommandRejected};
pub use inbox::{Inbox, TectonicCommandsExt};
pub use plugin::AuthoringPlugin;
pub use scenario::{Recording, Scenario, TimedCommand};
