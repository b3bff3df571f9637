//! A PNG of 16-bit grey from the lowest height, black, to the highest, white, and the sidecar that
//! decodes it.

use super::error::{ExportError, cannot_encode};
use crate::io::png::grey_png;
use crate::io::{MarkedJson, Sidecar};
use crate::query::{HeightGrid, MapSquare};

/// The picture and its sidecar.
pub(super) fn encode(
    square: &MapSquare,
    grid: &HeightGrid,
) -> Result<(Vec<u8>, Vec<u8>), ExportError> {
    let [low, high] = grid.range().unwrap_or_default().map(f64::from);
    // Level ground is black, and its range is empty.
    let scale = if high > low {
        65_535.0 / (high - low)
    } else {
        0.0
    };
    let greys = grid
        .values
        .iter()
        .map(|&z| ((f64::from(z) - low) * scale + 0.5) as u16);
    let picture = grey_png(grid.width as u32, greys).map_err(cannot_encode)?;
    let (lat, lon) = square.projection().lat_lon();
    let sidecar = Sidecar {
        min_m: Some(low),
        max_m: Some(high),
        metres_per_unit: None,
        metres_per_pixel: square.pixel_m(),
        lat: Some(lat),
        lon: Some(lon),
    };
    let mut text = serde_json::to_vec_pretty(&MarkedJson::new(sidecar)).map_err(cannot_encode)?;
    text.push(b'\n');
    Ok((picture, text))
}
