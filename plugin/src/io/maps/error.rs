//! Why a file is no map.

use crate::climate::MapError;
use crate::io::dem::DemError;
use thiserror::Error;

/// Why a file is no map.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum MapFileError {
    /// Files with the name's extension are not read.
    #[error("maps are .tif, .tiff or .png files")]
    Extension,
    /// The file cannot be decoded.
    #[error(transparent)]
    Raster(#[from] DemError),
    /// The map shows a part of the planet.
    #[error(
        "the map reaches from {} to {} °E and from {} to {} °N; \
         it must reach over 360 degrees of longitude, between -90 and 90 °N",
        .0[0], .0[1], .0[2], .0[3]
    )]
    Extent([f64; 4]),
    /// Values in a unit that is not one of the quantity.
    #[error("values in the unit {0:?} are not read here")]
    Unit(String),
    /// A picture without the values of black and white.
    #[error(
        "a grey picture needs a sidecar {0} with the values of black and white, \
         {{\"min\": .., \"max\": ..}}"
    )]
    NoScale(String),
    /// A sidecar that does not hold the values of black and white.
    #[error("the sidecar must be {{\"min\": .., \"max\": ..}}, two different finite numbers")]
    Sidecar,
    /// A sidecar of a square of ground.
    #[error("the sidecar is that of a square of ground; a map shows a whole planet")]
    Square,
    /// Elevations in metres of which none is beyond 15 m.
    #[error(
        "no elevation is beyond 15 m; if they are kilometres, a terrain file must say so: \
         `unit: kilometres`"
    )]
    Flat,
    /// The size or a value is not one of a map.
    #[error(transparent)]
    Map(#[from] MapError),
}
