//! Apps without a window, and what tests do to a planet in them.

use bevy::prelude::*;
use bevy_pangaea::authoring::CommandRejected;
use bevy_pangaea::authoring::Inbox;
use bevy_pangaea::io;
use bevy_pangaea::plate::PlateTable;
use bevy_pangaea::plate::plate_table;
use bevy_pangaea::prelude::*;
use bevy_pangaea::schedule::run_steps;
use bevy_pangaea::spawn::PlanetState;
use std::sync::Arc;

/// Everything of Pangaea but the renderer.
pub fn app() -> App {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    app
}

/// A planet grown from a recipe, in an app of its own.
pub fn planet_app(recipe: &PlanetRecipe) -> (App, Entity) {
    spawn(PlanetState::new(recipe).expect("the recipe of a test is valid"))
}

/// A planet with a given state, in an app of its own.
pub fn spawn(state: PlanetState) -> (App, Entity) {
    let mut app = app();
    let planet = state.spawn(app.world_mut());
    (app, planet)
}

/// Takes `count` whole steps.
pub fn steps(app: &mut App, planet: Entity, count: u64) {
    run_steps(app.world_mut(), planet, count);
}

/// The state between two steps.
pub fn state(app: &App, planet: Entity) -> PlanetState {
    io::capture(app.world(), planet).expect("the planet stands between two steps")
}

/// The hash over all state.
pub fn digest(app: &App, planet: Entity) -> String {
    io::digest(&state(app, planet))
}

/// Puts a command into the planet's inbox.
pub fn command(app: &mut App, planet: Entity, command: TectonicCommand) {
    app.world_mut()
        .get_mut::<Inbox>(planet)
        .expect("an inbox")
        .0
        .push(command);
}

/// Carries out one command now. Returns whether it was accepted.
pub fn obey(app: &mut App, planet: Entity, wanted: TectonicCommand) -> bool {
    let before = count::<CommandRejected>(app);
    command(app, planet, wanted);
    bevy_pangaea::authoring::apply_pending(app.world_mut(), planet);
    count::<CommandRejected>(app) == before
}

/// The plates in order of their numbers.
pub fn plates(app: &App, planet: Entity) -> PlateTable {
    plate_table(app.world(), planet)
}

/// The surface as it is now.
pub fn surface(app: &mut App, planet: Entity) -> Arc<Surface> {
    bevy_pangaea::resample::project_now(app.world_mut(), planet);
    app.world()
        .get::<PlanetSurface>(planet)
        .expect("a surface")
        .0
        .clone()
}

/// A component of the planet.
pub fn get<C: Component>(app: &App, planet: Entity) -> &C {
    app.world()
        .get::<C>(planet)
        .expect("a component of every planet")
}

/// The parameters, to be changed.
pub fn params(app: &mut App, planet: Entity) -> Mut<'_, TectonicParams> {
    app.world_mut().get_mut(planet).expect("parameters")
}

/// Events of one type, in order.
#[derive(Resource)]
pub struct Log<E: Send + Sync + 'static>(pub Vec<E>);

/// Keeps a log of all events of a type from now on.
pub fn listen<E: EntityEvent + Clone>(app: &mut App) {
    if app.world().contains_resource::<Log<E>>() {
        return;
    }
    app.insert_resource(Log::<E>(Vec::new()));
    app.add_observer(|event: On<E>, mut log: ResMut<Log<E>>| log.0.push(event.event().clone()));
}

/// The events logged so far; none where nobody listens.
pub fn heard<E: Clone + Send + Sync + 'static>(app: &App) -> Vec<E> {
    app.world()
        .get_resource::<Log<E>>()
        .map_or_else(Vec::new, |log| log.0.clone())
}

fn count<E: EntityEvent + Clone>(app: &mut App) -> usize {
    listen::<E>(app);
    heard::<E>(app).len()
}
