//! Blocks of square tiles in one projection, as engines join them: neighbours share the vertices of
//! their edges.

use super::check::{check_count, check_length};
use super::error::GroundError;
use super::level::raster_level;
use super::map_grid::{GridPoint, MapGrid};
use super::projection::AzimuthalEquidistant;
use super::raster::{LEAST_PIXEL_M, MapSquare};
use crate::math::TAU;
use bevy::math::DVec2;
use bevy::reflect::Reflect;

/// Columns and rows of tiles about the centre of an [`AzimuthalEquidistant`] projection, north up.
///
/// ```
/// use bevy_pangaea::query::{AzimuthalEquidistant, TileBlock};
///
/// let about = AzimuthalEquidistant::new(30.0, -12.0, 6_370_000.0)?;
/// let block = TileBlock::new(about, 8000.0, 1025, [4, 3])?;
/// assert_eq!(block.spacing_m(), 7.8125);
/// assert_eq!(block.grid().columns(), 4 * 1024 + 1);
/// # Ok::<(), bevy_pangaea::query::GroundError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(opaque, Clone, Debug, PartialEq)]
pub struct TileBlock {
    projection: AzimuthalEquidistant,
    tile_m: f64,
    vertices: usize,
    tiles: [usize; 2],
}

impl TileBlock {
    /// Most tiles of a block.
    pub const MAX_TILES: usize = 4096;

    /// Most vertices along a side of a block.
    pub const MAX_VERTICES: usize = 65_537;

    /// A block of `tiles` columns and rows about the centre of `projection`; each tile has sides of
    /// `tile_m` and `vertices` to a side.
    ///
    /// # Errors
    /// As [`check`](Self::check); [`GroundError::Length`] if the block is larger than the sphere,
    /// or its vertices are less than a millimetre apart.
    pub fn new(
        projection: AzimuthalEquidistant,
        tile_m: f64,
        vertices: usize,
        tiles: [usize; 2],
    ) -> Result<Self, GroundError> {
        Self::check(vertices, tiles)?;
        let least = (vertices - 1) as f64 * LEAST_PIXEL_M;
        // The corners lie at most half a great circle from the centre.
        let diagonal = DVec2::new(tiles[0] as f64, tiles[1] as f64).length();
        let most = TAU * projection.radius_m() / diagonal;
        check_length("the side of a tile", tile_m, [least, most])?;
        Ok(Self {
            projection,
            tile_m,
            vertices,
            tiles,
        })
    }

    /// Refuses numbers of which there is no block.
    ///
    /// # Errors
    /// [`GroundError::Count`] outside of 2..=16,384 vertices to the side of a tile, and for more
    /// than [`MAX_TILES`](Self::MAX_TILES) tiles or [`MAX_VERTICES`](Self::MAX_VERTICES) vertices
    /// to the side of the block.
    pub fn check(vertices: usize, tiles: [usize; 2]) -> Result<(), GroundError> {
        let most = [2, MapSquare::MAX_PIXELS];
        check_count("the number of vertices to a side", vertices, most)?;
        let count = tiles[0].saturating_mul(tiles[1]);
        check_count("the number of tiles", count, [1, Self::MAX_TILES])?;
        let sides = tiles.map(|n| n.saturating_mul(vertices - 1).saturating_add(1));
        let longest = sides[0].max(sides[1]);
        let what = "the number of vertices along the block";
        check_count(what, longest, [2, Self::MAX_VERTICES])
    }

    /// The projection.
    pub fn projection(&self) -> &AzimuthalEquidistant {
        &self.projection
    }

    /// Side of a tile in m.
    pub fn tile_m(&self) -> f64 {
        self.tile_m
    }

    /// Vertices to the side of a tile.
    pub fn vertices(&self) -> usize {
        self.vertices
    }

    /// Columns and rows of tiles.
    pub fn tiles(&self) -> [usize; 2] {
        self.tiles
    }

    /// From a vertex to the next in m.
    pub fn spacing_m(&self) -> f64 {
        self.tile_m / (self.vertices - 1) as f64
    }

    /// All vertices of the block, at the level whose edges are not longer than they are apart.
    pub fn grid(&self) -> MapGrid {
        let size = self.tiles.map(|n| n * (self.vertices - 1) + 1);
        let level = raster_level(self.projection.radius_m(), self.spacing_m());
        MapGrid::about(
            self.projection,
            self.spacing_m(),
            GridPoint::Vertex,
            size,
            level,
        )
    }

    /// The vertices of the tile in a column, counted from the west, and a row, from the north;
    /// beyond the block the nearest tile's.
    pub fn tile(&self, column: usize, row: usize) -> MapGrid {
        let [columns, rows] = self.tiles;
        let steps = self.vertices - 1;
        MapGrid {
            first: [column.min(columns - 1) * steps, row.min(rows - 1) * steps],
            size: [self.vertices; 2],
            ..self.grid()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const R: f64 = 6_370_000.0;

    fn block(tile_m: f64, vertices: usize, tiles: [usize; 2]) -> Result<TileBlock, GroundError> {
        let about = AzimuthalEquidistant::new(60.0, 20.0, R)?;
        TileBlock::new(about, tile_m, vertices, tiles)
    }

    #[test]
    fn a_block_lies_around_its_centre_and_edges_are_shared() {
        let block = block(1000.0, 5, [2, 3]).unwrap();
        let corner = DVec2::new(-1000.0, 1500.0);
        assert_eq!(block.tile(0, 0).plane(0, 0), corner);
        assert_eq!(block.tile(1, 2).plane(4, 4), -corner);
        assert_eq!(block.tile(1, 0).plane(0, 0), DVec2::new(0.0, 1500.0));
        assert_eq!(block.tile(0, 1).plane(3, 4), block.tile(0, 2).plane(3, 0));
        assert_eq!(block.spacing_m(), 250.0);
    }

    #[test]
    fn one_tile_has_its_corners_on_the_edges_of_the_square() {
        let tile = block(60_000.0, 257, [1, 1]).unwrap().tile(0, 0);
        assert_eq!(tile.plane(0, 0), DVec2::new(-30_000.0, 30_000.0));
        assert_eq!(tile.plane(128, 128), DVec2::ZERO);
    }

    #[test]
    fn blocks_that_cannot_be_are_refused() {
        for (vertices, tiles) in [(1, [1, 1]), (9, [0, 1]), (9, [1, 0]), (9, [65, 64])] {
            let refused = block(1000.0, vertices, tiles);
            assert!(matches!(refused, Err(GroundError::Count { .. })));
        }
        let long = block(1000.0, 8193, [9, 1]);
        assert!(matches!(long, Err(GroundError::Count { .. })));
        for side in [0.0, f64::NAN, 15e6] {
            let refused = block(side, 9, [2, 2]);
            assert!(matches!(refused, Err(GroundError::Length { .. })), "{side}");
        }
    }
}
