//! A bake that follows a running planet in the background.
//!
//! A planet with [`BakeSettings`] is baked whenever its [`PlanetSurface`], its [`ClimateMaps`], its
//! [`TerrainMaps`] or the settings have changed and no bake of it is under way. Where it has
//! [`TerrainMaps`], they are its ground, not the surface. Bakes run on a thread pool of their
//! own: they share the processors with the simulation, but a frame never waits for them. The
//! finished bake is the component [`PlanetBake`], and [`BakeFinished`] is triggered on the planet.
//! The planet's state and its digest are not touched.

use super::bake::{Bake, BakeError, BakeFrame, BakeSource};
use super::settings::BakeSettings;
use crate::background::{BackgroundJob, BackgroundPool};
use crate::climate::ClimateMaps;
use crate::crust::{PlanetSurface, Surface};
use crate::hydrology::TerrainMaps;
use crate::planet::{Lattice, Planet};
use crate::sphere::SphereMesh;
use crate::view::{PlanetQuery, PlanetQueryItem};
use bevy::ecs::query::QueryData;
use bevy::prelude::*;
use core::sync::atomic::{AtomicU64, Ordering};
use std::sync::Arc;

/// Follows planets with bakes; see the module.
pub struct BakePlugin;

impl Plugin for BakePlugin {
    fn build(&self, app: &mut App) {
        // Collected first: a planet may begin its next bake in the frame that ends its last.
        app.add_systems(Update, (collect, start).chain());
    }
}

/// The last finished bake of a planet.
#[derive(Component, Clone, Deref, Reflect)]
#[reflect(Component, Clone)]
pub struct PlanetBake(pub Arc<Bake>);

/// All but the planet and its surface that a bake follows from.
#[derive(Clone, Default)]
struct BakeWish {
    settings: BakeSettings,
    maps: ClimateMaps,
    terrain: Option<TerrainMaps>,
}

impl BakeWish {
    fn asks_for_the_same(&self, other: &Self) -> bool {
        let same_maps = self.maps == other.maps && self.terrain == other.terrain;
        same_maps && self.settings.asks_for_the_same(&other.settings)
    }
}

/// Bakes a planet as its [`Surface`] is now, and waits for it: for tools and tests. Uses its
/// [`BakeSettings`], or the default ones, its [`ClimateMaps`] and its [`TerrainMaps`].
///
/// # Errors
/// [`BakeError`] for settings that no bake can have; the planet keeps its last one.
pub fn bake_now(world: &mut World, planet: Entity) -> Result<(), BakeError> {
    let Ok(entity) = world.get_entity(planet) else {
        return Ok(());
    };
    let Ok((own, lattice, surface)) =
        entity.get_components::<(&Planet, &Lattice, &PlanetSurface)>()
    else {
        return Ok(());
    };
    let wish = BakeWish {
        settings: entity.get().cloned().unwrap_or_default(),
        maps: entity.get().cloned().unwrap_or_default(),
        terrain: entity.get().cloned(),
    };
    wish.settings.check()?;
    let frame = reusable(entity.get::<PlanetBake>(), own, lattice, &wish.settings);
    let bake = bake(frame, own, &lattice.0, surface, &wish)?;
    world.entity_mut(planet).insert(PlanetBake(Arc::new(bake)));
    Ok(())
}

/// The bake of a planet as its surface is; without a frame to use again it makes one.
fn bake(
    frame: Option<Arc<BakeFrame>>,
    planet: &Planet,
    lattice: &SphereMesh,
    surface: &Surface,
    wish: &BakeWish,
) -> Result<Bake, BakeError> {
    let frame = match frame {
        Some(frame) => frame,
        None => Arc::new(BakeFrame::new(
            planet.seed,
            wish.settings.spacing,
            Some(lattice),
        )?),
    };
    let source = match &wish.terrain {
        Some(maps) => BakeSource::Maps(maps),
        None => BakeSource::Surface(surface),
    };
    let rules = &wish.settings.rules;
    let bake = Bake::new(&frame, planet.radius, &source, &wish.maps, rules)?;
    // Maps have no moment of their own: whoever waits for a bake of this surface has it.
    Ok(Bake {
        version: surface.version,
        time: surface.time,
        ..bake
    })
}

/// The frame of the last bake, if it serves the next one.
fn reusable(
    last: Option<&PlanetBake>,
    planet: &Planet,
    lattice: &Lattice,
    settings: &BakeSettings,
) -> Option<Arc<BakeFrame>> {
    let frame = last?.frame.clone();
    // A user may have given the planet another seed, or another lattice, since.
    let same = frame.spacing == settings.spacing && frame.base.seed == planet.seed;
    let fits = frame
        .transfer
        .as_ref()
        .is_some_and(|transfer| transfer.samples() == lattice.len());
    (same && fits).then_some(frame)
}

/// A bake is finished; the planet's [`PlanetBake`] is new.
#[derive(EntityEvent, Clone, Debug, Reflect)]
#[reflect(Event)]
pub struct BakeFinished {
    /// The planet.
    #[event_target]
    pub planet: Entity,
    /// [`Surface::version`] that it was made from.
    pub version: u64,
    /// Geological time in My.
    pub time: f64,
    /// Wall-clock time that it took in ms.
    pub milliseconds: f64,
}

/// A bake under way.
#[derive(Component)]
struct BakeJob {
    /// Jobs are collected in the order in which they began.
    serial: u64,
    work: BackgroundJob<BakeOutcome>,
}

/// A finished job.
struct BakeOutcome {
    bake: Result<Bake, BakeError>,
    /// Wall-clock time that it took in ms.
    milliseconds: f64,
}

/// The surface and the wish of a planet's last bake, so that a failure is not tried again and
/// again.
#[derive(Component)]
struct Baked {
    version: u64,
    wish: BakeWish,
}

/// Two threads, or the half of a large machine's.
static POOL: BackgroundPool = BackgroundPool::new("bake", |cores| cores.min(2).max(cores / 2));

/// A planet as bakes read it.
#[derive(QueryData)]
struct BakeQuery {
    planet: PlanetQuery,
    surface: &'static PlanetSurface,
    settings: &'static BakeSettings,
    maps: &'static ClimateMaps,
    terrain: Option<&'static TerrainMaps>,
    last: Option<&'static PlanetBake>,
    baked: Option<&'static Baked>,
}

impl BakeQueryItem<'_, '_> {
    fn wish(&self) -> BakeWish {
        BakeWish {
            settings: self.settings.clone(),
            maps: self.maps.clone(),
            terrain: self.terrain.cloned(),
        }
    }

    /// Whether the surface was baked, or refused, with the same wish.
    fn is_done(&self) -> bool {
        self.same_wish()
            .is_some_and(|baked| baked.version == self.surface.version)
    }

    /// The last attempt, if it followed from the same wish.
    fn same_wish(&self) -> Option<&Baked> {
        self.baked
            .filter(|baked| baked.wish.asks_for_the_same(&self.wish()))
    }

    /// Starts a job. It takes copies along: the planet may change or go meanwhile.
    fn start_job(&self) -> BakeJob {
        static SERIAL: AtomicU64 = AtomicU64::new(0);
        // Most bakes share the base mesh and its winds with the last one.
        let PlanetQueryItem {
            planet, lattice, ..
        } = self.planet;
        let frame = reusable(self.last, planet, lattice, self.settings);
        let (planet, lattice) = (*planet, lattice.0.clone());
        let surface = self.surface.0.clone();
        let wish = self.wish();
        let work = POOL.start(move || {
            let began = std::time::Instant::now();
            let bake = bake(frame, &planet, &lattice, &surface, &wish);
            let milliseconds = began.elapsed().as_secs_f64() * 1e3;
            BakeOutcome { bake, milliseconds }
        });
        BakeJob {
            serial: SERIAL.fetch_add(1, Ordering::Relaxed),
            work,
        }
    }
}

/// Starts bakes of planets whose surface or settings have changed.
fn start(mut commands: Commands, planets: Query<(Entity, BakeQuery), Without<BakeJob>>) {
    for (entity, planet) in &planets {
        if planet.surface.is_empty() || planet.is_done() {
            continue;
        }
        let attempt = Baked {
            version: planet.surface.version,
            wish: planet.wish(),
        };
        if let Err(error) = planet.settings.check() {
            // Told once, not at every new surface.
            if planet.same_wish().is_none() {
                warn!("the planet is not baked: {error}");
                commands.entity(entity).insert(attempt);
            }
            continue;
        }
        commands
            .entity(entity)
            .insert((planet.start_job(), attempt));
    }
}

/// Takes finished bakes in.
fn collect(mut commands: Commands, jobs: Query<(Entity, &BakeJob)>) {
    let mut jobs: Vec<_> = jobs.iter().collect();
    jobs.sort_by_key(|(_, job)| job.serial);
    for (planet, job) in jobs {
        let Some(outcome) = job.work.take() else {
            continue;
        };
        commands.entity(planet).remove::<BakeJob>();
        match outcome.bake {
            Ok(bake) => {
                let finished = BakeFinished {
                    planet,
                    version: bake.version,
                    time: bake.time,
                    milliseconds: outcome.milliseconds,
                };
                commands.entity(planet).insert(PlanetBake(Arc::new(bake)));
                commands.trigger(finished);
            }
            Err(error) => warn!("the planet is not baked: {error}"),
        }
    }
}

#[cfg(test)]
#[path = "plugin_tests.rs"]
mod tests;
