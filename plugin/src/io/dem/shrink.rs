//! Rasters of more pixels than are held: while they are read they become the means of their blocks.
//!
//! Held are at most 2^24 values, 64 MiB, which 4096 x 4096 pixels have. A larger raster becomes as
//! many equal blocks as that allows, of as many columns as rows; voids count for nothing.

use super::error::DemError;
use super::means::CellMeans;
use super::tile::{Dem, MAX_HEIGHT_M};

/// Most values that are held.
const MOST_VALUES: u64 = 1 << 24;

/// A raster while it is read.
pub(super) struct ShrunkRaster {
    pixels: [u32; 2],
    size: [u32; 2],
    /// The column and row of the block that each column and row of the raster lies in.
    columns: Vec<u32>,
    rows: Vec<u32>,
    means: CellMeans,
}

impl ShrunkRaster {
    /// A raster of so many columns and rows; `is_turned` says whether columns go west, and rows
    /// north.
    ///
    /// # Errors
    /// [`DemError::Memory`].
    pub(super) fn new(pixels: [u32; 2], is_turned: [bool; 2]) -> Result<Self, DemError> {
        Self::within(MOST_VALUES, pixels, is_turned)
    }

    fn within(most: u64, pixels: [u32; 2], is_turned: [bool; 2]) -> Result<Self, DemError> {
        let size = size_within(most, pixels);
        let [columns, rows] = [0, 1].map(|axis| blocks(pixels[axis], size[axis], is_turned[axis]));
        let cells = size[0] as usize * size[1] as usize;
        Ok(Self {
            pixels,
            size,
            columns,
            rows,
            means: CellMeans::new(cells, size == pixels)?,
        })
    }

    /// Takes heights in m from pixel `place` of the file on, all of one row; NaN, and what no ground
    /// has, are voids.
    pub(super) fn add(&mut self, place: usize, heights: &[f32]) {
        let across = self.columns.len();
        let first = self.rows[place / across] as usize * self.size[0] as usize;
        let columns = &self.columns[place % across..];
        for (column, &height) in columns.iter().zip(heights) {
            if height.abs() <= MAX_HEIGHT_M {
                self.means.add(first + *column as usize, height);
            }
        }
    }

    /// The model, of pixels of that size.
    pub(super) fn finish(
        self,
        pixel_m: [f64; 2],
        centre: Option<(f64, f64)>,
    ) -> Result<Dem, DemError> {
        let block_m = [0, 1]
            .map(|axis| pixel_m[axis] * f64::from(self.pixels[axis]) / f64::from(self.size[axis]));
        let dem = Dem::new(self.size, self.means.finish(), block_m, centre)?;
        Ok(Dem {
            pixels: self.pixels.map(|side| side as usize),
            ..dem
        })
    }
}

/// Columns and rows of blocks that are not more than `most`.
fn size_within(most: u64, pixels: [u32; 2]) -> [u32; 2] {
    let blocks = |side: u32| pixels.map(|pixels| pixels.div_ceil(side));
    let are_few = |[across, down]: [u32; 2]| u64::from(across) * u64::from(down) <= most;
    let mut sizes = (1..=u32::MAX).map(blocks);
    sizes.find(|size| are_few(*size)).unwrap_or([1; 2])
}

/// The block of each pixel along an axis.
fn blocks(pixels: u32, count: u32, is_turned: bool) -> Vec<u32> {
    let block = |pixel: u32| (u64::from(pixel) * u64::from(count) / u64::from(pixels)) as u32;
    let mut blocks: Vec<u32> = (0..pixels).map(block).collect();
    if is_turned {
        blocks.reverse();
    }
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Heights and size of pixels of a raster of which at most `most` values are held.
    fn shrunk(
        most: u64,
        pixels: [u32; 2],
        is_turned: [bool; 2],
        height: impl Fn(u32, u32) -> f32,
    ) -> Dem {
        let mut raster = ShrunkRaster::within(most, pixels, is_turned).unwrap();
        for y in 0..pixels[1] {
            let row: Vec<f32> = (0..pixels[0]).map(|x| height(x, y)).collect();
            raster.add((y * pixels[0]) as usize, &row);
        }
        raster.finish([10.0; 2], Some((1.0, 2.0))).unwrap()
    }

    #[test]
    fn small_rasters_stay_and_are_turned_north_up() {
        let numbers = |x: u32, y: u32| (3 * y + x) as f32;
        let turned = |is_turned| shrunk(6, [3, 2], is_turned, numbers).grid.values;
        assert_eq!(turned([false; 2]), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(turned([true, false]), [2.0, 1.0, 0.0, 5.0, 4.0, 3.0]);
        assert_eq!(turned([false, true]), [3.0, 4.0, 5.0, 0.0, 1.0, 2.0]);
    }

    #[test]
    fn large_ones_become_means_of_equal_blocks() {
        // 9 x 6 pixels within 8 values: blocks of 3 x 3, of which one lacks all and one some.
        let dem = shrunk(8, [9, 6], [false; 2], |x, y| match (x, y) {
            (0..3, 0..3) => f32::NAN,
            (3, 0) => -3e38,
            (3..6, 0..3) => 40.0,
            _ => (x + 10 * y) as f32,
        });
        assert_eq!(dem.pixels, [9, 6]);
        assert_eq!((dem.grid.width, dem.grid.height), (3, 2));
        assert_eq!(
            (dem.grid.pixel_m, dem.centre),
            ([30.0; 2], Some((1.0, 2.0)))
        );
        assert_eq!(dem.voids, 1);
        assert_eq!(dem.grid.values[1..], [40.0, 17.0, 41.0, 44.0, 47.0]);
    }

    #[test]
    fn the_largest_raster_takes_little_memory() {
        assert_eq!(size_within(MOST_VALUES, [4096; 2]), [4096; 2]);
        assert_eq!(size_within(MOST_VALUES, [7201; 2]), [3601; 2]);
        assert_eq!(size_within(MOST_VALUES, [100_000; 2]), [4000; 2]);
        assert_eq!(size_within(MOST_VALUES, [100_000, 2]), [100_000, 2]);
    }
}
