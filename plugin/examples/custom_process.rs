//! A geological process of your own, between those of Pangaea: a hot spot.
//!
//! A plume is fixed to the mantle; the plates drift over it, and it builds a chain of volcanoes on
//! each of them. At angular distance d from its middle crust rises by
//!
//! ```text
//! dz = rate · δt · smoothstep(1 - d R / radius)      km per step, at most up to the summits z_c
//! ```
//!
//! and thickens by isostasy, or the volcano would sink again. Reads: frames. Writes: elevation,
//! thickness, ledger. It follows [`Stage::SurfaceProcesses`], so that a step's erosion meets the
//! volcano in the next step.
//!
//! Every process has to
//! - work on [`CurrentPlanet`] alone, in a set of [`TectonicStep`] after the stage that it follows;
//! - keep the mathematics in functions that know no ECS: the system gathers, calls and writes;
//! - sum in the order of samples, so that the same seed gives the same bits;
//! - book what continents gain or lose: what no cause explains shows in
//!   [`Ledger::unexplained_volume_max`], and a resample takes it back.
//!
//! `cargo run -p bevy_pangaea --example custom_process --no-default-features`

use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::crust::Cause;
use bevy_pangaea::crust::isostasy::Isostasy;
use bevy_pangaea::math::{angle_between, direction, lat_lon, smoothstep};
use bevy_pangaea::prelude::*;
use bevy_pangaea::resample::project_now;
use bevy_pangaea::view::{PlanetQuery, PlanetView};

/// A plume under a planet, on the planet's entity.
#[derive(Component, Clone, Debug, Reflect)]
#[reflect(Component)]
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
    mut planets: Query<(&HotSpot, PlanetQuery, &Frames, &mut Crust, &mut Ledger)>,
) {
    let Ok((spot, planet, frames, mut crust, mut ledger)) = planets.get_mut(current.0) else {
        return;
    };
    let volume = build_volcano(spot, &planet.view(), frames, &mut crust);
    // No continent grows in area: the kind of the crust stays as it is.
    ledger.book(Cause::Custom, 0.0, volume);
}

/// Lets the volcano grow for one step. Returns the volume in km³ that continents gain.
fn build_volcano(spot: &HotSpot, planet: &PlanetView, frames: &Frames, crust: &mut Crust) -> f64 {
    let isostasy = Isostasy::new(planet.params);
    let summit = planet.params.summit_elevation as f32;
    let mut volume = 0.0;
    for i in 0..crust.len() {
        // Samples never move; their frame says where they are now.
        let place = frames[usize::from(crust.frame[i])].to_world(planet.mesh.points()[i]);
        let distance = angle_between(place, spot.at) * planet.radius;
        if distance >= spot.radius {
            continue;
        }
        let growth = spot.rate * planet.params.time_step * smoothstep(1.0 - distance / spot.radius);
        let (z, thickness) = (crust.elevation[i], crust.thickness[i]);
        let raised = (z + growth as f32).min(summit).max(z);
        crust.elevation[i] = raised;
        crust.thickness[i] += isostasy.thickening(z, raised - z);
        if crust.is_continental(i) {
            let thickening = f64::from(crust.thickness[i] - thickness);
            volume += thickening * planet.mesh.areas()[i] * planet.square();
        }
    }
    volume
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut app = App::new();
    app.add_plugins((PangaeaPlugins, HotSpotPlugin));
    let recipe = PlanetRecipe {
        seed: 3,
        samples: 20_000,
        ..default()
    };
    let world = app.world_mut();
    let planet = PlanetState::new(&recipe)?.spawn(world);
    let hawaii = direction(19.0, -155.0);
    world.entity_mut(planet).insert(HotSpot {
        at: hawaii,
        radius: 500.0,
        rate: 0.5,
    });
    for _ in 0..6 {
        run_steps(world, planet, 5);
        report(world, planet, hawaii)?;
    }
    Ok(())
}

/// Says how high the hot spot stands, and whether the account of continental crust agrees.
fn report(world: &mut World, planet: Entity, at: DVec3) -> Result<(), &'static str> {
    project_now(world, planet);
    let planet = world
        .entity(planet)
        .get_components::<(&PlanetSurface, &Lattice, &Ledger)>();
    let (surface, mesh, ledger) = planet.map_err(|_| "the entity is no planet")?;
    let elevation = surface.at(mesh, at).elevation;
    let unexplained = ledger.unexplained_volume_max;
    let (lat, lon) = lat_lon(at);
    println!(
        "{:3.0} My  {elevation:5.2} km at the hot spot ({lat:.0} N, {lon:.0} E), \
         unexplained volume {unexplained:.0e}",
        surface.time
    );
    Ok(())
}
