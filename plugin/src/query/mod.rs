//! The ground for games and tools: heights, water, normals, what the ground is made of, rays,
//! colliders, rasters.
//!
//! ```text
//! ground       Ground: what every reader asks for; levels and their lengths
//! sample       all there is to know of one point
//! surface      rock, sand, grass, snow ...: a rule of height, slope, warmth, wetness and water
//! planet       the amplified ground of a planet
//! coarse       the ground of the crust alone, interpolated between its samples
//! projection   azimuthal equidistant squares
//! raster       heights on such a square
//! patch        a regular grid of triangles around a point
//! collider     the ground's own triangles around a point
//! ray          where a ray meets the ground
//! tree         many rays against one patch
//! ```
//!
//! Positions are in metres from the planet's centre, +z to the north pole, +x to 0° E; heights are
//! above sea level. Nothing here panics on its input: what makes no sense is a [`GroundError`].

mod ground;

mod sample;

mod surface;

mod coarse;

mod planet;

mod projection;

mod raster;

mod patch;

mod collider;

mod ray;

mod tree;

pub use coarse::CoarseGround;
pub use ground::{Ground, LEVELS, checked, direction_at, level_for, spacing};
pub use pangaea_shaders::amplify::rules::Rules;
#[cfg(feature = "export")]
pub(crate) use patch::grid_triangles;
pub use patch::{Patch, collider_patch};
pub use planet::PlanetGround;
pub use projection::AzimuthalEquidistant;
pub use raster::{HeightGrid, Square};
pub use ray::{RayHit, cast_ray};
pub use sample::{Sample, normal, sample, samples};
use surface::LAPSE;
pub use surface::{Climate, GroundSurface, Site, classify};
pub use tree::PatchTree;

use thiserror::Error;

/// Why a question about the ground has no answer.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum GroundError {
    /// A direction or a position that is zero, infinite or not a number.
    #[error("a direction must be finite and not zero")]
    NotADirection,
    /// A latitude outside of -90..=90 degrees, or not a number.
    #[error("the latitude must be a number from -90 to 90, not {0}")]
    Latitude(f64),
    /// A longitude outside of -360..=360 degrees, or not a number.
    #[error("the longitude must be a number from -360 to 360, not {0}")]
    Longitude(f64),
    /// A level beyond the finest.
    #[error("level {0} does not exist: the finest is {max}", max = LEVELS)]
    Level(u8),
    /// A planet of no size, or of one that is not a number.
    #[error("the planet's radius must be a positive number of metres, not {0}")]
    Radius(f64),
    /// A length that is zero, negative, not a number, or too large.
    #[error("{what} must be from {min} to {max} m, not {value}")]
    Length {
        /// What it is the length of.
        what: &'static str,
        /// The refused value in m.
        value: f64,
        /// Smallest allowed value in m.
        min: f64,
        /// Largest allowed value in m.
        max: f64,
    },
    /// More or fewer points than there can be.
    #[error("{what} must be from {min} to {max}, not {value}")]
    Count {
        /// What is counted.
        what: &'static str,
        /// The refused number.
        value: usize,
        /// Smallest allowed number.
        min: usize,
        /// Largest allowed number.
        max: usize,
    },
    /// Whoever asked did not want to go on.
    #[error("stopped before all heights were known")]
    Stopped,
    /// The planet has no ground that could be asked for, in the words of its maker.
    #[error("{0}")]
    Unavailable(String),
}
