//! Amplification: the planet's ground from 52 km to half a metre, in exact integers (paper 002).

pub mod arith;
pub mod fixed;

pub mod control;
pub mod seed;
pub mod vertex;

pub mod rules;
