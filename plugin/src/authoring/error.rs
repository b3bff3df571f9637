//! Why a command is refused.

use crate::params::{OutOfRange, ParamError};
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
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// The parameter or its value is refused.
    #[error(transparent)]
    Param(#[from] ParamError),
    /// The plate does not rift.
    #[error(transparent)]
    Rift(#[from] RiftError),
}
