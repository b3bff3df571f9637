//! How far a planet grows, and what a scenario does to it on the way.

use crate::cli::GrowthArgs;
use crate::error::CliError;
use crate::headless::Headless;
use crate::progress;
use bevy_pangaea::authoring::{Scenario, TectonicCommand, TimedCommand};
use bevy_pangaea::io::load_scenario;
use bevy_pangaea::planet::{GeologicClock, Lattice};
use std::path::Path;

/// By how much a sum of steps may fall short of the end and still count as having reached it, in
/// My: ten thousand My in steps of 0.1 are summed with a fiftieth of this error.
const ROUNDING_MY: f64 = 1e-6;

/// How far a planet grows, and what a scenario does to it on the way.
pub struct GrowthPlan {
    until: f64,
    scenario: Option<Scenario>,
}

impl GrowthPlan {
    /// The plan that `--until` and `--scenario` give for a planet that begins with steps of
    /// `time_step` My.
    ///
    /// # Errors
    /// If the scenario is refused, or has commands that would come after the end.
    pub fn new(args: &GrowthArgs, time_step: f64) -> Result<Self, CliError> {
        let until = args.until();
        let scenario = match &args.scenario {
            Some(path) => Some(scenario_until(path, until, time_step)?),
            None => None,
        };
        Ok(Self { until, scenario })
    }

    /// Grows a planet, with a progress bar. The steps go by its clock: a scenario may change their
    /// length.
    ///
    /// # Errors
    /// If a command of the scenario is refused, or the user interrupts it.
    pub fn run(mut self, headless: &mut Headless) -> Result<(), CliError> {
        headless.play(self.scenario.take());
        let title = format!("growing {} samples", headless.get::<Lattice>()?.0.len());
        let bar = progress::bar(self.until.ceil() as u64, "My", &title);
        while !is_over(headless.get::<GeologicClock>()?.time, self.until) {
            headless.step()?;
            bar.set_position(headless.get::<GeologicClock>()?.time.min(self.until) as u64);
        }
        headless.obey_due()?;
        bar.finish_and_clear();
        Ok(())
    }
}

/// The scenario in a file, none of whose commands come after the end. At the end itself there may
/// be some: those of a planet that rested there while it was recorded.
fn scenario_until(path: &Path, until: f64, time_step: f64) -> Result<Scenario, CliError> {
    let scenario = load_scenario(path)?;
    let steps = steps(until, time_step, &scenario);
    match scenario.0.iter().position(|timed| timed.step > steps) {
        None => Ok(scenario),
        Some(late) => Err(CliError::input(format!(
            "{}: command {} (step {}) comes after the end: {until} My are {steps} steps",
            path.display(),
            late + 1,
            scenario.0[late].step,
        ))),
    }
}

fn is_over(time: f64, until: f64) -> bool {
    time >= until - ROUNDING_MY
}

/// The steps that a planet takes until the end, as its clock will count them.
fn steps(until: f64, mut time_step: f64, scenario: &Scenario) -> u64 {
    let mut changes: Vec<(u64, f64)> = scenario.0.iter().filter_map(new_time_step).collect();
    // A stable sort: of two changes at one step the later one of the list holds, as in the planet.
    changes.sort_by_key(|&(step, _)| step);
    let mut changes = changes.into_iter().peekable();
    let (mut time, mut step) = (0.0, 0);
    // Summed as the clock sums them, rounding included.
    while !is_over(time, until) {
        while let Some((_, changed)) = changes.next_if(|&(due, _)| due <= step) {
            time_step = changed;
        }
        time += time_step;
        step += 1;
    }
    step
}

/// When a command changes the time step, and to how many My.
fn new_time_step(timed: &TimedCommand) -> Option<(u64, f64)> {
    match &timed.command {
        TectonicCommand::SetParam { name, value } if name == "time_step" => {
            Some((timed.step, *value))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A scenario that sets the time step, each time at a step to a number of My.
    fn scenario(changes: &[(u64, f64)]) -> Scenario {
        Scenario(changes.iter().map(|&(step, my)| change(step, my)).collect())
    }

    fn change(step: u64, value: f64) -> TimedCommand {
        let name = "time_step".into();
        let command = TectonicCommand::SetParam { name, value };
        TimedCommand { step, command }
    }

    #[test]
    fn times_are_rounded_up_to_whole_steps() {
        let steps = |until, time_step| steps(until, time_step, &scenario(&[]));
        assert_eq!(steps(250.0, 2.0), 125);
        assert_eq!(steps(251.0, 2.0), 126);
        assert_eq!(steps(0.3, 0.1), 3);
        assert_eq!(steps(0.1, 5.0), 1);
        assert_eq!(steps(10_000.0, 0.1), 100_000);
    }

    #[test]
    fn changes_of_the_step_count_from_when_they_are_due() {
        assert_eq!(steps(30.0, 2.0, &scenario(&[(1, 4.0)])), 8);
        // In order of time, then of the list.
        let changes = scenario(&[(5, 5.0), (0, 1.0), (0, 4.0)]);
        assert_eq!(steps(30.0, 2.0, &changes), 7);
    }
}
