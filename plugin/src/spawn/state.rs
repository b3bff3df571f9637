//! The state of a planet, before it is in a world.

use crate::authoring::{Recording, Scenario};
use crate::climate::ClimateMaps;
use crate::crust::{Crust, Frame, Frames, Ledger, ledger};
use crate::hydrology::TerrainMaps;
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet, PlanetError, PlanetRecipe, PlateNumbers};
use crate::plate::front::FrontField;
use crate::plate::polarity::PolarityMemory;
use crate::plate::{PlateId, PlateMotion, PlateStats, initial_crust, initial_plates, stats};
use crate::sphere::SphereMesh;
use bevy::prelude::*;
use std::sync::Arc;

/// Everything that a planet is made of, before it is in a world: what a recipe or a save file
/// gives.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// # fn main() -> Result<(), PlanetError> {
/// let recipe = PlanetRecipe { samples: 500, ..default() };
/// let mut state = PlanetState::new(&recipe)?;
/// // Whatever is changed here is the planet's state at time 0.
/// state.params.processes.rifting = false;
///
/// let mut app = App::new();
/// app.add_plugins(PangaeaPlugins);
/// let planet = state.spawn(app.world_mut());
/// run_steps(app.world_mut(), planet, 1);
/// # Ok(())
/// # }
/// ```
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
    /// Sizes and shares of the plates, in the same order, as they were found when frames last
    /// gained or lost samples: rifting and slab pull go by them until the next time.
    pub stats: Vec<PlateStats>,
    /// The clock.
    pub clock: GeologicClock,
    /// The numbers of plates that are used up.
    pub numbers: PlateNumbers,
    /// Parameters.
    pub params: TectonicParams,
    /// The account of continental crust.
    pub ledger: Ledger,
    /// The commands that were carried out.
    pub recording: Recording,
    /// Commands to come.
    pub pending: Scenario,
    /// The memory of subduction polarity.
    pub polarity: PolarityMemory,
    /// Distances to fronts.
    pub fronts: FrontField,
    /// Maps that replace fields of the climate.
    pub climate: ClimateMaps,
    /// Maps that the planet is made of, where it was not grown.
    pub terrain: Option<TerrainMaps>,
}

impl PlanetState {
    /// Grows the planet that `recipe` describes, at time 0.
    ///
    /// ```
    /// # use bevy_pangaea::prelude::*;
    /// let recipe = PlanetRecipe { samples: 500, ..Default::default() };
    /// let state = PlanetState::new(&recipe)?;
    /// assert_eq!(state.plates.len(), 40);
    /// # Ok::<(), PlanetError>(())
    /// ```
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
        let (motions, owner) = initial_plates(recipe, &mesh);
        let mut crust = initial_crust(recipe, &mesh, &owner);
        crust.frame.clone_from(&owner);
        Ok(Self::with_crust(recipe, mesh, motions, crust))
    }

    /// The planet at time 0 whose crust lies on plates with these motions; a plate's frame has its
    /// place in the list. Of the recipe count seed, radius and parameters.
    pub(super) fn with_crust(
        recipe: &PlanetRecipe,
        mesh: Arc<SphereMesh>,
        motions: Vec<PlateMotion>,
        crust: Crust,
    ) -> Self {
        let (numbers, plates) = numbered(motions);
        let frames = Frames(plates.iter().map(|&(id, ..)| Frame::at_rest(id)).collect());
        let stats = stats::plate_stats(&mesh, &crust, &frames, recipe.radius, |_| true);
        Self {
            planet: Planet {
                radius: recipe.radius,
                seed: recipe.seed,
            },
            ledger: Ledger {
                initial: ledger::measure(&crust, &mesh, recipe.radius),
                ..default()
            },
            fronts: FrontField::new(mesh.len()),
            lattice: Lattice(mesh),
            crust,
            frames,
            plates,
            stats: stats.into_iter().map(|(_, stats)| stats).collect(),
            clock: GeologicClock::default(),
            numbers,
            params: recipe.params.clone(),
            recording: Recording::default(),
            pending: Scenario::default(),
            polarity: PolarityMemory::default(),
            climate: ClimateMaps::default(),
            terrain: None,
        }
    }
}

/// Numbers for new plates, and the plates: their numbers, motions and times of birth.
fn numbered(motions: Vec<PlateMotion>) -> (PlateNumbers, Vec<(PlateId, PlateMotion, f64)>) {
    let mut numbers = PlateNumbers::default();
    let plates = motions
        .into_iter()
        .map(|motion| (numbers.issue(), motion, 0.0))
        .collect();
    (numbers, plates)
}
