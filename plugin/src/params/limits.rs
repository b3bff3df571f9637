//! Numbers and their limits.

use thiserror::Error;

/// A number outside of its limits, or NaN.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{name} = {} is outside of {min}..={max}{}", shown(*value), with_unit(unit))]
pub struct OutOfRange {
    /// Name of the number.
    pub name: &'static str,
    /// The refused value.
    pub value: f64,
    /// Smallest allowed value.
    pub min: f64,
    /// Largest allowed value.
    pub max: f64,
    /// Unit of the limits, empty for a pure number.
    pub unit: &'static str,
}

/// Refuses a pure number outside of its limits, and NaN.
///
/// # Errors
/// [`OutOfRange`]
///
/// ```
/// use bevy_pangaea::params::within;
///
/// assert!(within("latitude", 45.0, -90.0, 90.0).is_ok());
/// let error = within("latitude", f64::NAN, -90.0, 90.0).unwrap_err();
/// assert_eq!(error.to_string(), "latitude = NaN is outside of -90..=90");
/// ```
pub fn within(name: &'static str, value: f64, min: f64, max: f64) -> Result<(), OutOfRange> {
    within_of(name, value, min, max, "")
}

/// The same for a number with a unit.
pub(super) fn within_of(
    name: &'static str,
    value: f64,
    min: f64,
    max: f64,
    unit: &'static str,
) -> Result<(), OutOfRange> {
    // Written so that NaN is refused.
    if value >= min && value <= max {
        return Ok(());
    }
    Err(OutOfRange {
        name,
        value,
        min,
        max,
        unit,
    })
}

/// A refused number as a message shows it: a huge one with an exponent, not with three hundred
/// digits.
pub(crate) fn shown(value: f64) -> String {
    if value.abs() >= 1e15 {
        format!("{value:e}")
    } else {
        value.to_string()
    }
}

fn with_unit(unit: &str) -> String {
    if unit.is_empty() {
        String::new()
    } else {
        format!(" {unit}")
    }
}
