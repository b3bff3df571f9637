//! The ground of a planet down to half a metre, in exact integers; and the WGSL of the globe.
//!
//! - [`amplify`] refines a control mesh of 52 km to ground of half a metre. It runs on the CPU, is
//!   written pass by pass and in operations that WGSL's 32-bit integers have: every pass has a twin
//!   in WGSL with the same bits.
//! - [`wgsl`] puts compute shaders together of such twins.
//! - `gpu` (feature `gpu`) runs them: a view's ground, from the control mesh to the last triangle,
//!   without reading anything back.
//! - [`globe`] holds the WGSL that draws a planet from orbit, as constants: ground and sea, air,
//!   lines.
//!
//! Without features the crate has no dependencies; it knows no engine. Compute shaders are plain WGSL; a shader that
//! draws is written in the dialect of Bevy (`naga_oil`: `#import`, `#ifdef`, `#{NAME}`).

pub mod wgsl;

pub mod amplify;

#[cfg(feature = "gpu")]
pub mod gpu;

pub mod globe;

/// The examples of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
