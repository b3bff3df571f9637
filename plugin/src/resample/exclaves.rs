//! Exclaves: small pieces cut off from their plate go to the plate around them.
//!
//! Overlaps resolved sample by sample can leave a few samples of one plate inside of another. Crust
//! is not touched, only who carries it. Pieces above [`LARGEST_EXCLAVE`] stay: a plate may well be
//! cut in two.

use crate::crust::Surface;
use crate::ids::{FrameId, PlateId};
use crate::math::PI;
use crate::sphere::SphereMesh;
use crate::sphere::components::{Components, largest_of_label};

/// Pieces of a plate with a larger share of the sphere keep their owner: 1,000,000 km² on Earth.
const LARGEST_EXCLAVE: f64 = 0.002;

/// Gives exclaves to the neighbour with which they share the longest border. Returns the samples
/// that changed owner.
pub(super) fn merge_exclaves(mesh: &SphereMesh, surface: &mut Surface) -> usize {
    let mut changed = 0;
    for piece in exclaves(mesh, &surface.plate) {
        if let Some((plate, frame)) = main_neighbour(mesh, surface, &piece) {
            for &i in &piece {
                surface.plate[i as usize] = plate;
                surface.crust.frame[i as usize] = frame;
            }
            changed += piece.len();
        }
    }
    changed
}

/// The plate, and a frame of it, that has the longest border with a piece; of equals the plate with
/// the lower number.
fn main_neighbour(
    mesh: &SphereMesh,
    surface: &Surface,
    piece: &[u32],
) -> Option<(PlateId, FrameId)> {
    let own = surface.plate[piece[0] as usize];
    // Every edge across the border counts once: their number stands for its length.
    let mut border: Vec<(PlateId, FrameId, usize)> = Vec::new();
    for &j in piece.iter().flat_map(|&i| mesh.ring(i)) {
        let (plate, frame) = (surface.plate[j as usize], surface.crust.frame[j as usize]);
        if plate == own {
            continue;
        }
        match border.iter_mut().find(|entry| entry.0 == plate) {
            Some(entry) => entry.2 += 1,
            None => border.push((plate, frame, 1)),
        }
    }
    border
        .into_iter()
        .min_by_key(|&(plate, _, length)| (usize::MAX - length, plate))
        .map(|(plate, frame, _)| (plate, frame))
}

/// The samples of all pieces that are neither large nor the largest of their plate, in the order of
/// their first samples.
fn exclaves(mesh: &SphereMesh, plate: &[PlateId]) -> Vec<Vec<u32>> {
    let pieces = Components::new(
        mesh,
        |_| true,
        |i, j| plate[i as usize] == plate[j as usize],
    );
    let mut sizes: Vec<(PlateId, f64)> = vec![(PlateId::default(), 0.0); pieces.count];
    for (i, &number) in pieces.of.iter().enumerate() {
        let size = &mut sizes[number as usize];
        size.0 = plate[i];
        size.1 += mesh.areas()[i];
    }
    let is_largest = largest_of_label(&sizes);
    let limit = LARGEST_EXCLAVE * 4.0 * PI;
    // Position of each piece in the list that is returned.
    let mut slot = vec![None; pieces.count];
    let mut count = 0;
    for (k, &(_, area)) in sizes.iter().enumerate() {
        // A plate that is all small keeps its largest piece: no plate dies of tidying up.
        if area <= limit && !is_largest[k] {
            slot[k] = Some(count);
            count += 1;
        }
    }
    let mut exclaves = vec![Vec::new(); count];
    for (i, &number) in pieces.of.iter().enumerate() {
        if let Some(k) = slot[number as usize] {
            exclaves[k].push(i as u32);
        }
    }
    exclaves
}
