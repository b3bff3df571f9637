//! A bake that follows a running planet in the background.
//!
//! A planet with [`BakeSettings`] is baked whenever its [`PlanetSurface`] has changed and no bake
//! of it is under way. Bakes run on a thread pool of their own: they share the processors with the
//! simulation, but a frame never waits for them. The finished bake is the component [`PlanetBake`],
//! and [`BakeFinished`] is triggered on the planet. The planet's state and its digest are not
//! touched.

use super::bake::{Bake, BakeError, BakeFrame, BakeRules, BakeSource};
use crate::crust::{PlanetSurface, Surface};
use crate::hydrology::base::SPACING;
use crate::planet::{Lattice, Planet};
use crate::sphere::SphereMesh;
use bevy::prelude::*;
use core::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, OnceLock};

/// Follows planets with bakes; see the module.
pub struct BakePlugin;

impl Plugin for BakePlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(Update, (collect, start).chain());
    }
}

/// Asks for bakes of a planet, and says how.
#[derive(Component, Clone, Debug, PartialEq)]
pub struct BakeSettings {
    /// Smallest distance of the base mesh's vertices in radians.
    pub spacing: f64,
    /// Maps, network and rivers.
    pub rules: BakeRules,
}

impl BakeSettings {
    /// Refuses a spacing that is none.
    ///
    /// # Errors
    /// [`BakeError::Spacing`].
    pub fn check(&self) -> Result<(), BakeError> {
        let spacing = self.spacing;
        if spacing > 0.0 && spacing.is_finite() {
            Ok(())
        } else {
            Err(BakeError::Spacing(spacing))
        }
    }

    /// Whether both ask for the same bake. Numbers are compared by their bits: one that is none
    /// would never equal itself, and the planet would be baked for ever.
    fn asks_for_the_same(&self, other: &Self) -> bool {
        let bits =
            |settings: &Self| [settings.spacing, settings.rules.rivers.discharge].map(f64::to_bits);
        let BakeRules {
            climate,
            network,
            rivers,
        } = &self.rules;
        bits(self) == bits(other)
            && rivers.order == other.rules.rivers.order
            && *network == other.rules.network
            && *climate == other.rules.climate
    }
}

impl Default for BakeSettings {
    fn default() -> Self {
        Self {
            spacing: SPACING,
            rules: BakeRules::default(),
        }
    }
}

/// The last finished bake of a planet.
#[derive(Component, Clone, Deref)]
pub struct PlanetBake(pub Arc<Bake>);

/// Bakes a planet as its [`Surface`] is now, and waits for it: for tools and tests. Uses its
/// [`BakeSettings`], or the default ones.
///
/// # Errors
/// [`BakeError`] for settings of which there is no bake; the planet keeps its last one.
pub fn bake_now(world: &mut World, planet: Entity) -> Result<(), BakeError> {
    let settings = world
        .get::<BakeSettings>(planet)
        .cloned()
        .unwrap_or_default();
    let (Some(own), Some(lattice), Some(surface)) = (
        world.get::<Planet>(planet),
        world.get::<Lattice>(planet),
        world.get::<PlanetSurface>(planet),
    ) else {
        return Ok(());
    };
    settings.check()?;
    let frame = reusable(world.get::<PlanetBake>(planet), own, lattice, &settings);
    let bake = bake(frame, own, &lattice.0, surface, &settings)?;
    world.entity_mut(planet).insert(PlanetBake(Arc::new(bake)));
    Ok(())
}

/// The bake of a planet as its surface is; without a frame to use again it makes one.
fn bake(
    frame: Option<Arc<BakeFrame>>,
    planet: &Planet,
    lattice: &SphereMesh,
    surface: &Surface,
    settings: &BakeSettings,
) -> Result<Bake, BakeError> {
    let frame = match frame {
        Some(frame) => frame,
        None => Arc::new(BakeFrame::new(
            planet.seed,
            settings.spacing,
            Some(lattice),
        )?),
    };
    Bake::new(
        &frame,
        planet.radius,
        &BakeSource::Surface(surface),
        &settings.rules,
    )
}

/// The frame of the last bake, if it serves the next one.
fn reusable(
    last: Option<&PlanetBake>,
    planet: &Planet,
    lattice: &Lattice,
    settings: &BakeSettings,
) -> Option<Arc<BakeFrame>> {
    let frame = last?.frame.clone();
    let same = frame.spacing == settings.spacing && frame.base.seed == planet.seed;
    let fits = frame
        .transfer
        .as_ref()
        .is_some_and(|transfer| transfer.samples() == lattice.len());
    (same && fits).then_some(frame)
}

/// A bake is finished; the planet's [`PlanetBake`] is new.
#[derive(EntityEvent, Clone, Debug)]
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
    serial: u64,
    outcome: Arc<Mutex<Option<Outcome>>>,
}

/// The bake, or why there is none, and its wall-clock time in ms.
type Outcome = (Result<Bake, BakeError>, f64);

/// What a planet was last baked from, so that a failure is not tried again and again.
#[derive(Component)]
struct Baked {
    version: u64,
    settings: BakeSettings,
}

/// The pool of all bakes: two threads, or the half of a large machine's.
fn pool() -> Option<&'static rayon::ThreadPool> {
    static POOL: OnceLock<Option<rayon::ThreadPool>> = OnceLock::new();
    POOL.get_or_init(|| {
        let cores = std::thread::available_parallelism().map_or(1, core::num::NonZero::get);
        let name = |k| format!("bake {k}");
        rayon::ThreadPoolBuilder::new()
            .num_threads(cores.min(2).max(cores / 2))
            .thread_name(name)
            .build()
            .ok()
    })
    .as_ref()
}

fn start(
    mut commands: Commands,
    planets: Query<
        (
            Entity,
            &Planet,
            &Lattice,
            &PlanetSurface,
            &BakeSettings,
            Option<&PlanetBake>,
            Option<&Baked>,
        ),
        Without<BakeJob>,
    >,
) {
    static SERIAL: AtomicU64 = AtomicU64::new(0);
    for (entity, planet, lattice, surface, settings, last, baked) in &planets {
        let same = baked.filter(|baked| baked.settings.asks_for_the_same(settings));
        if surface.is_empty() || same.is_some_and(|baked| baked.version == surface.version) {
            continue;
        }
        let wanted = Baked {
            version: surface.version,
            settings: settings.clone(),
        };
        if let Err(error) = settings.check() {
            if same.is_none() {
                warn!("the planet is not baked: {error}");
                commands.entity(entity).insert(wanted);
            }
            continue;
        }
        let Some(pool) = pool() else { return };
        let frame = reusable(last, planet, lattice, settings);
        let (planet, lattice, surface, settings) = (
            *planet,
            lattice.0.clone(),
            surface.0.clone(),
            settings.clone(),
        );
        let outcome = Arc::new(Mutex::new(None));
        let result = outcome.clone();
        pool.spawn(move || {
            let began = std::time::Instant::now();
            let bake = bake(frame, &planet, &lattice, &surface, &settings);
            let milliseconds = began.elapsed().as_secs_f64() * 1e3;
            if let Ok(mut slot) = result.lock() {
                *slot = Some((bake, milliseconds));
            }
        });
        let serial = SERIAL.fetch_add(1, Ordering::Relaxed);
        commands
            .entity(entity)
            .insert((BakeJob { serial, outcome }, wanted));
    }
}

fn collect(mut commands: Commands, jobs: Query<(Entity, &BakeJob)>) {
    let mut jobs: Vec<_> = jobs.iter().collect();
    jobs.sort_by_key(|(_, job)| job.serial);
    for (planet, job) in jobs {
        let Some((bake, milliseconds)) =
            job.outcome.try_lock().ok().and_then(|mut slot| slot.take())
        else {
            continue;
        };
        commands.entity(planet).remove::<BakeJob>();
        let bake = match bake {
            Ok(bake) => bake,
            Err(error) => {
                warn!("the planet is not baked: {error}");
                continue;
            }
        };
        let (version, time) = (bake.version, bake.time);
        commands.entity(planet).insert(PlanetBake(Arc::new(bake)));
        commands.trigger(BakeFinished {
            planet,
            version,
            time,
            milliseconds,
        });
    }
}

#[cfg(test)]
#[path = "plugin_tests.rs"]
mod tests;
