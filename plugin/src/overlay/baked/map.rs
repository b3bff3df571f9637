//! Maps of a bake. To find a pixel in the base mesh costs more than its colour: overlays that are
//! drawn together share what is found.

use super::BasePlace;
use super::shown::Shown;
use crate::control::Bake;
use crate::math;
use crate::overlay::raster::{Raster, paint};
use crate::overlay::{Overlay, rivers};
use bevy::math::DVec3;

/// Draws overlays, each on a raster of its own; all are of one size.
pub(in crate::overlay) fn draw(overlays: &[Overlay], bake: &Bake, rasters: &mut [Raster]) {
    let Some(&Raster { width, height, .. }) = rasters.first() else {
        return;
    };
    let shown: Vec<_> = overlays.iter().map(|&o| Shown::new(o, bake)).collect();
    let meridians: Vec<_> = (0..width).map(|x| meridian(x, width)).collect();
    paint(
        rasters,
        |y| places(bake, parallel_of(y as u32, height), &meridians),
        |k, place| shown[k].at(place),
    );
    for (&overlay, raster) in overlays.iter().zip(rasters) {
        rivers::draw(overlay, bake, raster);
    }
}

/// The places of the pixels of a row, whose latitude and longitudes are given as sine and cosine.
fn places(bake: &Bake, (sin, cos): (f64, f64), meridians: &[(f64, f64)]) -> Vec<BasePlace> {
    let base = bake.mesh();
    let mut places = Vec::with_capacity(meridians.len());
    // The sample nearest to a pixel is close to that of the pixel before.
    let mut hint = None;
    for &(sin_lon, cos_lon) in meridians {
        let p = DVec3::new(cos * cos_lon, cos * sin_lon, sin);
        let nearest = hint.map_or_else(|| base.nearest(p), |hint| base.nearest_from(p, hint));
        hint = Some(nearest);
        places.push(BasePlace::new(bake, base.locate_from(p, nearest)));
    }
    places
}

/// Sine and cosine of the longitude of the centre of column `x`.
fn meridian(x: u32, width: u32) -> (f64, f64) {
    let degrees = 360.0 * (f64::from(x) + 0.5) / f64::from(width) - 180.0;
    math::sin_cos(degrees.to_radians())
}

/// Sine and cosine of the latitude of the centre of row `y`.
fn parallel_of(y: u32, height: u32) -> (f64, f64) {
    let degrees = 90.0 - 180.0 * (f64::from(y) + 0.5) / f64::from(height);
    math::sin_cos(degrees.to_radians())
}
