//! Connected components of samples.
//!
//! Union-find, first within chunks of samples and then across their borders. Samples follow a
//! space-filling curve, so few links cross. Components are numbered by their first samples: the
//! numbers depend on nothing else.

use super::SphereMesh;
use crate::parallel::CHUNK;
use bevy::reflect::Reflect;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// The number of a sample that is in no component.
pub const OUTSIDE: u32 = u32::MAX;

/// Samples per unit of parallel work.
const BLOCK: usize = 8 * CHUNK;

/// Which samples are connected.
///
/// ```
/// # use bevy_pangaea::sphere::{SphereMesh, components::{Components, OUTSIDE}};
/// let mesh = SphereMesh::fibonacci(2000)?;
/// // Two caps around the poles.
/// let polar = |i: u32| mesh.point(i).z.abs() > 0.8;
/// let caps = Components::new(&mesh, polar, |_, _| true);
/// assert_eq!(caps.count, 2);
/// assert!(caps.samples(0).iter().all(|&i| polar(i)));
/// assert_eq!(caps.of[mesh.nearest(bevy::math::DVec3::X) as usize], OUTSIDE);
/// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Reflect)]
pub struct Components {
    /// The component of every sample of the mesh, or [`OUTSIDE`].
    pub of: Vec<u32>,
    /// Number of components.
    pub count: usize,
}

impl Components {
    /// Connects neighbours that are both a `member` and belong `together`.
    pub fn new(
        mesh: &SphereMesh,
        member: impl Fn(u32) -> bool + Sync,
        together: impl Fn(u32, u32) -> bool + Sync,
    ) -> Self {
        let mut parent = vec![OUTSIDE; mesh.len()];
        let crossing: Vec<Vec<(u32, u32)>> = parent
            .par_chunks_mut(BLOCK)
            .enumerate()
            .map(|(block, parent)| {
                let start = (block * BLOCK) as u32;
                join_block(mesh, start, parent, &member, &together)
            })
            .collect();
        // In the order of blocks, on one thread: few links cross.
        for (i, j) in crossing.into_iter().flatten() {
            join(&mut parent, 0, i, j);
        }
        Self::numbered(parent)
    }

    /// Turns parents, which are never higher than their children, into numbers.
    fn numbered(mut parent: Vec<u32>) -> Self {
        let mut count = 0;
        // Parents come first, so those of later samples are numbers already.
        for i in 0..parent.len() {
            let above = parent[i];
            if above == i as u32 {
                parent[i] = count;
                count += 1;
            } else if above != OUTSIDE {
                parent[i] = parent[above as usize];
            }
        }
        Self {
            of: parent,
            count: count as usize,
        }
    }

    /// The samples of one component, in order.
    pub fn samples(&self, number: u32) -> Vec<u32> {
        let parts = crate::parallel::map_chunks(self.of.len(), |range| {
            range
                .filter(|&i| self.of[i] == number)
                .map(|i| i as u32)
                .collect::<Vec<_>>()
        });
        parts.concat()
    }
}

/// Builds the forest of one block of samples, the first of which is `start`. Returns the links to
/// samples of earlier blocks.
fn join_block(
    mesh: &SphereMesh,
    start: u32,
    parent: &mut [u32],
    member: impl Fn(u32) -> bool,
    together: impl Fn(u32, u32) -> bool,
) -> Vec<(u32, u32)> {
    let mut crossing = Vec::new();
    for i in start..start + parent.len() as u32 {
        if !member(i) {
            continue;
        }
        parent[(i - start) as usize] = i;
        // Links to later samples are found from those.
        for &j in mesh.ring(i).iter().filter(|&&j| j < i) {
            if j < start {
                if member(j) && together(j, i) {
                    crossing.push((j, i));
                }
            } else if parent[(j - start) as usize] != OUTSIDE && together(j, i) {
                join(parent, start, j, i);
            }
        }
    }
    crossing
}

/// For each of some pieces, given by label and size: whether it is the largest of its label, the
/// first among equals.
pub(crate) fn largest_of_label<L: Ord, S: PartialOrd>(pieces: &[(L, S)]) -> Vec<bool> {
    let mut largest: BTreeMap<&L, usize> = BTreeMap::new();
    for (k, (label, size)) in pieces.iter().enumerate() {
        let best = largest.entry(label).or_insert(k);
        if pieces[*best].1 < *size {
            *best = k;
        }
    }
    let mut is_largest = vec![false; pieces.len()];
    largest.into_values().for_each(|k| is_largest[k] = true);
    is_largest
}

/// Joins two trees of a forest whose first entry is the sample `start`: the lower root stays.
fn join(parent: &mut [u32], start: u32, i: u32, j: u32) {
    let (a, b) = (root(parent, start, i), root(parent, start, j));
    // So a root is the first sample of its tree, in whatever order trees are joined.
    parent[(a.max(b) - start) as usize] = a.min(b);
}

/// The root of the tree of sample `i`. Entries on the way are hung one step higher, so that later
/// ways are short.
fn root(parent: &mut [u32], start: u32, mut i: u32) -> u32 {
    loop {
        let above = parent[(i - start) as usize];
        if above == i {
            return i;
        }
        let next = parent[(above - start) as usize];
        parent[(i - start) as usize] = next;
        i = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A flood from every sample that no earlier flood has reached.
    fn flooded(mesh: &SphereMesh, label: &[u8]) -> Components {
        let mut found = Components {
            of: vec![OUTSIDE; mesh.len()],
            count: 0,
        };
        for start in 0..mesh.len() as u32 {
            if label[start as usize] == 0 || found.of[start as usize] != OUTSIDE {
                continue;
            }
            let mut open = vec![start];
            while let Some(i) = open.pop() {
                if found.of[i as usize] == OUTSIDE {
                    found.of[i as usize] = found.count as u32;
                    let like = |j: &&u32| label[**j as usize] == label[i as usize];
                    open.extend(mesh.ring(i).iter().filter(like));
                }
            }
            found.count += 1;
        }
        found
    }

    /// Labels 0..=3 in a pattern of waves with `scale` and `fine` as wave numbers.
    fn labels(mesh: &SphereMesh, scale: f64, fine: f64) -> Vec<u8> {
        let wave = |x: f64| crate::math::sin(scale * x) + crate::math::sin(fine * x * x);
        let height = |p: &bevy::math::DVec3| wave(p.x) + wave(p.y) * wave(p.z) + 2.0;
        let points = mesh.points().iter();
        points
            .map(|p| (height(p) as i32).clamp(0, 3) as u8)
            .collect()
    }

    #[test]
    fn the_first_of_the_largest_pieces_stays() {
        let pieces = [('a', 3), ('b', 1), ('a', 5), ('b', 1), ('a', 5)];
        assert_eq!(largest_of_label(&pieces), [false, true, true, false, false]);
    }

    #[test]
    fn equals_a_flood() {
        let mesh = SphereMesh::fibonacci(40_000).unwrap();
        for (scale, fine) in [(3.0, 0.0), (9.0, 2.0), (40.0, 0.0), (200.0, 30.0)] {
            let label = labels(&mesh, scale, fine);
            let found = Components::new(
                &mesh,
                |i| label[i as usize] != 0,
                |i, j| label[i as usize] == label[j as usize],
            );
            assert_eq!(found, flooded(&mesh, &label));
            assert!(found.count > 1);
            let samples: usize = (0..found.count as u32)
                .map(|k| found.samples(k).len())
                .sum();
            assert_eq!(samples, label.iter().filter(|&&l| l != 0).count());
        }
    }
}
