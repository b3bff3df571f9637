//! A geological process of your own, between those of Pangaea: a hot spot.
//!
//! A plume is fixed to the mantle; the plates drift over it, and it builds a chain of volcanoes on
//! each of them. The system runs after the stage `Relief` of every step, for the planet that the
//! step works on.
//!
//! Rules of the house: continental crust is conserved, so what the process adds to continents is
//! booked in the [`Ledger`], and thickness follows elevation by isostasy, or the volcano would sink
//! again.
//!
//! `cargo run -p bevy_pangaea --example custom_process --no-default-features`

use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::crust::Cause;
use bevy_pangaea::crust::isostasy::Isostasy;
use bevy_pangaea::math::{angle_between, direction, lat_lon, smoothstep};
use bevy_pangaea::prelude::*;
use bevy_pangaea::schedule::run_steps;
use bevy_pangaea::spawn::PlanetState;

/// A plume under a planet.
#[derive(Component)]
struct HotSpot {
    /// Unit direction, fixed to the mantle.
    at: DVec3,
    /// Radius of the volcano in km.
    radius: f64,
    /// Growth at its middle in km/My.
    rate: f64,
}

struct HotSpotPlugin;

impl Plugin for HotSpotPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            erupt.in_set(TectonicSystems::After(Stage::SurfaceProcesses)),
        );
    }
}

fn erupt(
    current: Res<CurrentPlanet>,
    mut planets: Query<(
        &HotSpot,
        &Planet,
        &Lattice,
        &TectonicParams,
        &Frames,
        &mut Crust,
        &mut Ledger,
    )>,
) {
    let Ok((spot, planet, mesh, params, frames, mut crust, mut ledger)) =
        planets.get_mut(current.0)
    else {
        return;
    };
    let isostasy = Isostasy::new(params);
    let mut volume = 0.0;
    for i in 0..crust.len() {
        // Samples never move; their frame says where they are now.
        let p = frames[usize::from(crust.frame[i])].to_world(mesh.point(i as u32));
        let distance = angle_between(p, spot.at) * planet.radius;
        if distance >= spot.radius {
            continue;
        }
        let growth = spot.rate * params.time_step * smoothstep(1.0 - distance / spot.radius);
        let z = crust.elevation[i];
        let raised = (z + growth as f32).min(params.summit_elevation as f32);
        let before = crust.thickness[i];
        crust.thickness[i] += isostasy.thickening(z, raised - z);
        crust.elevation[i] = raised;
        if crust.is_continental(i) {
            volume += f64::from(crust.thickness[i] - before)
                * mesh.area(i as u32)
                * planet.radius
                * planet.radius;
        }
    }
    // The causes are a closed list; magma from below is what arcs grow by as well.
    ledger.book(Cause::Custom, 0.0, volume);
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut app = App::new();
    app.add_plugins((PangaeaPlugins, HotSpotPlugin));
    let world = app.world_mut();
    let planet = PlanetState::new(&PlanetRecipe {
        seed: 3,
        samples: 20_000,
        ..default()
    })?
    .spawn(world);
    let at = direction(19.0, -155.0);
    world.entity_mut(planet).insert(HotSpot {
        at,
        radius: 500.0,
        rate: 0.5,
    });
    for _ in 0..6 {
        run_steps(world, planet, 5);
        bevy_pangaea::resample::project_now(world, planet);
        let (Some(surface), Some(mesh)) = (
            world.get::<PlanetSurface>(planet),
            world.get::<Lattice>(planet),
        ) else {
            break;
        };
        let spot = surface.at(mesh, at);
        let unexplained = world
            .get::<Ledger>(planet)
            .map_or(0.0, |ledger| ledger.unexplained_volume_max);
        let (lat, lon) = lat_lon(at);
        println!(
            "{:3.0} My  {:5.2} km at the hot spot ({lat:.0} N, {lon:.0} E), unexplained volume {unexplained:.0e}",
            surface.time, spot.elevation
        );
    }
    Ok(())
}
