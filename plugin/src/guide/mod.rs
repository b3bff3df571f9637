//! Pages to read, without any item.

pub mod costs;
#[cfg(feature = "export")]
pub mod engines;
pub mod symbols;
