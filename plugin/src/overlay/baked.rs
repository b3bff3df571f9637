//! Overlays of a bake: climate, discharge, basins and lakes, on the base mesh of the ground.
//!
//! Maps look at the base mesh itself, which may be finer than the crust's samples; on it lie the
//! lines of `rivers`. A colour per sample of the crust shows what lies at the sample.

use super::discharge::discharge_position;
use super::palette::{self, Rgba, classes};
use super::raster::Raster;
use super::{Overlay, rivers};
use crate::control::Bake;
use crate::hydrology::{NO_VERTEX, ShoreClass};
use crate::math;
use crate::parallel;
use crate::random::mix;
use crate::sphere::{Location, SphereMesh};
use bevy::math::DVec3;
use rayon::prelude::*;

/// Temperature in °C at the start of the ramp.
pub(super) const TEMPERATURE_MIN: f32 = -40.0;
/// Temperature in °C at the end of the ramp.
pub(super) const TEMPERATURE_MAX: f32 = 35.0;
/// Rain at the end of the ramp in mm per year.
pub(super) const RAIN_MAX: f32 = 4000.0;

/// Colours of the samples of the crust.
pub(super) fn colors(overlay: Overlay, bake: &Bake, lattice: &SphereMesh) -> Vec<Rgba> {
    let base = bake.mesh();
    parallel::map(lattice.len(), |i| {
        color_at(overlay, bake, &base.locate(lattice.point(i)))
    })
}

/// The map of an overlay.
pub(super) fn draw(overlay: Overlay, bake: &Bake, width: u32, height: u32) -> Raster {
    let base = bake.mesh();
    let mut rgb = vec![0; 3 * width as usize * height as usize];
    rgb.par_chunks_mut(3 * width as usize)
        .enumerate()
        .for_each(|(y, row)| {
            // The sample nearest to a pixel is close to that of the pixel before.
            let mut hint = None;
            for (x, out) in row.chunks_exact_mut(3).enumerate() {
                let p = pixel_direction(x as f64 + 0.5, y as f64 + 0.5, width, height);
                let nearest =
                    hint.map_or_else(|| base.nearest(p), |hint| base.nearest_from(p, hint));
                hint = Some(nearest);
                out.copy_from_slice(&color_at(overlay, bake, &base.locate_from(p, nearest))[..3]);
            }
        });
    let mut raster = Raster { width, height, rgb };
    rivers::draw(overlay, bake, &mut raster);
    raster
}

/// The direction of a place on an equirectangular map, in pixels from its north west corner.
fn pixel_direction(x: f64, y: f64, width: u32, height: u32) -> DVec3 {
    let lat = 90.0 - 180.0 * y / f64::from(height);
    let lon = 360.0 * x / f64::from(width) - 180.0;
    math::direction(lat, lon)
}

/// The colour at a place of the base mesh, rivers apart.
fn color_at(overlay: Overlay, bake: &Bake, at: &Location) -> Rgba {
    let climate = &bake.climate;
    match overlay {
        Overlay::Temperature => palette::TEMPERATURE.within(
            mean(&climate.temperature, at),
            TEMPERATURE_MIN,
            TEMPERATURE_MAX,
        ),
        Overlay::Rain => palette::RAIN.at(mean(&climate.rain, at) / RAIN_MAX),
        Overlay::Wetness => palette::RAIN.at(mean(&climate.wetness, at)),
        Overlay::Drainage => discharge_at(bake, at),
        Overlay::Basins => basin_at(bake, at),
        Overlay::Rivers | Overlay::Lakes => lake_at(bake, at),
        _ => classes::NO_VALUE_LAND,
    }
}

fn mean(column: &[f32], at: &Location) -> f32 {
    at.interpolate(|i| f64::from(column[i as usize])) as f32
}

/// Whether a place is covered by the sea. Hollows of the land may lie below its level.
fn is_sea(bake: &Bake, at: &Location) -> bool {
    let drainage = &bake.drainage;
    let ground = at.interpolate(|k| f64::from(drainage.ground[k as usize]));
    ground < 0.0 && drainage.shore[at.nearest as usize] != ShoreClass::Land
}

/// The colour of land or sea.
fn backdrop(bake: &Bake, at: &Location) -> Rgba {
    if is_sea(bake, at) {
        classes::SEA
    } else {
        classes::LAND
    }
}

/// The colour of the discharge at a place of the base mesh. Between a river and its banks discharge
/// differs by powers of ten, so positions on the ramp are averaged, not m³/s.
fn discharge_at(bake: &Bake, at: &Location) -> Rgba {
    if is_sea(bake, at) {
        return classes::SEA;
    }
    let position =
        at.interpolate(|k| discharge_position(bake.drainage.earth_like_discharge(k as usize)));
    palette::DISCHARGE.at(position as f32)
}

/// The colour of the basin at a place of the base mesh, drawn by the number of its mouth; darker
/// where its water does not reach the sea.
fn basin_at(bake: &Bake, at: &Location) -> Rgba {
    let i = at.nearest as usize;
    let basin = bake.drainage.basin[i];
    if is_sea(bake, at) || basin == NO_VERTEX {
        return backdrop(bake, at);
    }
    let color = palette::distinct(mix(u64::from(basin)) as u32);
    if bake.drainage.is_endorheic(i) {
        palette::mix(color, classes::ENDORHEIC, 0.6)
    } else {
        color
    }
}

fn lake_at(bake: &Bake, at: &Location) -> Rgba {
    match bake.drainage.lake_kind(at.nearest as usize) {
        Some(kind) => classes::LAKES[kind as usize],
        None => backdrop(bake, at),
    }
}

#[cfg(test)]
pub(crate) mod tests;
