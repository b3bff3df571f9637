//! Drift: frames rotate rigidly with their plates; no sample moves (paper 000 §3).
//!
//! ```text
//! s(p) = omega w x p
//! ```

use crate::crust::{Frame, Frames};
use crate::math::rotation;
use crate::params::TectonicParams;
use crate::plate::PlateAccess;
use crate::plate::{PlateId, PlateMotion, PlateStats, PlateTable};
use crate::schedule::{CurrentPlanet, Stage, TectonicStep, TectonicSystems};
use bevy::prelude::*;

/// Adds [`drift`] to the step.
pub struct DriftPlugin;

impl Plugin for DriftPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            (drift, drift_centroids)
                .chain()
                .in_set(TectonicSystems::Process(Stage::Drift)),
        );
    }
}

/// Rotates the frames of the current planet by one time step.
pub fn drift(plates: PlateAccess, mut planets: Query<(&TectonicParams, &mut Frames)>) {
    let Ok((params, mut frames)) = planets.get_mut(plates.planet()) else {
        return;
    };
    if params.processes.drift {
        let table = plates.table();
        for frame in frames.iter_mut() {
            rotate_frame(frame, &table, params.time_step);
        }
    }
}

/// Takes the centroids along.
fn drift_centroids(
    current: Res<CurrentPlanet>,
    planets: Query<(&TectonicParams, &crate::plate::Plates)>,
    mut plates: Query<(&PlateMotion, &mut PlateStats), With<PlateId>>,
) {
    let Ok((params, of_planet)) = planets.get(current.0) else {
        return;
    };
    if !params.processes.drift {
        return;
    }
    let mut plates = plates.iter_many_mut(of_planet.iter());
    while let Some((motion, mut stats)) = plates.fetch_next() {
        let turn = rotation(motion.axis, motion.speed * params.time_step);
        stats.centroid = (turn * stats.centroid).normalize();
    }
}

/// Rotates one frame with its plate for `dt` My.
pub fn rotate_frame(frame: &mut Frame, plates: &PlateTable, dt: f64) {
    let Some(plate) = plates.get(frame.plate) else {
        return;
    };
    // A frame at rest keeps its bits: projections copy crust where they see them.
    if plate.motion.speed == 0.0 {
        return;
    }
    // The unit length is restored in every step, or rounding would add up over thousands.
    let turn = rotation(plate.motion.axis, plate.motion.speed * dt);
    frame.rotation = (turn * frame.rotation).normalize();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::TAU;
    use crate::plate::PlateRow;
    use bevy::math::DVec3;

    fn table(motion: PlateMotion) -> PlateTable {
        let stats = PlateStats::default();
        PlateTable::new([PlateRow {
            id: PlateId(3),
            entity: Entity::PLACEHOLDER,
            motion,
            stats,
            born: 0.0,
        }])
    }

    #[test]
    fn a_plate_turned_by_a_full_circle_returns() {
        let axis = DVec3::new(1.0, -2.0, 0.5).normalize();
        let plates = table(PlateMotion {
            axis,
            speed: TAU / 250.0,
        });
        let mut frame = Frame::at_rest(PlateId(3));
        for _ in 0..125 {
            rotate_frame(&mut frame, &plates, 2.0);
        }
        let p = DVec3::new(0.1, 0.7, -0.7).normalize();
        assert!((frame.to_world(p) - p).length() < 1e-12);
        assert!((frame.to_lattice(frame.to_world(p)) - p).length() < 1e-15);
    }

    #[test]
    fn speed_is_the_surface_speed() {
        let plates = table(PlateMotion {
            axis: DVec3::Z,
            speed: 0.01,
        });
        let mut frame = Frame::at_rest(PlateId(3));
        rotate_frame(&mut frame, &plates, 2.0);
        let angle = crate::math::angle_between(DVec3::X, frame.to_world(DVec3::X));
        assert!((angle - 0.02).abs() < 1e-15);
        assert_eq!(frame.to_world(DVec3::Z), DVec3::Z);
    }

    #[test]
    fn a_plate_at_rest_keeps_its_frame_bit_for_bit() {
        let mut frame = Frame::at_rest(PlateId(3));
        rotate_frame(&mut frame, &table(PlateMotion::REST), 2.0);
        assert!(frame.is_at_rest());
    }
}
