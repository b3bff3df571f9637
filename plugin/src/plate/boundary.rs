//! The rims of frames: samples with a neighbour on another plate.

use crate::crust::{FrameId, Frames};
use crate::ids::PlateId;
use crate::math;
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;

/// Entry of [`Rim::index`] for samples that are on no rim.
pub const NOT_ON_RIM: u32 = u32::MAX;

/// The samples on the rims of all frames, in sample order, with what never changes while no frame
/// gains or loses samples. Vectors are in lattice coordinates.
#[derive(Component, Clone, Debug, Default, Reflect)]
#[reflect(Component)]
pub struct Rim {
    /// The samples.
    pub samples: Vec<u32>,
    /// Unit tangent vector that points out of the frame.
    pub normal: Vec<DVec3>,
    /// Position of every sample of the lattice in `samples`, or [`NOT_ON_RIM`].
    pub index: Vec<u32>,
    /// Length of front in radians that one sample stands for.
    pub length: f64,
}

impl Rim {
    /// Finds the rims.
    pub fn new(mesh: &SphereMesh, frame: &[FrameId], frames: &Frames) -> Self {
        let owners = Owners::new(mesh, frame, frames);
        let parts = parallel::map_chunks(mesh.len(), |range| {
            let on_rim = |i: usize| Some((i as u32, owners.outward(i as u32)?));
            range.filter_map(on_rim).collect::<Vec<_>>()
        });
        let mut rim = Self {
            index: vec![NOT_ON_RIM; mesh.len()],
            length: mesh.spacing(),
            ..default()
        };
        for (i, normal) in parts.into_iter().flatten() {
            rim.push(i, normal);
        }
        rim.number();
        rim
    }

    /// Updates the rims after the samples `changed`, in order, have gone to other frames.
    ///
    /// Only samples that changed and their neighbours can have come to a rim, left it, or got
    /// another normal. They are looked at anew and merged with the others, both in sample order.
    pub fn update(
        &mut self,
        mesh: &SphereMesh,
        frame: &[FrameId],
        frames: &Frames,
        changed: &[u32],
    ) {
        let owners = Owners::new(mesh, frame, frames);
        // Amid others that went to the same frame nothing can change, and most samples of a large
        // terrane are.
        let at_edge = |i: &&u32| self.index[**i as usize] != NOT_ON_RIM || !owners.is_amid_own(**i);
        let edge = changed.iter().filter(at_edge);
        let mut near: Vec<u32> = edge
            .flat_map(|&i| mesh.ring(i).iter().copied().chain([i]))
            .collect();
        near.par_sort_unstable();
        near.dedup();
        let fresh = parallel::map_chunks(near.len(), |range| {
            let on_rim = |&i: &u32| Some((i, owners.outward(i)?));
            near[range].iter().filter_map(on_rim).collect::<Vec<_>>()
        });
        self.replace(&near, fresh.concat());
        self.number();
    }

    /// Replaces what is known of the samples `near` by `fresh`, both in sample order.
    fn replace(&mut self, near: &[u32], fresh: Vec<(u32, DVec3)>) {
        let samples = core::mem::take(&mut self.samples);
        let normals = core::mem::take(&mut self.normal);
        let mut fresh = fresh.into_iter().peekable();
        let mut near = near.iter().copied().peekable();
        for (i, normal) in samples.into_iter().zip(normals) {
            self.index[i as usize] = NOT_ON_RIM;
            // Both lists catch up with the old rim before one of its samples is kept.
            while near.next_if(|&k| k < i).is_some() {}
            while let Some((k, normal)) = fresh.next_if(|&(k, _)| k <= i) {
                self.push(k, normal);
            }
            if near.peek() != Some(&i) {
                self.push(i, normal);
            }
        }
        fresh.for_each(|(k, normal)| self.push(k, normal));
    }

    fn push(&mut self, sample: u32, normal: DVec3) {
        self.samples.push(sample);
        self.normal.push(normal);
    }

    /// Writes the positions of all samples on rims.
    fn number(&mut self) {
        for (k, &i) in (0..).zip(&self.samples) {
            self.index[i as usize] = k;
        }
    }

    /// Number of samples on rims.
    pub fn len(&self) -> usize {
        self.samples.len()
    }

    /// Whether there is no rim: a planet of one plate.
    pub fn is_empty(&self) -> bool {
        self.samples.is_empty()
    }
}

/// Who owns the samples.
struct Owners<'a> {
    mesh: &'a SphereMesh,
    frame: &'a [FrameId],
    /// The plate of every frame.
    plate: Vec<PlateId>,
}

impl<'a> Owners<'a> {
    fn new(mesh: &'a SphereMesh, frame: &'a [FrameId], frames: &Frames) -> Self {
        Self {
            mesh,
            frame,
            plate: frames.iter().map(|frame| frame.plate).collect(),
        }
    }

    fn plate(&self, i: u32) -> PlateId {
        self.plate[usize::from(self.frame[i as usize])]
    }

    /// Whether all neighbours of sample `i` are on its own frame.
    fn is_amid_own(&self, i: u32) -> bool {
        let own = self.frame[i as usize];
        let mut ring = self.mesh.ring(i).iter();
        ring.all(|&j| self.frame[j as usize] == own)
    }

    /// The outward normal of sample `i`, if it has a neighbour on another plate: the tangential
    /// part of the sum of all edges to those.
    fn outward(&self, i: u32) -> Option<DVec3> {
        // Frames are compared first, as most samples are amid their own.
        if self.is_amid_own(i) {
            return None;
        }
        let own = self.plate(i);
        let p = self.mesh.point(i);
        let mut sum = DVec3::ZERO;
        let mut found = false;
        for &j in self.mesh.ring(i) {
            if self.plate(j) != own {
                sum += self.mesh.point(j) - p;
                found = true;
            }
        }
        let tangent = sum - p * sum.dot(p);
        // A sample alone among strangers has no outside: any direction serves.
        let normal = tangent.try_normalize();
        found.then(|| normal.unwrap_or_else(|| math::any_tangent(p)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crust::Frame;

    /// Gives the samples within 0.3 of `at` to a new frame of a plate. Returns them.
    fn give(
        mesh: &SphereMesh,
        frame: &mut [FrameId],
        frames: &mut Frames,
        at: DVec3,
        plate: u32,
    ) -> Vec<u32> {
        let id = frames.len() as FrameId;
        frames.push(Frame::at_rest(PlateId(plate)));
        let disc = |i: &u32| mesh.point(*i).distance(at) < 0.3;
        let changed: Vec<u32> = (0..mesh.len() as u32).filter(disc).collect();
        changed.iter().for_each(|&i| frame[i as usize] = id);
        changed
    }

    #[test]
    fn updated_rims_are_those_found_anew() {
        let mesh = SphereMesh::fibonacci(3000).unwrap();
        let frame_of = |p: &DVec3| u16::from(p.x > 0.2) + 2 * u16::from(p.y > 0.1);
        let mut frame: Vec<FrameId> = mesh.points().iter().map(frame_of).collect();
        // Two frames of one plate: a sample between them is on no rim until one changes plate.
        let mut frames = Frames([0, 1, 2, 1].map(|id| Frame::at_rest(PlateId(id))).to_vec());
        let mut rim = Rim::new(&mesh, &frame, &frames);
        let between = DVec3::new(0.2, 0.1, 0.95);
        for (at, plate) in [(DVec3::X, 0), (between, 5), (-DVec3::Y, 1), (DVec3::X, 1)] {
            let changed = give(&mesh, &mut frame, &mut frames, at, plate);
            rim.update(&mesh, &frame, &frames, &changed);
            let anew = Rim::new(&mesh, &frame, &frames);
            assert_eq!(rim.samples, anew.samples);
            assert_eq!(rim.normal, anew.normal);
            assert_eq!(rim.index, anew.index);
        }
    }
}
