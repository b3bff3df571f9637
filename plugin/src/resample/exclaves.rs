//! Ownership without speckle: small pieces cut off from their plate go to the plate around them.
//!
//! Overlaps resolved sample by sample can leave crumbs of one plate inside of another. Crust is not
//! touched, only who carries it. Pieces above [`LARGEST_STRAY`] stay: a plate may well be cut in
//! two.

use crate::crust::Surface;
use crate::plate::PlateId;
use crate::sphere::SphereMesh;
use crate::sphere::components::{Components, largest_of_label};

/// Pieces of a plate with a larger share of the sphere keep their owner: 1,000,000 km² on Earth.
pub const LARGEST_STRAY: f64 = 0.002;

/// Gives stray pieces to the neighbour with which they share the longest border. Returns the
/// samples that changed owner.
pub fn merge_exclaves(mesh: &SphereMesh, surface: &mut Surface) -> usize {
    let mut changed = 0;
    for piece in strays(mesh, &surface.plate) {
        let own = surface.plate[piece[0] as usize];
        let mut border: Vec<(PlateId, u16, usize)> = Vec::new();
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
        border.sort_by_key(|&(plate, _, length)| (usize::MAX - length, plate));
        if let Some(&(plate, frame, _)) = border.first() {
            for &i in &piece {
                surface.plate[i as usize] = plate;
                surface.crust.frame[i as usize] = frame;
            }
            changed += piece.len();
        }
    }
    changed
}

/// The samples of all pieces that are neither large nor the largest of their plate, in the order of
/// their first samples.
fn strays(mesh: &SphereMesh, plate: &[PlateId]) -> Vec<Vec<u32>> {
    let together = |i: u32, j: u32| plate[i as usize] == plate[j as usize];
    let components = Components::new(mesh, |_| true, together);
    let mut pieces: Vec<(PlateId, f64)> = vec![(PlateId::default(), 0.0); components.count];
    for (i, &number) in components.of.iter().enumerate() {
        let piece = &mut pieces[number as usize];
        piece.0 = plate[i];
        piece.1 += mesh.areas()[i];
    }
    let is_largest = largest_of_label(&pieces);
    let limit = LARGEST_STRAY * 4.0 * crate::math::PI;
    let mut slot = vec![usize::MAX; pieces.len()];
    let mut count = 0;
    for (k, &(_, area)) in pieces.iter().enumerate() {
        if area <= limit && !is_largest[k] {
            slot[k] = count;
            count += 1;
        }
    }
    let mut strays = vec![Vec::new(); count];
    for (i, &number) in components.of.iter().enumerate() {
        if let Some(stray) = strays.get_mut(slot[number as usize]) {
            stray.push(i as u32);
        }
    }
    strays
}
