//! Scenarios: lists of commands with their times, and the recording of what was done.

use super::command::TectonicCommand;
use bevy::prelude::*;

/// A command with the time at which it took effect, or shall.
#[derive(Clone, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TimedCommand {
    /// Number of steps that the planet has taken before.
    pub step: u64,
    /// The command.
    pub command: TectonicCommand,
}

/// The commands that were carried out on a planet since it was made, in order.
#[derive(
    Component, Clone, Debug, Default, PartialEq, Reflect, serde::Serialize, serde::Deserialize,
)]
#[reflect(Component, Default, Serialize, Deserialize)]
pub struct Recording(pub Vec<TimedCommand>);

/// Commands to come, the content of a `*.scenario.ron` file. Insert it on a planet to play it.
///
/// ```
/// use bevy_pangaea::prelude::*;
///
/// let tired = TectonicCommand::SetProcess { name: "rifting".into(), on: false };
/// let mut scenario = Scenario(vec![TimedCommand { step: 40, command: tired.clone() }]);
/// assert!(scenario.take_due(39).is_empty());
/// assert_eq!(scenario.take_due(40), [tired]);
/// ```
#[derive(
    Component, Clone, Debug, Default, PartialEq, Reflect, serde::Serialize, serde::Deserialize,
)]
#[reflect(Component, Default, Serialize, Deserialize)]
pub struct Scenario(pub Vec<TimedCommand>);

impl Scenario {
    /// Takes the commands that are due once `step` steps have been taken, in order of time, then of
    /// the list.
    pub fn take_due(&mut self, step: u64) -> Vec<TectonicCommand> {
        let (mut due, rest): (Vec<_>, Vec<_>) =
            self.0.drain(..).partition(|timed| timed.step <= step);
        self.0 = rest;
        due.sort_by_key(|timed| timed.step);
        due.into_iter().map(|timed| timed.command).collect()
    }
}

impl From<Recording> for Scenario {
    fn from(recording: Recording) -> Self {
        Self(recording.0)
    }
}
