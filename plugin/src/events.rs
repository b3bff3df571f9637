//! Events of the simulation, for games to react to: observable, triggered on the planet's entity.
//!
//! Those of commands are in [`authoring`](crate::authoring), those of making a planet in
//! [`spawn`](crate::spawn).
//!
//! ```
//! # use bevy::prelude::*;
//! # use bevy_pangaea::prelude::*;
//! fn shake(event: On<TerraneCollided>) {
//!     info!("a collision of {:.0} km² at {:?}", event.area, event.at);
//! }
//! # App::new().add_observer(shake);
//! ```

use crate::ids::PlateId;
use bevy::math::DVec3;
use bevy::prelude::*;

/// A step has ended.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn note(event: On<StepCompleted>) {
///     info!("step {}: {} My", event.step, event.time);
/// }
/// # App::new().add_observer(note);
/// ```
#[derive(EntityEvent, Clone, Debug, PartialEq, Reflect)]
#[reflect(Event)]
pub struct StepCompleted {
    /// The planet.
    #[event_target]
    pub planet: Entity,
    /// Steps taken so far.
    pub step: u64,
    /// Geological time in My.
    pub time: f64,
}

/// A terrane broke off its plate and was sutured to another.
#[derive(EntityEvent, Clone, Debug, PartialEq, Reflect)]
#[reflect(Event)]
pub struct TerraneCollided {
    /// The planet.
    #[event_target]
    pub planet: Entity,
    /// The plate that lost the terrane.
    pub from: PlateId,
    /// The plate that it was sutured to.
    pub to: PlateId,
    /// Area of the terrane in km².
    pub area: f64,
    /// Unit direction of the deepest point of contact.
    pub at: DVec3,
    /// Relative speed in km/My.
    pub speed: f64,
}

/// A plate broke.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// /// The youngest fragments hurry away.
/// fn hurry(event: On<PlateRifted>, mut commands: Commands) {
///     for &plate in event.fragments.iter().skip(1) {
///         let pole = (90.0, 0.0);
///         let away = TectonicCommand::SetPlateMotion { plate, pole, speed: 80.0 };
///         commands.entity(event.planet).tectonic(away);
///     }
/// }
/// # App::new().add_observer(hurry);
/// ```
#[derive(EntityEvent, Clone, Debug, PartialEq, Reflect)]
#[reflect(Event)]
pub struct PlateRifted {
    /// The planet.
    #[event_target]
    pub planet: Entity,
    /// The plate that broke; the first fragment keeps its number.
    pub parent: PlateId,
    /// The fragments.
    pub fragments: Vec<PlateId>,
}

/// A plate has no crust left.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn lament(event: On<PlateConsumed>) {
///     info!("plate {} is gone", event.plate.0);
/// }
/// # App::new().add_observer(lament);
/// ```
#[derive(EntityEvent, Clone, Debug, PartialEq, Reflect)]
#[reflect(Event)]
pub struct PlateConsumed {
    /// The planet.
    #[event_target]
    pub planet: Entity,
    /// The plate that is gone.
    pub plate: PlateId,
}

/// The crust was resampled and new ocean floor was made.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn measure(event: On<CrustResampled>, clocks: Query<&GeologicClock>) -> Result {
///     let time = clocks.get(event.planet)?.time;
///     info!("{time} My: {:.0} km² of new sea floor", event.new_ocean);
///     Ok(())
/// }
/// # App::new().add_observer(measure);
/// ```
#[derive(EntityEvent, Clone, Debug, PartialEq, Reflect)]
#[reflect(Event)]
pub struct CrustResampled {
    /// The planet.
    #[event_target]
    pub planet: Entity,
    /// Area of new ocean crust in km².
    pub new_ocean: f64,
}
