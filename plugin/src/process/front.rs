//! Distance to the subduction front on every overriding plate.
//!
//! The front is the rim of the overriding plate, so in that plate's frame it stands still: distances stay
//! true until the set of rim samples that override something changes. They are renewed for a quarter of the
//! plates in each step, and at once for those whose frames have gained or lost samples.
//!
//! Policy: distance is measured within one frame, around gaps but not across them.

use crate::crust::{FrameId, Frames};
use crate::plate::PlateId;
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contacts, Role};
use crate::sphere::SphereMesh;
use crate::sphere::spread::{Reached, Scratch, UNREACHED, spread};
use bevy::prelude::*;

/// Every so many steps a plate's distances are renewed.
pub const REFRESH: u64 = 4;

/// Distance to the nearest front, and which rim sample is nearest.
#[derive(Component, Clone, Debug, Default)]
pub struct FrontField {
    /// Rim samples from which distances were last spread, in sample order: with the frames they
    /// determine all the rest, so they alone are saved.
    pub seeds: Vec<u32>,
    /// Plates whose frames have gained or lost samples since, in order: all their distances must be renewed.
    pub stale: Vec<PlateId>,
    /// Distance in radians; infinite where no front is near.
    pub distance: Vec<f32>,
    /// Rim sample nearest to each sample; [`UNREACHED`] where there is none.
    pub source: Vec<u32>,
    /// Memory of the two spreads that run side by side.
    pub(crate) scratch: [Scratch; 2],
}

impl FrontField {
    /// Marks the distances of plates as out of date.
    pub fn invalidate(&mut self, plates: impl IntoIterator<Item = PlateId>) {
        self.stale.extend(plates);
        self.stale.sort_unstable();
        self.stale.dedup();
    }

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
        let turn = |plate: PlateId| (u64::from(plate.0) + step).is_multiple_of(REFRESH);
        let due: Vec<bool> = frames
            .iter()
            .map(|f| turn(f.plate) || self.stale.binary_search(&f.plate).is_ok())
            .collect();
        let is_due = |sample: u32| due[usize::from(frame[sample as usize])];
        let mut seeds: Vec<u32> = self.seeds.iter().copied().filter(|&i| !is_due(i)).collect();
        let fresh = rim.samples.iter().zip(&contacts.0);
        seeds.extend(fresh.filter(|(i, c)| c.role == Role::Overriding && is_due(**i)).map(|(&i, _)| i));
        seeds.sort_unstable();
        self.seeds = seeds;
        self.stale.clear();
        self.spread(mesh, frame, reach, &due);
    }

    /// Finds all distances again from the seeds, after a load.
    pub fn restore(&mut self, mesh: &SphereMesh, frame: &[FrameId], frames: &Frames, reach: f64) {
        self.spread(mesh, frame, reach, &vec![true; frames.len()]);
    }

    fn spread(&mut self, mesh: &SphereMesh, frame: &[FrameId], reach: f64, due: &[bool]) {
        self.distance.resize(mesh.len(), f32::INFINITY);
        self.source.resize(mesh.len(), UNREACHED);
        for (i, &frame) in frame.iter().enumerate() {
            if due[usize::from(frame)] {
                self.distance[i] = f32::INFINITY;
                self.source[i] = UNREACHED;
            }
        }
        // Two halves of the frames at a time; no distance crosses from one frame to another.
        let half = |half: u16| -> Vec<u32> {
            let chosen = |&i: &u32| {
                let id = frame[i as usize];
                id % 2 == half && due[usize::from(id)]
            };
            self.seeds.iter().copied().filter(chosen).collect()
        };
        let seeds = [half(0), half(1)];
        let [left, right] = &mut self.scratch;
        let (left, right) = rayon::join(
            || spread_within(mesh, left, frame, &seeds[0], reach),
            || spread_within(mesh, right, frame, &seeds[1], reach),
        );
        for (seeds, reached) in seeds.iter().zip([left, right]) {
            let found = reached.samples.iter().zip(&reached.source).zip(&reached.distance);
            for ((&i, &source), &distance) in found {
                self.distance[i as usize] = distance;
                self.source[i as usize] = seeds[source as usize];
            }
        }
    }
}

/// Spreads from seeds, each within its own frame.
fn spread_within(
    mesh: &SphereMesh,
    scratch: &mut Scratch,
    frame: &[FrameId],
    seeds: &[u32],
    reach: f64,
) -> Reached {
    let seeds: Vec<_> = seeds.iter().map(|&i| (i, mesh.point(i))).collect();
    spread(mesh, scratch, &seeds, reach, |from, to| frame[from as usize] == frame[to as usize])
}
