//! The neighbours of every sample, in order around it.
//!
//! A triangulation of 2n - 4 triangles in which the triangles at every sample form one closed fan
//! is a closed surface: each edge has exactly two triangles. Building the rings checks that.

use super::rows::Rows;
use crate::parallel;

/// Neighbours of all samples.
#[derive(Clone)]
pub(super) struct NeighbourRings(Rows<u32>);

impl NeighbourRings {
    /// Orders the neighbours of `n` samples; `None` unless the triangles (with indices below `n`)
    /// make a closed surface.
    pub(super) fn new(n: usize, triangles: &[[u32; 3]]) -> Option<Self> {
        if n < 4 || triangles.len() != 2 * n - 4 {
            return None;
        }
        // Each triangle is one step around each of its corners: along the edge opposite to it.
        let triangles = triangles.iter();
        let edges = triangles.flat_map(|&[a, b, c]| [(a, [b, c]), (b, [c, a]), (c, [a, b])]);
        let fans: Rows<[u32; 2]> = Rows::new(n, edges);
        fans.map(chain).map(Self)
    }

    /// Neighbours of sample `i`, counter-clockwise seen from outside; the lowest index comes first.
    #[inline(always)]
    pub(super) fn of(&self, i: u32) -> &[u32] {
        self.0.row(i as usize)
    }

    /// All triangles, each with its lowest index first, in the order of that index.
    pub(super) fn triangles(&self) -> Vec<[u32; 3]> {
        let parts = parallel::map_chunks(self.0.len(), |range| {
            let rows = range.flat_map(|i| self.triangles_of(i as u32));
            rows.collect::<Vec<_>>()
        });
        parts.concat()
    }

    /// The triangles of which `i` is the lowest index, in the order of its ring.
    fn triangles_of(&self, i: u32) -> impl Iterator<Item = [u32; 3]> {
        let ring = self.of(i);
        let pairs = ring.iter().zip(ring.iter().cycle().skip(1));
        // A triangle stands in the rings of its three corners; the lowest of them tells it.
        pairs
            .filter(move |&(&j, &k)| i < j && i < k)
            .map(move |(&j, &k)| [i, j, k])
    }
}

/// Writes the edges' vertices in the order of one closed walk along them; `None` if the edges form
/// several walks or an open one.
fn chain(fan: &mut [[u32; 2]], ring: &mut [u32]) -> Option<()> {
    // By their first vertex, so that a walk finds each next edge by bisection.
    fan.sort_unstable();
    let first = fan.first()?[0];
    let mut at = first;
    for (step, place) in ring.iter_mut().enumerate() {
        *place = at;
        let edge = fan.binary_search_by_key(&at, |e| e[0]).ok()?;
        at = fan[edge][1];
        // Back too early: the fan falls into several loops.
        if at == first && step + 1 < fan.len() {
            return None;
        }
    }
    (at == first && fan.len() >= 3).then_some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];

    #[test]
    fn a_tetrahedron_has_rings_of_three() {
        let rings = NeighbourRings::new(4, &TETRAHEDRON).unwrap();
        assert_eq!(rings.of(0), [1, 2, 3]);
        assert_eq!(rings.of(1), [0, 3, 2]);
        let mut triangles = rings.triangles();
        triangles.sort_unstable();
        assert_eq!(triangles, TETRAHEDRON);
    }

    #[test]
    fn surfaces_with_holes_or_flipped_triangles_are_refused() {
        let mut flipped = TETRAHEDRON;
        flipped[3] = [1, 2, 3];
        assert!(NeighbourRings::new(4, &flipped).is_none());
        let mut doubled = TETRAHEDRON;
        doubled[3] = [0, 1, 2];
        assert!(NeighbourRings::new(4, &doubled).is_none());
        assert!(NeighbourRings::new(4, &TETRAHEDRON[..3]).is_none());
        assert!(NeighbourRings::new(5, &TETRAHEDRON).is_none());
    }
}
