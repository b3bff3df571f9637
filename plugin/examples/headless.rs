//! A planet without a window or a renderer: grow it for 100 My and say what became of it.
//!
//! `cargo run --example headless --no-default-features`

use bevy::prelude::*;
use bevy_pangaea::crust::PlanetSurface;
use bevy_pangaea::prelude::*;
use bevy_pangaea::schedule::{StageTimings, run_steps};
use bevy_pangaea::spawn::PlanetState;

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
        bevy_pangaea::resample::project_now(world, planet);
        let surface = world.get::<PlanetSurface>(planet).ok_or("no surface")?;
        let land = (0..surface.len())
            .filter(|&i| surface.elevation(i) > 0.0)
            .count();
        let plates = world
            .get::<Plates>(planet)
            .map_or(0, |plates| plates.iter().count());
        let ms = world
            .get::<StageTimings>(planet)
            .map_or(0.0, StageTimings::step_mean_ms);
        println!(
            "{:4.0} My  {plates} plates  {:4.1} % land  {ms:.2} ms per step",
            surface.time,
            100.0 * land as f64 / surface.len() as f64
        );
    }
    Ok(())
}
