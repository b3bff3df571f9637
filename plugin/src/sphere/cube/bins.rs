//! Coarse bins for directions: the faces of the cube cut into equal squares.

use super::{FacePoint, project, unproject};
use bevy::math::DVec3;

/// Gnomonic coordinates change by less than this times a small chord, at the corners of a face,
/// too.
const LARGEST_STRETCH: f64 = 3.5;

/// Chord up to which [`LARGEST_STRETCH`] holds.
const SMALL_CHORD: f64 = 0.1;

/// Least depth of a unit vector in the direction of the face that it lies on: 1/√3, rounded down.
const LEAST_DEPTH: f64 = 0.57;

/// A grid of bins: each face of the cube has `cells` x `cells` of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CubeGrid {
    cells: usize,
}

impl CubeGrid {
    /// A grid with `cells` bins along each edge of the cube, at least 1.
    pub(crate) fn new(cells: usize) -> Self {
        Self {
            cells: cells.max(1),
        }
    }

    /// Number of bins on all faces.
    pub(crate) fn len(&self) -> usize {
        6 * self.cells * self.cells
    }

    /// The bin that holds the direction `p`, which need not be normalised.
    #[inline]
    pub(crate) fn cell(&self, p: DVec3) -> usize {
        let at = project(p);
        self.index(at.face, self.column(at.u), self.column(at.v))
    }

    /// Unit direction of a bin's centre.
    pub(crate) fn center(&self, cell: usize) -> DVec3 {
        let (face, column, row) = self.split(cell);
        let at = |k: usize| (k as f64 + 0.5) / self.cells as f64 * 2.0 - 1.0;
        unproject(face, at(column), at(row)).normalize()
    }

    /// Chord from the centre of a bin to its farthest corner.
    pub(crate) fn radius(&self, cell: usize) -> f64 {
        let center = self.center(cell);
        let (face, column, row) = self.split(cell);
        let at = |k: usize| k as f64 / self.cells as f64 * 2.0 - 1.0;
        (0..4)
            .map(|k| unproject(face, at(column + k % 2), at(row + k / 2)).normalize())
            .map(|corner| corner.distance(center))
            .fold(0.0, f64::max)
    }

    /// Calls `visit` for every bin that may lie within the chord `reach` of the unit direction `p`.
    /// All bins within reach are visited, and some just beyond.
    #[inline]
    pub(crate) fn visit_near(&self, p: DVec3, reach: f64, mut visit: impl FnMut(usize)) {
        match self.only_cell(p, reach) {
            Some(cell) => visit(cell),
            None => self.visit_faces(p, reach, visit),
        }
    }

    /// The bin of `p`, if nothing within reach lies in another. Most visits end here.
    #[inline]
    fn only_cell(&self, p: DVec3, reach: f64) -> Option<usize> {
        let FacePoint { face, u, v } = project(p);
        let margin = LARGEST_STRETCH * reach;
        let low = [u - margin, v - margin].map(|x| (x + 1.0) * 0.5 * self.cells as f64);
        let high = [u + margin, v + margin].map(|x| (x + 1.0) * 0.5 * self.cells as f64);
        let end = self.cells as f64;
        let inside = low[0] > 0.0 && low[1] > 0.0 && high[0] < end && high[1] < end;
        // Above 0 a cast rounds down; below it would round up.
        let same = low[0] as usize == high[0] as usize && low[1] as usize == high[1] as usize;
        (inside && same && reach < SMALL_CHORD)
            .then(|| self.index(face, low[0] as usize, low[1] as usize))
    }

    /// Visits on every face the rectangle of bins that encloses what lies within reach.
    fn visit_faces(&self, p: DVec3, reach: f64, mut visit: impl FnMut(usize)) {
        for face in 0..6 {
            let (depth, u, v) = components(face, p);
            // Nothing within reach is deep enough to lie on this face.
            if depth + reach < LEAST_DEPTH {
                continue;
            }
            let (u0, u1) = gnomonic_range(u, depth, reach);
            let (v0, v1) = gnomonic_range(v, depth, reach);
            if u0 > 1.0 || u1 < -1.0 || v0 > 1.0 || v1 < -1.0 {
                continue;
            }
            for row in self.column(v0)..=self.column(v1) {
                for column in self.column(u0)..=self.column(u1) {
                    visit(self.index(face, column, row));
                }
            }
        }
    }

    #[inline]
    fn column(&self, u: f64) -> usize {
        // The cast saturates: coordinates below the edge fall into column 0.
        (((u + 1.0) * 0.5 * self.cells as f64) as usize).min(self.cells - 1)
    }

    #[inline]
    fn index(&self, face: u32, column: usize, row: usize) -> usize {
        (face as usize * self.cells + row) * self.cells + column
    }

    /// Face, column and row of a bin.
    fn split(&self, cell: usize) -> (u32, usize, usize) {
        let row = cell / self.cells;
        (
            (row / self.cells) as u32,
            cell % self.cells,
            row % self.cells,
        )
    }
}

/// Least and greatest quotient x / depth over all displacements of both by at most `reach`, where
/// the depth is at least [`LEAST_DEPTH`].
#[inline]
fn gnomonic_range(x: f64, depth: f64, reach: f64) -> (f64, f64) {
    let near = (depth - reach).max(LEAST_DEPTH);
    // A negative numerator is least over the smallest depth, a positive one over the greatest.
    let low = (x - reach) / if x < reach { near } else { depth + reach };
    let high = (x + reach) / if x > -reach { near } else { depth + reach };
    (low, high)
}

/// Depth of `p` along the normal of a face, and the two coordinates across it.
#[inline]
fn components(face: u32, p: DVec3) -> (f64, f64, f64) {
    match face {
        0 => (p.x, p.y, p.z),
        1 => (-p.x, p.y, p.z),
        2 => (p.y, p.x, p.z),
        3 => (-p.y, p.x, p.z),
        4 => (p.z, p.x, p.y),
        _ => (-p.z, p.x, p.y),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Stream};

    #[test]
    fn centres_lie_in_their_cells() {
        let grid = CubeGrid::new(7);
        for cell in 0..grid.len() {
            assert_eq!(grid.cell(grid.center(cell)), cell);
        }
    }

    #[test]
    fn no_near_cell_is_left_out() {
        let grid = CubeGrid::new(9);
        let stream = Stream::new(1, Purpose::PlateCentroids, 0);
        for i in 0..4000 {
            let p = stream.direction(2 * i);
            let reach = 0.002 + 0.2 * stream.unit(1_000_000 + i);
            let mut seen = vec![false; grid.len()];
            grid.visit_near(p, reach, |cell| seen[cell] = true);
            for k in 0..8 {
                let near = (p + stream.direction(50_000 + 8 * i + k) * (reach * 0.999)).normalize();
                if near.distance(p) <= reach {
                    assert!(seen[grid.cell(near)], "{p} {near} {reach}");
                }
            }
            assert!(seen.iter().filter(|&&s| s).count() < grid.len() / 3);
        }
    }
}
