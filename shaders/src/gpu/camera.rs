//! A camera that sees the ground.

use crate::amplify::fixed::ONE;

/// The meaning of the ground's colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum GroundColours {
    /// Grass, sand, rock and snow.
    #[default]
    Natural = 0,
    /// The level that made a vertex: blue for coarse ones, red for fine ones.
    Level = 1,
    /// The kind of a vertex: ground, sea, coast, river, lake or gully.
    Kind = 2,
}

/// Bit of [`GroundCamera::words`]'s colours that draws the triangles' edges.
const WIREFRAME: u32 = 16;

crate::wgsl::shared!(
    DRAW_LEVEL = GroundColours::Level as u32,
    DRAW_KIND = GroundColours::Kind as u32,
    DRAW_WIREFRAME = WIREFRAME,
);

/// Bytes of the uniform of a camera.
pub(super) const CAMERA_BYTES: u64 = 128;

/// A camera that sees the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundCamera {
    /// From the planet's axes, with the camera at their origin, to the clip space: columns of a
    /// matrix. Depth is reversed: 1 near, 0 far.
    pub clip_from_planet: [[f32; 4]; 4],
    /// The camera's place from the planet's centre in the planet's axes, metres.
    pub position: [f64; 3],
    /// Units of length of the clip space in a metre.
    pub metre: f32,
    /// Where the sun stands, a unit vector in the planet's axes.
    pub sun: [f32; 3],
    /// The meaning of the colours.
    pub colours: GroundColours,
    /// Whether the triangles' edges are drawn.
    pub wireframe: bool,
}

impl GroundCamera {
    /// Its direction from the centre in integers, and its height above the sea in grains.
    fn quantised(&self, radius_m: f64) -> ([i32; 3], i32, [f32; 3]) {
        let length = self
            .position
            .map(|x| x * x)
            .iter()
            .sum::<f64>()
            .sqrt()
            .max(1.0);
        let one = f64::from(ONE);
        let direction = self.position.map(|x| (x / length * one).round() as i32);
        let height = ((length - radius_m) * 1024.0).round() as i32;
        let at = radius_m + f64::from(height) / 1024.0;
        let rest = [0, 1, 2].map(|i| {
            let rounded = f64::from(direction[i]) / one * at;
            ((self.position[i] - rounded) * f64::from(self.metre)) as f32
        });
        (direction, height, rest)
    }

    /// The words of its uniform.
    pub(super) fn words(&self, radius_m: f64) -> [u32; 32] {
        let (direction, height, rest) = self.quantised(radius_m);
        let unit = (radius_m / f64::from(ONE)) as f32;
        let colours = self.colours as u32 | if self.wireframe { WIREFRAME } else { 0 };
        let mut words = [0; 32];
        let matrix = self.clip_from_planet.iter().flatten();
        for (word, x) in words.iter_mut().zip(matrix) {
            *word = x.to_bits();
        }
        words[16..19].copy_from_slice(&direction.map(|x| x as u32));
        words[19] = height as u32;
        words[20..23].copy_from_slice(&rest.map(f32::to_bits));
        words[23] = self.metre.to_bits();
        words[24..27].copy_from_slice(&self.sun.map(f32::to_bits));
        words[27] = unit.to_bits();
        words[28] = colours;
        words
    }
}
