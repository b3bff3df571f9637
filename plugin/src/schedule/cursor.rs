//! Where in a step a planet is.

use super::stage::{Stage, TectonicSystems};
use super::timings::StageTimings;
use bevy::prelude::*;
use core::time::Duration;
use std::time::Instant;

/// Where in a step a planet is.
#[derive(Component, Clone, Debug, Default, Reflect)]
#[require(StageTimings)]
#[reflect(Component, Default)]
pub struct StepCursor {
    /// Position in the chain of [`TectonicSystems`].
    pub(super) position: usize,
    pub(super) held: bool,
    /// How far a stage that holds has come; the stage gives the number its meaning, 0 at the start.
    pub progress: usize,
    /// When the present time slice should end. `None`: never.
    pub deadline: Option<Instant>,
    /// When the set at `position` was entered, or entered again.
    entered: Option<Instant>,
    /// Time spent in the set at `position` so far.
    spent: Duration,
    /// Set when a whole step has ended, until the runner sees it.
    pub step_done: bool,
}

impl StepCursor {
    /// Asks for another time slice of the present stage.
    pub fn hold(&mut self) {
        self.held = true;
    }

    /// Whether the stage has asked for another time slice: what else belongs to it must wait.
    pub fn is_held(&self) -> bool {
        self.held
    }

    /// Whether the present time slice should end.
    pub fn out_of_time(&self) -> bool {
        self.deadline
            .is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Whether the planet stands between two steps: saves and commands are safe.
    pub fn at_boundary(&self) -> bool {
        self.position == 0 && self.progress == 0
    }

    /// The stage that the present time slice is in, or that the next one begins with.
    pub fn stage(&self) -> Stage {
        Stage::ALL[self.position / 2 % Stage::COUNT]
    }

    /// Begins a time slice.
    pub(super) fn begin(&mut self, deadline: Option<Instant>) {
        self.held = false;
        self.deadline = deadline;
        self.entered = Some(Instant::now());
    }

    /// Leaves the present set: for the next one, or, if its stage holds, until the next time slice.
    pub(super) fn leave(&mut self, timings: &mut StageTimings) {
        let now = Instant::now();
        if let Some(entered) = self.entered.replace(now) {
            self.spent += now - entered;
        }
        if self.held {
            return;
        }
        let spent = core::mem::take(&mut self.spent);
        timings.take(TectonicSystems::at(self.position), spent);
        self.progress = 0;
        self.position += 1;
        // A time slice that is used up ends between two stages, too.
        self.held = self.out_of_time();
        if self.position == TectonicSystems::COUNT {
            self.position = 0;
            self.step_done = true;
            timings.end_step();
        }
    }
}
