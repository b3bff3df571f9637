//! A pixel of a map, packed.

use crate::overlay::field::Barycentric;
use crate::sphere::Location;

/// The triangle around a pixel's centre and the weights of its first two corners in 65535ths: a map
/// has millions of pixels, and no colour needs more.
#[derive(Clone, Copy, Default)]
pub(super) struct MapPixel {
    vertices: [u32; 3],
    weights: [u16; 2],
}

impl MapPixel {
    pub(super) fn new(found: &Location) -> Self {
        let [a, b, _] = found.weights.map(|w| (w * 65_535.0 + 0.5) as u16);
        Self {
            vertices: found.vertices,
            // Rounding must not leave a negative weight for the third corner.
            weights: [a, b.min(u16::MAX - a)],
        }
    }

    /// The samples and their weights.
    pub(super) fn place(&self) -> Barycentric {
        let [a, b] = self.weights;
        Barycentric {
            vertices: self.vertices,
            weights: [a, b, u16::MAX - a - b].map(|w| f32::from(w) / 65_535.0),
        }
    }
}
