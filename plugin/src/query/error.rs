//! Why a question about the ground has no answer.

use super::level::LEVELS;
use bevy::reflect::Reflect;
use thiserror::Error;

/// Why a question about the ground has no answer.
#[derive(Clone, Debug, Error, PartialEq, Reflect)]
pub enum GroundError {
    /// A direction or a position that is zero, infinite or NaN.
    #[error("a direction must be finite and not zero")]
    NotADirection,
    /// A latitude outside of -90..=90 degrees, or NaN.
    #[error("the latitude must be a number from -90 to 90, not {0}")]
    Latitude(f64),
    /// A longitude outside of -360..=360 degrees, or NaN.
    #[error("the longitude must be a number from -360 to 360, not {0}")]
    Longitude(f64),
    /// A level beyond the finest.
    #[error("level {0} does not exist: the finest is {max}", max = LEVELS)]
    Level(u8),
    /// A planet's radius that is zero, negative, infinite or NaN.
    #[error("the planet's radius must be a positive number of metres, not {0}")]
    Radius(f64),
    /// A length that is zero, negative, NaN, or too large.
    #[error("{what} must be from {min} to {max} m, not {value}")]
    Length {
        /// The thing that has the length.
        what: &'static str,
        /// The refused value in m.
        value: f64,
        /// Smallest allowed value in m.
        min: f64,
        /// Largest allowed value in m.
        max: f64,
    },
    /// More or fewer things than there can be.
    #[error("{what} must be from {min} to {max}, not {value}")]
    Count {
        /// The counted things.
        what: &'static str,
        /// The refused number.
        value: usize,
        /// Smallest allowed number.
        min: usize,
        /// Largest allowed number.
        max: usize,
    },
    /// A box of degrees without a width or a height, or wider than the planet.
    #[error("the box {0} {1}")]
    Box(&'static str, String),
    /// The machine has no memory left.
    #[error("there is not enough memory")]
    Memory,
    /// The caller stopped the work.
    #[error("stopped before all heights were known")]
    Stopped,
    /// The planet has no ground for this question, in the words of its maker.
    #[error("{0}")]
    Unavailable(String),
}
