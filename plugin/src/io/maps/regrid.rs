//! From the pixels of a raster to those of a map: a pixel counts in the cell of the map that its
//! middle lies in, one whose middle lies on an edge in both cells; a cell is the mean of what counts
//! in it.
//!
//! So archives come in as they are: a map that begins at another meridian is turned, one whose rows
//! go north is turned over, values at nodes (361 x 181) become those of the cells between, latitudes
//! that a map does not reach are void, and rasters of more than 8192 columns become means while they
//! are read.

use super::error::MapFileError;
use crate::climate::{EquirectMap, MapError};
use crate::io::dem::{CellMeans, DemError};
use core::ops::RangeInclusive;

/// Most columns of a map: pixels of 5 km on the Earth, a fifth of an edge of the base mesh.
const MOST_COLUMNS: u32 = 8192;

/// The place of a pixel that is in no cell.
const NOWHERE: u32 = u32::MAX;

/// Which cells the columns and rows of a raster count in.
pub(super) struct Regrid {
    width: u32,
    height: u32,
    /// Two for each column of the raster; the same twice for one whose middle is in a cell.
    columns: Vec<[u32; 2]>,
    rows: Vec<[u32; 2]>,
    /// Has every cell one pixel?
    is_one_to_one: bool,
}

impl Regrid {
    /// Of a raster of that size that reaches over `extent` degrees (west, east, south, north), or
    /// does not tell: then it is a whole map from -180 on. `is_turned` says whether its columns go
    /// west and its rows north.
    ///
    /// # Errors
    /// [`MapFileError::Extent`] if it does not reach around the planet; [`MapError::Shape`] if it
    /// does not tell, and is not twice as wide as high.
    pub(super) fn new(
        size: [u32; 2],
        extent: Option<[f64; 4]>,
        is_turned: [bool; 2],
    ) -> Result<Self, MapFileError> {
        let [width, height] = size;
        let Some(extent) = extent else {
            if width != 2 * height {
                return Err(MapError::Shape(width, height).into());
            }
            return Ok(Self::of([-180.0, 180.0, -90.0, 90.0], size, is_turned));
        };
        match whole(extent, size) {
            Some(extent) => Ok(Self::of(extent, size, is_turned)),
            None => Err(MapFileError::Extent(extent)),
        }
    }

    fn of([west, east, south, north]: [f64; 4], size: [u32; 2], is_turned: [bool; 2]) -> Self {
        let across = (east - west) / f64::from(size[0]);
        let down = (north - south) / f64::from(size[1]);
        // The nearest map of square pixels that are not smaller than those of the raster.
        let finest = (180.0 / across.max(down) + 1e-6).floor().max(1.0) as u32;
        let height = shrunk(finest);
        let mut columns = columns(west, across, size[0], height);
        let mut rows = rows(north, down, size[1], height);
        if is_turned[0] {
            columns.reverse();
        }
        if is_turned[1] {
            rows.reverse();
        }
        let width = 2 * height;
        let is_single = |pairs: &[[u32; 2]]| pairs.iter().all(|[a, b]| a == b);
        let is_one_to_one =
            size[0] <= width && size[1] <= height && is_single(&columns) && is_single(&rows);
        Self {
            width,
            height,
            columns,
            rows,
            is_one_to_one,
        }
    }

    /// An empty map, whose values are possible within a range.
    pub(super) fn map(self, possible: RangeInclusive<f32>) -> Result<MapMeans, DemError> {
        let cells = self.width as usize * self.height as usize;
        Ok(MapMeans {
            means: CellMeans::new(cells, self.is_one_to_one)?,
            grid: self,
            possible,
            impossible: None,
        })
    }
}

/// The columns of a map of so many rows in which `count` columns of a raster count, `across` degrees
/// wide from `west` on.
fn columns(west: f64, across: f64, count: u32, map_rows: u32) -> Vec<[u32; 2]> {
    let cell = 180.0 / f64::from(map_rows);
    let around = |column: i64| column.rem_euclid(2 * i64::from(map_rows)) as u32;
    let mut columns: Vec<_> = (0..count)
        .map(|k| cells((west + 180.0 + (f64::from(k) + 0.5) * across) / cell))
        .map(|pair| pair.map(around))
        .collect();
    // The last column of nodes is the first one again.
    let surplus = ((f64::from(count) * across - 360.0) / across)
        .round()
        .max(0.0) as usize;
    let kept = columns.len() - surplus.min(columns.len());
    columns[kept..].fill([NOWHERE; 2]);
    columns
}

/// The same of rows, `down` degrees high from `north` on; those beyond a pole count nowhere.
fn rows(north: f64, down: f64, count: u32, map_rows: u32) -> Vec<[u32; 2]> {
    let cell = 180.0 / f64::from(map_rows);
    let in_map = |row: i64| u32::try_from(row).ok().filter(|row| *row < map_rows);
    (0..count)
        .map(|k| cells((90.0 - north + (f64::from(k) + 0.5) * down) / cell))
        .map(|pair| pair.map(|row| in_map(row).unwrap_or(NOWHERE)))
        .collect()
}

/// The degrees of a raster around the planet, set right where a pixel is missing or too much: files
/// may count from the middles of their pixels. `None` for one of a region.
fn whole(extent: [f64; 4], [width, height]: [u32; 2]) -> Option<[f64; 4]> {
    let [west, east, south, north] = extent;
    let pixel = (east - west) / f64::from(width);
    let near = |x: f64, end: f64| (x - end).abs() <= pixel * (1.0 + 1e-6);
    let is_latitude = |z: f64| z.abs() <= 90.0 + pixel * (1.0 + 1e-6);
    if !near(east - west, 360.0) || !is_latitude(south) || !is_latitude(north) {
        return None;
    }
    // What reaches over all degrees by its shape is taken to do so by its place, too.
    let is_full = width == 2 * height && near(south, -90.0) && near(north, 90.0);
    let begins_there = is_full && near(west, -180.0);
    let west = if begins_there { -180.0 } else { west };
    if is_full {
        return Some([west, west + 360.0, -90.0, 90.0]);
    }
    Some([west, east, south, north])
}

/// Rows of a map that a raster of so many becomes: as many, or a whole part of them.
fn shrunk(rows: u32) -> u32 {
    if rows <= MOST_COLUMNS / 2 {
        return rows;
    }
    let mut part = (2 * rows).div_ceil(MOST_COLUMNS);
    // Cells of equally many pixels, if a part near by gives them.
    part = (part..2 * part)
        .find(|part| rows.is_multiple_of(*part))
        .unwrap_or(part);
    rows / part
}

/// The cells on both sides of a place, counted in cells: the same twice within a cell.
fn cells(place: f64) -> [i64; 2] {
    const EDGE: f64 = 1e-4;
    [place - EDGE, place + EDGE].map(|place| place.floor() as i64)
}

/// A map while its raster is read.
pub(super) struct MapMeans {
    grid: Regrid,
    means: CellMeans,
    possible: RangeInclusive<f32>,
    /// The first value that is not possible, and its cell.
    impossible: Option<(usize, f32)>,
}

impl MapMeans {
    /// Takes values from pixel `place` of the raster on, NaN for voids.
    pub(super) fn add(&mut self, place: usize, values: &[f32]) {
        let across = self.grid.columns.len();
        let pairs = &self.grid.columns[place % across..];
        for row in self.grid.rows[place / across] {
            if row == NOWHERE {
                continue;
            }
            let first = row as usize * self.grid.width as usize;
            for (columns, &value) in pairs.iter().zip(values) {
                for column in columns.iter().filter(|column| **column != NOWHERE) {
                    let cell = first + *column as usize;
                    self.means.add(cell, value);
                    if !value.is_nan() && !self.possible.contains(&value) {
                        self.impossible.get_or_insert((cell, value));
                    }
                }
            }
        }
    }

    /// The map. An impossible value stands for its whole cell: means would hide it from whoever
    /// checks the map.
    pub(super) fn finish(self) -> Result<EquirectMap, MapError> {
        let mut values = self.means.finish();
        if let Some((cell, value)) = self.impossible {
            values[cell] = value;
        }
        EquirectMap::new(self.grid.width, self.grid.height, values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The map of a raster whose pixel (column, row) has this value.
    fn map(
        size: [u32; 2],
        extent: [f64; 4],
        is_turned: [bool; 2],
        value: impl Fn(u32, u32) -> f32,
    ) -> EquirectMap {
        let mut means = Regrid::new(size, Some(extent), is_turned)
            .unwrap()
            .map(f32::NEG_INFINITY..=f32::INFINITY)
            .unwrap();
        for y in 0..size[1] {
            let row: Vec<f32> = (0..size[0]).map(|x| value(x, y)).collect();
            means.add((y * size[0]) as usize, &row);
        }
        means.finish().unwrap()
    }

    const WHOLE: [f64; 4] = [-180.0, 180.0, -90.0, 90.0];

    #[test]
    fn a_whole_map_stays_as_it_is_and_others_are_turned() {
        let numbers = |x: u32, y: u32| (10 * y + x) as f32;
        let kept = map([4, 2], WHOLE, [false; 2], numbers);
        assert_eq!(kept.values(), [0.0, 1.0, 2.0, 3.0, 10.0, 11.0, 12.0, 13.0]);
        let over = map([4, 2], WHOLE, [false, true], numbers);
        assert_eq!(over.values(), [10.0, 11.0, 12.0, 13.0, 0.0, 1.0, 2.0, 3.0]);
        let mirrored = map([4, 2], WHOLE, [true, false], numbers);
        assert_eq!(mirrored.values()[..4], [3.0, 2.0, 1.0, 0.0]);
        let from_greenwich = map([4, 2], [0.0, 360.0, -90.0, 90.0], [false; 2], numbers);
        assert_eq!(from_greenwich.values()[..4], [2.0, 3.0, 0.0, 1.0]);
    }

    #[test]
    fn latitudes_that_are_not_there_are_void() {
        // 12 x 5 pixels of 30 degrees from -60 to 90, as archives without the Antarctic have.
        let archive = map([12, 5], [-180.0, 180.0, -60.0, 90.0], [false; 2], |_, y| {
            y as f32
        });
        assert_eq!(archive.size(), [12, 6]);
        assert_eq!(archive.voids(), 12);
        let column: Vec<f32> = archive.values().iter().copied().step_by(12).collect();
        assert_eq!(column[..5], [0.0, 1.0, 2.0, 3.0, 4.0]);
        assert!(column[5].is_nan());
    }

    #[test]
    fn nodes_become_the_means_of_the_cells_between() {
        // 13 x 7 nodes 30 degrees apart, the last column the first again: a ramp from the north, a
        // wave along the equator.
        let extent = [-195.0, 195.0, -105.0, 105.0];
        let ramp = map([13, 7], extent, [false; 2], |_, y| y as f32);
        assert_eq!(ramp.size(), [12, 6]);
        assert_eq!(ramp.voids(), 0);
        let column: Vec<f32> = ramp.values().iter().copied().step_by(12).collect();
        assert_eq!(column, [0.5, 1.5, 2.5, 3.5, 4.5, 5.5]);
        let wave = map([13, 7], extent, [false; 2], |x, _| {
            if x % 12 == 0 { 6.0 } else { 0.0 }
        });
        let row: Vec<f32> = wave.values()[..12].to_vec();
        assert_eq!((row[0], row[1], row[10], row[11]), (3.0, 0.0, 0.0, 3.0));
    }

    #[test]
    fn wide_rasters_become_means() {
        // 43,200 columns, as an archive of 30 seconds of arc, become 7200: blocks of 6 x 6.
        let grid = Regrid::new([43_200, 21_600], Some(WHOLE), [false; 2]).unwrap();
        assert_eq!((grid.width, grid.height), (7200, 3600));
        assert_eq!(grid.columns[6 * 5..6 * 6], [[5, 5]; 6]);
        assert_eq!(grid.rows[21_599], [3599, 3599]);
        assert!(!grid.is_one_to_one);
        let small = Regrid::new([8192, 4096], Some(WHOLE), [false; 2]).unwrap();
        assert!(small.is_one_to_one);
    }

    #[test]
    fn impossible_values_are_not_hidden_by_means() {
        // 12,000 columns become 6000.
        let grid = Regrid::new([12_000, 6000], Some(WHOLE), [false; 2]).unwrap();
        let mut means = grid.map(0.0..=1.0).unwrap();
        means.add(0, &[0.5, f32::NAN, 0.5, -9999.0, 0.5, 0.5]);
        let map = means.finish().unwrap();
        assert_eq!(map.size(), [6000, 3000]);
        assert_eq!(map.values()[..3], [0.5, -9999.0, 0.5]);
    }

    #[test]
    fn regions_are_refused() {
        for extent in [[0.0, 90.0, -90.0, 90.0], [-180.0, 180.0, -90.0, 200.0]] {
            let refused = Regrid::new([40, 20], Some(extent), [false; 2]);
            assert!(matches!(refused, Err(MapFileError::Extent(_))));
        }
        let shape = Regrid::new([40, 30], None, [false; 2]);
        assert!(matches!(
            shape,
            Err(MapFileError::Map(MapError::Shape(40, 30)))
        ));
    }
}
