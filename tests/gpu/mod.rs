//! The ground's modules in WGSL: each is valid alone, has its Rust module's functions under their
//! names, takes its constants from there, and has the same bits on every input; each pass has the
//! same words on every level, and a whole run the ground of the CPU.

mod arithmetic;
mod layouts;
mod names;
mod noise;
mod passes;
mod places;
mod runs;
mod views;
