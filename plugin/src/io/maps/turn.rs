//! Maps that begin at another meridian than -180, such as Greenwich, turned until they begin there.

use super::error::MapFileError;

/// The column that begins at longitude -180, of a map that reaches over these degrees (west, east,
/// south, north); the first if it does not tell.
///
/// # Errors
/// [`MapFileError::Extent`] if it does not reach over the whole planet. A pixel's difference is
/// allowed: files may count from the centres of their pixels.
pub(super) fn first_column(
    extent: Option<[f64; 4]>,
    [width, _]: [u32; 2],
) -> Result<usize, MapFileError> {
    let Some(extent) = extent else {
        return Ok(0);
    };
    let [west, east, south, north] = extent;
    let pixel = 360.0 / f64::from(width);
    let near = |x: f64, end: f64| (x - end).abs() <= pixel * (1.0 + 1e-9);
    if !(near(east - west, 360.0) && near(south, -90.0) && near(north, 90.0)) {
        return Err(MapFileError::Extent(extent));
    }
    // A map that begins near the date line is one that counts from the centres of its pixels.
    if near(west, -180.0) {
        return Ok(0);
    }
    let columns = ((-180.0 - west) / pixel).round();
    Ok(columns.rem_euclid(f64::from(width)) as usize)
}

/// Turns every row until a column comes first.
pub(super) fn turn(values: &mut [f32], width: u32, column: usize) {
    for row in values.chunks_exact_mut(width as usize) {
        row.rotate_left(column);
    }
}
