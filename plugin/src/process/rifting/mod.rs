//! Rifting: a plate breaks into two to four (paper 000 §4.4).
//!
//! ```text
//! P = 1 - exp(-lambda)        lambda = lambda_0 f(x_P) A / A_0      f(x) = s + (1 - s) x²
//! ```
//!
//! The printed `lambda exp(-lambda)` falls again beyond lambda = 1. s is the share that oceanic
//! plates keep. Fragments keep the parent's motion and gain opposite turns that open the rift;
//! continental crust along it is thinned, and sinks into margins as isostasy follows. No frame
//! moves and nothing is resampled.
//!
//! | file | what it does |
//! |---|---|
//! | `choice` | draws lines for a plate that breaks by chance |
//! | [`shape`] | lines of fracture, and on which side a sample lies |
//! | `opening` | the motions that open a line |
//! | `plan` | what a line would do to a plate, before anything changes |
//! | `breakup` | does it: columns, frames, plates |

mod breakup;

mod choice;

mod opening;

mod plan;

pub mod shape;

use self::breakup::break_plate;
use self::choice::RiftChoice;
use self::plan::{RiftInput, RiftPlan};
use self::shape::{RiftShape, Warp};
use crate::crust::{Crust, Frames};
use crate::math::{PI, angle_between, exp};
use crate::params::TectonicParams;
use crate::planet::GeologicClock;
use crate::plate::{PlateId, PlateRow, PlateStats, plate_table};
use crate::random::{Purpose, Stream};
use crate::schedule::{CurrentPlanet, Stage, StageTimings, TectonicStep, TectonicSystems};
use crate::view::PlanetQuery;
use bevy::math::DVec3;
use bevy::prelude::*;
use std::time::Instant;
use thiserror::Error;

/// Fewest samples of a plate that rifts by itself: with fewer, fragments would be specks.
const FEWEST_SAMPLES: u32 = 200;

/// Warp of a line that a user draws, as a share of the warp of random lines.
const DRAWN_LINE_WARP: f64 = 0.15;

/// Adds [`rifting`] to the step.
pub struct RiftingPlugin;

impl Plugin for RiftingPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            rifting.in_set(TectonicSystems::Process(Stage::Rifting)),
        );
    }
}

/// Why a plate does not rift.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum RiftError {
    /// There is no such plate.
    #[error("there is no plate {}", .0.0)]
    NoPlate(PlateId),
    /// The line leaves all of the plate on one side.
    #[error("the line does not cross the plate")]
    Misses,
    /// The plate is too small or too long for a rift of its own choice.
    #[error("the plate is too small or too long to break at random")]
    NoShape,
}

/// Breaks the plates of the current planet whose turn has come.
pub fn rifting(world: &mut World) {
    let planet = world.resource::<CurrentPlanet>().0;
    for id in plates_to_rift(world, planet) {
        // A plate without a good shape stays whole; it will be asked again.
        let _ = rift_at_random(world, planet, id, None);
    }
}

/// The plates whose draw of this step says that they break, in order.
fn plates_to_rift(world: &mut World, planet: Entity) -> Vec<PlateId> {
    let plates = plate_table(world, planet);
    let mut query = world.query::<(PlanetQuery, &GeologicClock)>();
    let Ok((body, clock)) = query.get(world, planet) else {
        return Vec::new();
    };
    let view = body.view();
    if !view.params.processes.rifting {
        return Vec::new();
    }
    plates
        .rows()
        .iter()
        .filter(|row| {
            // A stream for each plate, a number for each step: no draw depends on other plates.
            let draws = Stream::new(view.seed, Purpose::RiftTrigger, u64::from(row.id.0));
            row.stats.samples >= FEWEST_SAMPLES
                && draws.unit(clock.step) < probability(view.params, &row.stats, view.radius)
        })
        .map(|row| row.id)
        .collect()
}

/// Probability that a plate rifts within one step.
pub fn probability(params: &TectonicParams, stats: &PlateStats, radius: f64) -> f64 {
    let average = params.plate_share * 4.0 * PI * radius * radius;
    let share = params.rift_oceanic_share;
    let influence = share + (1.0 - share) * stats.continental * stats.continental;
    1.0 - exp(-params.rift_rate * influence * stats.area / average)
}

/// Breaks a plate along a random shape of `fragments` pieces (a random number where none is given).
///
/// # Errors
/// [`RiftError`]; nothing has changed then.
pub fn rift_at_random(
    world: &mut World,
    planet: Entity,
    id: PlateId,
    fragments: Option<u32>,
) -> Result<Vec<PlateId>, RiftError> {
    let start = Instant::now();
    let row = plate_row(world, planet, id)?;
    let choice = RiftChoice::new(world, planet, row, fragments).ok_or(RiftError::NoPlate(id))?;
    for attempt in 0..choice.attempts() {
        let Some(trial) = choice.trial(world, planet, attempt) else {
            continue;
        };
        match rift(world, planet, row, &trial) {
            // A refused shape has changed nothing: the next one is tried.
            Err(RiftError::NoShape | RiftError::Misses) => {}
            Err(error) => return Err(error),
            Ok(plates) => {
                note_time(world, planet, start);
                return Ok(plates);
            }
        }
    }
    Err(RiftError::NoShape)
}

/// Breaks a plate along a line through `points`, unit directions in world coordinates.
///
/// # Errors
/// [`RiftError`]; nothing has changed then.
pub fn rift_along(
    world: &mut World,
    planet: Entity,
    id: PlateId,
    points: Vec<DVec3>,
) -> Result<Vec<PlateId>, RiftError> {
    let start = Instant::now();
    let row = plate_row(world, planet, id)?;
    let choice = RiftChoice::new(world, planet, row, None).ok_or(RiftError::NoPlate(id))?;
    let shortest = points
        .windows(2)
        .map(|ends| angle_between(ends[0], ends[1]))
        .fold(f64::INFINITY, f64::min);
    if points.len() < 2 || shortest < 1e-6 {
        return Err(RiftError::Misses);
    }
    let warp = Warp {
        amplitude: DRAWN_LINE_WARP * choice.warp.amplitude,
        ..choice.warp
    };
    let trial = RiftTrial {
        shape: RiftShape::Path { points, warp },
        // A user may cut off as little as a single sample.
        smallest_share: 0.0,
        far_end: true,
    };
    let plates = rift(world, planet, row, &trial)?;
    note_time(world, planet, start);
    Ok(plates)
}

/// Counts a rift and its time, refused shapes included.
fn note_time(world: &mut World, planet: Entity, start: Instant) {
    if let Some(mut timings) = world.get_mut::<StageTimings>(planet) {
        timings.rift.0 += 1;
        timings.rift.1 += start.elapsed().as_secs_f64() * 1e3;
    }
}

/// A shape that is tried on a plate.
struct RiftTrial {
    shape: RiftShape,
    /// Share of the plate's samples that every fragment must have.
    smallest_share: f64,
    /// At which end of a line the pole of the opening lies.
    far_end: bool,
}

fn plate_row(world: &World, planet: Entity, id: PlateId) -> Result<PlateRow, RiftError> {
    plate_table(world, planet)
        .get(id)
        .copied()
        .ok_or(RiftError::NoPlate(id))
}

/// Breaks a plate along the shape of a trial, if it fits.
fn rift(
    world: &mut World,
    planet: Entity,
    row: PlateRow,
    trial: &RiftTrial,
) -> Result<Vec<PlateId>, RiftError> {
    let mut query = world.query::<(PlanetQuery, &Crust, &Frames)>();
    let Ok((body, crust, frames)) = query.get(world, planet) else {
        return Err(RiftError::NoPlate(row.id));
    };
    let input = RiftInput {
        planet: body.view(),
        crust,
        frames,
        row,
    };
    let plan = RiftPlan::new(&input, trial)?;
    break_plate(world, planet, row, plan).ok_or(RiftError::NoPlate(row.id))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stats(area: f64, continental: f64) -> PlateStats {
        PlateStats {
            area,
            continental,
            ..default()
        }
    }

    #[test]
    fn large_continents_break_first_and_the_chance_never_falls() {
        let params = TectonicParams::default();
        let chance = |area, continental| probability(&params, &stats(area, continental), 6370.0);
        assert!(chance(4e7, 1.0) > chance(1e7, 1.0) && chance(1e7, 1.0) > chance(1e7, 0.2));
        let average = params.plate_share * 4.0 * PI * 6370.0 * 6370.0;
        assert!((chance(average, 1.0) - (1.0 - exp(-params.rift_rate))).abs() < 1e-12);
        let wild = TectonicParams {
            rift_rate: 10.0,
            ..default()
        };
        assert!(
            probability(&wild, &stats(1e8, 1.0), 6370.0) > 0.999,
            "the printed form would be near 0"
        );
    }
}
