//! Equirectangular maps: north up, longitude -180 at the left edge, 0 in the middle.
//!
//! Where each pixel lies in the mesh is looked up once, in a [`MapProjection`] that serves all maps
//! of a planet. A pixel stands for the point at its centre.

mod colors;
mod pixel;

use super::raster::{Raster, paint};
use super::{Overlay, OverlayInput, baked};
use crate::crust::Surface;
use crate::math;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use colors::MapColors;
use pixel::MapPixel;
use rayon::prelude::*;

/// Most bytes of maps that are drawn together: those of all overlays at the default size fit.
const TOGETHER_BYTES: usize = 256 << 20;

/// The place of every pixel of a map between the samples of a mesh.
///
/// ```
/// use bevy_pangaea::overlay::MapProjection;
/// use bevy_pangaea::sphere::SphereMesh;
///
/// let mesh = SphereMesh::fibonacci(1000)?;
/// let map = MapProjection::new(&mesh, 64, 32);
/// // The sine of the latitude, rows from the north.
/// let sine = map.interpolate(|i| mesh.point(i as u32).z as f32);
/// assert!(sine[0] > 0.9 && sine[31 * 64] < -0.9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct MapProjection {
    width: u32,
    height: u32,
    samples: usize,
    pixels: Vec<MapPixel>,
}

impl MapProjection {
    /// Largest width or height of a map in pixels.
    pub const MAX_SIDE: u32 = 16_384;

    /// Looks up every pixel of a map of `width` x `height` pixels, each clamped to
    /// 1..=[`Self::MAX_SIDE`].
    pub fn new(mesh: &SphereMesh, width: u32, height: u32) -> Self {
        let width = width.clamp(1, Self::MAX_SIDE);
        let height = height.clamp(1, Self::MAX_SIDE);
        let mut pixels = vec![MapPixel::default(); width as usize * height as usize];
        // A column has one longitude and a row one latitude: two sines a row and a column, not a
        // pixel.
        let columns: Vec<(f64, f64)> = (0..width)
            .map(|x| math::sin_cos(longitude(x, width)))
            .collect();
        pixels
            .par_chunks_mut(width as usize)
            .enumerate()
            .for_each(|(y, row)| locate_row(mesh, latitude(y as u32, height), &columns, row));
        Self {
            width,
            height,
            samples: mesh.len(),
            pixels,
        }
    }

    /// Pixels per row.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// A number per pixel, interpolated between samples; rows from the top.
    pub fn interpolate(&self, value: impl Fn(usize) -> f32 + Sync) -> Vec<f32> {
        self.pixels
            .par_iter()
            .with_min_len(self.width as usize)
            .map(|pixel| pixel.place().interpolate(&value))
            .collect()
    }

    /// Elevation at every pixel in km, trenches included.
    pub fn elevation(&self, surface: &Surface) -> Vec<f32> {
        self.interpolate(|i| surface.elevation(i))
    }

    /// The map of `overlay`: elevation with shaded relief, plates with their boundaries, the mesh
    /// with its edges, rivers as lines. Black if the surface does not belong to the mesh of this
    /// projection.
    pub fn draw(&self, overlay: Overlay, input: &OverlayInput) -> Raster {
        self.draw_together(&[overlay], input).remove(0)
    }

    /// The maps of several overlays, as [`Self::draw`] makes them, in their order; `take` gets each.
    /// Small maps are drawn together, for their pixels are looked up once then: those of climate and
    /// rivers in a third of the time.
    ///
    /// # Errors
    /// Those of `take`, which end the drawing.
    pub fn draw_each<E>(
        &self,
        overlays: &[Overlay],
        input: &OverlayInput,
        mut take: impl FnMut(Overlay, Raster) -> Result<(), E>,
    ) -> Result<(), E> {
        let at_once = (TOGETHER_BYTES / (3 * self.pixels.len())).max(1);
        let runs = overlays.chunk_by(|a, b| a.needs_bake() == b.needs_bake());
        for part in runs.flat_map(|run| run.chunks(at_once)) {
            let maps = self.draw_together(part, input);
            part.iter()
                .zip(maps)
                .try_for_each(|(&overlay, map)| take(overlay, map))?;
        }
        Ok(())
    }

    /// The maps of overlays that all need a bake, or all need none.
    fn draw_together(&self, overlays: &[Overlay], input: &OverlayInput) -> Vec<Raster> {
        let mut rasters = vec![Raster::black(self.width, self.height); overlays.len()];
        // A bake has a mesh of its own, finer than this projection's.
        if let (Some(bake), true) = (input.bake, overlays.iter().all(|o| o.needs_bake())) {
            baked::draw(overlays, bake, &mut rasters);
        } else if input.surface.len() == self.samples {
            let colors = overlays
                .iter()
                .map(|&o| MapColors::new(o, input, self.height));
            let colors: Vec<_> = colors.collect();
            paint(
                &mut rasters,
                |y| self.row(y).iter().map(MapPixel::place).collect(),
                |k, place| colors[k].at(place),
            );
        }
        rasters
    }

    /// The pixels of a row.
    fn row(&self, y: usize) -> &[MapPixel] {
        let width = self.width as usize;
        &self.pixels[y * width..][..width]
    }
}

/// Looks up a row of pixels at a latitude in radians; `columns` are sine and cosine of their
/// longitudes.
fn locate_row(mesh: &SphereMesh, latitude: f64, columns: &[(f64, f64)], row: &mut [MapPixel]) {
    let (sin, cos) = math::sin_cos(latitude);
    // The sample nearest to a pixel is close to that of the pixel before.
    let mut hint = None;
    for (pixel, &(sin_lon, cos_lon)) in row.iter_mut().zip(columns) {
        let p = DVec3::new(cos * cos_lon, cos * sin_lon, sin);
        let nearest = match hint {
            Some(hint) => mesh.nearest_from(p, hint),
            None => mesh.nearest(p),
        };
        hint = Some(nearest);
        *pixel = MapPixel::new(&mesh.locate_from(p, nearest));
    }
}

/// Longitude of the centre of column `x` in radians.
fn longitude(x: u32, width: u32) -> f64 {
    math::TAU * ((f64::from(x) + 0.5) / f64::from(width) - 0.5)
}

/// Latitude of the centre of row `y` in radians.
fn latitude(y: u32, height: u32) -> f64 {
    math::PI * (0.5 - (f64::from(y) + 0.5) / f64::from(height))
}

#[cfg(test)]
mod tests;
