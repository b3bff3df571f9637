//! Fixed-point numbers of the ground, in the 32-bit operations that WGSL has.
//!
//! Directions are in units of 1 / [`ONE`] of the radius (3.1 mm on Earth), heights and lengths in grains of
//! 1 / [`GRAINS`] m (range ±2097 km), shares in Q16 (65,536 is 1).

/// A direction component of 1: 1.9 · 2³⁰, so that sums of differences stay within an i32.
pub const ONE: i32 = 2_040_109_465;

/// Grains in a metre.
pub const GRAINS: i32 = 1024;

/// 1 in Q16.
pub const Q16: i32 = 1 << 16;
