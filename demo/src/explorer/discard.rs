//! The question before a planet that is not saved makes way for another.

use super::state::Action;
use bevy::prelude::*;
use bevy_pangaea::prelude::*;
use std::mem::{Discriminant, discriminant};
use std::time::{Duration, Instant};

/// How soon the second press must follow.
const ASK_AGAIN_AFTER: Duration = Duration::from_secs(3);

/// The message after the first press.
pub const DISCARD_QUESTION: &str = "the planet is not saved: press again within 3 s to discard it";

/// How far a planet was at a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanetRevision {
    /// The planet.
    pub planet: Entity,
    steps: u64,
    commands: usize,
}

impl PlanetRevision {
    /// How far a planet is now.
    pub fn of((planet, clock, recording): (Entity, &GeologicClock, &Recording)) -> Self {
        Self {
            planet,
            steps: clock.step,
            commands: recording.0.len(),
        }
    }
}

/// The revision that may be discarded without a question, and the last question.
#[derive(Default)]
pub struct Discard {
    kept: Option<PlanetRevision>,
    /// The kind of action that was asked about, and when.
    asked: Option<(Discriminant<Action>, Instant)>,
}

impl Discard {
    /// A planet was made, loaded or saved: up to here nothing is lost.
    pub fn keep(&mut self, revision: PlanetRevision) {
        self.kept = Some(revision);
    }

    /// Whether the planet may go for `action`: it has not changed, or this is the second press.
    pub fn allows(&mut self, action: &Action, now: PlanetRevision) -> bool {
        let what = discriminant(action);
        let again = self
            .asked
            .take()
            .is_some_and(|(asked, at)| asked == what && at.elapsed() < ASK_AGAIN_AFTER);
        // A question is answered by the next wish, whatever it is.
        let allowed = again || self.kept == Some(now);
        if !allowed {
            self.asked = Some((what, Instant::now()));
        }
        allowed
    }
}
