//! Ownership without speckle: small pieces cut off from their plate go to the plate around them.
//!
//! Overlaps resolved sample by sample can leave crumbs of one plate inside of another. Crust is not touched, only who
//! carries it. Pieces above [`LARGEST_STRAY`] stay: a plate may well be cut in two.

use crate::crust::Surface;
use crate::plate::PlateId;
use crate::sphere::SphereMesh;

/// Pieces of a plate with a larger share of the sphere keep their owner: 1,000,000 km² on Earth.
pub const LARGEST_STRAY: f64 = 0.002;

/// Gives stray pieces to the neighbour with which they share the longest border. Returns the samples that changed owner.
pub fn gather_strays(mesh: &SphereMesh, surface: &mut Surface) -> usize {
    let pieces = pieces(mesh, &surface.plate);
    let limit = LARGEST_STRAY * 4.0 * crate::math::PI;
    let mut largest: Vec<(PlateId, usize)> = Vec::new();
    for (k, piece) in pieces.iter().enumerate() {
        match largest.iter_mut().find(|(plate, _)| *plate == piece.plate) {
            Some((_, best)) if pieces[*best].area < piece.area => *best = k,
            Some(_) => {}
            None => largest.push((piece.plate, k)),
        }
    }
    let mut changed = 0;
    for (k, piece) in pieces.iter().enumerate() {
        if piece.area > limit || largest.iter().any(|&(_, best)| best == k) {
            continue;
        }
        let mut border: Vec<(PlateId, u16, usize)> = Vec::new();
        for &i in &piece.samples {
            for &j in mesh.ring(i) {
                let (plate, frame) = (surface.plate[j as usize], surface.crust.frame[j as usize]);
                if plate == piece.plate {
                    continue;
                }
                match border.iter_mut().find(|entry| entry.0 == plate) {
                    Some(entry) => entry.2 += 1,
                    None => border.push((plate, frame, 1)),
                }
            }
        }
        border.sort_by_key(|&(plate, _, length)| (usize::MAX - length, plate));
        if let Some(&(plate, frame, _)) = border.first() {
            for &i in &piece.samples {
                surface.plate[i as usize] = plate;
                surface.crust.frame[i as usize] = frame;
            }
            changed += piece.samples.len();
        }
    }
    changed
}

/// A connected set of samples of one plate.
struct Piece {
    plate: PlateId,
    samples: Vec<u32>,
    area: f64,
}

/// All connected pieces in the order of their first samples.
fn pieces(mesh: &SphereMesh, plate: &[PlateId]) -> Vec<Piece> {
    let mut seen = vec![false; plate.len()];
    let mut pieces = Vec::new();
    for start in 0..plate.len() as u32 {
        if seen[start as usize] {
            continue;
        }
        seen[start as usize] = true;
        let own = plate[start as usize];
        let mut piece = Piece { plate: own, samples: vec![start], area: 0.0 };
        let mut next = 0;
        while let Some(&i) = piece.samples.get(next) {
            next += 1;
            piece.area += mesh.area(i);
            for &j in mesh.ring(i) {
                if !seen[j as usize] && plate[j as usize] == own {
                    seen[j as usize] = true;
                    piece.samples.push(j);
                }
            }
        }
        pieces.push(piece);
    }
    pieces
}
