//! Connected regions of equally labelled samples.

use crate::sphere::SphereMesh;
use crate::sphere::components::{Components, OUTSIDE, largest_of_label};
use core::cmp::Reverse;

/// The connected regions of a labelled set of samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::plate) struct Regions {
    /// The region of each entry of the set; regions are numbered by their first entry.
    pub(in crate::plate) region: Vec<u32>,
    /// Number of samples of each region.
    pub(in crate::plate) size: Vec<u32>,
    /// The label of each region.
    pub(in crate::plate) label: Vec<u16>,
}

/// Finds the connected regions of `samples`, where neighbours with equal entries of `labels` belong
/// together.
pub(in crate::plate) fn connected_regions(
    mesh: &SphereMesh,
    samples: &[u32],
    labels: &[u16],
) -> Regions {
    Part::new(mesh, samples).regions(labels)
}

/// Makes each label one connected region.
///
/// Its largest region stays, the first among equals. The samples of the others take, from their rim
/// inwards, the label that most of their settled neighbours have, the lowest among equals. A region
/// that touches no settled one keeps its label.
pub(in crate::plate) fn keep_connected(mesh: &SphereMesh, samples: &[u32], labels: &mut [u16]) {
    let part = Part::new(mesh, samples);
    let regions = part.regions(labels);
    let pieces: Vec<(u16, u32)> = regions.label.into_iter().zip(regions.size).collect();
    let stays = largest_of_label(&pieces);
    let mut settled: Vec<bool> = regions.region.iter().map(|&r| stays[r as usize]).collect();
    let mut stray: Vec<usize> = (0..samples.len()).filter(|&e| !settled[e]).collect();
    while !stray.is_empty() {
        // A whole ring is decided before any of it counts, or labels would creep along the order.
        let decide = |&e: &usize| Some((e, part.label_around(e, labels, &settled)?));
        let decided: Vec<(usize, u16)> = stray.iter().filter_map(decide).collect();
        if decided.is_empty() {
            return;
        }
        for (entry, label) in decided {
            labels[entry] = label;
            settled[entry] = true;
        }
        stray.retain(|&entry| !settled[entry]);
    }
}

/// A part of a mesh as a world of its own.
struct Part<'a> {
    mesh: &'a SphereMesh,
    samples: &'a [u32],
    /// The entry of each sample of the mesh in `samples`, or [`OUTSIDE`].
    entry: Vec<u32>,
}

impl<'a> Part<'a> {
    fn new(mesh: &'a SphereMesh, samples: &'a [u32]) -> Self {
        let mut entry = vec![OUTSIDE; mesh.len()];
        for (e, &i) in (0..).zip(samples) {
            entry[i as usize] = e;
        }
        Self {
            mesh,
            samples,
            entry,
        }
    }

    fn regions(&self, labels: &[u16]) -> Regions {
        let entry = |i: u32| self.entry[i as usize];
        let member = |i: u32| entry(i) != OUTSIDE;
        let together = |i: u32, j: u32| labels[entry(i) as usize] == labels[entry(j) as usize];
        let components = Components::new(self.mesh, member, together);
        // Components are numbered by sample, regions by entry.
        let mut number = vec![OUTSIDE; components.count];
        let mut found = Regions::default();
        for (&i, &label) in self.samples.iter().zip(labels) {
            let number = &mut number[components.of[i as usize] as usize];
            if *number == OUTSIDE {
                *number = found.size.len() as u32;
                found.size.push(0);
                found.label.push(label);
            }
            found.region.push(*number);
            found.size[*number as usize] += 1;
        }
        found
    }

    /// The label that most of the settled neighbours of an entry have.
    fn label_around(&self, entry: usize, labels: &[u16], settled: &[bool]) -> Option<u16> {
        let ring = self.mesh.ring(self.samples[entry]).iter();
        let entries = ring.map(|&j| self.entry[j as usize]);
        let near = entries.filter(|&e| e != OUTSIDE && settled[e as usize]);
        most_common(near.map(|e| labels[e as usize]))
    }
}

/// The most common of a few labels, the lowest among equals.
fn most_common(labels: impl Iterator<Item = u16> + Clone) -> Option<u16> {
    let count = |label: u16| labels.clone().filter(|&other| other == label).count();
    labels
        .clone()
        .max_by_key(|&label| (count(label), Reverse(label)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bevy::math::DVec3;

    #[test]
    fn only_strays_change_and_the_largest_region_stays() {
        let mesh = SphereMesh::fibonacci(2000).unwrap();
        let samples: Vec<u32> = (0..mesh.len() as u32).collect();
        let mut labels: Vec<u16> = mesh.points().iter().map(|p| u16::from(p.z > 0.0)).collect();
        let before = labels.clone();
        let north = mesh.nearest(DVec3::Z);
        labels[north as usize] = 0;
        labels[mesh.nearest(-DVec3::Z) as usize] = 7;
        keep_connected(&mesh, &samples, &mut labels);
        // Label 7 has no other region, so its only sample is its largest one.
        labels[mesh.nearest(-DVec3::Z) as usize] = 0;
        assert_eq!(labels, before);
    }
}
