//! Checks of a command that need no planet: names, limits, coordinates.

use super::error::CommandError;
use super::{Brush, PaintTarget, TectonicCommand};
use crate::math::direction;
use crate::params::{ProcessSwitches, TectonicParams, within};
use bevy::math::DVec3;

impl TectonicCommand {
    /// Checks names and numbers, as far as they do not depend on a planet. Commands are checked by
    /// this before they take effect, and scenarios and recordings when they are read: what one
    /// accepts the others accept.
    ///
    /// # Errors
    /// [`CommandError`] for the first name or number that is refused.
    pub fn check(&self) -> Result<(), CommandError> {
        match self {
            Self::SetPlateMotion { pole, speed, .. } => {
                direction_of(*pole)?;
                Ok(within("speed", *speed, -300.0, 300.0)?)
            }
            Self::RiftPlate {
                line, fragments, ..
            } => {
                check_line(line)?;
                Ok(within("fragments", f64::from(*fragments), 2.0, 4.0)?)
            }
            Self::PaintCrust { target, brush } => {
                target.check()?;
                brush.check()
            }
            Self::SetParam { name, value } => Ok(TectonicParams::default().set(name, *value)?),
            Self::SetProcess { name, .. } => {
                Ok(ProcessSwitches::default().get_mut(name).map(|_| ())?)
            }
            Self::SetPlateCrust { .. } | Self::SetOceanFloor { .. } | Self::Resample => Ok(()),
        }
    }
}

impl PaintTarget {
    fn check(&self) -> Result<(), CommandError> {
        match *self {
            Self::Everywhere => Ok(()),
            Self::Disc { center, radius } => {
                direction_of(center)?;
                Ok(within("radius", radius, 0.0, 1e5)?)
            }
        }
    }
}

impl Brush {
    fn check(&self) -> Result<(), CommandError> {
        match *self {
            Self::Raise(km) => Ok(within("height", km, -20.0, 20.0)?),
            Self::Elevation(km) => Ok(within("elevation", km, -15.0, 20.0)?),
            Self::Kind(_) => Ok(()),
        }
    }
}

/// A line of no points asks for a random fracture.
fn check_line(line: &[(f64, f64)]) -> Result<(), CommandError> {
    if line.is_empty() {
        return Ok(());
    }
    within("points", line.len() as f64, 2.0, 1000.0)?;
    line.iter()
        .try_for_each(|&point| direction_of(point).map(|_| ()))
}

/// Checks a latitude and longitude in degrees and returns the direction.
pub(super) fn direction_of((lat, lon): (f64, f64)) -> Result<DVec3, CommandError> {
    within("latitude", lat, -90.0, 90.0)?;
    within("longitude", lon, -360.0, 360.0)?;
    Ok(direction(lat, lon))
}
