//! Planets without a window: an app that has the simulation and nothing else.

use crate::error::CliError;
use crate::floor::memory_floor_ms;
use crate::interrupt;
use crate::output::say;
use bevy::prelude::*;
use bevy_pangaea::PangaeaPlugins;
use bevy_pangaea::authoring::{CommandRejected, Scenario, apply_pending};
use bevy_pangaea::control::{PlanetBake, bake_now};
use bevy_pangaea::crust::{Crust, Ledger, PlanetSurface};
use bevy_pangaea::io::stats::StatsInput;
use bevy_pangaea::io::{Timings, capture};
use bevy_pangaea::overlay::OverlayInput;
use bevy_pangaea::params::TectonicParams;
use bevy_pangaea::planet::{GeologicClock, Lattice, Planet, PlanetRecipe};
use bevy_pangaea::plate::PlateTable;
use bevy_pangaea::plate::plate_table;
use bevy_pangaea::resample::project_now;
use bevy_pangaea::schedule::{StageTimings, run_steps};
use bevy_pangaea::spawn::PlanetState;
use bevy_pangaea::sphere::SphereMesh;
use std::sync::Arc;
use std::time::Instant;

/// An app with one planet.
pub struct Headless {
    /// The app.
    pub app: App,
    /// The planet's entity.
    pub planet: Entity,
}

/// The first command that a planet refused.
#[derive(Resource, Default)]
struct FirstRefusal(Option<String>);

impl Headless {
    /// Puts a planet into an app of its own.
    pub fn new(state: PlanetState) -> Self {
        let mut app = App::new();
        app.add_plugins((
            TaskPoolPlugin::default(),
            bevy::time::TimePlugin,
            PangaeaPlugins,
        ));
        app.init_resource::<FirstRefusal>();
        app.add_observer(note_refusal);
        // Nothing runs the app, so that it is completed by hand.
        app.finish();
        app.cleanup();
        let planet = state.spawn(app.world_mut());
        Self { app, planet }
    }

    /// Plays a scenario from now on.
    pub fn play(&mut self, scenario: Option<Scenario>) {
        if let Some(scenario) = scenario {
            self.app
                .world_mut()
                .entity_mut(self.planet)
                .insert(scenario);
        }
    }

    /// Brings the surface that maps and figures read up to date.
    pub fn project(&mut self) {
        project_now(self.app.world_mut(), self.planet);
    }

    /// Bakes the climate, the rivers and the control maps of the surface as it was last projected.
    ///
    /// # Errors
    /// If the planet cannot be baked.
    pub fn bake(&mut self) -> Result<(), CliError> {
        bake_now(self.app.world_mut(), self.planet)
            .map_err(|error| CliError::Failed(error.to_string()))
    }

    /// Takes a step.
    ///
    /// # Errors
    /// The first command of the scenario that the planet refuses, or an interrupt.
    pub fn step(&mut self) -> Result<(), CliError> {
        interrupt::check()?;
        let step = self.get::<GeologicClock>()?.step;
        run_steps(self.app.world_mut(), self.planet, 1);
        self.check_refusal(step)
    }

    /// Carries out the commands that are due between two steps.
    ///
    /// # Errors
    /// The first command that the planet refuses.
    pub fn obey_due(&mut self) -> Result<(), CliError> {
        let step = self.get::<GeologicClock>()?.step;
        apply_pending(self.app.world_mut(), self.planet);
        self.check_refusal(step)
    }

    /// The first command that the planet refused at a step, as an error.
    fn check_refusal(&mut self, step: u64) -> Result<(), CliError> {
        match self.app.world_mut().resource_mut::<FirstRefusal>().0.take() {
            None => Ok(()),
            Some(problem) => Err(CliError::input(format!(
                "a command at step {step} is refused: {problem}"
            ))),
        }
    }

    /// A component of the planet.
    ///
    /// # Errors
    /// If the planet has no such component; every planet has those that commands read.
    pub fn get<T: Component>(&self) -> Result<&T, CliError> {
        self.app.world().get::<T>(self.planet).ok_or_else(|| {
            let name = core::any::type_name::<T>();
            CliError::Failed(format!("the planet lost its {name}"))
        })
    }

    /// The state of the planet.
    ///
    /// # Errors
    /// If the planet is in the middle of a step.
    pub fn state(&self) -> Result<PlanetState, CliError> {
        capture(self.app.world(), self.planet)
            .ok_or_else(|| CliError::Failed("the planet is in the middle of a step".into()))
    }

    /// The plates, ordered by number.
    pub fn plates(&self) -> PlateTable {
        plate_table(self.app.world(), self.planet)
    }

    /// The planet as overlays read it.
    ///
    /// # Errors
    /// As [`get`](Self::get).
    pub fn overlay_input<'a>(
        &'a self,
        plates: &'a PlateTable,
    ) -> Result<OverlayInput<'a>, CliError> {
        let bake = self.app.world().get::<PlanetBake>(self.planet);
        Ok(OverlayInput {
            planet: self.get::<Planet>()?,
            mesh: &self.get::<Lattice>()?.0,
            surface: self.get::<PlanetSurface>()?,
            plates,
            params: self.get::<TectonicParams>()?,
            bake: bake.map(|bake| &*bake.0),
        })
    }

    /// How long the planet took, with the ms that its mesh and the whole of it took.
    ///
    /// # Errors
    /// As [`get`](Self::get).
    pub fn timings(&self, mesh_ms: f64, total_ms: f64) -> Result<Timings, CliError> {
        Ok(Timings {
            mesh: Some(mesh_ms),
            total: Some(total_ms),
            floor: Some(memory_floor_ms(self.get::<Crust>()?)),
            ..Timings::of_stages(self.get::<StageTimings>()?)
        })
    }

    /// The planet as statistics read it.
    ///
    /// # Errors
    /// As [`get`](Self::get).
    pub fn stats_input(&self, plates: usize) -> Result<StatsInput<'_>, CliError> {
        Ok(StatsInput {
            mesh: &self.get::<Lattice>()?.0,
            surface: self.get::<PlanetSurface>()?,
            clock: self.get::<GeologicClock>()?,
            ledger: self.get::<Ledger>()?,
            radius: self.get::<Planet>()?.radius,
            plates,
        })
    }
}

/// Remembers the first command that the planet refuses, for [`Headless::step`] to report.
fn note_refusal(rejected: On<CommandRejected>, mut first: ResMut<FirstRefusal>) {
    first.0.get_or_insert_with(|| rejected.error.to_string());
}

/// A planet at time 0, and how many ms its mesh took. Whatever the recipe asks for and the planet
/// will not have is said on stderr.
///
/// # Errors
/// If the recipe is refused.
pub fn initial_planet(recipe: &PlanetRecipe) -> Result<(PlanetState, f64), CliError> {
    recipe.validate()?;
    for warning in recipe.warnings() {
        say(&format!("warning: {warning}"));
    }
    let start = Instant::now();
    let mesh = SphereMesh::fibonacci(recipe.samples).map_err(CliError::input)?;
    let mesh_ms = start.elapsed().as_secs_f64() * 1e3;
    Ok((PlanetState::on(recipe, Arc::new(mesh))?, mesh_ms))
}
