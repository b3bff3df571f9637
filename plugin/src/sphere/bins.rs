//! A cube laid around the sphere: six faces of equal square cells, for coarse bins.

use bevy::math::DVec3;

/// Bins for directions: each face of the cube has `cells` x `cells` of them (gnomonic projection).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CubeGrid {
    cells: usize,
}

impl CubeGrid {
    /// A grid with `cells` cells along each edge of the cube.
    pub fn new(cells: usize) -> Self {
        Self {
            cells: cells.max(1),
        }
    }

    /// Number of cells on all faces.
    pub fn len(&self) -> usize {
        6 * self.cells * self.cells
    }

    /// Never true; there are at least six cells.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The cell that holds the direction `p`, which need not be normalised.
    #[inline]
    pub fn cell(&self, p: DVec3) -> usize {
        let (face, u, v) = project(p);
        self.index(face, self.column(u), self.column(v))
    }

    /// Unit direction of a cell's centre.
    pub fn center(&self, cell: usize) -> DVec3 {
        let (face, column, row) = self.split(cell);
        let at = |k: usize| (k as f64 + 0.5) / self.cells as f64 * 2.0 - 1.0;
        unproject(face, at(column), at(row)).normalize()
    }

    /// Chord from the centre of a cell to its farthest corner.
    pub fn radius(&self, cell: usize) -> f64 {
        let center = self.center(cell);
        let (face, column, row) = self.split(cell);
        let at = |k: usize| k as f64 / self.cells as f64 * 2.0 - 1.0;
        (0..4)
            .map(|k| unproject(face, at(column + k % 2), at(row + k / 2)).normalize())
            .map(|corner| corner.distance(center))
            .fold(0.0, f64::max)
    }

    /// Calls `visit` for every cell that may lie within the chord `reach` of the unit direction
    /// `p`. Cells near the limit may be visited without lying within it; none within it is left
    /// out.
    #[inline]
    pub fn visit_near(&self, p: DVec3, reach: f64, mut visit: impl FnMut(usize)) {
        match self.only_cell(p, reach) {
            Some(cell) => visit(cell),
            None => self.visit_faces(p, reach, visit),
        }
    }

    /// The cell of `p`, if nothing within reach lies in another.
    #[inline]
    fn only_cell(&self, p: DVec3, reach: f64) -> Option<usize> {
        let (face, u, v) = project(p);
        // Gnomonic coordinates change by at most 3.5 times a small chord, at the corners of a face.
        let spread = 3.5 * reach;
        let low = [u - spread, v - spread].map(|x| (x + 1.0) * 0.5 * self.cells as f64);
        let high = [u + spread, v + spread].map(|x| (x + 1.0) * 0.5 * self.cells as f64);
        let end = self.cells as f64;
        let inside = low[0] > 0.0 && low[1] > 0.0 && high[0] < end && high[1] < end;
        let same = low[0] as usize == high[0] as usize && low[1] as usize == high[1] as usize;
        (inside && same && reach < 0.1).then(|| self.index(face, low[0] as usize, low[1] as usize))
    }

    fn visit_faces(&self, p: DVec3, reach: f64, mut visit: impl FnMut(usize)) {
        for face in 0..6 {
            let (depth, u, v) = components(face, p);
            // A point of a face has a depth of 1/sqrt(3) at least.
            if depth + reach < 0.57 {
                continue;
            }
            let near = (depth - reach).max(0.57);
            let range = |x: f64| {
                // Extremes of x / depth over all displacements within reach.
                let low = (x - reach) / if x < reach { near } else { depth + reach };
                let high = (x + reach) / if x > -reach { near } else { depth + reach };
                (low, high)
            };
            let ((u0, u1), (v0, v1)) = (range(u), range(v));
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
        // The cast saturates: coordinates below the edge fall into cell 0.
        (((u + 1.0) * 0.5 * self.cells as f64) as usize).min(self.cells - 1)
    }

    #[inline]
    fn index(&self, face: usize, column: usize, row: usize) -> usize {
        (face * self.cells + row) * self.cells + column
    }

    fn split(&self, cell: usize) -> (usize, usize, usize) {
        let row = cell / self.cells;
        (row / self.cells, cell % self.cells, row % self.cells)
    }
}

/// Face and gnomonic coordinates in -1..1.
#[inline]
fn project(p: DVec3) -> (usize, f64, f64) {
    let a = p.abs();
    let face = if a.x >= a.y && a.x >= a.z {
        usize::from(p.x < 0.0)
    } else if a.y >= a.z {
        2 + usize::from(p.y < 0.0)
    } else {
        4 + usize::from(p.z < 0.0)
    };
    let (depth, u, v) = components(face, p);
    let scale = 1.0 / depth;
    (face, u * scale, v * scale)
}

/// Depth along the face's normal, and the two coordinates across it.
#[inline]
fn components(face: usize, p: DVec3) -> (f64, f64, f64) {
    match face {
        0 => (p.x, p.y, p.z),
        1 => (-p.x, p.y, p.z),
        2 => (p.y, p.x, p.z),
        3 => (-p.y, p.x, p.z),
        4 => (p.z, p.x, p.y),
        _ => (-p.z, p.x, p.y),
    }
}

fn unproject(face: usize, u: f64, v: f64) -> DVec3 {
    match face {
        0 => DVec3::new(1.0, u, v),
        1 => DVec3::new(-1.0, u, v),
        2 => DVec3::new(u, 1.0, v),
        3 => DVec3::new(u, -1.0, v),
        4 => DVec3::new(u, v, 1.0),
        _ => DVec3::new(u, v, -1.0),
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
