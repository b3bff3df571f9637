//! What happens in a step. One file is one process, one plugin and one section of paper 000.
//!
//! | file | paper 000 | reads | writes |
//! |---|---|---|---|
//! | [`drift`] | §3 | motions | frames |
//! | [`contact`] | §6 | frames, crust, motions | contacts, polarity |
//! | [`subduction`] | §4.1 | contacts | elevation, thickness, fold, orogeny |
//! | [`slab_pull`] | §4.1 | contacts | motions |
//! | [`collision`] | §4.2 | contacts, crust | frames, elevation, thickness, fold, orogeny |
//! | [`rifting`] | §4.4 | plates, crust | plates, frames, thickness |
//! | [`relief`] | §4.5 | crust | elevation, thickness, ages, kind |
//! | [`margin`] | §4.5 | elevation, kind | elevation of ocean crust |
//! | [`commit`] | | crust | clock, ledger |
//!
//! New ocean crust (§4.3) belongs to [`resample`](crate::resample).

pub mod contact;

pub mod drift;

pub mod front;

pub mod subduction;

pub mod slab_pull;

pub mod collision;

pub mod rift_shape;

pub mod rifting;

pub mod ocean_floor;

pub mod erosion;

pub mod relief;

pub mod margin;

pub mod commit;

use crate::crust::cover::CoverIndex;
use crate::plate::boundary::Rim;
use crate::plate::contact::Contacts;
use crate::plate::{Plate, PlateId, PlateMotion, PlateRow, PlateStats, PlateTable, Plates};
use crate::schedule::CurrentPlanet;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;

/// What processes keep between steps and can find again from the state: never saved.
#[derive(Bundle, Clone, Default)]
pub struct ProcessState {
    /// Which frames cover a point.
    pub cover: CoverIndex,
    /// Rims of the frames.
    pub rim: Rim,
    /// Contacts of the last step.
    pub contacts: Contacts,
    /// Values of the relief noise.
    pub noise: relief::ReliefNoise,
    /// A resample in progress.
    pub resampling: crate::resample::Resampling,
}

/// The plates of the current planet as a table.
#[derive(SystemParam)]
pub struct PlateAccess<'w, 's> {
    current: Res<'w, CurrentPlanet>,
    planets: Query<'w, 's, &'static Plates>,
    plates: Query<
        'w,
        's,
        (
            Entity,
            &'static PlateId,
            &'static PlateMotion,
            &'static PlateStats,
            &'static Plate,
        ),
    >,
}

impl PlateAccess<'_, '_> {
    /// The planet that this step works on.
    pub fn planet(&self) -> Entity {
        self.current.0
    }

    /// The plates in order of their numbers.
    pub fn table(&self) -> PlateTable {
        let Ok(plates) = self.planets.get(self.current.0) else {
            return PlateTable::default();
        };
        PlateTable::new(plates.iter().filter_map(|entity| {
            let (entity, id, motion, stats, plate) = self.plates.get(entity).ok()?;
            Some(PlateRow {
                id: *id,
                entity,
                motion: *motion,
                stats: *stats,
                born: plate.born,
            })
        }))
    }
}

/// The same for code that holds the whole world.
pub fn plate_table(world: &World, planet: Entity) -> PlateTable {
    let Some(plates) = world.get::<Plates>(planet) else {
        return PlateTable::default();
    };
    PlateTable::new(plates.iter().filter_map(|entity| {
        Some(PlateRow {
            entity,
            id: *world.get(entity)?,
            motion: *world.get(entity)?,
            stats: *world.get(entity)?,
            born: world.get::<Plate>(entity)?.born,
        })
    }))
}

/// Radius of a planet in km; Earth's, as recipes have it, for what is none.
pub(crate) fn planet_radius(world: &World, planet: Entity) -> f64 {
    world
        .get::<crate::planet::Planet>(planet)
        .map_or(6370.0, |planet| planet.radius)
}

/// Raises `z` by `dz` km so that it approaches `ceiling` smoothly and never passes it: slope 1 far
/// below, all of the distance that is left for an endless `dz`. What is lowered (`dz` < 0) is
/// lowered in full.
#[inline]
pub fn saturating_rise(z: f32, dz: f32, ceiling: f32) -> f32 {
    let room = ceiling - z;
    if dz <= 0.0 {
        z + dz
    } else if room <= 0.0 {
        z
    } else {
        z + dz * room / (dz + room)
    }
}

#[cfg(test)]
mod tests {
    use super::saturating_rise;

    #[test]
    fn uplift_saturates_smoothly() {
        assert_eq!(saturating_rise(1.0, 0.0, 10.0), 1.0);
        assert!((saturating_rise(0.0, 1e-3, 10.0) - 1e-3).abs() < 1e-6);
        assert!(saturating_rise(0.0, 1e6, 10.0) <= 10.0);
        assert!(saturating_rise(9.0, 130.0, 10.0) > 9.9);
        assert_eq!(saturating_rise(11.0, 1.0, 10.0), 11.0);
        assert_eq!(saturating_rise(1.0, -0.5, 10.0), 0.5);
        let mut last = -5.0;
        for k in 0..100 {
            let next = saturating_rise(-5.0, k as f32, 10.0);
            assert!(next >= last);
            last = next;
        }
    }
}
