//! The runner: whole steps for tools, time slices within a frame's budget for games.

use super::cursor::StepCursor;
use super::stage::{BetweenSteps, CurrentPlanet, TectonicStep};
use crate::params::TectonicParams;
use crate::planet::{ClockControls, GeologicClock, Planet};
use bevy::prelude::*;
use std::time::Instant;

/// The set of the system that advances planets, for what must run before or after it.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct AdvancePlanets;

/// Geological time in My that a planet's clock owes to the wall clock.
#[derive(Component, Clone, Debug, Default, PartialEq, Reflect)]
#[reflect(Component, Default)]
pub struct TimeDebt(f64);

impl TimeDebt {
    /// Most steps that a clock owes: a slow machine lags instead of working off a backlog.
    const MOST_STEPS: f64 = 2.0;

    /// Adds `time` My, of steps that last `step` My.
    fn grow(&mut self, time: f64, step: f64) {
        let owed = self.0 + time;
        self.0 = if owed.is_finite() {
            owed.clamp(0.0, Self::MOST_STEPS * step)
        } else {
            0.0
        };
    }

    fn pay(&mut self, step: f64) {
        self.0 = (self.0 - step).max(0.0);
    }
}

/// Runs one time slice of a step for `planet`; with no deadline that is one whole step. Returns
/// whether a step ended.
pub fn run_time_slice(world: &mut World, planet: Entity, deadline: Option<Instant>) -> bool {
    world.insert_resource(CurrentPlanet(planet));
    if let Some(mut cursor) = world.get_mut::<StepCursor>(planet) {
        cursor.begin(deadline);
    }
    if world.try_run_schedule(TectonicStep).is_err() {
        return false;
    }
    world
        .get_mut::<StepCursor>(planet)
        .is_some_and(|mut cursor| core::mem::take(&mut cursor.step_done))
}

/// Runs `count` whole steps, without regard to clocks and budgets: for tools and tests.
///
/// Nothing happens to an entity that is no planet, or in a world without
/// [`TectonicSchedulePlugin`](super::TectonicSchedulePlugin).
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// # fn main() -> Result<(), PlanetError> {
/// let mut app = App::new();
/// app.add_plugins(PangaeaPlugins);
/// let recipe = PlanetRecipe { samples: 500, ..default() };
/// let planet = PlanetState::new(&recipe)?.spawn(app.world_mut());
/// run_steps(app.world_mut(), planet, 3);
/// assert_eq!(app.world().get::<GeologicClock>(planet).map(|clock| clock.time), Some(6.0));
/// # Ok(())
/// # }
/// ```
pub fn run_steps(world: &mut World, planet: Entity, count: u64) {
    for _ in 0..count {
        if !run_time_slice(world, planet, None) {
            return;
        }
    }
}

/// Advances every planet by as many time slices as its clock and budget allow.
pub(super) fn run_planets(world: &mut World) {
    let delta = world
        .get_resource::<Time>()
        .map_or(0.0, |time| time.delta_secs_f64());
    let mut planets: Vec<Entity> = world
        .query_filtered::<Entity, With<Planet>>()
        .iter(world)
        .collect();
    // The order of a query depends on what else the world holds; entities have an order of their
    // own.
    planets.sort();
    for planet in planets {
        run_planet(world, planet, delta);
    }
}

/// Advances one planet, `delta` seconds of wall clock after the last time.
fn run_planet(world: &mut World, planet: Entity, delta: f64) {
    let step = world
        .get::<TectonicParams>(planet)
        .map_or(2.0, |params| params.time_step);
    let Some((controls, wants_step)) = tick(world, planet, delta, step) else {
        return;
    };
    let at_boundary = world
        .get::<StepCursor>(planet)
        .is_some_and(StepCursor::at_boundary);
    if at_boundary && !wants_step {
        world.insert_resource(CurrentPlanet(planet));
        // At rest between two steps: what waits for a boundary has its turn.
        world.run_schedule(BetweenSteps);
        return;
    }
    let deadline = Instant::now() + controls.frame_budget;
    loop {
        if run_time_slice(world, planet, Some(deadline)) {
            finish_step(world, planet, step);
            return;
        }
        // At least one time slice runs, however small the budget.
        if Instant::now() >= deadline {
            return;
        }
    }
}

/// Lets the planet's debt of time grow. Returns its controls, and whether a step is due.
fn tick(world: &mut World, planet: Entity, delta: f64, step: f64) -> Option<(ClockControls, bool)> {
    let controls = world.get::<ClockControls>(planet)?.clone();
    let mut debt = world.get_mut::<TimeDebt>(planet)?;
    if !controls.paused {
        debt.grow(delta * controls.speed, step);
    }
    // A paused clock keeps what it owes.
    let due = !controls.paused && debt.0 >= step;
    let wants_step = due || controls.single_steps > 0;
    Some((controls, wants_step))
}

/// Settles the clock's accounts after a step of `step` My.
fn finish_step(world: &mut World, planet: Entity, step: f64) {
    let mut query = world.query::<(&GeologicClock, &mut ClockControls, &mut TimeDebt)>();
    let Ok((clock, mut controls, mut debt)) = query.get_mut(world, planet) else {
        return;
    };
    debt.pay(step);
    controls.single_steps = controls.single_steps.saturating_sub(1);
    if controls.until.is_some_and(|until| clock.time >= until) {
        controls.paused = true;
        controls.until = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_debt_is_bounded_and_never_nan() {
        let mut debt = TimeDebt::default();
        debt.grow(3.0, 2.0);
        assert_eq!(debt, TimeDebt(3.0));
        debt.grow(30.0, 2.0);
        assert_eq!(debt, TimeDebt(4.0));
        debt.pay(2.0);
        assert_eq!(debt, TimeDebt(2.0));
        debt.grow(f64::NAN, 2.0);
        assert_eq!(debt, TimeDebt(0.0));
        debt.grow(-1.0, 2.0);
        assert_eq!(debt, TimeDebt(0.0));
    }
}
