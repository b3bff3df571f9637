//! How far a planet grows, and what is done to it on the way.

use crate::cli::RecipeArgs;
use crate::error::CliError;
use crate::headless::Headless;
use crate::progress;
use bevy_pangaea::authoring::Scenario;
use bevy_pangaea::io::load_scenario;
use bevy_pangaea::planet::{GeologicClock, Lattice};

/// What sums of steps may be short of, in My: ten thousand My in steps of 0.1 add up to a fiftieth of it.
const HAIR: f64 = 1e-6;

/// How far a planet grows, and what is done to it on the way.
pub struct Course {
    until: f64,
    scenario: Option<Scenario>,
}

impl Course {
    /// What `--until` and `--scenario` say.
    ///
    /// # Errors
    /// If the scenario is refused.
    pub fn new(args: &RecipeArgs) -> Result<Self, CliError> {
        let scenario = args.scenario.as_deref().map(load_scenario).transpose()?;
        Ok(Self { until: args.until(), scenario })
    }

    /// Grows a planet, with a progress bar. The steps go by its clock: a scenario may change their length.
    ///
    /// # Errors
    /// If a command of the scenario is refused, or the user interrupts it.
    pub fn run(mut self, headless: &mut Headless) -> Result<(), CliError> {
        headless.play(self.scenario.take());
        let what = format!("growing {} samples", headless.get::<Lattice>()?.0.len());
        let bar = progress::bar(self.until.ceil() as u64, "My", &what);
        while !self.is_over(headless.get::<GeologicClock>()?.time) {
            headless.step()?;
            bar.set_position(headless.get::<GeologicClock>()?.time.min(self.until) as u64);
        }
        bar.finish_and_clear();
        Ok(())
    }

    fn is_over(&self, time: f64) -> bool {
        time >= self.until - HAIR
    }
}
