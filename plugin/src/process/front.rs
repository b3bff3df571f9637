//! Distance to the subduction front on every overriding plate.
//!
//! The front is the rim of the overriding plate, so in that plate's frame it stands still: distances stay
//! true until the set of rim samples that override something changes. They are renewed for a quarter of the
//! plates in each step, and for all after a resample. So the field is state: it remembers up to three steps.
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
#[derive(Component, Clone, Debug)]
pub struct FrontField {
    /// Whether all distances must be renewed at the next step.
    pub stale: bool,
    /// Distance in radians; infinite where no front is near.
    pub distance: Vec<f32>,
    /// Rim sample nearest to each sample; [`UNREACHED`] where there is none.
    pub source: Vec<u32>,
    /// Memory of the two spreads that run side by side.
    pub(crate) scratch: [Scratch; 2],
}

impl FrontField {
    /// The field of `n` samples before any front was seen.
    pub fn new(n: usize) -> Self {
        Self { stale: true, distance: vec![f32::INFINITY; n], source: vec![UNREACHED; n], scratch: default() }
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
        let due: Vec<bool> = frames.iter().map(|f| self.stale || turn(f.plate)).collect();
        self.stale = false;
        for (i, &frame) in frame.iter().enumerate() {
            if due[usize::from(frame)] {
                self.distance[i] = f32::INFINITY;
                self.source[i] = UNREACHED;
            }
        }
        // Two halves of the frames at a time; no distance crosses from one frame to another.
        let half = |half: u16| -> Vec<u32> {
            let front = rim.samples.iter().zip(&contacts.0).filter(|(i, contact)| {
                let id = frame[**i as usize];
                contact.role == Role::Overriding && id % 2 == half && due[usize::from(id)]
            });
            front.map(|(&i, _)| i).collect()
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
