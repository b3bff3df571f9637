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

pub mod carve;
pub mod cull;
pub mod demand;
pub mod edge_split;
pub mod emit;
pub mod face_decide;
pub mod face_split;
pub mod ground;
pub mod local;
pub mod locate;
pub mod mark;
pub mod scan;
pub mod step;
pub mod synthetic;
pub mod vertex_resolve;

pub mod rules;

#[cfg(test)]
mod ground_tests;
#[cfg(test)]
mod local_tests;
