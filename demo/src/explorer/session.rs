//! The planet on show: growing, loading and saving in the background.
//!
//! A new planet replaces the old one only once it is there, and one that is not saved only when
//! that is asked for twice; whatever fails is said in a message and the old planet lives on. A save
//! takes the state at a step boundary and writes it on another thread.

use super::background::Background;
use super::discard::{Discard, Mark, QUESTION};
use super::messages::Messages;
use super::panels::planet::PlanetForm;
use super::state::{Action, Selection};
use bevy::prelude::*;
use bevy_pangaea::io;
use bevy_pangaea::prelude::*;
use bevy_pangaea::schedule::StepCursor;
use bevy_pangaea::spawn::PlanetState;
use std::path::{Path, PathBuf};

/// The planet on show and what is under way.
#[derive(Resource, Default)]
pub struct Session {
    /// The planet on show.
    pub planet: Option<Entity>,
    job: Option<Job>,
    /// Where to save as soon as the planet stands between two steps.
    save_to: Option<PathBuf>,
    saving: Option<Saving>,
    discard: Discard,
}

/// A save under way: what it holds, and the note when it is written.
struct Saving {
    mark: Option<Mark>,
    work: Background<String>,
}

struct Job {
    what: String,
    work: Background<Outcome>,
}

enum Outcome {
    Grown(Box<PlanetState>),
    Loaded(Box<PlanetState>, PathBuf),
    Preset(Box<PlanetRecipe>, PathBuf),
}

impl Session {
    /// What is under way, in words.
    pub fn busy(&self) -> Option<&str> {
        let saving = self.save_to.is_some() || self.saving.is_some();
        self.job
            .as_ref()
            .map(|job| job.what.as_str())
            .or(saving.then_some("Saving"))
    }

    /// Whether a new planet is on its way.
    pub fn is_growing(&self) -> bool {
        self.job.is_some()
    }

    fn start(
        &mut self,
        what: String,
        work: impl FnOnce() -> Result<Outcome, String> + Send + 'static,
    ) {
        self.job = Some(Job {
            what,
            work: Background::start(work),
        });
    }
}

/// Starts what the user asks for.
pub fn start_jobs(
    mut actions: MessageReader<Action>,
    mut session: ResMut<Session>,
    mut messages: ResMut<Messages>,
    planets: Query<(Entity, &GeologicClock, &Recording)>,
) {
    let now = session
        .planet
        .and_then(|planet| planets.get(planet).ok())
        .map(Mark::of);
    for action in actions.read() {
        let wants_job = matches!(
            action,
            Action::Grow(_) | Action::Load(_) | Action::ReadPreset(_)
        );
        if wants_job && session.job.is_some() {
            messages.error("a planet is on its way already: wait for it");
            continue;
        }
        let discards = matches!(action, Action::Grow(_) | Action::Load(_));
        if let Some(now) = now.filter(|_| discards)
            && !session.discard.allows(action, now)
        {
            messages.note(QUESTION);
            continue;
        }
        match action.clone() {
            Action::Grow(recipe) => session.start("Growing a planet".into(), move || {
                PlanetState::new(&recipe)
                    .map(Box::new)
                    .map(Outcome::Grown)
                    .map_err(text)
            }),
            Action::Load(path) => session.start("Loading".into(), move || {
                let state = io::load(&path).map_err(text)?;
                Ok(Outcome::Loaded(Box::new(state), path))
            }),
            Action::ReadPreset(path) => session.start("Reading a preset".into(), move || {
                let recipe = io::load_preset(&path).map_err(text)?;
                Ok(Outcome::Preset(Box::new(recipe), path))
            }),
            Action::Save(path) if session.planet.is_none() => {
                messages.error(format!("there is no planet to save as {}", path.display()));
            }
            Action::Save(path) if path.as_os_str().is_empty() => {
                messages.error("name a file to save the planet to");
            }
            Action::Save(path) => session.save_to = Some(path),
            _ => {}
        }
    }
}

/// Puts a planet that is ready on show.
pub fn finish_jobs(world: &mut World) {
    let mut session = world.resource_mut::<Session>();
    let Some(job) = session.job.as_mut() else {
        return;
    };
    let Some(outcome) = job.work.take() else {
        return;
    };
    session.job = None;
    match outcome {
        Ok(Outcome::Grown(state)) => {
            let seed = state.planet.seed;
            replace(world, *state);
            world
                .resource_mut::<Messages>()
                .note(format!("a new planet from seed {seed}"));
        }
        Ok(Outcome::Loaded(state, path)) => show_loaded(world, *state, &path),
        Ok(Outcome::Preset(recipe, path)) => {
            world
                .resource_mut::<PlanetForm>()
                .take_preset(*recipe, &path);
            world
                .resource_mut::<Messages>()
                .note(format!("read {}", path.display()));
        }
        Err(error) => world.resource_mut::<Messages>().error(error),
    }
}

/// Shows a planet that was loaded before the app runs, as the first one.
pub fn begin_with(app: &mut App, planet: Box<PlanetState>, path: PathBuf) {
    let mut planet = Some(planet);
    app.add_systems(Startup, move |world: &mut World| {
        if let Some(planet) = planet.take() {
            show_loaded(world, *planet, &path);
        }
    });
}

fn show_loaded(world: &mut World, state: PlanetState, path: &Path) {
    replace(world, state);
    world
        .resource_mut::<Messages>()
        .note(format!("loaded {}", path.display()));
}

/// Spawns the planet in place of the present one; whether time runs, and how fast, stays.
fn replace(world: &mut World, state: PlanetState) {
    let old = world.resource::<Session>().planet;
    let controls = old.and_then(|old| world.get::<ClockControls>(old));
    let controls = controls.map(|controls| ClockControls {
        paused: controls.paused,
        speed: controls.speed,
        ..default()
    });
    let planet = state.spawn(world);
    world
        .entity_mut(planet)
        .insert(controls.unwrap_or_default());
    let mark = mark(world, planet);
    let mut session = world.resource_mut::<Session>();
    session.planet = Some(planet);
    if let Some(mark) = mark {
        session.discard.keep(mark);
    }
    world.resource_mut::<Selection>().0 = None;
    if let Some(old) = old {
        world.despawn(old);
    }
}

fn mark(world: &World, planet: Entity) -> Option<Mark> {
    Some(Mark::of((planet, world.get(planet)?, world.get(planet)?)))
}

/// Takes the state for a save when the planet stands between two steps, and hands it to a thread.
pub fn save_at_boundary(world: &mut World) {
    let session = world.resource::<Session>();
    let (Some(planet), Some(path)) = (session.planet, session.save_to.clone()) else {
        return;
    };
    let between = world
        .get::<StepCursor>(planet)
        .is_some_and(StepCursor::at_boundary);
    if !between || session.saving.is_some() {
        return;
    }
    world.resource_mut::<Session>().save_to = None;
    match io::capture(world, planet) {
        Some(state) => {
            let mark = mark(world, planet);
            let work = Background::start(move || {
                io::save(&state, &path).map_err(text)?;
                Ok(format!("saved {}", path.display()))
            });
            world.resource_mut::<Session>().saving = Some(Saving { mark, work });
        }
        None => world
            .resource_mut::<Messages>()
            .error("the planet cannot be saved now"),
    }
}

/// Says how a save went.
pub fn finish_save(mut session: ResMut<Session>, mut messages: ResMut<Messages>) {
    let Some(saving) = session.saving.as_mut() else {
        return;
    };
    let Some(outcome) = saving.work.take() else {
        return;
    };
    let mark = saving.mark;
    session.saving = None;
    match outcome {
        Ok(note) => {
            messages.note(note);
            // Another planet may have come meanwhile.
            if let Some(mark) = mark.filter(|mark| session.planet == Some(mark.planet)) {
                session.discard.keep(mark);
            }
        }
        Err(error) => messages.error(error),
    }
}

fn text(error: impl ToString) -> String {
    error.to_string()
}

#[cfg(test)]
#[path = "session_tests.rs"]
mod tests;
