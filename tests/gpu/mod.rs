//! The ground's modules in WGSL: each is valid alone, has its Rust module's functions under their
//! names, takes its constants from there, and has the same bits on every input.

mod arithmetic;
mod names;
mod noise;
mod places;
mod views;
