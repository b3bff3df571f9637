//! Amplification: the planet's ground from 52 km to half a metre, in exact integers (paper 002).

pub mod arith;
pub mod fixed;

pub mod control;
pub mod seed;
pub mod vertex;

pub mod base;
pub mod geometry;
pub mod planet;
pub mod topology;

pub mod cull;
pub mod mark;
pub mod scan;
pub mod edge_split;
pub mod face_decide;
pub mod vertex_resolve;
pub mod face_split;
pub mod step;
pub mod carve;
pub mod emit;
pub mod ground;
pub mod locate;
pub mod local;
pub mod synthetic;

pub mod rules;

#[cfg(test)]
mod ground_tests;
#[cfg(test)]
mod local_tests;
