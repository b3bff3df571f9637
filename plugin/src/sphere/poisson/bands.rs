//! The sphere cut into bands of latitude, and the bands into cells that hold one point at most.

use crate::math;
use bevy::math::DVec3;
use core::ops::Range;

/// Bands per block. Two would be enough to keep blocks apart; more leave fewer seams.
pub(super) const BANDS_PER_BLOCK: usize = 12;

/// One band of latitude, cut into cells of equal length.
pub(super) struct Band {
    /// Number of cells.
    pub(super) cells: usize,
    /// Place of the first cell among those of the block.
    pub(super) first: usize,
    /// Half-width in turns within which cells of the bands around may hold points closer than the
    /// distance; 0.5 is the whole band.
    pub(super) reach: f64,
    /// Sine and cosine of the northern and the southern border's colatitude.
    borders: [(f64, f64); 2],
}

/// All bands, from the north pole to the south pole.
pub(super) struct Bands {
    pub(super) bands: Vec<Band>,
    /// Squared chord of the distance.
    pub(super) chord2: f64,
}

impl Bands {
    /// Bands for points that are at least `distance` radians apart.
    pub(super) fn new(distance: f64) -> Self {
        // Two points in a square of this side are never farther apart than the distance.
        let side = distance / 2.0_f64.sqrt();
        let count = (math::PI / side).ceil() as usize;
        let mut bands: Vec<Band> = Vec::with_capacity(count);
        for k in 0..count {
            let mut band = Band::new(k, count, side, distance);
            if !k.is_multiple_of(BANDS_PER_BLOCK) {
                band.first = bands[k - 1].first + bands[k - 1].cells;
            }
            bands.push(band);
        }
        let half = math::sin(0.5 * distance);
        Self {
            bands,
            chord2: 4.0 * half * half,
        }
    }

    /// Number of blocks that the bands are cut into.
    pub(super) fn block_count(&self) -> usize {
        self.bands.len().div_ceil(BANDS_PER_BLOCK)
    }
}

impl Band {
    /// Band `k` of `count`, the first of its block, with cells no longer than `side`.
    fn new(k: usize, count: usize, side: f64, distance: f64) -> Self {
        let colatitude = |k: usize| math::PI * k as f64 / count as f64;
        let north = math::sin_cos(colatitude(k));
        let south = math::sin_cos(colatitude(k + 1));
        // The widest circle of the band; beside the equator that is the equator itself.
        let widest = if north.1 * south.1 < 0.0 {
            1.0
        } else {
            north.0.max(south.0)
        };
        // A point within the distance lies two bands away at most, and the narrowest circle there
        // sees it under the largest angle.
        let circle = |k: usize| math::sin(colatitude(k.min(count)));
        let narrowest = circle(k.saturating_sub(2)).min(circle(k + 3));
        let half_chord = 0.5 * distance / narrowest.max(1e-12);
        let reach = if half_chord >= 1.0 {
            0.5
        } else {
            2.0 * math::asin(half_chord) / math::TAU
        };
        Self {
            cells: ((math::TAU * widest / side).ceil() as usize).max(3),
            first: 0,
            // A little more, or rounding might leave a cell out.
            reach: reach * 1.0001,
            borders: [north, south],
        }
    }

    /// The cells within `reach` (below 0.5) turns of `turn`, as three ranges: what lies beyond the
    /// meridian 0 goes on at the other end of the band.
    pub(super) fn cells_near(&self, turn: f64, reach: f64) -> [Range<usize>; 3] {
        let len = self.cells as i64;
        let from = ((turn - reach) * self.cells as f64).floor() as i64;
        let end = ((turn + reach) * self.cells as f64).floor() as i64 + 1;
        let range = |from: i64, end: i64| from.clamp(0, len) as usize..end.clamp(0, len) as usize;
        [
            range(from, end),
            range(from + len, len),
            range(0, end - len),
        ]
    }

    /// Sine and cosine of the longitude of every cell's western border, and the first again.
    pub(super) fn meridians(&self) -> Vec<(f64, f64)> {
        (0..=self.cells)
            .map(|c| math::sin_cos(math::TAU * c as f64 / self.cells as f64))
            .collect()
    }

    /// The point at the shares `u` from west to east and `v` from north to south of a cell.
    pub(super) fn point(&self, meridians: &[(f64, f64)], cell: usize, u: f64, v: f64) -> DVec3 {
        let [north, south] = self.borders;
        let [west, east] = [meridians[cell], meridians[cell + 1]];
        let on_north = corner(north, west).lerp(corner(north, east), u);
        let on_south = corner(south, west).lerp(corner(south, east), u);
        on_north.lerp(on_south, v).normalize()
    }
}

/// The unit vector where a parallel and a meridian cross, each given by sine and cosine.
fn corner((sin, cos): (f64, f64), (sin_lon, cos_lon): (f64, f64)) -> DVec3 {
    DVec3::new(sin * cos_lon, sin * sin_lon, cos)
}
