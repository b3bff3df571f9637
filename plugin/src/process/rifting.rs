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
//! Reads: plates, crust. Writes: plates, frames, thickness.

use super::rift_shape::{RiftShape, Warp};
use crate::crust::{Cause, Crust, Frame, FrameId, Frames, Ledger};
use crate::events::PlateRifted;
use crate::math::{PI, acos, exp};
use crate::noise::Noise;
use crate::params::TectonicParams;
use crate::planet::planet_radius;
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::plate::boundary::Rim;
use crate::plate::caches::{MovedSamples, recompute_moved};
use crate::plate::plate_table;
use crate::plate::{Plate, PlateId, PlateMotion, PlateOf, PlateRow, PlateStats};
use crate::random::{Purpose, Stream};
use crate::schedule::{CurrentPlanet, Stage, StageTimings, TectonicStep, TectonicSystems};
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;
use std::time::Instant;
use thiserror::Error;

/// Plates with fewer samples do not rift by themselves.
const FEWEST_SAMPLES: u32 = 200;

/// Each fragment of a random rift has at least this share of the plate.
const SMALLEST_SHARE: f64 = 0.15;

/// Plates that fill a cap of more than so many radians break by shedding bites.
const WIDE: f64 = 1.2;

/// A plate that fills a cap of more than so many radians may break all round.
const ALL_ROUND: f64 = 2.0;

/// A bite has at least this share of the plate, where none of the first [`PATIENCE`] shapes gives a
/// larger one.
const SMALLEST_BITE: f64 = 0.025;
const PATIENCE: u64 = 36;

/// Shapes that are tried before a random rift is given up: of plates that great circles break, and
/// of wide ones.
const ATTEMPTS: u64 = 12;
const WIDE_ATTEMPTS: u64 = 56;

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
    let Some(params) = world.get::<TectonicParams>(planet).cloned() else {
        return;
    };
    if !params.processes.rifting {
        return;
    }
    let Some(&Planet { seed, radius }) = world.get::<Planet>(planet) else {
        return;
    };
    let Some(step) = world.get::<GeologicClock>(planet).map(|clock| clock.step) else {
        return;
    };
    for row in plate_table(world, planet).rows() {
        let chance = probability(&params, &row.stats, radius);
        let draw = Stream::new(seed, Purpose::RiftTrigger, u64::from(row.id.0)).unit(step);
        if row.stats.samples >= FEWEST_SAMPLES && draw < chance {
            // A plate without a good shape stays whole; it will be asked again.
            let _ = rift_at_random(world, planet, row.id, None);
        }
    }
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
    let (row, stream, warp) = prepare(world, planet, id)?;
    let reach = (row.stats.area / PI).sqrt() / planet_radius(world, planet);
    // The cap of the same area.
    let extent = acos(1.0 - 0.5 * reach * reach);
    let step = world
        .get::<GeologicClock>(planet)
        .map_or(0, |clock| clock.step);
    let count = fragments.unwrap_or_else(|| match stream.unit(64 * step) {
        u if u < 0.75 || extent > WIDE => 2,
        u if u < 0.93 => 3,
        _ => 4,
    });
    let wide = count == 2 && extent > WIDE;
    for attempt in 0..if wide { WIDE_ATTEMPTS } else { ATTEMPTS } {
        let counter = 4 + 64 * step + attempt;
        let far_end = stream.bits(counter) & 1 == 0;
        let shape = if wide && extent > ALL_ROUND && attempt % 16 == 15 {
            RiftShape::halves(&stream, counter, warp)
        } else if wide && attempt % 4 != 0 {
            let Some((at, outward)) = border(world, planet, id, stream.bits(16 * counter + 9))
            else {
                continue;
            };
            RiftShape::bite(&stream, counter, at, outward, warp)
        } else {
            RiftShape::random(&stream, counter, row.stats.centroid, reach, count, warp)
        };
        let smallest = if attempt < PATIENCE {
            SMALLEST_SHARE
        } else {
            SMALLEST_BITE
        };
        match rift(world, planet, id, &shape, smallest, far_end) {
            Err(RiftError::NoShape | RiftError::Misses) => {}
            done => return done,
        }
    }
    Err(RiftError::NoShape)
}

/// A place on the rim of a plate, which the number `draw` chooses, and the rim's outward normal, in
/// world coordinates.
fn border(world: &World, planet: Entity, id: PlateId, draw: u64) -> Option<(DVec3, DVec3)> {
    let (lattice, rim) = (world.get::<Lattice>(planet)?, world.get::<Rim>(planet)?);
    let (crust, frames) = (world.get::<Crust>(planet)?, world.get::<Frames>(planet)?);
    let frame = |k: usize| frames[usize::from(crust.frame[rim.samples[k] as usize])];
    let start = (draw % rim.len().max(1) as u64) as usize;
    let k = (start..rim.len())
        .chain(0..start)
        .find(|&k| frame(k).plate == id)?;
    Some((
        frame(k).to_world(lattice.point(rim.samples[k])),
        frame(k).to_world(rim.normal[k]),
    ))
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
    let (_, _, warp) = prepare(world, planet, id)?;
    let length = points
        .windows(2)
        .map(|w| crate::math::angle_between(w[0], w[1]))
        .fold(f64::INFINITY, f64::min);
    if points.len() < 2 || length < 1e-6 {
        return Err(RiftError::Misses);
    }
    let warp = Warp {
        amplitude: 0.15 * warp.amplitude,
        ..warp
    };
    rift(
        world,
        planet,
        id,
        &RiftShape::Path { points, warp },
        0.0,
        true,
    )
}

fn prepare(
    world: &World,
    planet: Entity,
    id: PlateId,
) -> Result<(PlateRow, Stream, Warp), RiftError> {
    let row = *plate_table(world, planet)
        .get(id)
        .ok_or(RiftError::NoPlate(id))?;
    let seed = world.get::<Planet>(planet).map_or(0, |planet| planet.seed);
    let step = world
        .get::<GeologicClock>(planet)
        .map_or(0, |clock| clock.step);
    let amount = world
        .get::<TectonicParams>(planet)
        .map_or(0.0, |params| params.border_warp);
    let reach = (row.stats.area / PI).sqrt() / planet_radius(world, planet);
    let noise = Noise::new(seed, Purpose::RiftWarp, u64::from(id.0) << 32 | step);
    let warp = Warp {
        noise,
        amplitude: 0.5 * amount * reach,
        frequency: 2.0 / reach.max(0.01),
    };
    Ok((
        row,
        Stream::new(seed, Purpose::RiftShape, u64::from(id.0)),
        warp,
    ))
}

/// A plate's samples: number, fragment, distance from the fracture in radians, world direction.
struct Split {
    sample: u32,
    fragment: u8,
    distance: f32,
    world: DVec3,
}

/// Splits every `stride`-th sample of a plate; distances beyond `near` radians need only lie beyond
/// it.
fn split(
    mesh: &SphereMesh,
    crust: &Crust,
    frames: &Frames,
    id: PlateId,
    shape: &RiftShape,
    near: f64,
    stride: usize,
) -> Vec<Split> {
    let own: Vec<bool> = frames.iter().map(|frame| frame.plate == id).collect();
    crate::parallel::map_chunks(crust.len(), |range| {
        range
            .step_by(stride)
            .filter(|&i| own[usize::from(crust.frame[i])])
            .map(|i| {
                let world = frames[usize::from(crust.frame[i])].to_world(mesh.points()[i]);
                let (fragment, distance) = shape.split(world, near);
                Split {
                    sample: i as u32,
                    fragment: fragment as u8,
                    distance: distance as f32,
                    world,
                }
            })
            .collect::<Vec<_>>()
    })
    .into_iter()
    .flatten()
    .collect()
}

/// Breaks a plate along `shape`. Fragments smaller than `smallest` of its samples refuse the shape.
fn rift(
    world: &mut World,
    planet: Entity,
    id: PlateId,
    shape: &RiftShape,
    smallest: f64,
    far_end: bool,
) -> Result<Vec<PlateId>, RiftError> {
    let start = Instant::now();
    let row = *plate_table(world, planet)
        .get(id)
        .ok_or(RiftError::NoPlate(id))?;
    let mut query = world.query::<(
        (&Planet, &Lattice, &TectonicParams, &mut GeologicClock),
        (&mut Crust, &mut Frames, &mut Ledger, &mut StageTimings),
    )>();
    let Ok(((body, lattice, params, mut clock), (mut crust, mut frames, mut ledger, mut timings))) =
        query.get_mut(world, planet)
    else {
        return Err(RiftError::NoPlate(id));
    };
    let speed = params.rift_speed.min(params.max_speed) / body.radius;
    let near = params.rift_width / body.radius;
    let opens = |parts: &[Split]| {
        check_shares(parts, shape, smallest)?;
        let plate: Vec<DVec3> = parts.iter().map(|part| part.world).collect();
        shape
            .motions(&plate, speed, far_end)
            .ok_or(RiftError::NoShape)
    };
    // Most random shapes are refused; some hundred samples are enough to see it.
    let stride = (row.stats.samples as usize / 400).clamp(1, 64);
    if smallest > 0.0 && stride > 1 {
        opens(&split(lattice, &crust, &frames, id, shape, near, stride))?;
    }
    let parts = split(lattice, &crust, &frames, id, shape, near, 1);
    let gained = opens(&parts)?;
    let fragments = shape.fragments();
    // The parent's motion is held back so that no fragment exceeds the highest speed.
    let limit = params.max_speed / body.radius;
    let most = gained
        .iter()
        .map(|omega| omega.length())
        .fold(0.0, f64::max);
    let parent = row
        .motion
        .limited((limit - most).max(0.0))
        .angular_velocity();
    let volume = thin(&mut crust, lattice, &parts, params, body.radius);
    ledger.book(Cause::Rifting, 0.0, volume * body.radius * body.radius);
    let ids: Vec<PlateId> = (0..fragments)
        .map(|k| {
            if k == 0 {
                id
            } else {
                PlateId(clock.next_plate + k as u32 - 1)
            }
        })
        .collect();
    clock.next_plate += fragments as u32 - 1;
    reframe(&mut crust, &mut frames, &parts, &ids);
    let touched = (0..)
        .zip(frames.iter())
        .filter(|(_, frame)| ids.contains(&frame.plate));
    let moved = MovedSamples {
        samples: parts
            .iter()
            .filter(|part| part.fragment > 0)
            .map(|part| part.sample)
            .collect(),
        frames: touched.map(|(id, _)| id).collect(),
    };
    let now = clock.time;
    timings.rift.0 += 1;
    for (k, &fragment) in ids.iter().enumerate() {
        let motion = PlateMotion::from_angular_velocity(parent + gained[k]);
        let born = Plate { born: now };
        if k == 0 {
            world.entity_mut(row.entity).insert((motion, born));
        } else {
            let name = Name::new(format!("plate {}", fragment.0));
            world.spawn((
                name,
                PlateOf(planet),
                born,
                fragment,
                motion,
                PlateStats::default(),
            ));
        }
    }
    recompute_moved(world, planet, &moved);
    if let Some(mut timings) = world.get_mut::<StageTimings>(planet) {
        timings.rift.1 += start.elapsed().as_secs_f64() * 1e3;
    }
    world.trigger(PlateRifted {
        planet,
        parent: id,
        fragments: ids.clone(),
    });
    Ok(ids)
}

/// Refuses a shape that leaves a fragment less than the share `smallest` of the samples, or none.
fn check_shares(parts: &[Split], shape: &RiftShape, smallest: f64) -> Result<(), RiftError> {
    let mut count = vec![0usize; shape.fragments()];
    parts
        .iter()
        .for_each(|part| count[usize::from(part.fragment)] += 1);
    let fewest = ((smallest * parts.len() as f64) as usize).max(1);
    if count.iter().all(|&c| c >= fewest) {
        Ok(())
    } else {
        Err(RiftError::Misses)
    }
}

/// Thins continental crust beside the fracture. Returns the change of volume per square of the
/// radius.
fn thin(
    crust: &mut Crust,
    mesh: &SphereMesh,
    parts: &[Split],
    params: &TectonicParams,
    radius: f64,
) -> f64 {
    let width = params.rift_width / radius;
    let mut volume = 0.0;
    for part in parts {
        let i = part.sample as usize;
        let fade = 1.0 - crate::math::smoothstep(f64::from(part.distance) / width.max(1e-9));
        if fade > 0.0 && crust.is_continental(i) {
            let before = crust.thickness[i];
            crust.thickness[i] = before * (1.0 - params.rift_thinning * fade) as f32;
            volume += f64::from(crust.thickness[i] - before) * mesh.areas()[i];
        }
    }
    volume
}

/// Gives the samples of all fragments but the first new frames, one for each frame that the plate
/// had.
fn reframe(crust: &mut Crust, frames: &mut Frames, parts: &[Split], ids: &[PlateId]) {
    let mut fresh: Vec<((FrameId, u8), FrameId)> = Vec::new();
    for part in parts.iter().filter(|part| part.fragment > 0) {
        let i = part.sample as usize;
        let key = (crust.frame[i], part.fragment);
        let known = fresh
            .iter()
            .find(|entry| entry.0 == key)
            .map(|entry| entry.1);
        let id = known.unwrap_or_else(|| {
            let id = frames.len() as FrameId;
            let old = frames[usize::from(key.0)];
            frames.push(Frame {
                plate: ids[usize::from(key.1)],
                ..old
            });
            fresh.push((key, id));
            id
        });
        crust.frame[i] = id;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_continents_break_first_and_the_chance_never_falls() {
        let params = TectonicParams::default();
        let stats = |area: f64, continental: f64| PlateStats {
            area,
            continental,
            ..default()
        };
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
