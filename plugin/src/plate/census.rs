//! The census of terranes: which samples each has, kept from step to step.
//!
//! An arc that rises out of the sea adds a sample to the terrane beside it, begins one of its own,
//! or joins several. Crust that changes its frame, as in most steps an island does that collides,
//! has the terranes counted again that it was part of; a resample asks for a new census. Areas and
//! moments are summed as integers: they do not depend on the order in which samples came, so a
//! planet that was loaded has the same terranes as one that grew.

use super::plate_table;
use super::terrane::{Terrane, TerraneOf, Terranes};
use crate::crust::{Crust, Frames};
use crate::ids::{FrameId, PlateId};
use crate::sphere::SphereMesh;
use crate::sphere::components::{Components, OUTSIDE};
use crate::view::{PlanetQuery, PlanetView};
use bevy::math::DVec3;
use bevy::prelude::*;
use std::collections::BTreeSet;
use std::mem;

/// Parts of a steradian that areas and moments are counted in: the whole sphere is less than 2^56
/// of them, and a sample of the finest planet more than 2^34.
const PARTS_PER_STERADIAN: f64 = (1_u64 << 52) as f64;

/// Which terrane every sample of a planet belongs to.
#[derive(Component, Clone, Debug, Default, PartialEq, Reflect)]
#[reflect(Component)]
pub struct TerraneCensus {
    /// Whether all terranes must be found anew before the step ends. Set by whatever gives all
    /// samples new frames or makes ocean floor of land.
    pub stale: bool,
    /// Samples that have gone to other frames since they were counted.
    pub moved: Vec<u32>,
    /// Samples that have become land where they are, and are not counted yet.
    pub grown: Vec<u32>,
    /// The number that every sample was counted under, or [`OUTSIDE`].
    number: Vec<u32>,
    /// Sums over what is counted under each number.
    sums: Vec<TerraneSums>,
    /// The number that each number has been joined to, or itself; [`OUTSIDE`] for one whose samples
    /// are counted under others.
    joined: Vec<u32>,
}

/// Sums over the samples of a terrane, in lattice coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Reflect)]
struct TerraneSums {
    frame: FrameId,
    samples: u32,
    area: i64,
    moment: [i64; 3],
}

impl TerraneSums {
    fn add(&mut self, mesh: &SphereMesh, sample: usize) {
        let area = mesh.areas()[sample] * PARTS_PER_STERADIAN;
        let moment = mesh.points()[sample] * area;
        self.merge(&Self {
            frame: self.frame,
            samples: 1,
            area: area as i64,
            moment: moment.to_array().map(|x| x as i64),
        });
    }

    fn merge(&mut self, other: &Self) {
        self.samples += other.samples;
        self.area += other.area;
        for (sum, part) in self.moment.iter_mut().zip(other.moment) {
            *sum += part;
        }
    }

    fn terrane(&self, number: u32, frames: &Frames, radius: f64) -> Terrane {
        let moment = DVec3::from_array(self.moment.map(|x| x as f64));
        let world = frames[usize::from(self.frame)].to_world(moment);
        Terrane {
            number,
            frame: self.frame,
            samples: self.samples,
            area: self.area as f64 / PARTS_PER_STERADIAN * radius * radius,
            centroid: world.try_normalize().unwrap_or(DVec3::Z),
        }
    }
}

impl TerraneCensus {
    /// Counts all terranes: connected continental samples of one frame, numbered by their first
    /// samples.
    pub fn new(mesh: &SphereMesh, crust: &Crust) -> Self {
        let components = Components::new(
            mesh,
            |i| crust.is_continental(i as usize),
            |i, j| crust.frame[i as usize] == crust.frame[j as usize],
        );
        let mut sums = vec![TerraneSums::default(); components.count];
        for (i, &number) in components.of.iter().enumerate() {
            // Samples of no component have a number beyond the last.
            if let Some(sum) = sums.get_mut(number as usize) {
                sum.frame = crust.frame[i];
                sum.add(mesh, i);
            }
        }
        Self {
            joined: (0..sums.len() as u32).collect(),
            number: components.of,
            sums,
            ..Self::default()
        }
    }

    /// All terranes, in the order of their numbers. `radius` is in km.
    pub fn terranes(&self, frames: &Frames, radius: f64) -> impl Iterator<Item = Terrane> {
        (0..self.len()).filter_map(move |number| self.terrane(number, frames, radius))
    }

    /// Numbers that have been given out.
    pub(crate) fn len(&self) -> u32 {
        self.sums.len() as u32
    }

    /// The terrane of a number; `None` if it has been joined to another.
    pub(crate) fn terrane(&self, number: u32, frames: &Frames, radius: f64) -> Option<Terrane> {
        self.is_one(number)
            .then(|| self.sums[number as usize].terrane(number, frames, radius))
    }

    /// Whether a number still stands for a terrane, and has not been joined to another.
    fn is_one(&self, number: u32) -> bool {
        self.joined.get(number as usize) == Some(&number)
    }

    /// Counts the samples that have become land, and anew those of terranes that lost or gained
    /// samples.
    pub(crate) fn catch_up(&mut self, mesh: &SphereMesh, crust: &Crust) {
        self.release_moved();
        for sample in mem::take(&mut self.grown) {
            self.count(mesh, crust, sample);
        }
    }

    /// Gives up the terranes that the moved samples were counted under, and leaves their samples to
    /// be counted with those that have grown.
    fn release_moved(&mut self) {
        let moved = mem::take(&mut self.moved);
        // Ocean floor has no number, and land that is new in this step will be counted anyway.
        let counted = moved
            .iter()
            .map(|&i| self.number[i as usize])
            .filter(|&number| number != OUTSIDE);
        let released: BTreeSet<u32> = counted.map(|number| self.root(number)).collect();
        if released.is_empty() {
            return;
        }
        // By number, joined ones included: samples are many, numbers are few.
        let is_released: Vec<bool> = (0..self.len())
            .map(|number| released.contains(&self.root(number)))
            .collect();
        for (i, number) in (0..).zip(&mut self.number) {
            if is_released.get(*number as usize) == Some(&true) {
                *number = OUTSIDE;
                self.grown.push(i);
            }
        }
        for number in released {
            self.joined[number as usize] = OUTSIDE;
        }
    }

    /// Counts a sample under the number of its neighbours, which are joined where they differ.
    fn count(&mut self, mesh: &SphereMesh, crust: &Crust, sample: u32) {
        let frame = crust.frame[sample as usize];
        let mut home = None;
        // A neighbour that is to be counted later joins this sample then.
        for &j in mesh.ring(sample) {
            let counted = self.number[j as usize];
            if counted != OUTSIDE && crust.frame[j as usize] == frame {
                let number = self.root(counted);
                home = Some(home.map_or(number, |home| self.join(home, number)));
            }
        }
        let number = home.unwrap_or_else(|| self.begin(frame));
        self.number[sample as usize] = number;
        self.sums[number as usize].add(mesh, sample as usize);
    }

    /// A new number for a terrane of this frame.
    fn begin(&mut self, frame: FrameId) -> u32 {
        let number = self.sums.len() as u32;
        self.joined.push(number);
        self.sums.push(TerraneSums {
            frame,
            ..TerraneSums::default()
        });
        number
    }

    /// The number that a number has been joined to in the end, or [`OUTSIDE`].
    fn root(&self, mut number: u32) -> u32 {
        while number != OUTSIDE && !self.is_one(number) {
            number = self.joined[number as usize];
        }
        number
    }

    /// Joins two terranes under the lower of their numbers.
    fn join(&mut self, a: u32, b: u32) -> u32 {
        let (low, high) = (a.min(b), a.max(b));
        if low != high {
            let taken = mem::take(&mut self.sums[high as usize]);
            self.sums[low as usize].merge(&taken);
            self.joined[high as usize] = low;
        }
        low
    }
}

/// Finds the terranes of a planet anew: their entities are replaced.
pub fn recount_terranes(world: &mut World, planet: Entity) {
    let mut query = world.query::<(PlanetQuery, &Crust, &Frames, &mut TerraneCensus)>();
    let Ok((body, crust, frames, mut census)) = query.get_mut(world, planet) else {
        return;
    };
    let PlanetView { mesh, radius, .. } = body.view();
    *census = TerraneCensus::new(mesh, crust);
    let terranes: Vec<(PlateId, Terrane)> = census
        .terranes(frames, radius)
        .map(|terrane| (frames.plate(terrane.frame), terrane))
        .collect();
    let plates = plate_table(world, planet);
    for row in plates.rows() {
        world.entity_mut(row.entity).despawn_related::<Terranes>();
    }
    for (plate, terrane) in terranes {
        if let Some(row) = plates.get(plate) {
            world.spawn((TerraneOf(row.entity), terrane));
        }
    }
}

#[cfg(test)]
mod tests;
