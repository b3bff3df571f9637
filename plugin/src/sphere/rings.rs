//! The neighbours of every sample, in order around it.
//!
//! A triangulation of 2n - 4 triangles in which the triangles at every sample form one closed fan
//! is a closed surface: each edge has exactly two triangles. Building the rings checks that.

/// Neighbours of all samples in one array (compressed sparse rows).
#[derive(Clone, Default)]
pub(super) struct NeighbourRings {
    start: Vec<u32>,
    neighbours: Vec<u32>,
}

impl NeighbourRings {
    /// Orders the neighbours of `n` samples; `None` unless the triangles (with indices below `n`)
    /// make a closed surface.
    pub(super) fn new(n: usize, triangles: &[[u32; 3]]) -> Option<Self> {
        if n < 4 || triangles.len() != 2 * n - 4 {
            return None;
        }
        let (start, mut fans) = gather(n, triangles);
        let mut neighbours = Vec::with_capacity(fans.len());
        for row in start.windows(2) {
            chain(&mut fans[row[0] as usize..row[1] as usize], &mut neighbours)?;
        }
        Some(Self { start, neighbours })
    }

    /// Neighbours of sample `i`, counter-clockwise seen from outside; the lowest index comes first.
    #[inline(always)]
    pub(super) fn of(&self, i: u32) -> &[u32] {
        let i = i as usize;
        &self.neighbours[self.start[i] as usize..self.start[i + 1] as usize]
    }

    /// All triangles, each with its lowest index first, in the order of that index.
    pub(super) fn triangles(&self) -> Vec<[u32; 3]> {
        let n = self.start.len() - 1;
        let mut triangles = Vec::with_capacity(2 * n - 4);
        for i in 0..n as u32 {
            let ring = self.of(i);
            let pairs = ring.iter().zip(ring.iter().cycle().skip(1));
            triangles.extend(
                pairs
                    .filter(|&(&j, &k)| i < j && i < k)
                    .map(|(&j, &k)| [i, j, k]),
            );
        }
        triangles
    }
}

/// For every sample the opposite edges of its triangles, rows of one array.
fn gather(n: usize, triangles: &[[u32; 3]]) -> (Vec<u32>, Vec<[u32; 2]>) {
    // Count the corners at each sample one place ahead: the running sum then says where rows begin.
    let mut start = vec![0u32; n + 1];
    for &i in triangles.as_flattened() {
        start[i as usize + 1] += 1;
    }
    for i in 0..n {
        start[i + 1] += start[i];
    }
    let mut next = start.clone();
    let mut fans = vec![[0; 2]; 3 * triangles.len()];
    for &[a, b, c] in triangles {
        for (i, edge) in [(a, [b, c]), (b, [c, a]), (c, [a, b])] {
            fans[next[i as usize] as usize] = edge;
            next[i as usize] += 1;
        }
    }
    (start, fans)
}

/// Appends the edges' vertices in the order of one closed walk along them; `None` if the edges form
/// several walks or an open one.
fn chain(fan: &mut [[u32; 2]], ring: &mut Vec<u32>) -> Option<()> {
    fan.sort_unstable();
    let first = fan.first()?[0];
    let mut at = first;
    for step in 0..fan.len() {
        ring.push(at);
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
