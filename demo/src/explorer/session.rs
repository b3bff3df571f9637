//! The planet on show: growing, loading and saving in the background.
//!
//! A new planet replaces the old one only once it is there, and one that is not saved only when
//! that is asked for twice; whatever fails is said in a message and the old planet lives on. A save
//! takes the state at a step boundary and writes it on another thread.

use super::background::Background;
use super::discard::{DISCARD_QUESTION, Discard, PlanetRevision};
use super::messages::MessageLog;
use super::saving::{SaveContent, SaveOutcome, SaveQueue, SaveRequest};
use super::state::{Action, PresetRead, Selection, ShownPlanet};
use bevy::prelude::*;
use bevy_pangaea::hydrology::TerrainMaps;
use bevy_pangaea::io::{self, LoadedPlanet, PlanetFileKind};
use bevy_pangaea::prelude::*;
use bevy_pangaea::schedule::StepCursor;
use bevy_pangaea::spawn::PlanetState;
use std::path::{Path, PathBuf};

/// The work under way for the planet on show.
#[derive(Resource, Default)]
pub struct Session {
    job: Option<PlanetJob>,
    saves: SaveQueue,
    discard: Discard,
}

/// A planet or a preset on its way; one at a time.
struct PlanetJob {
    title: &'static str,
    work: Background<JobResult>,
}

enum JobResult {
    Grown(Box<PlanetState>),
    Loaded(Box<LoadedPlanet>, PathBuf),
    Preset(Box<PresetRead>),
}

impl Session {
    /// The work under way, in words.
    pub fn busy(&self) -> Option<&str> {
        self.job
            .as_ref()
            .map(|job| job.title)
            .or(self.saves.is_busy().then_some("Saving"))
    }

    /// Whether a new planet is on its way.
    pub fn is_growing(&self) -> bool {
        self.job.is_some()
    }

    fn start(
        &mut self,
        title: &'static str,
        work: impl FnOnce() -> Result<JobResult, String> + Send + 'static,
    ) {
        let work = Background::start(work);
        self.job = Some(PlanetJob { title, work });
    }
}

/// Starts what the user asks for.
pub fn start_jobs(
    mut actions: MessageReader<Action>,
    mut session: ResMut<Session>,
    mut messages: ResMut<MessageLog>,
    shown: Res<ShownPlanet>,
    planets: Query<(Entity, &GeologicClock, &Recording)>,
) {
    let shown = shown.0.and_then(|planet| planets.get(planet).ok());
    let now = shown.map(PlanetRevision::of);
    for action in actions.read() {
        match action {
            Action::Grow(_) | Action::Load(_) | Action::ReadPreset(_) => {
                start_job(&mut session, &mut messages, action, now);
            }
            Action::Save(path) => {
                let request = SaveRequest::new(path, SaveContent::Planet);
                request_save(&mut session, &mut messages, request, now.is_some());
            }
            Action::SaveScenario(path) => {
                let request = SaveRequest::new(path, SaveContent::Scenario);
                request_save(&mut session, &mut messages, request, now.is_some());
            }
            _ => {}
        }
    }
}

/// Starts a job, unless one is under way, or a planet that is not saved would go unasked.
fn start_job(
    session: &mut Session,
    messages: &mut MessageLog,
    action: &Action,
    now: Option<PlanetRevision>,
) {
    if session.job.is_some() {
        messages.error("a planet is on its way already: wait for it");
        return;
    }
    let replaces = matches!(action, Action::Grow(_) | Action::Load(_));
    if let Some(now) = now.filter(|_| replaces)
        && !session.discard.allows(action, now)
    {
        messages.note(DISCARD_QUESTION);
        return;
    }
    if let Action::Grow(recipe) = action {
        for warning in recipe.warnings() {
            messages.note(warning.to_string());
        }
    }
    match action.clone() {
        Action::Grow(recipe) => session.start("Growing a planet", move || grow(&recipe)),
        Action::Load(path) => session.start("Loading", move || load(path)),
        Action::ReadPreset(path) => session.start("Reading a preset", move || read_preset(path)),
        _ => {}
    }
}

fn grow(recipe: &PlanetRecipe) -> Result<JobResult, String> {
    let state = PlanetState::new(recipe).map_err(text)?;
    Ok(JobResult::Grown(Box::new(state)))
}

fn load(path: PathBuf) -> Result<JobResult, String> {
    let loaded = io::load_planet_with_notes(&path).map_err(text)?;
    Ok(JobResult::Loaded(Box::new(loaded), path))
}

fn read_preset(path: PathBuf) -> Result<JobResult, String> {
    let recipe = io::load_preset(&path).map_err(text)?;
    Ok(JobResult::Preset(Box::new(PresetRead { recipe, path })))
}

fn request_save(
    session: &mut Session,
    messages: &mut MessageLog,
    request: SaveRequest,
    has_planet: bool,
) {
    let path = &request.path;
    if !has_planet {
        messages.error(format!("there is no planet to save as {}", path.display()));
    } else if path.as_os_str().is_empty() {
        messages.error("name a file to save the planet to");
    } else if PlanetFileKind::of(path) != PlanetFileKind::Save {
        // The form names the maps that were loaded: they must not be lost.
        messages.error("a planet is saved as *.pangaea, not over the maps that it is made of");
    } else {
        session.saves.ask(request);
    }
}

/// Puts a planet that is ready on show, and hands on a preset that has been read.
pub fn finish_jobs(world: &mut World) {
    let mut session = world.resource_mut::<Session>();
    let Some(result) = session.job.as_mut().and_then(|job| job.work.take()) else {
        return;
    };
    session.job = None;
    match result {
        Ok(JobResult::Grown(state)) => {
            let seed = state.planet.seed;
            replace(world, *state);
            note(world, format!("a new planet from seed {seed}"));
        }
        Ok(JobResult::Loaded(loaded, path)) => {
            show_loaded(world, loaded.planet, &path);
            loaded.notes.into_iter().for_each(|text| note(world, text));
        }
        Ok(JobResult::Preset(preset)) => {
            note(world, format!("read {}", preset.path.display()));
            world.write_message(*preset);
        }
        Err(error) => world.resource_mut::<MessageLog>().error(error),
    }
}

fn note(world: &mut World, text: String) {
    world.resource_mut::<MessageLog>().note(text);
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
    note(world, format!("loaded {}", path.display()));
}

/// Spawns the planet in place of the present one; whether time runs, and how fast, stays.
fn replace(world: &mut World, state: PlanetState) {
    let old = world.resource::<ShownPlanet>().0;
    let mut controls = old.map(|old| kept_controls(world, old)).unwrap_or_default();
    controls.paused |= state.terrain.is_some();
    let planet = state.spawn(world);
    world.entity_mut(planet).insert(controls);
    world.resource_mut::<ShownPlanet>().0 = Some(planet);
    // Numbers of plates mean nothing on another planet.
    world.resource_mut::<Selection>().0 = None;
    if let Some(revision) = revision(world, planet) {
        world.resource_mut::<Session>().discard.keep(revision);
    }
    // Last, so that the clock could be read; its plates go with it.
    if let Some(old) = old {
        world.despawn(old);
    }
}

/// How time passes on the planet after `old`. A planet of maps, on which it stands still, says
/// nothing of the next one.
fn kept_controls(world: &World, old: Entity) -> ClockControls {
    let was_grown = world.get::<TerrainMaps>(old).is_none();
    let controls = world.get::<ClockControls>(old).filter(|_| was_grown);
    controls.map_or_else(default, |controls| ClockControls {
        paused: controls.paused,
        speed: controls.speed,
        ..default()
    })
}

fn revision(world: &World, planet: Entity) -> Option<PlanetRevision> {
    Some(PlanetRevision::of((
        planet,
        world.get(planet)?,
        world.get(planet)?,
    )))
}

/// Takes the state for a save when the planet stands between two steps, and hands it to a thread.
pub fn save_at_boundary(world: &mut World) {
    let Some(planet) = world.resource::<ShownPlanet>().0 else {
        return;
    };
    // In the middle of a step the state is torn: a save waits.
    let between = world
        .get::<StepCursor>(planet)
        .is_some_and(StepCursor::at_boundary);
    if !between || !world.resource::<Session>().saves.is_ready() {
        return;
    }
    let (state, revision) = (io::capture(world, planet), revision(world, planet));
    let mut session = world.resource_mut::<Session>();
    session.saves.begin(state, revision);
}

/// Says how a save went.
pub fn finish_save(
    mut session: ResMut<Session>,
    mut messages: ResMut<MessageLog>,
    shown: Res<ShownPlanet>,
) {
    let Some(SaveOutcome { revision, result }) = session.saves.take() else {
        return;
    };
    match result {
        Ok(note) => {
            messages.note(note);
            // Another planet may have come meanwhile.
            if let Some(saved) = revision.filter(|saved| shown.0 == Some(saved.planet)) {
                session.discard.keep(saved);
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
