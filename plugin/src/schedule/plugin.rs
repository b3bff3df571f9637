//! The chain of sets and gates that makes the schedule.

use super::cursor::StepCursor;
use super::runner::{AdvancePlanets, run_planets};
use super::stage::{
    BetweenSteps, BetweenStepsSystems, CurrentPlanet, TectonicStep, TectonicSystems,
};
use super::timings::StageTimings;
use bevy::ecs::intern::Interned;
use bevy::ecs::schedule::{LogLevel, ScheduleBuildSettings, ScheduleLabel, SingleThreadedExecutor};
use bevy::prelude::*;

/// The order of stages as a plugin: schedules, sets and gates, without any process.
///
/// Planets advance in [`Update`], or in the schedule that is given:
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// let mut app = App::new();
/// app.add_plugins(PangaeaPlugins.set(TectonicSchedulePlugin::new(FixedUpdate)));
/// ```
pub struct TectonicSchedulePlugin {
    /// The schedule in which planets advance, within [`AdvancePlanets`].
    pub schedule: Interned<dyn ScheduleLabel>,
}

impl TectonicSchedulePlugin {
    /// Advances planets in `schedule`. Time passes on them as it does there: by the resource
    /// [`Time`], which is that of the fixed steps in [`FixedUpdate`].
    pub fn new(schedule: impl ScheduleLabel) -> Self {
        Self {
            schedule: schedule.intern(),
        }
    }
}

impl Default for TectonicSchedulePlugin {
    fn default() -> Self {
        Self::new(Update)
    }
}

impl Plugin for TectonicSchedulePlugin {
    fn build(&self, app: &mut App) {
        app.add_schedule(step_schedule())
            .init_schedule(BetweenSteps)
            .configure_sets(
                BetweenSteps,
                (BetweenStepsSystems::Commands, BetweenStepsSystems::Caches).chain(),
            )
            .add_systems(self.schedule, run_planets.in_set(AdvancePlanets));
    }
}

/// One chain: for every position of the cursor its set, then the system that moves the cursor on.
fn step_schedule() -> Schedule {
    let mut schedule = Schedule::new(TectonicStep);
    schedule
        .set_executor(SingleThreadedExecutor::new())
        .set_build_settings(ScheduleBuildSettings {
            ambiguity_detection: LogLevel::Error,
            ..default()
        });
    for position in 0..TectonicSystems::COUNT {
        let set = TectonicSystems::at(position);
        schedule.configure_sets(set.run_if(enters(position)));
        if position > 0 {
            schedule.configure_sets(Leave(position - 1).before(set));
        }
        schedule.configure_sets(Leave(position).after(set));
        // A stage that holds leaves too, for its timing; it just does not move on.
        schedule.add_systems(leave.in_set(Leave(position)).run_if(reaches(position)));
    }
    schedule
}

#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Leave(usize);

/// Whether the planet's cursor is at `position` and has time.
fn enters(position: usize) -> impl Fn(Res<CurrentPlanet>, Query<&StepCursor>) -> bool + Clone {
    move |current: Res<CurrentPlanet>, cursors: Query<&StepCursor>| {
        cursors
            .get(current.0)
            .is_ok_and(|cursor| cursor.position == position && !cursor.held)
    }
}

/// Whether the planet's cursor is at `position`.
fn reaches(position: usize) -> impl Fn(Res<CurrentPlanet>, Query<&StepCursor>) -> bool + Clone {
    move |current: Res<CurrentPlanet>, cursors: Query<&StepCursor>| {
        cursors
            .get(current.0)
            .is_ok_and(|cursor| cursor.position == position)
    }
}

/// Moves the cursor on, unless the stage holds.
fn leave(current: Res<CurrentPlanet>, mut planets: Query<(&mut StepCursor, &mut StageTimings)>) {
    if let Ok((mut cursor, mut timings)) = planets.get_mut(current.0) {
        cursor.leave(&mut timings);
    }
}
