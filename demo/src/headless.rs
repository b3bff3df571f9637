//! Planets without a window: an app that has the simulation and nothing else.

use crate::cli::GrowthArgs;
use crate::course::Course;
use crate::error::CliError;
use crate::interrupt;
use bevy::prelude::*;
use bevy_pangaea::PangaeaPlugins;
use bevy_pangaea::authoring::CommandRejected;
use bevy_pangaea::authoring::Scenario;
use bevy_pangaea::climate::ClimateMaps;
use bevy_pangaea::control::{BakeRules, BakeSettings, PlanetBake, bake_now};
use bevy_pangaea::crust::{Ledger, PlanetSurface};
use bevy_pangaea::io::stats::StatsInput;
use bevy_pangaea::io::{capture, load};
use bevy_pangaea::overlay::OverlayInput;
use bevy_pangaea::params::TectonicParams;
use bevy_pangaea::planet::{GeologicClock, Lattice, Planet, PlanetRecipe};
use bevy_pangaea::plate::PlateTable;
use bevy_pangaea::plate::plate_table;
use bevy_pangaea::resample::project_now;
use bevy_pangaea::schedule::run_steps;
use bevy_pangaea::spawn::PlanetState;
use bevy_pangaea::sphere::SphereMesh;
use std::path::Path;
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
struct Refused(Option<String>);

impl Headless {
    /// Puts a planet into an app of its own.
    pub fn new(state: PlanetState) -> Self {
        let mut app = App::new();
        app.add_plugins((
            TaskPoolPlugin::default(),
            bevy::time::TimePlugin,
            PangaeaPlugins,
        ));
        app.init_resource::<Refused>();
        app.add_observer(
            |rejected: On<CommandRejected>, mut refused: ResMut<Refused>| {
                refused.0.get_or_insert_with(|| rejected.error.to_string());
            },
        );
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

    /// Renews the surface that maps and figures read.
    pub fn look(&mut self) {
        project_now(self.app.world_mut(), self.planet);
    }

    /// Bakes the climate, but for what `maps` give, the rivers and the control maps of the surface
    /// as it was last looked at.
    ///
    /// # Errors
    /// If the planet cannot be baked.
    pub fn bake(&mut self, maps: ClimateMaps) -> Result<(), CliError> {
        let rules = BakeRules {
            climate: maps,
            ..default()
        };
        self.app
            .world_mut()
            .entity_mut(self.planet)
            .insert(BakeSettings { rules, ..default() });
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
        match self.app.world_mut().resource_mut::<Refused>().0.take() {
            None => Ok(()),
            Some(problem) => Err(CliError::input(format!(
                "a command at step {step} is refused: {problem}"
            ))),
        }
    }

    /// A component of the planet; every planet has those that are asked for here.
    pub fn get<T: Component>(&self) -> Result<&T, CliError> {
        let missing = || {
            CliError::Failed(format!(
                "the planet lost its {}",
                core::any::type_name::<T>()
            ))
        };
        self.app.world().get::<T>(self.planet).ok_or_else(missing)
    }

    /// The state of the planet.
    pub fn state(&self) -> Result<PlanetState, CliError> {
        let torn = || CliError::Failed("the planet is in the middle of a step".into());
        capture(self.app.world(), self.planet).ok_or_else(torn)
    }

    /// The plates, ordered by number.
    pub fn plates(&self) -> PlateTable {
        plate_table(self.app.world(), self.planet)
    }

    /// What overlays look at.
    pub fn overlay_input<'a>(
        &'a self,
        plates: &'a PlateTable,
    ) -> Result<OverlayInput<'a>, CliError> {
        Ok(OverlayInput {
            planet: self.get::<Planet>()?,
            mesh: &self.get::<Lattice>()?.0,
            surface: self.get::<PlanetSurface>()?,
            plates,
            params: self.get::<TectonicParams>()?,
            bake: self
                .app
                .world()
                .get::<PlanetBake>(self.planet)
                .map(|bake| &*bake.0),
        })
    }

    /// What figures are computed from.
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

/// A planet at time 0, and how long its mesh took in ms.
pub fn sprout(recipe: &PlanetRecipe) -> Result<(PlanetState, f64), CliError> {
    recipe.validate()?;
    let start = Instant::now();
    let mesh = SphereMesh::fibonacci(recipe.samples).map_err(CliError::input)?;
    let mesh_ms = start.elapsed().as_secs_f64() * 1e3;
    Ok((PlanetState::on(recipe, Arc::new(mesh))?, mesh_ms))
}

/// A planet, or all that is needed to grow it.
pub enum Seedling {
    /// A planet that stays as it is.
    Saved(Box<PlanetState>),
    /// One that is still to come.
    Sown(Box<PlanetRecipe>, Course),
}

impl Seedling {
    /// The planet in a file, or the one that the options describe.
    ///
    /// # Errors
    /// If the file, or what the options say, is refused.
    pub fn new(file: Option<&Path>, args: &GrowthArgs) -> Result<Self, CliError> {
        set_threads(args.threads)?;
        if let Some(path) = file {
            return Ok(Self::Saved(Box::new(load(path)?)));
        }
        let recipe = args.recipe.checked()?;
        let course = Course::new(args, recipe.params.time_step)?;
        Ok(Self::Sown(Box::new(recipe), course))
    }

    /// Radius in km.
    pub fn radius(&self) -> f64 {
        match self {
            Self::Saved(state) => state.planet.radius,
            Self::Sown(recipe, _) => recipe.radius,
        }
    }

    /// Grows it, with a progress bar; that may take minutes.
    ///
    /// # Errors
    /// If a command of the scenario is refused, or the user interrupts it.
    pub fn grow(self) -> Result<PlanetState, CliError> {
        match self {
            Self::Saved(state) => Ok(*state),
            Self::Sown(recipe, course) => {
                let mut headless = Headless::new(sprout(&recipe)?.0);
                course.run(&mut headless)?;
                headless.state()
            }
        }
    }
}

/// Sets the number of threads of all parallel loops.
pub fn set_threads(threads: Option<u64>) -> Result<(), CliError> {
    let Some(threads) = threads else {
        return Ok(());
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads as usize);
    pool.build_global()
        .map_err(|error| CliError::Failed(format!("cannot start {threads} threads: {error}")))
}
