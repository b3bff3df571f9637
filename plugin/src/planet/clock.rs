//! Geological time: how much has passed, how fast it shall pass, and which plate numbers are used
//! up.

use crate::ids::PlateId;
use bevy::prelude::*;
use core::time::Duration;

/// Geological time of a planet: part of its state, written by the simulation alone.
///
/// How fast it passes is said by [`ClockControls`].
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn report(clocks: Query<&GeologicClock, With<Planet>>) {
///     for clock in &clocks {
///         info!("{} My, {} steps", clock.time, clock.step);
///     }
/// }
/// # bevy::ecs::system::assert_is_system(report);
/// ```
#[derive(
    Component, Clone, Debug, Default, PartialEq, Reflect, serde::Serialize, serde::Deserialize,
)]
#[serde(default)]
#[reflect(Component, Default, Serialize, Deserialize)]
pub struct GeologicClock {
    /// Time since the planet was made in My.
    pub time: f64,
    /// Steps taken.
    pub step: u64,
    /// Steps taken since the last resampling.
    pub since_resample: u32,
    /// Time of the last resampling in My.
    pub last_resample: f64,
    /// Whether a user wants a resampling at the next step.
    pub resample_requested: bool,
}

/// How a game lets time pass on a planet. Change it at any moment; it is no part of the state, and
/// no result depends on it.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// # use std::time::Duration;
/// fn hurry(mut planets: Query<&mut ClockControls>) {
///     for mut controls in &mut planets {
///         controls.speed = 40.0;
///         controls.until = Some(250.0);
///         controls.frame_budget = Duration::from_millis(4);
///     }
/// }
/// # bevy::ecs::system::assert_is_system(hurry);
/// ```
#[derive(Component, Clone, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
#[reflect(Component, Default, Serialize, Deserialize)]
pub struct ClockControls {
    /// Wanted speed in My per second of wall clock; the machine may be slower.
    pub speed: f64,
    /// Whether time stands still; single steps still run.
    pub paused: bool,
    /// Steps asked for while paused.
    pub single_steps: u32,
    /// Time in My at which the clock pauses by itself.
    pub until: Option<f64>,
    /// Longest that the simulation may hold one frame.
    pub frame_budget: Duration,
}

impl Default for ClockControls {
    fn default() -> Self {
        Self {
            speed: 10.0,
            paused: false,
            single_steps: 0,
            until: None,
            frame_budget: Duration::from_millis(8),
        }
    }
}

/// The numbers of plates that a planet has used up: no number is given twice.
#[derive(
    Component,
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    Reflect,
    serde::Serialize,
    serde::Deserialize,
)]
#[reflect(Component, Default, Serialize, Deserialize)]
pub struct PlateNumbers {
    /// The next free number.
    pub next: u32,
}

impl PlateNumbers {
    /// Takes the next free number.
    pub fn issue(&mut self) -> PlateId {
        let id = PlateId(self.next);
        self.next += 1;
        id
    }
}
