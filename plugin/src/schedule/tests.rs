use super::*;
use crate::PangaeaPlugins;
use crate::planet::{ClockControls, GeologicClock, PlanetRecipe};
use crate::spawn::PlanetState;
use bevy::app::PluginGroup;
use bevy::ecs::schedule::ScheduleLabel;
use bevy::prelude::*;

/// A schedule that runs when a test runs it.
#[derive(ScheduleLabel, Clone, Debug, PartialEq, Eq, Hash)]
struct ByHand;

fn planet(app: &mut App) -> Entity {
    let recipe = PlanetRecipe {
        samples: 500,
        plate_count: 8,
        ..default()
    };
    let planet = PlanetState::new(&recipe).unwrap().spawn(app.world_mut());
    app.world_mut().entity_mut(planet).insert(ClockControls {
        paused: true,
        single_steps: 1,
        frame_budget: core::time::Duration::from_secs(60),
        ..default()
    });
    planet
}

fn steps(app: &App, planet: Entity) -> u64 {
    app.world().get::<GeologicClock>(planet).unwrap().step
}

#[test]
fn planets_advance_in_the_schedule_that_is_set() {
    let mut app = App::new();
    app.init_schedule(ByHand)
        .add_plugins(PangaeaPlugins.set(TectonicSchedulePlugin::new(ByHand)));
    let planet = planet(&mut app);
    app.update();
    assert_eq!(steps(&app, planet), 0);
    app.world_mut().run_schedule(ByHand);
    assert_eq!(steps(&app, planet), 1);
}

#[test]
fn planets_advance_in_update_by_default() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    let planet = planet(&mut app);
    app.update();
    assert_eq!(steps(&app, planet), 1);
}

#[test]
fn a_step_ends_where_it_began() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    let planet = planet(&mut app);
    assert!(run_time_slice(app.world_mut(), planet, None));
    let cursor = app.world().get::<StepCursor>(planet).unwrap();
    assert!(cursor.at_boundary());
    assert_eq!(cursor.stage(), Stage::Commands);
    let timings = app.world().get::<StageTimings>(planet).unwrap();
    assert_eq!(timings.steps, 1);
    assert!(timings.step_max_ms > 0.0);
}
