//! Transverse valleys and river beds, carved once the subdivision is done (paper 002 §6, Fig. 17).
//!
//! A vertex knows the nearest piece of river, its distance d and where along it lies. There water
//! and flow φ are read off, and from the flow the river's width and depth (`reach.rs`). From the
//! middle outwards come the bed, the bank, the levee and the flood plain (`plain.rs`), and the
//! valley's side, which rises to half-width D along the archetype e_r's curve (`section.rs`).
//!
//! The water keeps its level under its banks ([`Carved`]): where it ends follows from the ground.

pub(in crate::amplify) mod reach;

pub(in crate::amplify) mod place;

pub(in crate::amplify) mod plain;
pub(in crate::amplify) mod section;

pub(in crate::amplify) mod carve;

pub use carve::{CarveCache, Carved, NO_WATER, carve};
pub use place::{RiverPlace, wander};
pub use reach::{Reach, keeps_course, width};
pub use section::{archetype, section};

#[cfg(test)]
mod tests;
