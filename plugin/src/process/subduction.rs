//! Subduction: ocean crust sinks, and the overriding plate rises (paper 000 §4.1).
//!
//! ```text
//! z' = z + u dt         f' = f + beta f(d) (s_j - s_i) dt
//! ```
//!
//! u is the [`uplift`](super::uplift) and saturates towards z_c. The paper's fold direction turns
//! by beta (s_i - s_j): here it has the opposite sign, which is the same axis, and fades with the
//! distance from the front as the uplift does. Orogeny becomes Andean where continental crust rises
//! faster than `orogeny_rate`, unless a collision folded it in the last `himalayan_memory` My.
//! Thickness follows by isostasy; on continents it is booked as subduction uplift. *Several
//! fronts*: only the nearest lifts a sample. *Forced subduction*: where the crust going under is
//! continental, h is large and so is the uplift.

use super::saturating_rise;
use super::uplift::{FastUplift, Push, Uplift};
use crate::crust::{Cause, Crust, CrustChunk, CrustKind, Ledger, Orogeny};
use crate::plate::boundary::Rim;
use crate::plate::contact::Contacts;
use crate::plate::front::{FrontField, FrontInput};
use crate::schedule::{CurrentPlanet, Stage, StepCursor, TectonicStep, TectonicSystems};
use crate::view::{PlanetQuery, PlanetView};
use bevy::prelude::*;
use rayon::prelude::*;

/// Greatest distance in radians over which a front lifts: on small planets `uplift_end` would go
/// all round.
const FARTHEST_REACH: f64 = 2.0;

/// Adds [`subduction`] to the step.
pub struct SubductionPlugin;

impl Plugin for SubductionPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            subduction.in_set(TectonicSystems::Process(Stage::Subduction)),
        );
    }
}

/// Raises the overriding plates of the current planet.
pub fn subduction(
    current: Res<CurrentPlanet>,
    mut planets: Query<(
        (PlanetQuery, &Rim, &Contacts),
        (&mut Crust, &mut FrontField, &mut Ledger, &mut StepCursor),
    )>,
) {
    let Ok((input, (mut crust, mut field, mut ledger, mut cursor))) = planets.get_mut(current.0)
    else {
        return;
    };
    let (planet, rim, contacts) = input;
    let view = planet.view();
    if !view.params.processes.subduction {
        // While it is off the front moves on unseen.
        field.stale = true;
        return;
    }
    let front = FrontInput {
        mesh: view.mesh,
        frame: &crust.frame,
        rim,
        contacts,
        reach: (view.params.uplift_end() / view.radius).min(FARTHEST_REACH),
    };
    if !field.follow(&front, || cursor.out_of_time()) {
        // Nothing is written yet: the next time slice begins with the same crust.
        cursor.hold();
        return;
    }
    let volume = rise(&view, &mut crust, &field, rim, contacts);
    ledger.book(Cause::SubductionUplift, 0.0, volume);
}

/// Raises all samples near a front. Returns the volume in km³ that continents gained.
fn rise(
    planet: &PlanetView,
    crust: &mut Crust,
    field: &FrontField,
    rim: &Rim,
    contacts: &Contacts,
) -> f64 {
    let law = Uplift::new(planet.params, planet.radius);
    let fast = FastUplift::new(&law);
    let pushes = FrontPushes {
        field,
        rim,
        pushes: contacts.0.iter().map(|at| law.push(at)).collect(),
    };
    let n = crust.len();
    let volumes: Vec<f64> = crust
        .chunks_mut(0..n)
        .into_par_iter()
        .map(|mut chunk| rise_chunk(planet, &mut chunk, &pushes, &fast))
        .collect();
    // Chunk by chunk, in their order: the same bits on any number of threads.
    volumes.into_iter().sum::<f64>() * planet.radius * planet.radius
}

/// The pushes of all contacts, found by the samples that they lift.
struct FrontPushes<'a> {
    field: &'a FrontField,
    rim: &'a Rim,
    /// By position on the rim; `None` for a contact that does not override.
    pushes: Vec<Option<Push>>,
}

impl FrontPushes<'_> {
    /// The push of the front nearest to sample `i`, and its distance in radians.
    #[inline]
    fn on(&self, i: usize) -> Option<(&Push, f32)> {
        let (source, distance) = self.field.nearest(i as u32)?;
        // A sample stays on the front for a while after it overrode: it pushes no more.
        let place = self.rim.index[source as usize] as usize;
        Some((self.pushes.get(place)?.as_ref()?, distance))
    }
}

/// Raises the samples of a chunk. Returns the volume that its continents gained, in km times
/// steradians.
fn rise_chunk(
    planet: &PlanetView,
    chunk: &mut CrustChunk,
    pushes: &FrontPushes,
    law: &FastUplift,
) -> f64 {
    let mut volume = 0.0;
    for k in 0..chunk.elevation.len() {
        let i = chunk.start + k;
        let Some((push, distance)) = pushes.on(i) else {
            continue;
        };
        let n = planet.mesh.points()[i].as_vec3();
        let (rate, drag) = law.at(push, n, distance);
        let thicker = lift(chunk, k, rate, law);
        // Ocean floor that rises is booked when it becomes land.
        if chunk.kind[k] == CrustKind::Continental {
            volume += f64::from(thicker) * planet.mesh.areas()[i];
            note_orogeny(chunk, k, rate, law);
        }
        chunk.fold[k] = turned(chunk.fold[k], drag, n);
    }
    volume
}

/// Raises the chunk's sample `k` at `rate` km/My for one step. Returns by how many km its crust
/// grew thicker.
#[inline]
fn lift(chunk: &mut CrustChunk, k: usize, rate: f32, law: &FastUplift) -> f32 {
    let (z, before) = (chunk.elevation[k], chunk.thickness[k]);
    let raised = saturating_rise(z, rate * law.dt, law.ceiling);
    let thicker = before + law.isostasy.thickening(z, raised - z);
    chunk.elevation[k] = raised;
    chunk.thickness[k] = thicker;
    // The difference of what is stored, its rounding included: the ledger must agree with it.
    thicker - before
}

/// Continental crust that rises fast enough belongs to an Andean orogeny from now on.
#[inline]
fn note_orogeny(chunk: &mut CrustChunk, k: usize, rate: f32, law: &FastUplift) {
    let young_belt =
        chunk.orogeny[k] == Orogeny::Himalayan && chunk.orogeny_age[k] < law.belt_memory;
    if rate > law.folding && !young_belt {
        chunk.orogeny[k] = Orogeny::Andean;
        chunk.orogeny_age[k] = 0.0;
    }
}

/// A fold direction after it was dragged by `drag`: a tangent vector at the direction `n`, at most
/// of unit length.
fn turned(fold: Vec3, drag: Vec3, n: Vec3) -> Vec3 {
    let sum = fold + drag;
    let tangent = sum - n * sum.dot(n);
    let length = tangent.length();
    if length > 1.0 {
        tangent / length
    } else {
        tangent
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folds_stay_tangent_and_bounded() {
        let n = Vec3::new(0.6, 0.0, 0.8);
        let mut fold = Vec3::ZERO;
        for _ in 0..30 {
            fold = turned(fold, Vec3::new(0.1, 0.2, -0.3), n);
            assert!(fold.dot(n).abs() < 1e-5 && fold.length() < 1.0001);
        }
        assert!(fold.length() > 0.99);
    }
}
