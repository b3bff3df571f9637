//! A planet without a window or a renderer: grow it for 100 My and say what became of it.
//!
//! `cargo run -p bevy_pangaea --example headless --no-default-features`

use bevy::prelude::*;
use bevy_pangaea::prelude::*;
use bevy_pangaea::resample::project_now;
use bevy_pangaea::schedule::StageTimings;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let recipe = PlanetRecipe {
        seed: 7,
        samples: 10_000,
        ..default()
    };
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    let world = app.world_mut();
    let planet = PlanetState::new(&recipe)?.spawn(world);
    for _ in 0..5 {
        run_steps(world, planet, 10);
        report(world, planet)?;
    }
    Ok(())
}

/// Says how the planet is.
fn report(world: &mut World, planet: Entity) -> Result<(), &'static str> {
    project_now(world, planet);
    let planet = world
        .entity(planet)
        .get_components::<(&PlanetSurface, &Plates, &StageTimings)>();
    let (surface, plates, timings) = planet.map_err(|_| "the entity is no planet")?;
    let land = (0..surface.len())
        .filter(|&i| surface.elevation(i) > 0.0)
        .count();
    println!(
        "{:4.0} My  {} plates  {:4.1} % land  {:.2} ms per step",
        surface.time,
        plates.iter().count(),
        100.0 * land as f64 / surface.len() as f64,
        timings.step_mean_ms()
    );
    Ok(())
}
