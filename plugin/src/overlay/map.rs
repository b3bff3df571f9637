//! Equirectangular maps: north up, longitude -180 at the left edge, 0 in the middle.
//!
//! Where each pixel lies in the mesh is looked up once, in a [`MapProjection`] that serves all maps
//! of a planet. A pixel stands for the point at its centre.

use super::boundary::{BoundaryKind, boundaries};
use super::derivatives::{gradients_of, shade};
use super::field::{Field, majority};
use super::palette::{self, Rgba};
use super::{Overlay, OverlayInput, ground};
use crate::crust::{CrustKind, Surface};
use crate::math;
use crate::plate::PlateId;
use crate::sphere::{Location, SphereMesh};
use bevy::math::{DVec3, Vec3};
use rayon::prelude::*;

/// A picture of 8 bits per channel, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster {
    /// Pixels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green and blue of every pixel.
    pub rgb: Vec<u8>,
}

/// Where every pixel of a map lies between the samples of a mesh.
pub struct MapProjection {
    width: u32,
    height: u32,
    samples: usize,
    pixels: Vec<Pixel>,
}

/// The triangle around a pixel's centre and the weights of its first two corners in 65535ths: a map
/// has millions of pixels, and no colour needs more.
#[derive(Clone, Copy, Default)]
struct Pixel {
    vertices: [u32; 3],
    weights: [u16; 2],
}

impl Pixel {
    fn new(found: &Location) -> Self {
        let [a, b, _] = found.weights.map(|w| (w * 65_535.0 + 0.5) as u16);
        Self {
            vertices: found.vertices,
            weights: [a, b.min(u16::MAX - a)],
        }
    }

    fn weights(&self) -> [f32; 3] {
        let [a, b] = self.weights;
        [a, b, u16::MAX - a - b].map(|w| f32::from(w) / 65_535.0)
    }
}

/// How much steeper than true the relief of maps is drawn, on land and under water.
const EXAGGERATION: (f32, f32) = (20.0, 9.0);

impl MapProjection {
    /// Largest width or height of a map in pixels.
    pub const MAX_SIDE: u32 = 16_384;

    /// Looks up every pixel of a map of `width` x `height` pixels, each clamped to
    /// 1..=[`Self::MAX_SIDE`].
    pub fn new(mesh: &SphereMesh, width: u32, height: u32) -> Self {
        let (width, height) = (
            width.clamp(1, Self::MAX_SIDE),
            height.clamp(1, Self::MAX_SIDE),
        );
        let mut pixels = vec![Pixel::default(); width as usize * height as usize];
        let columns: Vec<(f64, f64)> = (0..width)
            .map(|x| math::sin_cos(longitude(x, width)))
            .collect();
        pixels
            .par_chunks_mut(width as usize)
            .enumerate()
            .for_each(|(y, row)| {
                let (sin, cos) = math::sin_cos(latitude(y as u32, height));
                let mut hint = None;
                for (pixel, &(sin_lon, cos_lon)) in row.iter_mut().zip(&columns) {
                    let p = DVec3::new(cos * cos_lon, cos * sin_lon, sin);
                    let nearest = match hint {
                        Some(hint) => mesh.nearest_from(p, hint),
                        None => mesh.nearest(p),
                    };
                    hint = Some(nearest);
                    *pixel = Pixel::new(&mesh.locate_from(p, nearest));
                }
            });
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
        let at = |pixel: &Pixel| {
            let weights = pixel.weights();
            (0..3)
                .map(|c| weights[c] * value(pixel.vertices[c] as usize))
                .sum()
        };
        self.pixels
            .par_iter()
            .with_min_len(self.width as usize)
            .map(at)
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
        if let (Some(bake), true) = (input.bake, ground::is_baked(overlay)) {
            return ground::draw(overlay, bake, self.width, self.height);
        }
        let mut rgb = vec![0; 3 * self.pixels.len()];
        if input.surface.len() == self.samples {
            let brush = Brush::new(overlay, input, self);
            let width = self.width as usize;
            rgb.par_chunks_mut(3 * width)
                .enumerate()
                .for_each(|(y, row)| {
                    let pixels = &self.pixels[y * width..(y + 1) * width];
                    for (out, pixel) in row.chunks_exact_mut(3).zip(pixels) {
                        out.copy_from_slice(&brush.color(pixel)[..3]);
                    }
                });
        }
        Raster {
            width: self.width,
            height: self.height,
            rgb,
        }
    }
}

fn longitude(x: u32, width: u32) -> f64 {
    math::TAU * ((f64::from(x) + 0.5) / f64::from(width) - 0.5)
}

fn latitude(y: u32, height: u32) -> f64 {
    math::PI * (0.5 - (f64::from(y) + 0.5) / f64::from(height))
}

/// What is drawn over the colours of an overlay.
enum Ink {
    Nothing,
    /// Uphill gradient per sample, of the land with the sea as a plain, and of the sea floor with
    /// the land as one: a coast is no cliff.
    Relief {
        land: Vec<Vec3>,
        sea: Vec<Vec3>,
    },
    /// Kind of boundary per sample.
    Boundaries(Vec<BoundaryKind>),
    /// Opacity and width (in barycentric weight) of the edges of triangles.
    Edges {
        opacity: f32,
        width: f32,
    },
}

struct Brush<'a> {
    field: Field,
    ink: Ink,
    mesh: &'a SphereMesh,
    surface: &'a Surface,
    kinds: &'a [CrustKind],
}

impl<'a> Brush<'a> {
    fn new(overlay: Overlay, input: &OverlayInput<'a>, map: &MapProjection) -> Self {
        let ink = match overlay {
            Overlay::Elevation => Ink::Relief {
                land: gradients_of(input, |z| z.max(0.0)),
                sea: gradients_of(input, |z| z.min(0.0)),
            },
            Overlay::Plates => Ink::Boundaries(boundaries(input)),
            Overlay::Mesh => {
                // Height of a triangle in pixels: where it is small, edges fade instead of covering
                // all.
                let height = 0.866 * input.mesh.spacing() / (math::PI / f64::from(map.height));
                Ink::Edges {
                    opacity: (height / 12.0).min(0.6) as f32,
                    width: (0.6 / height).min(0.3) as f32,
                }
            }
            _ => Ink::Nothing,
        };
        let (mesh, surface) = (input.mesh, input.surface);
        Self {
            field: Field::new(overlay, input),
            ink,
            mesh,
            surface,
            kinds: &surface.crust.kind,
        }
    }

    fn color(&self, pixel: &Pixel) -> Rgba {
        let (vertices, weights) = (pixel.vertices, pixel.weights());
        let color = self.field.between(vertices, weights, self.kinds);
        match &self.ink {
            Ink::Nothing => color,
            Ink::Relief { land, sea } => self.shaded(color, vertices, weights, [land, sea]),
            Ink::Boundaries(kinds) => self.bordered(color, vertices, weights, kinds),
            Ink::Edges { opacity, width } => {
                let least = weights[0].min(weights[1]).min(weights[2]);
                if least < *width {
                    palette::mix(color, [40, 42, 48, 255], *opacity)
                } else {
                    color
                }
            }
        }
    }

    fn shaded(
        &self,
        color: Rgba,
        vertices: [u32; 3],
        weights: [f32; 3],
        [land, sea]: [&[Vec3]; 2],
    ) -> Rgba {
        let corners = || vertices.into_iter().map(|v| v as usize).zip(weights);
        let z: f32 = corners().map(|(v, w)| w * self.surface.elevation(v)).sum();
        let (gradients, exaggeration) = if z >= 0.0 {
            (land, EXAGGERATION.0)
        } else {
            (sea, EXAGGERATION.1)
        };
        let p: Vec3 = corners()
            .map(|(v, w)| w * self.mesh.point(v as u32).as_vec3())
            .sum();
        let gradient: Vec3 = corners().map(|(v, w)| w * gradients[v]).sum();
        let light = shade(p.normalize_or(Vec3::Z), gradient * exaggeration);
        palette::scaled(color, light.clamp(0.45, 1.35))
    }

    fn bordered(
        &self,
        color: Rgba,
        vertices: [u32; 3],
        weights: [f32; 3],
        kinds: &[BoundaryKind],
    ) -> Rgba {
        let plates: [PlateId; 3] = vertices.map(|v| self.surface.plate[v as usize]);
        if plates[0] == plates[1] && plates[1] == plates[2] {
            return color;
        }
        let (_, lead) = majority(plates, weights);
        if lead > 0.5 {
            return color;
        }
        let (kind, _) = majority(vertices.map(|v| kinds[v as usize]), weights);
        if kind == BoundaryKind::None {
            color
        } else {
            kind.color()
        }
    }
}

#[cfg(test)]
#[path = "map_tests.rs"]
mod tests;
