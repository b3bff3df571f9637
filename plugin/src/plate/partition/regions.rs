//! Connected regions of equally labelled samples.

use crate::sphere::SphereMesh;
use crate::sphere::components::{Components, OUTSIDE};

/// The connected regions of a labelled set of samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Regions {
    /// The region of each entry of the set; regions are numbered by their first entry.
    pub region: Vec<u32>,
    /// Number of samples of each region.
    pub size: Vec<u32>,
    /// The label of each region.
    pub label: Vec<u16>,
}

/// Finds the connected regions of `samples`, where neighbours with equal entries of `labels` belong
/// together.
pub fn connected_regions(mesh: &SphereMesh, samples: &[u32], labels: &[u16]) -> Regions {
    regions(mesh, samples, labels, &entries(mesh, samples))
}

/// Makes each label one connected region.
///
/// Its largest region stays, the first among equals. The samples of the others take, from their rim
/// inwards, the label that most of their settled neighbours have, the lowest among equals. What no
/// kept region touches keeps its label.
pub fn keep_connected(mesh: &SphereMesh, samples: &[u32], labels: &mut [u16]) {
    let entries = entries(mesh, samples);
    let regions = regions(mesh, samples, labels, &entries);
    let mut largest: Vec<Option<u32>> = Vec::new();
    for (region, (&size, &label)) in regions.size.iter().zip(&regions.label).enumerate() {
        let label = usize::from(label);
        largest.resize(largest.len().max(label + 1), None);
        if largest[label].is_none_or(|kept| regions.size[kept as usize] < size) {
            largest[label] = Some(region as u32);
        }
    }
    let kept = |entry: usize| largest[usize::from(labels[entry])] == Some(regions.region[entry]);
    let mut settled: Vec<bool> = (0..samples.len()).map(kept).collect();
    let mut stray: Vec<usize> = (0..samples.len())
        .filter(|&entry| !settled[entry])
        .collect();
    while !stray.is_empty() {
        let decide = |&entry: &usize| {
            let ring = mesh
                .ring(samples[entry])
                .iter()
                .map(|&j| entries[j as usize]);
            let near = ring.filter(|&e| e != OUTSIDE && settled[e as usize]);
            most_common(near.map(|e| labels[e as usize])).map(|label| (entry, label))
        };
        let decided: Vec<_> = stray.iter().filter_map(decide).collect();
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

/// The position of each sample of the mesh in `samples`.
fn entries(mesh: &SphereMesh, samples: &[u32]) -> Vec<u32> {
    let mut entries = vec![OUTSIDE; mesh.len()];
    samples
        .iter()
        .enumerate()
        .for_each(|(entry, &i)| entries[i as usize] = entry as u32);
    entries
}

fn regions(mesh: &SphereMesh, samples: &[u32], labels: &[u16], entries: &[u32]) -> Regions {
    let entry = |i: u32| entries[i as usize];
    let member = |i: u32| entry(i) != OUTSIDE;
    let together = |i: u32, j: u32| labels[entry(i) as usize] == labels[entry(j) as usize];
    let components = Components::new(mesh, member, together);
    let mut number = vec![OUTSIDE; components.count];
    let mut found = Regions {
        region: vec![OUTSIDE; samples.len()],
        ..Regions::default()
    };
    for (entry, &i) in samples.iter().enumerate() {
        let number = &mut number[components.of[i as usize] as usize];
        if *number == OUTSIDE {
            *number = found.size.len() as u32;
            found.size.push(0);
            found.label.push(labels[entry]);
        }
        found.region[entry] = *number;
        found.size[*number as usize] += 1;
    }
    found
}

/// The most common of a few labels, the lowest among equals.
fn most_common(labels: impl Iterator<Item = u16> + Clone) -> Option<u16> {
    let count = |label: u16| labels.clone().filter(|&other| other == label).count();
    labels
        .clone()
        .max_by_key(|&label| (count(label), core::cmp::Reverse(label)))
}
