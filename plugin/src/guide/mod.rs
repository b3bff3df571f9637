//! Pages to read, without any item.

pub mod costs;
pub mod symbols;
