//! The tests of Pangaea; `README.md` says what each kind is for.

#![allow(
    clippy::disallowed_methods,
    reason = "references in tests need not have the same bits everywhere"
)]

mod belts;
mod commands;
mod contracts;
mod determinism;
mod fast_paths;
mod folds;
mod fuzz;
mod input;
mod laws;
mod planets;
mod soak;
mod spectra;
mod structure;

#[cfg(feature = "render")]
mod gpu;
#[cfg(feature = "render")]
mod shaders;
