//! Rigid geodetic motion: rotation about an axis through the planet's centre (paper 000 §3).

use super::{PlateId, PlateStats};
use bevy::math::DVec3;
use bevy::prelude::*;

/// The motion G of a plate. A point p of it moves with `s(p) = omega w x p`.
#[derive(Component, Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(Component)]
pub struct PlateMotion {
    /// Unit rotation axis w.
    pub axis: DVec3,
    /// Angular speed omega in rad/My, not negative.
    pub speed: f64,
}

impl PlateMotion {
    /// A plate at rest.
    pub const REST: Self = Self {
        axis: DVec3::Z,
        speed: 0.0,
    };

    /// The motion with the angular velocity `omega` in rad/My.
    pub fn from_angular_velocity(omega: DVec3) -> Self {
        let speed = omega.length();
        if speed > 1e-12 {
            Self {
                axis: omega / speed,
                speed,
            }
        } else {
            Self::REST
        }
    }

    /// Angular velocity omega w in rad/My.
    pub fn angular_velocity(&self) -> DVec3 {
        self.axis * self.speed
    }

    /// Surface velocity at the unit direction `p`, in planet radii per My.
    pub fn velocity(&self, p: DVec3) -> DVec3 {
        self.angular_velocity().cross(p)
    }

    /// The same motion slowed so that no point exceeds `limit` rad/My.
    pub fn limited(&self, limit: f64) -> Self {
        Self {
            axis: self.axis,
            speed: self.speed.min(limit),
        }
    }
}

/// A plate's row in a [`PlateTable`].
#[derive(Clone, Copy, Debug)]
pub struct PlateRow {
    /// The stable number.
    pub id: PlateId,
    /// The entity.
    pub entity: Entity,
    /// The motion.
    pub motion: PlateMotion,
    /// What it is made of.
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
