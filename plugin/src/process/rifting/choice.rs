//! Shapes that a plate tries when it breaks by chance.

use super::RiftTrial;
use super::shape::{RiftShape, Warp};
use crate::crust::{Crust, Frames};
use crate::math::{PI, acos};
use crate::noise::Noise;
use crate::planet::{GeologicClock, Lattice};
use crate::plate::boundary::Rim;
use crate::plate::{PlateId, PlateRow};
use crate::random::{Purpose, Stream};
use crate::view::PlanetQuery;
use bevy::math::DVec3;
use bevy::prelude::*;

/// Least share of the plate's samples in each fragment of a random rift.
const SMALLEST_SHARE: f64 = 0.15;

/// Angular radius in radians of the cap of a plate's area above which the plate breaks by shedding
/// bites.
const WIDE_EXTENT: f64 = 1.2;

/// Angular radius in radians of the cap of a plate's area above which the plate may break all
/// round.
const ALL_ROUND_EXTENT: f64 = 2.0;

/// Least share of the plate's samples in a bite, once [`ATTEMPTS_AT_LARGE_SHARES`] shapes have not
/// given [`SMALLEST_SHARE`].
const SMALLEST_BITE_SHARE: f64 = 0.025;

/// Number of shapes of which each fragment must have [`SMALLEST_SHARE`].
const ATTEMPTS_AT_LARGE_SHARES: u64 = 36;

/// Shapes that are tried on a plate that great circles break, before a random rift is given up.
const ATTEMPTS: u64 = 12;

/// Shapes that are tried on a wide plate, of which most bites are refused.
const WIDE_ATTEMPTS: u64 = 56;

/// Counters of the random numbers of a step: the number of fragments first, then one an attempt.
const DRAWS_PER_STEP: u64 = 64;

/// The first of a step's counters that belongs to an attempt.
const FIRST_ATTEMPT: u64 = 4;

/// How a plate breaks by chance: everything that its shapes are drawn from.
pub(super) struct RiftChoice {
    row: PlateRow,
    stream: Stream,
    step: u64,
    /// Extent of the plate in radians: the root of its area.
    reach: f64,
    fragments: u32,
    /// Angular radius of the cap that has the plate's area.
    extent: f64,
    /// Warp of random lines.
    pub(super) warp: Warp,
}

impl RiftChoice {
    /// The choice of a plate in this step, with a random number of fragments where none is given.
    pub(super) fn new(
        world: &mut World,
        planet: Entity,
        row: PlateRow,
        fragments: Option<u32>,
    ) -> Option<Self> {
        let mut query = world.query::<(PlanetQuery, &GeologicClock)>();
        let (body, clock) = query.get(world, planet).ok()?;
        let view = body.view();
        let id = u64::from(row.id.0);
        let reach = (row.stats.area / PI).sqrt() / view.radius;
        // A cap of radius e has the area 2π (1 - cos e), the plate π reach².
        let extent = acos(1.0 - 0.5 * reach * reach);
        let stream = Stream::new(view.seed, Purpose::RiftShape, id);
        let draw = stream.unit(DRAWS_PER_STEP * clock.step);
        // The lines of a junction cannot all open on a wide plate.
        let drawn = if draw < view.params.rift_in_two || extent > WIDE_EXTENT {
            2
        } else if draw < view.params.rift_up_to_three {
            3
        } else {
            4
        };
        Some(Self {
            row,
            stream,
            step: clock.step,
            reach,
            fragments: fragments.unwrap_or(drawn),
            extent,
            warp: Warp {
                noise: Noise::new(view.seed, Purpose::RiftWarp, id << 32 | clock.step),
                // As for initial borders, about two bends over the extent of the plate.
                amplitude: 0.5 * view.params.border_warp * reach,
                frequency: 2.0 / reach.max(0.01),
            },
        })
    }

    /// Whether no great circle breaks the plate in two.
    fn is_wide(&self) -> bool {
        self.fragments == 2 && self.extent > WIDE_EXTENT
    }

    /// Shapes that are tried.
    pub(super) fn attempts(&self) -> u64 {
        if self.is_wide() {
            WIDE_ATTEMPTS
        } else {
            ATTEMPTS
        }
    }

    /// The shape of an attempt; `None` if the plate has no rim to bite.
    pub(super) fn trial(&self, world: &World, planet: Entity, attempt: u64) -> Option<RiftTrial> {
        let counter = FIRST_ATTEMPT + DRAWS_PER_STEP * self.step + attempt;
        Some(RiftTrial {
            shape: self.shape(world, planet, attempt, counter)?,
            smallest_share: if attempt < ATTEMPTS_AT_LARGE_SHARES {
                SMALLEST_SHARE
            } else {
                SMALLEST_BITE_SHARE
            },
            far_end: self.stream.bits(counter) & 1 == 0,
        })
    }

    /// Of a wide plate, every fourth attempt is a great circle, a few whole circles, the rest
    /// bites.
    fn shape(
        &self,
        world: &World,
        planet: Entity,
        attempt: u64,
        counter: u64,
    ) -> Option<RiftShape> {
        let Self {
            row, stream, warp, ..
        } = self;
        if self.is_wide() && self.extent > ALL_ROUND_EXTENT && attempt % 16 == 15 {
            return Some(RiftShape::halves(stream, counter, *warp));
        }
        if self.is_wide() && !attempt.is_multiple_of(4) {
            let draw = stream.bits(16 * counter + 9);
            let (at, outward) = place_on_border(world, planet, row.id, draw)?;
            return Some(RiftShape::bite(stream, counter, at, outward, *warp));
        }
        let centroid = row.stats.centroid;
        let fragments = self.fragments;
        Some(RiftShape::random(
            stream, counter, centroid, self.reach, fragments, *warp,
        ))
    }
}

/// A place on the rim of a plate, which the number `draw` chooses, and the rim's outward normal, in
/// world coordinates.
fn place_on_border(
    world: &World,
    planet: Entity,
    id: PlateId,
    draw: u64,
) -> Option<(DVec3, DVec3)> {
    let (lattice, rim) = (world.get::<Lattice>(planet)?, world.get::<Rim>(planet)?);
    let (crust, frames) = (world.get::<Crust>(planet)?, world.get::<Frames>(planet)?);
    let frame = |k: usize| frames[usize::from(crust.frame[rim.samples[k] as usize])];
    let start = (draw % rim.len().max(1) as u64) as usize;
    // The first sample of the plate from the drawn place on, all the way round.
    let k = (start..rim.len())
        .chain(0..start)
        .find(|&k| frame(k).plate == id)?;
    Some((
        frame(k).to_world(lattice.point(rim.samples[k])),
        frame(k).to_world(rim.normal[k]),
    ))
}
