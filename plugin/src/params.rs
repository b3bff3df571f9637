//! The constants of the model: one table gives each its default, limits, unit and source, and with
//! them validation, files, commands and the explorer's panel.
//!
//! Values of paper 000, Appendix A, where it gives one; the others say why they are what they are.

mod limits;
mod switches;
mod table;

use bevy::prelude::*;
use thiserror::Error;

pub(crate) use limits::shown;
use limits::within_of;
pub use limits::{OutOfRange, within};
pub use switches::{OceanFloor, ProcessSwitches};
pub use table::TectonicParams;

/// Name, limits, unit and meaning of a parameter.
#[derive(Clone, Copy, Debug)]
pub struct ParamInfo {
    /// Name in files and commands.
    pub name: &'static str,
    /// The section of the panel that it belongs to.
    pub group: &'static str,
    /// Smallest allowed value.
    pub min: f64,
    /// Largest allowed value.
    pub max: f64,
    /// Default value.
    pub default: f64,
    /// Unit, empty for a pure number.
    pub unit: &'static str,
    /// Meaning and source.
    pub doc: &'static str,
    /// Reads the value.
    pub get: fn(&TectonicParams) -> f64,
    set: fn(&mut TectonicParams, f64),
}

/// Why a parameter was refused.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ParamError {
    /// There is no parameter of that name.
    #[error("unknown parameter `{}`", .0.escape_debug())]
    Unknown(String),
    /// The value is outside of the limits, or NaN.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// Two parameters stand the wrong way round.
    #[error("{lower} is above {upper}")]
    Order {
        /// The one that must not be above the other.
        lower: &'static str,
        /// The other.
        upper: &'static str,
    },
}

/// Parameters that came after files and digests of planets were fixed. Those hold one only where it
/// differs from its default, so that a planet without it keeps its bytes, and programs from before
/// can read it. The default of such a parameter never changes.
const LATER: [&str; 8] = [
    "slab_pull_grace",
    "trench_speed",
    "himalayan_memory",
    "collision_belt_share",
    "widest_crack",
    "noise_period",
    "rift_in_two",
    "rift_up_to_three",
];

impl TectonicParams {
    /// The parameters that a file of the planet holds, in the order of the table.
    pub(crate) fn written(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let entries = Self::TABLE
            .iter()
            .map(|info| (info, (info.get)(self)))
            .filter(|(info, value)| !LATER.contains(&info.name) || *value != info.default);
        entries.map(|(info, value)| (info.name, value))
    }

    /// The entry of the parameter `name`.
    pub fn info(name: &str) -> Option<&'static ParamInfo> {
        Self::TABLE.iter().find(|info| info.name == name)
    }

    /// Sets one parameter by name.
    ///
    /// # Errors
    /// [`ParamError`] for an unknown name or a value outside of the limits; nothing is changed
    /// then.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), ParamError> {
        let info = Self::info(name).ok_or_else(|| ParamError::Unknown(name.to_string()))?;
        info.check(value)?;
        (info.set)(self, value);
        Ok(())
    }

    /// Distance from a front at which uplift has faded to 0, in km.
    pub fn uplift_end(&self) -> f64 {
        self.subduction_distance * self.subduction_reach
    }

    /// Checks every parameter, and that trenches lie below abysses, and those below ridges.
    ///
    /// # Errors
    /// The first [`ParamError::OutOfRange`], or [`ParamError::Order`].
    pub fn validate(&self) -> Result<(), ParamError> {
        Self::TABLE
            .iter()
            .try_for_each(|info| info.check((info.get)(self)))?;
        let depths = [
            ("trench_elevation", self.trench_elevation),
            ("abyss_elevation", self.abyss_elevation),
            ("ridge_elevation", self.ridge_elevation),
        ];
        match depths.windows(2).find(|pair| pair[0].1 > pair[1].1) {
            Some(pair) => Err(ParamError::Order {
                lower: pair[0].0,
                upper: pair[1].0,
            }),
            None => Ok(()),
        }
    }
}

impl ParamInfo {
    /// Refuses a value outside of the limits.
    ///
    /// # Errors
    /// [`ParamError::OutOfRange`]
    pub fn check(&self, value: f64) -> Result<(), ParamError> {
        Ok(within_of(self.name, value, self.min, self.max, self.unit)?)
    }
}

#[cfg(test)]
mod tests;
