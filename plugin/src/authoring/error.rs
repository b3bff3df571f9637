//! Why a command is refused.

use crate::params::ParamError;
use crate::plate::PlateId;
use crate::process::rifting::RiftError;
use thiserror::Error;

/// Why a command was refused.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum CommandError {
    /// The entity is no planet.
    #[error("the entity is no planet")]
    NoPlanet,
    /// The plate does not exist, or no longer.
    #[error("there is no plate {}", .0.0)]
    NoPlate(PlateId),
    /// A number is outside of its limits, or NaN.
    #[error("{field} = {} is outside of {min}..={max}", crate::params::shown(*value))]
    OutOfRange {
        /// The field.
        field: &'static str,
        /// The refused value.
        value: f64,
        /// Smallest allowed value.
        min: f64,
        /// Largest allowed value.
        max: f64,
    },
    /// The parameter or its value is refused.
    #[error(transparent)]
    Param(#[from] ParamError),
    /// The plate does not rift.
    #[error(transparent)]
    Rift(#[from] RiftError),
}
