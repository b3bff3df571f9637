//! The stages of a step, and the schedules and sets that they make.

use crate::named::named_enum;
use bevy::ecs::schedule::ScheduleLabel;
use bevy::prelude::*;

/// The schedule of one tectonic step. Its sets are [`TectonicSystems`].
#[derive(ScheduleLabel, Clone, Debug, PartialEq, Eq, Hash)]
pub struct TectonicStep;

/// The schedule of a planet that rests between two steps, run once a frame; [`CurrentPlanet`] names
/// the planet.
#[derive(ScheduleLabel, Clone, Debug, PartialEq, Eq, Hash)]
pub struct BetweenSteps;

/// The sets of [`BetweenSteps`], in order.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BetweenStepsSystems {
    /// Commands of the user take effect.
    Commands,
    /// Caches are brought up to date.
    Caches,
}

named_enum! {
    /// The stages of a step, in order.
    pub enum Stage {
        /// Commands of the user take effect.
        Commands = "commands",
        /// Frames rotate with their plates.
        Drift = "drift",
        /// Where plates meet, and which goes under.
        Contact = "contact",
        /// Overriding plates rise.
        Subduction = "subduction",
        /// Subducting plates turn towards their fronts.
        SlabPull = "slab pull",
        /// Terranes break off and are sutured.
        Collision = "collision",
        /// Plates break.
        Rifting = "rifting",
        /// Erosion, subsidence, sediment, isostasy, noise.
        SurfaceProcesses = "surface processes",
        /// When it is due: even samples again, and new ocean crust.
        Resample = "resample",
        /// The clock ticks and the ledger is checked.
        Commit = "commit",
        /// When someone looks at the planet: its surface is projected.
        Projection = "projection",
    }
}

/// The sets of [`TectonicStep`], all in one chain: `Process(s)` then `After(s)` for every stage in
/// order.
///
/// A stage that holds runs its `Process` set several times in one step; `After` runs once.
/// A geological process of your own goes into the `After` set of the stage that it follows:
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn survey(current: Res<CurrentPlanet>, planets: Query<&Crust>) {
///     if let Ok(crust) = planets.get(current.0) {
///         let summit = crust.elevation.iter().copied().fold(f32::MIN, f32::max);
///         info!("the highest summit stands at {summit:.1} km");
///     }
/// }
///
/// let mut app = App::new();
/// app.add_plugins(PangaeaPlugins).add_systems(
///     TectonicStep,
///     survey.in_set(TectonicSystems::After(Stage::SurfaceProcesses)),
/// );
/// ```
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TectonicSystems {
    /// The stage's own systems.
    Process(Stage),
    /// Once per step, when the stage has ended.
    After(Stage),
}

impl TectonicSystems {
    /// Number of sets in the chain.
    pub(super) const COUNT: usize = 2 * Stage::COUNT;

    /// The set at a position of the chain, which is below [`Self::COUNT`].
    pub(super) fn at(position: usize) -> Self {
        let stage = Stage::ALL[position / 2];
        if position.is_multiple_of(2) {
            Self::Process(stage)
        } else {
            Self::After(stage)
        }
    }
}

/// The planet that [`TectonicStep`] works on. The runner sets it.
#[derive(Resource, Clone, Copy, Debug, PartialEq, Eq, Reflect)]
#[reflect(Resource)]
pub struct CurrentPlanet(pub Entity);
