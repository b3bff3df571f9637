//! The library of Pangaea's tests: planets without a window, hand-made crust, and measurements by
//! brute force.
//!
//! ```text
//! world      apps, steps, digests, commands, snapshots of the state
//! shape      planets whose plates and coasts are known to the kilometre
//! grown      planets that have grown and were amplified
//! order      commands in few words
//! measure    areas, volumes, hypsometry, coverage, by brute force
//! probe      what every stage of a step does to the state
//! fuzz       damaged inputs for readers
//! gpu        functions and passes in WGSL beside their twins (with the feature `render`)
//! soak       long runs, and the memory that they take
//! ```

pub mod earth;
pub mod fuzz;
#[cfg(feature = "render")]
pub mod gpu;
pub mod grown;
pub mod measure;
pub mod order;
pub mod probe;
pub mod shape;
pub mod soak;
pub mod world;
