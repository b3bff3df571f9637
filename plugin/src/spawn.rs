//! Making a planet: from a recipe to an entity with plates.

use crate::authoring::{Inbox, Recording, Scenario};
use crate::crust::{Crust, Frames, Ledger, PlanetSurface};
use crate::planet::{GeologicClock, Lattice, Planet, PlanetError, PlanetRecipe};
use crate::plate::boundary::Rim;
use crate::plate::contact::Contacts;
use crate::plate::overlap::OverlapIndex;
use crate::plate::terrane::TerraneCensus;
use crate::plate::{Plate, PlateId, PlateMotion, PlateOf, PlateStats, caches};
use crate::process::surface_processes::ReliefNoise;
use crate::resample::Resampling;
use crate::schedule::{StageTimings, StepCursor, TimeDebt};
use crate::sphere::SphereMesh;
use bevy::prelude::*;
use std::sync::Arc;

/// Everything that a planet is made of, before it is in a world: what a recipe or a save file
/// gives.
#[derive(Clone)]
pub struct PlanetState {
    /// Radius and seed.
    pub planet: Planet,
    /// Samples and triangles.
    pub lattice: Lattice,
    /// Crust columns.
    pub crust: Crust,
    /// Frames.
    pub frames: Frames,
    /// Plates in order of their numbers: number, motion, time of birth in My.
    pub plates: Vec<(PlateId, PlateMotion, f64)>,
    /// What each of the plates is made of, as it was found when frames last gained or lost samples:
    /// the plates' rifting and pull go by it until the next time.
    pub stats: Vec<PlateStats>,
    /// The clock.
    pub clock: GeologicClock,
    /// Parameters.
    pub params: crate::params::TectonicParams,
    /// The account of continental crust.
    pub ledger: Ledger,
    /// What was done to the planet.
    pub recording: Recording,
    /// Commands to come.
    pub pending: Scenario,
    /// The memory of subduction polarity.
    pub polarity: crate::plate::polarity::PolarityMemory,
    /// Distances to fronts.
    pub fronts: crate::plate::front::FrontField,
}

impl PlanetState {
    /// Grows the planet that `recipe` describes, at time 0.
    ///
    /// # Errors
    /// [`PlanetError`] names the value of the recipe that is refused.
    pub fn new(recipe: &PlanetRecipe) -> Result<Self, PlanetError> {
        recipe.validate()?;
        Self::on(recipe, Arc::new(SphereMesh::fibonacci(recipe.samples)?))
    }

    /// The same on a mesh that is already there; its number of samples counts, not the recipe's.
    ///
    /// # Errors
    /// As [`PlanetState::new`].
    pub fn on(recipe: &PlanetRecipe, mesh: Arc<SphereMesh>) -> Result<Self, PlanetError> {
        recipe.validate()?;
        let planet = Planet {
            radius: recipe.radius,
            seed: recipe.seed,
        };
        let (motions, owner) = crate::plate::initial_plates(recipe, &mesh);
        let mut crust = crate::plate::initial_crust(recipe, &mesh, &owner);
        crust.frame.clone_from(&owner);
        let plates: Vec<_> = motions
            .into_iter()
            .enumerate()
            .map(|(i, motion)| (PlateId(i as u32), motion, 0.0))
            .collect();
        let frames = Frames(
            plates
                .iter()
                .map(|&(id, ..)| crate::crust::Frame::at_rest(id))
                .collect(),
        );
        let stats =
            crate::plate::stats::plate_stats(&mesh, &crust, &frames, planet.radius, |_| true);
        let stats = stats.into_iter().map(|(_, stats)| stats).collect();
        let initial = crate::crust::ledger::measure(&crust, &mesh, planet.radius);
        let ledger = Ledger {
            initial,
            ..default()
        };
        let fronts = crate::plate::front::FrontField::new(mesh.len());
        let clock = GeologicClock {
            next_plate: plates.len() as u32,
            ..default()
        };
        Ok(Self {
            planet,
            lattice: Lattice(mesh),
            crust,
            frames,
            plates,
            stats,
            clock,
            params: recipe.params.clone(),
            ledger,
            recording: Recording::default(),
            pending: Scenario::default(),
            polarity: default(),
            fronts,
        })
    }

    /// Puts the planet into a world. Returns its entity.
    pub fn spawn(self, world: &mut World) -> Entity {
        let planet = world
            .spawn((
                (
                    self.planet,
                    self.lattice,
                    self.crust,
                    self.frames,
                    self.clock,
                    self.params,
                ),
                (self.ledger, self.recording, self.polarity, self.fronts),
                (
                    Inbox::default(),
                    PlanetSurface::default(),
                    crate::resample::SurfaceProjection::default(),
                ),
                (
                    StepCursor::default(),
                    StageTimings::default(),
                    TimeDebt::default(),
                ),
                (Name::new("planet"), Caches::default()),
            ))
            .id();
        if !self.pending.0.is_empty() {
            world.entity_mut(planet).insert(self.pending);
        }
        let mut plates = Vec::with_capacity(self.plates.len());
        for (id, motion, born) in self.plates {
            let name = Name::new(format!("plate {}", id.0));
            let plate = (
                name,
                PlateOf(planet),
                Plate { born },
                id,
                motion,
                PlateStats::default(),
            );
            plates.push(world.spawn(plate).id());
        }
        restore(world, planet);
        for (plate, stats) in plates.into_iter().zip(self.stats) {
            if let Ok(mut plate) = world.get_entity_mut(plate) {
                plate.insert(stats);
            }
        }
        planet
    }
}

/// What follows from the state or is worked on in slices: never saved.
#[derive(Bundle, Clone, Default)]
pub(crate) struct Caches {
    /// Which frames cover a point.
    overlap: OverlapIndex,
    /// Rims of the frames.
    rim: Rim,
    /// Contacts of the last step.
    contacts: Contacts,
    /// Values of the relief noise.
    noise: ReliefNoise,
    /// Whether terranes are out of date.
    terranes: TerraneCensus,
    /// A resample in progress.
    resampling: Resampling,
}

/// Finds what a planet derives from its state, after it was made or loaded, and projects its
/// surface.
fn restore(world: &mut World, planet: Entity) {
    caches::recompute_but_fronts(world, planet);
    caches::recompute_contacts(world, planet);
    caches::recompute_terranes(world, planet);
    crate::resample::project_now(world, planet);
}

/// `commands.spawn_planet(recipe)`: grows and spawns a planet at the next sync point.
pub trait SpawnPlanet {
    /// Spawns a planet. A refused recipe is logged as an error and spawns nothing; use
    /// [`PlanetState::new`] to handle it.
    fn spawn_planet(&mut self, recipe: PlanetRecipe);
}

impl SpawnPlanet for Commands<'_, '_> {
    fn spawn_planet(&mut self, recipe: PlanetRecipe) {
        self.queue(move |world: &mut World| match PlanetState::new(&recipe) {
            Ok(state) => {
                state.spawn(world);
            }
            Err(error) => error!("{error}"),
        });
    }
}
