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
///
/// Played as a [`Scenario`] on the same recipe, it gives the same planet:
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// use bevy_pangaea::authoring::apply_now;
/// use bevy_pangaea::io::{capture, digest};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mut app = App::new();
/// app.add_plugins(PangaeaPlugins);
/// let world = app.world_mut();
/// let recipe = PlanetRecipe { samples: 500, ..default() };
/// let planet = PlanetState::new(&recipe)?.spawn(world);
/// run_steps(world, planet, 2);
/// apply_now(world, planet, &TectonicCommand::SetParam { name: "erosion".into(), value: 0.5 })?;
/// run_steps(world, planet, 2);
///
/// let mut replay = PlanetState::new(&recipe)?;
/// replay.pending = world.get::<Recording>(planet).cloned().unwrap_or_default().into();
/// let replay = replay.spawn(world);
/// run_steps(world, replay, 4);
/// let bits = |planet| capture(world, planet).map(|state| digest(&state));
/// assert_eq!(bits(planet), bits(replay));
/// # Ok(())
/// # }
/// ```
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
