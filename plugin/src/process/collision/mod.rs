//! Continental collision: a terrane breaks off its slab and is sutured (paper 000 §4.2, §6).
//!
//! *Trigger* (`trigger`): continents of two plates overlap by 300 km, measured along their relative
//! motion from the rim of either plate backwards; half of that in a step that ends with a resample,
//! which would resolve the overlap. *Suture* (`suture`): the smaller of the two terranes takes a
//! new frame owned by the other's plate, with the rotation that it has; no resample is forced.
//! *Surge* (`surge`): continental crust on both sides rises. *Small islands*, below
//! [`TectonicParams::terrane_min_area`](crate::params::TectonicParams::terrane_min_area), do not
//! break off: they are forced down, and booked as such when the crust is resampled.

mod surge;

mod suture;

mod trigger;

pub use suture::smaller_terrane;

use self::suture::{Collision, CollisionInput};
use crate::crust::{Cause, Crust, Frames, Ledger};
use crate::events::TerraneCollided;
use crate::planet::GeologicClock;
use crate::plate::boundary::Rim;
use crate::plate::caches::{MovedSamples, recompute_moved};
use crate::plate::contact::Contacts;
use crate::plate::overlap::OverlapIndex;
use crate::plate::{PlateAccess, PlateTable};
use crate::resample::due;
use crate::schedule::{Stage, TectonicStep, TectonicSystems};
use crate::sphere::nearest_source::SourceScratch;
use crate::view::{PlanetQuery, PlanetView};
use bevy::prelude::*;

/// Share of the trigger's length at which continents collide in a step that ends with a resample:
/// the resample would undo an overlap that is half way to a collision.
const LAST_CHANCE_SHARE: f64 = 0.5;

/// Adds [`collision`] to the step.
pub struct CollisionPlugin;

impl Plugin for CollisionPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            collision.in_set(TectonicSystems::Process(Stage::Collision)),
        );
    }
}

/// Sutures terranes of the current planet.
pub fn collision(
    plates: PlateAccess,
    mut planets: Query<(
        (PlanetQuery, &GeologicClock),
        (&Rim, &Contacts, &OverlapIndex),
        (&mut Crust, &mut Frames, &mut Ledger),
    )>,
    mut commands: Commands,
) {
    let planet = plates.planet();
    let Ok((state, (rim, contacts, overlap), (mut crust, mut frames, mut ledger))) =
        planets.get_mut(planet)
    else {
        return;
    };
    let (body, clock) = state;
    let view = body.view();
    if !view.params.processes.collision {
        return;
    }
    let meeting = trigger::meeting_continents(rim, contacts, &crust);
    if meeting.is_empty() {
        return;
    }
    let table = plates.table();
    let trigger = trigger_length(&view, clock, &table, frames.len());
    let continents = CollisionInput {
        planet: view,
        rim,
        contacts,
        overlap,
        plates: table,
    };
    let places = continents.deep_overlaps(&meeting, trigger, &crust, &frames);
    let (events, moved) = collide(&continents, places, &mut crust, &mut frames, &mut ledger);
    announce(&mut commands, planet, events);
    if !moved.samples.is_empty() {
        // Only afterwards: the caches need the whole world.
        commands.queue(move |world: &mut World| recompute_moved(world, planet, &moved));
    }
}

fn announce(commands: &mut Commands, planet: Entity, events: Vec<TerraneCollided>) {
    for event in events {
        commands.trigger(TerraneCollided { planet, ..event });
    }
}

/// Length of overlap in radians from which continents collide; less before a resample.
fn trigger_length(
    planet: &PlanetView,
    clock: &GeologicClock,
    plates: &PlateTable,
    frames: usize,
) -> f64 {
    let last_chance = due(planet.params, clock, plates, planet.radius, frames);
    let share = if last_chance { LAST_CHANCE_SHARE } else { 1.0 };
    planet.params.collision_trigger / planet.radius * share
}

/// Carries out the collisions at some places of the rim, one after the other. Returns their events
/// and the samples that have a new frame.
fn collide(
    continents: &CollisionInput,
    places: Vec<usize>,
    crust: &mut Crust,
    frames: &mut Frames,
    ledger: &mut Ledger,
) -> (Vec<TerraneCollided>, MovedSamples) {
    let mut events = Vec::new();
    let mut moved = MovedSamples::default();
    let mut scratch = SourceScratch::default();
    for at in places {
        // Each sees what those before it have done.
        let Some(collision) = Collision::find(continents, at, crust, frames) else {
            continue;
        };
        events.push(collision.event(frames));
        for volume in collision.surge(continents, crust, frames, &mut scratch) {
            ledger.book(Cause::CollisionUplift, 0.0, volume);
        }
        let new_frame = collision.reframe(crust, frames);
        moved.frames.extend([new_frame, collision.from]);
        moved.samples.extend(collision.terrane);
    }
    // A terrane may be sutured twice in one step.
    moved.samples.sort_unstable();
    moved.samples.dedup();
    (events, moved)
}
