//! The schedule of one tectonic step, and the runner that spreads it over frames.
//!
//! A step is a walk through the [`Stage`]s. A slice of it ends where its time is up: between two
//! stages, or within a long one that asks for another slice with [`StepCursor::hold`]. The runner
//! runs [`TectonicStep`] again and again until the frame's budget is spent, and each run goes on
//! where the last one stopped. Without a budget a single run is a whole step.

use crate::named::named_enum;
use crate::planet::{GeologicClock, Planet};
use bevy::ecs::schedule::{LogLevel, ScheduleBuildSettings, ScheduleLabel, SingleThreadedExecutor};
use bevy::prelude::*;
use core::time::Duration;
use std::time::Instant;

/// The schedule of one tectonic step. Its sets are [`TectonicSystems`].
#[derive(ScheduleLabel, Clone, Debug, PartialEq, Eq, Hash)]
pub struct TectonicStep;

/// What is done to a planet that rests between two steps, once a frame; [`CurrentPlanet`] names it.
#[derive(ScheduleLabel, Clone, Debug, PartialEq, Eq, Hash)]
pub struct BetweenSteps;

/// The sets of [`BetweenSteps`], in order.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BetweenStepsSystems {
    /// Commands of the user take effect.
    Commands,
    /// What follows from the state is brought up to date.
    Caches,
}

named_enum! {
    /// The stages of a step, in order.
    pub enum Stage {
        /// Commands of the user take effect.
        Commands = "commands",
        /// Frames rotate with their plates.
        Drift = "drift",
        /// Where plates meet, and which goes under.
        Contact = "contact",
        /// Overriding plates rise.
        Subduction = "subduction",
        /// Subducting plates turn towards their fronts.
        SlabPull = "slab pull",
        /// Terranes break off and are sutured.
        Collision = "collision",
        /// Plates break.
        Rifting = "rifting",
        /// Erosion, subsidence, sediment, isostasy, noise.
        SurfaceProcesses = "surface processes",
        /// When it is due: even samples again, and new ocean crust.
        Resample = "resample",
        /// The clock ticks and the ledger is checked.
        Commit = "commit",
        /// When someone looks at the planet: its surface is projected.
        Projection = "projection",
    }
}

/// The sets of [`TectonicStep`], all in one chain: `Process(s)` then `After(s)` for every stage in
/// order.
///
/// A stage that holds runs its `Process` set several times in one step; `After` runs once.
/// A geological process of your own goes into the `After` set of the stage that it follows.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TectonicSystems {
    /// The stage's own systems.
    Process(Stage),
    /// Once per step, when the stage has ended.
    After(Stage),
}

/// The planet that [`TectonicStep`] works on. The runner sets it.
#[derive(Resource, Clone, Copy, Debug)]
pub struct CurrentPlanet(pub Entity);

/// Where in a step a planet is.
#[derive(Component, Clone, Debug, Default)]
pub struct StepCursor {
    position: usize,
    held: bool,
    /// How far a stage that holds has come; the stage gives the number its meaning, 0 at the start.
    pub progress: usize,
    /// When the present slice of work should end. `None`: never.
    pub deadline: Option<Instant>,
    entered: Option<Instant>,
    spent: Duration,
    /// Set when a whole step has ended, until the runner sees it.
    pub step_done: bool,
}

impl StepCursor {
    /// Asks for another slice of the present stage.
    pub fn hold(&mut self) {
        self.held = true;
    }

    /// Whether the stage has asked for another slice: what else belongs to it must wait.
    pub fn is_held(&self) -> bool {
        self.held
    }

    /// Whether the present slice should end.
    pub fn out_of_time(&self) -> bool {
        self.deadline
            .is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Whether the planet stands between two steps: saves and commands are safe.
    pub fn at_boundary(&self) -> bool {
        self.position == 0 && self.progress == 0
    }

    /// The stage that the present slice of work is in, or that the next one begins with.
    pub fn stage(&self) -> Stage {
        Stage::ALL[self.position / 2 % Stage::ALL.len()]
    }

    fn len() -> usize {
        2 * Stage::ALL.len()
    }
}

/// Wall-clock time of each stage.
#[derive(Component, Clone, Debug, Default)]
pub struct StageTimings {
    /// Time of each stage in the last step in ms, in the order of [`Stage::ALL`]; slices are
    /// summed.
    pub last_ms: [f64; Stage::COUNT],
    /// Sum over all steps in ms.
    pub total_ms: [f64; Stage::COUNT],
    /// Largest time of a step in ms, without resampling, rifting and projecting the surface.
    pub step_max_ms: f64,
    /// Steps measured.
    pub steps: u64,
    /// Resamplings done, and their time in ms.
    pub resample: (u32, f64),
    /// Riftings done, and their time in ms.
    pub rift: (u32, f64),
}

impl StageTimings {
    /// Time of the last step in ms, without resampling, rifting and projecting the surface.
    pub fn last_step_ms(&self) -> f64 {
        self.without_events(&self.last_ms)
    }

    /// Mean time of a step in ms, without resampling, rifting and projecting the surface.
    pub fn step_mean_ms(&self) -> f64 {
        self.without_events(&self.total_ms) / self.steps.max(1) as f64
    }

    fn without_events(&self, ms: &[f64; Stage::COUNT]) -> f64 {
        let apart = [Stage::Resample, Stage::Rifting, Stage::Projection];
        ms.iter().sum::<f64>() - apart.map(|stage| ms[stage as usize]).iter().sum::<f64>()
    }
}

/// The order of stages as a plugin: schedule, sets and gates, without any process.
pub struct TectonicSchedulePlugin;

impl Plugin for TectonicSchedulePlugin {
    fn build(&self, app: &mut App) {
        let mut schedule = Schedule::new(TectonicStep);
        schedule
            .set_executor(SingleThreadedExecutor::new())
            .set_build_settings(ScheduleBuildSettings {
                ambiguity_detection: LogLevel::Error,
                ..default()
            });
        let mut previous = None;
        for position in 0..StepCursor::len() {
            let set = set_at(position);
            schedule.configure_sets(set.run_if(at(position)));
            if let Some(previous) = previous {
                schedule.configure_sets(Leave(previous).before(set));
            }
            schedule.configure_sets(Leave(position).after(set));
            // A stage that holds leaves too, for the clock; it just does not move on.
            schedule.add_systems(leave.in_set(Leave(position)).run_if(reached(position)));
            previous = Some(position);
        }
        app.add_schedule(schedule)
            .init_schedule(BetweenSteps)
            .configure_sets(
                BetweenSteps,
                (BetweenStepsSystems::Commands, BetweenStepsSystems::Caches).chain(),
            )
            .add_systems(Update, run_planets);
    }
}

#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Leave(usize);

fn set_at(position: usize) -> TectonicSystems {
    let stage = Stage::ALL[position / 2];
    if position.is_multiple_of(2) {
        TectonicSystems::Process(stage)
    } else {
        TectonicSystems::After(stage)
    }
}

fn at(position: usize) -> impl Fn(Res<CurrentPlanet>, Query<&StepCursor>) -> bool + Clone {
    move |current: Res<CurrentPlanet>, cursors: Query<&StepCursor>| {
        cursors
            .get(current.0)
            .is_ok_and(|cursor| cursor.position == position && !cursor.held)
    }
}

fn reached(position: usize) -> impl Fn(Res<CurrentPlanet>, Query<&StepCursor>) -> bool + Clone {
    move |current: Res<CurrentPlanet>, cursors: Query<&StepCursor>| {
        cursors
            .get(current.0)
            .is_ok_and(|cursor| cursor.position == position)
    }
}

/// Moves the cursor on, unless the stage holds.
fn leave(current: Res<CurrentPlanet>, mut planets: Query<(&mut StepCursor, &mut StageTimings)>) {
    let Ok((mut cursor, mut timings)) = planets.get_mut(current.0) else {
        return;
    };
    let now = Instant::now();
    let elapsed = cursor
        .entered
        .map_or(Duration::ZERO, |entered| now - entered);
    cursor.entered = Some(now);
    cursor.spent += elapsed;
    if cursor.held {
        return;
    }
    let stage = cursor.position / 2;
    let ms = cursor.spent.as_secs_f64() * 1e3;
    if cursor.position.is_multiple_of(2) {
        timings.last_ms[stage] = ms;
    } else {
        timings.last_ms[stage] += ms;
        timings.total_ms[stage] += timings.last_ms[stage];
    }
    cursor.spent = Duration::ZERO;
    cursor.progress = 0;
    cursor.position += 1;
    // A slice that has used up its time ends between two stages, too.
    cursor.held = cursor.out_of_time();
    if cursor.position == StepCursor::len() {
        cursor.position = 0;
        cursor.step_done = true;
        timings.steps += 1;
        timings.step_max_ms = timings.step_max_ms.max(timings.last_step_ms());
    }
}

/// Runs one slice of a step for `planet`; with no deadline that is one whole step. Returns whether
/// a step ended.
pub fn run_slice(world: &mut World, planet: Entity, deadline: Option<Instant>) -> bool {
    world.insert_resource(CurrentPlanet(planet));
    if let Some(mut cursor) = world.get_mut::<StepCursor>(planet) {
        cursor.held = false;
        cursor.deadline = deadline;
        cursor.entered = Some(Instant::now());
    }
    if world.try_run_schedule(TectonicStep).is_err() {
        return false;
    }
    let Some(mut cursor) = world.get_mut::<StepCursor>(planet) else {
        return false;
    };
    core::mem::take(&mut cursor.step_done)
}

/// Runs `count` whole steps, without regard to clocks and budgets: for tools and tests. Nothing
/// happens to what is no planet, or in a world without [`TectonicSchedulePlugin`].
pub fn run_steps(world: &mut World, planet: Entity, count: u64) {
    for _ in 0..count {
        if !run_slice(world, planet, None) {
            return;
        }
    }
}

/// Advances every planet by as many slices as its clock and budget allow.
fn run_planets(world: &mut World) {
    let delta = world
        .get_resource::<Time>()
        .map_or(0.0, |time| time.delta_secs_f64());
    let mut planets: Vec<Entity> = world
        .query_filtered::<Entity, With<Planet>>()
        .iter(world)
        .collect();
    planets.sort();
    for planet in planets {
        run_planet(world, planet, delta);
    }
}

/// Geological time that a clock owes to the wall clock; a component so that each planet has its
/// own.
#[derive(Component, Clone, Debug, Default)]
pub struct TimeDebt(f64);

fn run_planet(world: &mut World, planet: Entity, delta: f64) {
    let Some(clock) = world.get::<GeologicClock>(planet).cloned() else {
        return;
    };
    let step = world
        .get::<crate::params::TectonicParams>(planet)
        .map_or(2.0, |p| p.time_step);
    let at_boundary = world
        .get::<StepCursor>(planet)
        .is_some_and(StepCursor::at_boundary);
    let Some(mut debt) = world.get_mut::<TimeDebt>(planet) else {
        return;
    };
    if !clock.paused {
        // A slow machine owes at most two steps: it lags instead of working off a backlog.
        let owed = debt.0 + delta * clock.speed;
        debt.0 = if owed.is_finite() {
            owed.clamp(0.0, 2.0 * step)
        } else {
            0.0
        };
    }
    let wanted = (!clock.paused && debt.0 >= step) || clock.single_steps > 0;
    if at_boundary && !wanted {
        run_between_steps(world, planet);
        return;
    }
    let deadline = Instant::now() + clock.frame_budget;
    loop {
        if run_slice(world, planet, Some(deadline)) {
            finish_step(world, planet, step);
            return;
        }
        if Instant::now() >= deadline {
            return;
        }
    }
}

fn run_between_steps(world: &mut World, planet: Entity) {
    world.insert_resource(CurrentPlanet(planet));
    world.run_schedule(BetweenSteps);
}

fn finish_step(world: &mut World, planet: Entity, step: f64) {
    if let Some(mut debt) = world.get_mut::<TimeDebt>(planet) {
        debt.0 = (debt.0 - step).max(0.0);
    }
    if let Some(mut clock) = world.get_mut::<GeologicClock>(planet) {
        clock.single_steps = clock.single_steps.saturating_sub(1);
        if clock.until.is_some_and(|until| clock.time >= until) {
            clock.paused = true;
            clock.until = None;
        }
    }
}
