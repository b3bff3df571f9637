//! Distance to the subduction front on every overriding plate.
//!
//! The front is the rim of the overriding plate, so in that plate's frame it stands still: distances stay
//! true until the set of rim samples that override something changes. They are renewed for a quarter of the
//! plates in each step, and for all when frames have gained or lost samples.
//!
//! Policy: distance is measured within one frame, around gaps but not across them.

use crate::crust::{FrameId, Frames};
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contacts, Role};
use crate::sphere::SphereMesh;
use crate::sphere::spread::{Scratch, UNREACHED, spread};
use bevy::prelude::*;

/// Every so many steps a plate's distances are renewed.
pub const REFRESH: u64 = 4;

/// Distance to the nearest front, and which rim sample is nearest.
#[derive(Component, Clone, Debug)]
pub struct FrontField {
    /// Rim samples from which distances were last spread, in sample order: with the frames they
    /// determine all the rest, so they alone are saved.
    pub seeds: Vec<u32>,
    /// Whether frames have changed since, so that all distances must be renewed.
    pub stale: bool,
    /// Distance in radians; infinite where no front is near.
    pub distance: Vec<f32>,
    /// Position in [`Rim::samples`] of the nearest front sample; [`UNREACHED`] where there is none.
    pub source: Vec<u32>,
}

impl Default for FrontField {
    fn default() -> Self {
        Self { seeds: Vec::new(), stale: true, distance: Vec::new(), source: Vec::new() }
    }
}

impl FrontField {
    /// Renews the distances of the plates that are due at `step`, up to `reach` radians.
    pub fn refresh(
        &mut self,
        mesh: &SphereMesh,
        frame: &[FrameId],
        frames: &Frames,
        rim: &Rim,
        contacts: &Contacts,
        reach: f64,
        step: u64,
    ) {
        let due: Vec<bool> = frames
            .iter()
            .map(|f| self.stale || (u64::from(f.plate.0) + step).is_multiple_of(REFRESH))
            .collect();
        let is_due = |sample: u32| due[usize::from(frame[sample as usize])];
        let mut seeds: Vec<u32> = self.seeds.iter().copied().filter(|&i| !is_due(i)).collect();
        let fresh = rim.samples.iter().zip(&contacts.0);
        seeds.extend(fresh.filter(|(i, c)| c.role == Role::Overriding && is_due(**i)).map(|(&i, _)| i));
        seeds.sort_unstable();
        self.seeds = seeds;
        self.stale = false;
        self.spread(mesh, frame, rim, reach, &due);
    }

    /// Finds all distances again from the seeds, after a load.
    pub fn restore(&mut self, mesh: &SphereMesh, frame: &[FrameId], frames: &Frames, rim: &Rim, reach: f64) {
        self.spread(mesh, frame, rim, reach, &vec![true; frames.len()]);
    }

    fn spread(&mut self, mesh: &SphereMesh, frame: &[FrameId], rim: &Rim, reach: f64, due: &[bool]) {
        self.distance.resize(mesh.len(), f32::INFINITY);
        self.source.resize(mesh.len(), UNREACHED);
        let is_due = |i: usize| due[usize::from(frame[i])];
        for i in 0..mesh.len() {
            if is_due(i) {
                self.distance[i] = f32::INFINITY;
                self.source[i] = UNREACHED;
            }
        }
        // Two halves of the frames at a time; no distance crosses from one frame to another.
        let (left, right) = rayon::join(
            || self.spread_half(mesh, frame, due, reach, 0),
            || self.spread_half(mesh, frame, due, reach, 1),
        );
        for (seeds, reached) in [left, right] {
            for ((&i, &source), &distance) in
                reached.samples.iter().zip(&reached.source).zip(&reached.distance)
            {
                let Ok(at) = rim.samples.binary_search(&seeds[source as usize].0) else { continue };
                self.distance[i as usize] = distance;
                self.source[i as usize] = at as u32;
            }
        }
    }

    fn spread_half(
        &self,
        mesh: &SphereMesh,
        frame: &[FrameId],
        due: &[bool],
        reach: f64,
        half: u16,
    ) -> (Vec<(u32, bevy::math::DVec3)>, crate::sphere::spread::Reached) {
        let seeds: Vec<_> = self
            .seeds
            .iter()
            .filter(|&&i| {
                let id = frame[i as usize];
                id % 2 == half && due[usize::from(id)]
            })
            .map(|&i| (i, mesh.point(i)))
            .collect();
        // A spread hands a source on from neighbour to neighbour; the frame of a sample is the frame of its source.
        let reached = spread_within(mesh, frame, &seeds, reach);
        (seeds, reached)
    }
}

/// Spreads from seeds, each within its own frame.
fn spread_within(
    mesh: &SphereMesh,
    frame: &[FrameId],
    seeds: &[(u32, bevy::math::DVec3)],
    reach: f64,
) -> crate::sphere::spread::Reached {
    spread(mesh, &mut Scratch::default(), seeds, reach, |from, to| {
        frame[from as usize] == frame[to as usize]
    })
}
