//! A game reacts to what happens on a planet, and makes things happen.
//!
//! `cargo run -p bevy_pangaea --example events --no-default-features`

use bevy::prelude::*;
use bevy_pangaea::math::lat_lon;
use bevy_pangaea::prelude::*;

/// The planet's history as the game keeps it.
#[derive(Resource, Default)]
struct Chronicle {
    collisions: u32,
    rifts: u32,
}

/// Continents have met: time for earthquakes.
fn shake(
    event: On<TerraneCollided>,
    clocks: Query<&GeologicClock>,
    mut chronicle: ResMut<Chronicle>,
) {
    let Ok(clock) = clocks.get(event.planet) else {
        return;
    };
    let (lat, lon) = lat_lon(event.at);
    chronicle.collisions += 1;
    println!(
        "{:4.0} My  plates {} and {} collide at {lat:4.0} {lon:5.0}: a terrane of {:.1} million km², {:.0} km/My",
        clock.time,
        event.from.0,
        event.to.0,
        event.area / 1e6,
        event.speed
    );
}

/// A plate has broken; the game speeds up one of the fragments by a command, which is recorded.
fn hurry(
    event: On<PlateRifted>,
    clocks: Query<&GeologicClock>,
    mut chronicle: ResMut<Chronicle>,
    mut commands: Commands,
) {
    let Ok(clock) = clocks.get(event.planet) else {
        return;
    };
    chronicle.rifts += 1;
    println!(
        "{:4.0} My  plate {} breaks into {:?}",
        clock.time, event.parent.0, event.fragments
    );
    if let Some(&plate) = event.fragments.last() {
        let faster = TectonicCommand::SetPlateMotion {
            plate,
            pole: (60.0, 30.0),
            speed: 90.0,
        };
        commands.entity(event.planet).tectonic(faster);
    }
}

fn lament(event: On<PlateConsumed>) {
    println!("         plate {} is gone", event.plate.0);
}

fn complain(event: On<CommandRejected>) {
    println!("         refused: {}", event.error);
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins)
        .init_resource::<Chronicle>()
        .add_observer(shake)
        .add_observer(hurry)
        .add_observer(lament)
        .add_observer(complain);
    let mut recipe = PlanetRecipe {
        seed: 1,
        samples: 10_000,
        ..default()
    };
    recipe.params.rift_rate = 0.02;
    let world = app.world_mut();
    let planet = PlanetState::new(&recipe)?.spawn(world);
    run_steps(world, planet, 50);
    let Chronicle { collisions, rifts } = *world.resource::<Chronicle>();
    let orders = world
        .get::<Recording>(planet)
        .map_or(0, |recording| recording.0.len());
    println!("{collisions} collisions, {rifts} rifts, {orders} orders in 100 My");
    Ok(())
}
