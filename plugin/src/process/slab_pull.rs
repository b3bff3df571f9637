//! Slab pull: a subducting plate is drawn towards its fronts (paper 000 §4.1).
//!
//! ```text
//! w' = w + eps sum_k  (c x q_k) / |c x q_k|  L_k / R  dt,   renormalised
//! ```
//!
//! L_k is the length of front that q_k stands for, so that the pull does not depend on the
//! resolution. The speed stays. Young fragments of a rift are left alone for `slab_pull_grace` My:
//! pulled together, they would close the rift.

use crate::crust::{Crust, Frames};
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice};
use crate::plate::boundary::Rim;
use crate::plate::contact::Contacts;
use crate::plate::{Plate, PlateId, PlateMotion, PlateStats, Plates};
use crate::schedule::{CurrentPlanet, Stage, TectonicStep, TectonicSystems};
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;
use std::collections::BTreeMap;

/// Adds [`slab_pull`] to the step.
pub struct SlabPullPlugin;

impl Plugin for SlabPullPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            slab_pull.in_set(TectonicSystems::Process(Stage::SlabPull)),
        );
    }
}

/// Turns the axes of the current planet's subducting plates.
pub fn slab_pull(
    current: Res<CurrentPlanet>,
    planets: Query<(
        (&Lattice, &TectonicParams, &GeologicClock),
        (&Crust, &Frames, &Rim, &Contacts, &Plates),
    )>,
    mut plates: Query<(&PlateId, &Plate, &PlateStats, &mut PlateMotion)>,
) {
    let Ok(((lattice, params, clock), (crust, frames, rim, contacts, of_planet))) =
        planets.get(current.0)
    else {
        return;
    };
    if !params.processes.slab_pull {
        return;
    }
    let fronts = sinking_fronts(lattice, crust, frames, rim, contacts);
    let mut plates = plates.iter_many_mut(of_planet.iter());
    while let Some((id, plate, stats, mut motion)) = plates.fetch_next() {
        if let Some(front) = fronts.get(id)
            && clock.time - plate.born >= params.slab_pull_grace
        {
            let rate = params.slab_pull * params.time_step;
            motion.axis = pulled(motion.axis, stats.centroid, front, rim.length, rate);
        }
    }
}

/// Directions in world coordinates of the places under which ocean floor sinks, by the plate that
/// they pull.
fn sinking_fronts(
    mesh: &SphereMesh,
    crust: &Crust,
    frames: &Frames,
    rim: &Rim,
    contacts: &Contacts,
) -> BTreeMap<PlateId, Vec<DVec3>> {
    let mut fronts: BTreeMap<PlateId, Vec<DVec3>> = BTreeMap::new();
    for (&i, contact) in rim.samples.iter().zip(&contacts.0) {
        if contact.is_over_sinking_floor() {
            // In the order of the rim, in which they are summed, too.
            let frame = &frames[usize::from(crust.frame[i as usize])];
            let place = frame.to_world(mesh.point(i));
            fronts.entry(contact.other).or_default().push(place);
        }
    }
    fronts
}

/// The axis after one step of pull by front points that each stand for `length` radians.
pub fn pulled(axis: DVec3, centroid: DVec3, front: &[DVec3], length: f64, rate: f64) -> DVec3 {
    let pull: DVec3 = front
        .iter()
        // A front under the centroid, or opposite to it, pulls in no direction.
        .filter_map(|q| centroid.cross(*q).try_normalize())
        .sum();
    (axis + pull * (rate * length))
        .try_normalize()
        .unwrap_or(axis)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::direction;

    #[test]
    fn the_plate_turns_towards_its_front() {
        let centroid = DVec3::X;
        let front: Vec<_> = (-20..=20)
            .map(|lat| direction(f64::from(lat), 40.0))
            .collect();
        let mut axis = direction(30.0, 0.0);
        for _ in 0..10_000 {
            axis = pulled(axis, centroid, &front, 0.01, 0.01);
        }
        // Rotation about +z carries the centroid straight to the front in the east.
        assert!(axis.z > 0.999, "{axis}");
        assert!((axis.length() - 1.0).abs() < 1e-12);
    }

    /// A front of `n` points along a meridian.
    fn line(n: i32) -> Vec<DVec3> {
        (0..n)
            .map(|k| direction(-20.0 + 40.0 * (f64::from(k) + 0.5) / f64::from(n), 50.0))
            .collect()
    }

    #[test]
    fn the_pull_does_not_depend_on_the_resolution() {
        let coarse = pulled(DVec3::Y, DVec3::X, &line(40), 1.0 / 40.0, 0.1);
        let fine = pulled(DVec3::Y, DVec3::X, &line(400), 1.0 / 400.0, 0.1);
        assert!((coarse - fine).length() < 1e-4);
    }
}
