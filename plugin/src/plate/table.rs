//! The plates of a planet as one table, in the order of their numbers.

use super::{Plate, PlateId, PlateMotion, PlateStats, Plates};
use crate::schedule::CurrentPlanet;
use bevy::ecs::query::QueryData;
use bevy::ecs::system::SystemParam;
use bevy::math::DVec3;
use bevy::prelude::*;

/// A plate's row in a [`PlateTable`].
#[derive(Clone, Copy, Debug)]
pub struct PlateRow {
    /// The stable number.
    pub id: PlateId,
    /// The entity.
    pub entity: Entity,
    /// The motion.
    pub motion: PlateMotion,
    /// Size and composition.
    pub stats: PlateStats,
    /// When it was made, in My.
    pub born: f64,
}

/// The plates of one planet as plain values, ordered by [`PlateId`]: what pure functions work on.
#[derive(Clone, Debug, Default)]
pub struct PlateTable(Vec<PlateRow>);

impl PlateTable {
    /// Sorts rows into a table.
    pub fn new(rows: impl IntoIterator<Item = PlateRow>) -> Self {
        let mut rows: Vec<_> = rows.into_iter().collect();
        rows.sort_by_key(|row| row.id);
        Self(rows)
    }

    /// Rows in order of their numbers.
    pub fn rows(&self) -> &[PlateRow] {
        &self.0
    }

    /// Position of a plate in the table.
    pub fn index(&self, id: PlateId) -> Option<usize> {
        self.0.binary_search_by_key(&id, |row| row.id).ok()
    }

    /// The row of a plate.
    pub fn get(&self, id: PlateId) -> Option<&PlateRow> {
        self.index(id).map(|i| &self.0[i])
    }

    /// Angular velocity of a plate in rad/My; zero for a plate that is gone.
    pub fn angular_velocity(&self, id: PlateId) -> DVec3 {
        self.get(id)
            .map_or(DVec3::ZERO, |row| row.motion.angular_velocity())
    }
}

/// A plate's row as a query.
#[derive(QueryData)]
pub(crate) struct PlateQuery {
    entity: Entity,
    id: &'static PlateId,
    motion: &'static PlateMotion,
    stats: &'static PlateStats,
    plate: &'static Plate,
}

impl PlateQueryItem<'_, '_> {
    /// The same as plain values.
    pub(crate) fn row(&self) -> PlateRow {
        PlateRow {
            id: *self.id,
            entity: self.entity,
            motion: *self.motion,
            stats: *self.stats,
            born: self.plate.born,
        }
    }
}

/// The plates of the current planet as a table.
#[derive(SystemParam)]
pub struct PlateAccess<'w, 's> {
    current: Res<'w, CurrentPlanet>,
    planets: Query<'w, 's, &'static Plates>,
    plates: Query<'w, 's, PlateQuery>,
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
        let rows = self.plates.iter_many(plates.iter());
        PlateTable::new(rows.map(|plate| plate.row()))
    }
}

/// The same for code that holds the whole world.
pub fn plate_table(world: &World, planet: Entity) -> PlateTable {
    let Some(plates) = world.get::<Plates>(planet) else {
        return PlateTable::default();
    };
    let plates = plates
        .iter()
        .filter_map(|plate| world.get_entity(plate).ok());
    let rows = plates.filter_map(|plate| plate.get_components::<PlateQuery>().ok());
    PlateTable::new(rows.map(|plate| plate.row()))
}
