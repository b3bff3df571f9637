//! Poisson-disk sampling of the sphere: random points, none closer to another than a given angle,
//! and no gap that could take one more disk of much that size (Bridson 2007; paper 002 §4).
//!
//! Darts are thrown into the cells of latitude bands. A cell is so small that it holds one point at
//! most, so a dart is checked against some twenty cells. A block of bands is independent of all but
//! its two neighbours: first every other block is filled, then the blocks between, which see what
//! the first have done. The blocks depend on the angle alone and every dart on its cell and round,
//! so any number of threads throws the same.

use super::cube;
use crate::math;
use crate::parallel::CHUNK;
use crate::random::{Purpose, Stream, mix};
use bevy::math::DVec3;
use rayon::prelude::*;

/// Smallest angle between points, in radians; about four million points.
const MIN_DISTANCE: f64 = 0.0015;

/// Largest angle between points, in radians; about a dozen points.
const MAX_DISTANCE: f64 = 0.8;

/// Bands per block. Two would be enough to keep blocks apart; more leave fewer seams.
const BLOCK: usize = 12;

/// Darts per cell. What is free after so many is too small to be seen.
const ROUNDS: u64 = 12;

/// Bits of a sort key that hold the point's place in the bands.
const INDEX_BITS: u32 = 24;

/// Points in random places, no two closer than `distance` radians (clamped to 0.0015..=0.8),
/// ordered along a space-filling curve. The mean distance of neighbours is about 1.3 times
/// `distance`.
pub fn poisson_disk(seed: u64, distance: f64) -> Vec<DVec3> {
    let bands = Bands::new(distance.clamp(MIN_DISTANCE, MAX_DISTANCE));
    let stream = Stream::new(seed, Purpose::BaseMesh, 0);
    let blocks = bands.rows.len().div_ceil(BLOCK);
    let throw = |parity: usize, done: &[Vec<DVec3>]| -> Vec<Vec<DVec3>> {
        let block = |b| {
            if b % 2 == parity {
                bands.fill(b, done, stream)
            } else {
                Vec::new()
            }
        };
        (0..blocks).into_par_iter().map(block).collect()
    };
    let even = throw(0, &vec![Vec::new(); blocks]);
    let odd = throw(1, &even);
    let mut points = Vec::new();
    for (a, b) in even.into_iter().zip(odd) {
        points.extend(a.into_iter().chain(b).filter(|p| *p != DVec3::ZERO));
    }
    along_curve(&points)
}

/// The points in the order of a space-filling curve: what is close on the sphere is close in
/// memory.
fn along_curve(points: &[DVec3]) -> Vec<DVec3> {
    let key = |(i, &p): (usize, &DVec3)| (cube::curve_key(p) << INDEX_BITS) | i as u64;
    let mut keys: Vec<u64> = points
        .par_iter()
        .enumerate()
        .with_min_len(CHUNK)
        .map(key)
        .collect();
    keys.par_sort_unstable();
    keys.into_iter()
        .map(|key| points[(key & ((1 << INDEX_BITS) - 1)) as usize])
        .collect()
}

/// One band of latitude, cut into cells of equal length.
struct Row {
    /// Number of cells.
    cells: usize,
    /// Place of the first cell among those of the block.
    first: usize,
    /// Half-width in turns within which cells of the bands around may hold points closer than the
    /// distance.
    reach: f64,
    /// Sine and cosine of the northern and the southern border's colatitude.
    borders: [(f64, f64); 2],
}

struct Bands {
    rows: Vec<Row>,
    /// Squared chord of the distance.
    chord2: f64,
}

impl Bands {
    fn new(distance: f64) -> Self {
        let side = distance / 2.0_f64.sqrt();
        let count = (math::PI / side).ceil() as usize;
        let colatitude = |k: usize| math::PI * k as f64 / count as f64;
        let narrow = |k: usize| math::sin(colatitude(k.min(count)));
        let mut rows: Vec<Row> = Vec::with_capacity(count);
        for k in 0..count {
            let north = math::sin_cos(colatitude(k));
            let south = math::sin_cos(colatitude(k + 1));
            // The widest circle of the band; beside the equator that is the equator itself.
            let widest = if north.1 * south.1 < 0.0 {
                1.0
            } else {
                north.0.max(south.0)
            };
            let least = narrow(k.saturating_sub(2)).min(narrow(k + 3));
            let half_chord = 0.5 * distance / least.max(1e-12);
            let reach = if half_chord >= 1.0 {
                0.5
            } else {
                2.0 * math::asin(half_chord) / math::TAU
            };
            let first = if k.is_multiple_of(BLOCK) {
                0
            } else {
                rows[k - 1].first + rows[k - 1].cells
            };
            let cells = ((math::TAU * widest / side).ceil() as usize).max(3);
            rows.push(Row {
                cells,
                first,
                reach: reach * 1.0001,
                borders: [north, south],
            });
        }
        let half = math::sin(0.5 * distance);
        Self {
            rows,
            chord2: 4.0 * half * half,
        }
    }

    /// Throws darts into block `b`; `done` holds the blocks that are filled already.
    fn fill(&self, b: usize, done: &[Vec<DVec3>], stream: Stream) -> Vec<DVec3> {
        let range = b * BLOCK..((b + 1) * BLOCK).min(self.rows.len());
        let last = &self.rows[range.end - 1];
        let mut own = vec![DVec3::ZERO; last.first + last.cells];
        let edges: Vec<Vec<(f64, f64)>> = range.clone().map(|k| self.edges(k)).collect();
        for round in 0..ROUNDS {
            for k in range.clone() {
                let row = &self.rows[k];
                for cell in 0..row.cells {
                    let slot = row.first + cell;
                    if own[slot] != DVec3::ZERO {
                        continue;
                    }
                    let bits = stream.bits(mix((k as u64) << 32 | cell as u64) ^ round);
                    // In each of the first four rounds a quarter of the cells, or the scan's
                    // direction would show.
                    if round < 4 && (bits ^ round) & 3 != 0 {
                        continue;
                    }
                    let (u, v) = (fraction(bits >> 2), fraction(bits >> 33));
                    let dart = self.dart(row, &edges[k - range.start], cell, u, v);
                    let turn = (cell as f64 + u) / row.cells as f64;
                    if self.is_free(k, turn, dart, b, &own, done) {
                        own[slot] = dart;
                    }
                }
            }
        }
        own
    }

    /// Sine and cosine of the longitude of every cell's western border in band `k`, and the first
    /// again.
    fn edges(&self, k: usize) -> Vec<(f64, f64)> {
        let cells = self.rows[k].cells;
        (0..=cells)
            .map(|c| math::sin_cos(math::TAU * c as f64 / cells as f64))
            .collect()
    }

    fn dart(&self, row: &Row, edges: &[(f64, f64)], cell: usize, u: f64, v: f64) -> DVec3 {
        let corner = |border: usize, edge: usize| {
            let ((sin, cos), (sin_lon, cos_lon)) = (row.borders[border], edges[edge]);
            DVec3::new(sin * cos_lon, sin * sin_lon, cos)
        };
        let north = corner(0, cell).lerp(corner(0, cell + 1), u);
        let south = corner(1, cell).lerp(corner(1, cell + 1), u);
        north.lerp(south, v).normalize()
    }

    /// Whether no point lies within the distance of a dart thrown at `turn` (of a whole one) in
    /// band `k`.
    fn is_free(
        &self,
        k: usize,
        turn: f64,
        dart: DVec3,
        b: usize,
        own: &[DVec3],
        done: &[Vec<DVec3>],
    ) -> bool {
        let reach = self.rows[k].reach;
        // Its own band first: there a dart that is not free most often meets a point.
        for near in [k, k.wrapping_sub(1), k + 1, k.wrapping_sub(2), k + 2] {
            let Some(row) = self.rows.get(near) else {
                continue;
            };
            let block = near / BLOCK;
            let points = if block == b { own } else { &done[block] };
            if points.is_empty() {
                continue;
            }
            let cells = &points[row.first..row.first + row.cells];
            let taken = |p: &DVec3| *p != DVec3::ZERO && (*p - dart).length_squared() < self.chord2;
            if reach >= 0.5 {
                if cells.iter().any(taken) {
                    return false;
                }
                continue;
            }
            let n = row.cells as f64;
            let (from, to) = (
                ((turn - reach) * n).floor() as i64,
                ((turn + reach) * n).floor() as i64,
            );
            let len = row.cells as i64;
            if (from.max(0)..(to + 1).min(len)).any(|c| taken(&cells[c as usize]))
                || (from..0).any(|c| taken(&cells[(c + len).max(0) as usize]))
                || (len..to + 1).any(|c| taken(&cells[(c - len).min(len - 1) as usize]))
            {
                return false;
            }
        }
        true
    }
}

/// A number in 0..1 from the 31 lowest bits.
fn fraction(bits: u64) -> f64 {
    (bits & 0x7fff_ffff) as f64 * (1.0 / 2_147_483_648.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sphere::SphereMesh;

    #[test]
    fn no_two_points_are_too_close_and_no_gap_is_left() {
        for (seed, distance) in [(1, 0.05), (2, 0.3), (9, 0.013)] {
            let mesh = SphereMesh::from_points(poisson_disk(seed, distance)).unwrap();
            let mut longest = 0.0_f64;
            for i in 0..mesh.len() as u32 {
                for &j in mesh.ring(i) {
                    let angle = math::angle_between(mesh.point(i), mesh.point(j));
                    assert!(
                        angle >= distance * (1.0 - 1e-9),
                        "{i} {j}: {angle} at {distance}"
                    );
                    longest = longest.max(angle);
                }
            }
            // Neighbours around a gap that takes no further disk are at most two distances apart;
            // the darts leave few gaps that do.
            assert!(longest < 2.7 * distance, "{longest} at {distance}");
        }
    }

    #[test]
    fn points_are_even_but_have_no_lattice() {
        let mesh = SphereMesh::from_points(poisson_disk(4, 0.02)).unwrap();
        let n = mesh.len() as f64;
        let sum: DVec3 = mesh.points().iter().sum();
        assert!(sum.length() < 0.003 * n, "{sum}");
        // Directions of the edges, as hexagons and squares would show them.
        for fold in [2.0, 4.0, 6.0] {
            let (mut c, mut s, mut count) = (0.0, 0.0, 0.0);
            for i in 0..mesh.len() as u32 {
                let p = mesh.point(i);
                if p.z.abs() > 0.9 {
                    continue;
                }
                let east = DVec3::new(-p.y, p.x, 0.0).normalize();
                for &j in mesh.ring(i) {
                    let d = mesh.point(j) - p;
                    let (sin, cos) =
                        math::sin_cos(fold * math::atan2(d.dot(p.cross(east)), d.dot(east)));
                    (c, s, count) = (c + cos, s + sin, count + 1.0);
                }
            }
            assert!(
                (c * c + s * s).sqrt() / count < 0.02,
                "{fold}-fold order {c} {s} of {count}"
            );
        }
        // Six neighbours are common, other numbers are, too.
        let six = (0..mesh.len() as u32)
            .filter(|&i| mesh.ring(i).len() == 6)
            .count() as f64;
        assert!(six < 0.6 * n, "{six} of {n}");
    }

    #[test]
    fn the_same_points_on_any_number_of_threads() {
        let pool = |threads| {
            rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap()
        };
        let one = pool(1).install(|| poisson_disk(5, 0.02));
        assert_eq!(one, pool(3).install(|| poisson_disk(5, 0.02)));
        assert_ne!(one, poisson_disk(6, 0.02));
    }
}
