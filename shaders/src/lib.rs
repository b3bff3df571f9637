//! The WGSL of Pangaea, and the ground in exact integers that its compute passes share with the
//! CPU.
//!
//! The crate has no dependencies and knows no renderer. [`amplify`] grows the ground from a control
//! mesh; [`globe`] holds the passes that draw a planet from orbit. A source is written in the
//! dialect of Bevy (`naga_oil`: `#import`, `#ifdef`, `#{NAME}`).
//!
//! Two kinds of source, told apart by their headers:
//! - *libraries* (`#define_import_path pangaea_shaders::...`) hold pure functions and import
//!   nothing, so they
//!   can be reused in other passes, validated alone, and twinned on the CPU;
//! - *passes* have entry points and bindings, and import the renderer's view and mesh.

pub mod amplify;

pub mod globe;

/// The examples of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
