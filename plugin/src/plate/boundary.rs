//! The rims of frames: samples with a neighbour on another plate.

use crate::crust::{FrameId, Frames};
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;

/// Entry of [`Rim::index`] for samples that are on no rim.
pub const INTERIOR: u32 = u32::MAX;

/// The samples on the rims of all frames, in sample order, with what never changes while no frame
/// gains or loses samples. Vectors are in lattice coordinates.
#[derive(Component, Clone, Debug, Default)]
pub struct Rim {
    /// The samples.
    pub samples: Vec<u32>,
    /// Unit tangent vector that points out of the frame.
    pub normal: Vec<DVec3>,
    /// Position of every sample in `samples`; [`INTERIOR`] for those that are on no rim.
    pub index: Vec<u32>,
    /// Length of front in radians that one sample stands for.
    pub length: f64,
}

impl Rim {
    /// Finds the rims.
    pub fn new(mesh: &SphereMesh, frame: &[FrameId], frames: &Frames) -> Self {
        let plate: Vec<_> = frames.iter().map(|frame| frame.plate).collect();
        let parts: Vec<(Vec<u32>, Vec<DVec3>)> = parallel::chunks(mesh.len())
            .map(|range| {
                let mut part = (Vec::new(), Vec::new());
                for i in range {
                    if let Some(normal) = outward(mesh, frame, &plate, i as u32) {
                        part.0.push(i as u32);
                        part.1.push(normal);
                    }
                }
                part
            })
            .collect();
        let mut rim = Self {
            length: mesh.spacing(),
            ..default()
        };
        for (samples, normal) in parts {
            rim.samples.extend(samples);
            rim.normal.extend(normal);
        }
        rim.index = vec![INTERIOR; mesh.len()];
        for (k, &i) in rim.samples.iter().enumerate() {
            rim.index[i as usize] = k as u32;
        }
        rim
    }

    /// Renews the rims after the samples `changed`, in order, have gone to other frames.
    pub fn update(
        &mut self,
        mesh: &SphereMesh,
        frame: &[FrameId],
        frames: &Frames,
        changed: &[u32],
    ) {
        let plate: Vec<_> = frames.iter().map(|frame| frame.plate).collect();
        // Amid others that went to the same frame nothing can change.
        let amid = |i: u32| {
            mesh.ring(i)
                .iter()
                .all(|&j| frame[j as usize] == frame[i as usize])
        };
        let at_edge = changed
            .iter()
            .filter(|&&i| self.index[i as usize] != INTERIOR || !amid(i));
        let mut near: Vec<u32> = at_edge
            .flat_map(|&i| mesh.ring(i).iter().copied().chain([i]))
            .collect();
        near.par_sort_unstable();
        near.dedup();
        let fresh = parallel::map_chunks(near.len(), |range| {
            let normal = |&i: &u32| Some((i, outward(mesh, frame, &plate, i)?));
            near[range].iter().filter_map(normal).collect::<Vec<_>>()
        });
        let mut fresh = fresh.into_iter().flatten().peekable();
        let old = core::mem::take(&mut self.samples)
            .into_iter()
            .zip(core::mem::take(&mut self.normal));
        let mut near = near.into_iter().peekable();
        for (i, normal) in old {
            self.index[i as usize] = INTERIOR;
            while near.next_if(|&k| k < i).is_some() {}
            while let Some((k, normal)) = fresh.next_if(|&(k, _)| k <= i) {
                self.push(k, normal);
            }
            if near.peek() != Some(&i) {
                self.push(i, normal);
            }
        }
        fresh.for_each(|(k, normal)| self.push(k, normal));
        for (k, &i) in self.samples.iter().enumerate() {
            self.index[i as usize] = k as u32;
        }
    }

    fn push(&mut self, sample: u32, normal: DVec3) {
        self.samples.push(sample);
        self.normal.push(normal);
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

/// The outward normal of sample `i`, if it has a neighbour on another plate.
fn outward(
    mesh: &SphereMesh,
    frame: &[FrameId],
    plate: &[super::PlateId],
    i: u32,
) -> Option<DVec3> {
    let frame_of = |j: u32| frame[j as usize];
    if mesh.ring(i).iter().all(|&j| frame_of(j) == frame_of(i)) {
        return None;
    }
    let own = plate[usize::from(frame_of(i))];
    let p = mesh.point(i);
    let mut sum = DVec3::ZERO;
    let mut found = false;
    for &j in mesh.ring(i) {
        if plate[usize::from(frame_of(j))] != own {
            sum += mesh.point(j) - p;
            found = true;
        }
    }
    let tangent = sum - p * sum.dot(p);
    // A sample alone among strangers has no outside: any direction serves.
    found.then(|| {
        tangent
            .try_normalize()
            .unwrap_or_else(|| crate::math::any_tangent(p))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crust::Frame;
    use crate::plate::PlateId;

    #[test]
    fn updated_rims_are_those_found_anew() {
        let mesh = SphereMesh::fibonacci(3000).unwrap();
        let frame_of = |p: DVec3| u16::from(p.x > 0.2) + 2 * u16::from(p.y > 0.1);
        let mut frame: Vec<FrameId> = mesh.points().iter().map(|&p| frame_of(p)).collect();
        // Two frames of one plate: a sample between them is on no rim until one changes plate.
        let mut frames = Frames([0, 1, 2, 1].map(|id| Frame::at_rest(PlateId(id))).to_vec());
        let mut rim = Rim::new(&mesh, &frame, &frames);
        for (at, to) in [
            (DVec3::X, 0),
            (DVec3::new(0.2, 0.1, 0.95), 5),
            (-DVec3::Y, 1),
            (DVec3::X, 1),
        ] {
            let id = frames.len() as FrameId;
            frames.push(Frame::at_rest(PlateId(to)));
            let disc = |i: &u32| mesh.point(*i).distance(at) < 0.3;
            let changed: Vec<u32> = (0..mesh.len() as u32).filter(disc).collect();
            changed.iter().for_each(|&i| frame[i as usize] = id);
            rim.update(&mesh, &frame, &frames, &changed);
            let anew = Rim::new(&mesh, &frame, &frames);
            assert_eq!(
                (&rim.samples, &rim.normal, &rim.index),
                (&anew.samples, &anew.normal, &anew.index)
            );
        }
    }
}
