//! The gradient of the ground, by differences over two pixels (over one at the edges of the tile).

use crate::query::HeightGrid;

/// Rise in m per m to the east and to the south at a pixel of a tile of at least 2 x 2 values.
pub(super) fn gradient(tile: &HeightGrid, x: usize, y: usize) -> [f64; 2] {
    let (west, east) = (x.saturating_sub(1), (x + 1).min(tile.width - 1));
    let (north, south) = (y.saturating_sub(1), (y + 1).min(tile.height - 1));
    let row = tile.row(y);
    let [pixel_x, pixel_y] = tile.pixel_m;
    let column = [north, south].map(|y| tile.row(y)[x]);
    [
        rise(row[west], row[east], east - west, pixel_x),
        rise(column[0], column[1], south - north, pixel_y),
    ]
}

/// Rise per m from a height to another, so many pixels away.
fn rise(from: f32, to: f32, pixels: usize, pixel_m: f64) -> f64 {
    (f64::from(to) - f64::from(from)) / (pixels.max(1) as f64 * pixel_m)
}
