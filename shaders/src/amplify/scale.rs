//! The size of a planet: how lengths of directions become metres, and how long an edge of a level
//! is.

use super::arith::length;
use super::control::ControlMesh;
use super::fixed::{ONE, difference, mul_shift};

/// Constants of one planet, in the layout of a uniform.
///
/// ```
/// use pangaea_shaders::amplify::fixed::{ONE, metres};
/// use pangaea_shaders::amplify::scale::PlanetScale;
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let scale = PlanetScale::new(&control_mesh(6_371_000, 3, 1));
/// // A millionth of the radius is 6.371 m.
/// let length = scale.grains([ONE / 1_000_000, 0, 0]);
/// assert!((length - metres(6_371) / 1_000).abs() < 8);
/// assert_eq!(scale.edge_grains(1), scale.edge_grains(0) / 2);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct PlanetScale {
    /// Radius at sea level, metres.
    pub radius_m: u32,
    /// Grains in a unit of direction, Q20.
    pub grains_per_unit: u32,
    /// Sixteenths of a metre in four units of direction, Q20.
    pub sixteenths_per_four: u32,
    /// Mean edge of the control mesh ℓ₀, sixteenths of a metre.
    pub edge: u32,
}

impl PlanetScale {
    /// The planet of a control mesh.
    pub fn new(mesh: &ControlMesh) -> Self {
        let radius = f64::from(mesh.radius_m.clamp(1000, 20_000_000));
        // An equilateral triangulation of the sphere with as many faces: edge² = 4/√3 · area.
        let area = 4.0 * std::f64::consts::PI / mesh.faces.len().max(4) as f64;
        let edge = (area * 4.0 / 3.0_f64.sqrt()).sqrt() * radius * 16.0;
        let unit = radius / f64::from(ONE) * f64::from(1_u32 << 20);
        Self {
            radius_m: mesh.radius_m,
            grains_per_unit: (unit * 1024.0).round() as u32,
            sixteenths_per_four: (unit * 64.0).round() as u32,
            edge: edge.round() as u32,
        }
    }

    /// It as a uniform: the words of its twin in WGSL.
    pub const fn words(&self) -> [u32; 4] {
        [
            self.radius_m,
            self.grains_per_unit,
            self.sixteenths_per_four,
            self.edge,
        ]
    }

    /// Length of a difference of directions, grains.
    #[inline]
    pub fn grains(&self, d: [i32; 3]) -> i32 {
        mul_shift(length(d[0], d[1], d[2]) as u32, self.grains_per_unit, 20)
    }

    /// Distance between two directions, anywhere on the sphere, along the chord; sixteenths of a
    /// metre.
    #[inline]
    pub fn chord(&self, a: [i32; 3], b: [i32; 3]) -> i32 {
        // Opposite directions are 2·ONE apart, which an i32 does not hold.
        let d = difference(a.map(|x| x >> 2), b.map(|x| x >> 2));
        self.sixteenths(length(d[0], d[1], d[2]) as u32)
    }

    /// A length in four units of direction as sixteenths of a metre.
    #[inline]
    pub fn sixteenths(&self, fours: u32) -> i32 {
        mul_shift(fours, self.sixteenths_per_four, 20)
    }

    /// Theoretical edge of a level, grains: ℓ₀ / 2^level.
    #[inline]
    pub fn edge_grains(&self, level: u32) -> i32 {
        // 64 grains in a sixteenth of a metre, doubled, for a shift of at least 1.
        mul_shift(self.edge, 128, 1 + level)
    }
}
