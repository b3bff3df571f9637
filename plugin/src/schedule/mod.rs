//! The schedule of one tectonic step, and the runner that spreads it over frames.
//!
//! ```text
//! stage      the stages of a step, the schedules, their sets
//! cursor     where in a step a planet is
//! timings    milliseconds per stage
//! plugin     the chain of sets and gates that makes the schedule
//! runner     time slices, budgets, clocks
//! ```
//!
//! A step is a walk through the [`Stage`]s. A time slice of it ends where its time is up: between
//! two stages, or within a long one that asks for another time slice with [`StepCursor::hold`]. The
//! runner runs [`TectonicStep`] again and again until the frame's budget is spent, and each run
//! goes on where the last one stopped. Without a budget a single run is a whole step.

mod stage;

mod cursor;

mod timings;

mod plugin;

mod runner;

pub use cursor::StepCursor;
pub use plugin::TectonicSchedulePlugin;
pub use runner::{AdvancePlanets, TimeDebt, run_steps, run_time_slice};
pub use stage::{
    BetweenSteps, BetweenStepsSystems, CurrentPlanet, Stage, TectonicStep, TectonicSystems,
};
pub use timings::StageTimings;

#[cfg(test)]
mod tests;
