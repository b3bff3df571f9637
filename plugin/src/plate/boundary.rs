//! The rims of frames: samples with a neighbour on another plate.

use crate::crust::{FrameId, Frames};
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;

/// Entry of [`Rim::index`] for samples that are on no rim.
pub const INTERIOR: u32 = u32::MAX;

/// The samples on the rims of all frames, in sample order, with what never changes while no frame gains or
/// loses samples. Vectors are in lattice coordinates.
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
        let mut rim = Self { length: mesh.spacing(), ..default() };
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
fn outward(mesh: &SphereMesh, frame: &[FrameId], plate: &[super::PlateId], i: u32) -> Option<DVec3> {
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
    found.then(|| tangent.try_normalize().unwrap_or_else(|| crate::math::any_tangent(p)))
}
