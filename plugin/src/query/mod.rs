//! The ground for games and tools: heights, water, normals, materials, rays, colliders, rasters.
//!
//! ```text
//! level        levels of detail and their lengths
//! error        GroundError
//! check        directions, radii, lengths and counts that make sense
//! surface      rock, sand, grass, snow ...: a rule of height, slope, warmth, wetness and water
//! sample       all there is to know of one point; normals
//! ground       the trait Ground: the questions that every reader asks
//! planet       the amplified ground of a planet
//! coarse       the ground of the crust alone, interpolated between its samples
//! projection   azimuthal equidistant squares
//! map_grid     regular grids of points on a map, and windows of them
//! bands        heights on a grid, by bands of rows
//! raster       squares of pixels, and heights on them
//! tiles        blocks of tiles that share their edges
//! degree_box   boxes of latitudes and longitudes
//! patch        a regular grid of triangles around a point
//! collider     the ground's own triangles around a point
//! ray          where a ray meets the ground
//! height_field heights that a user gives at a place, over those of a planet
//! tree         many rays against one patch
//! ```
//!
//! Positions are in metres from the planet's centre, +z to the north pole, +x to 0° E; heights are
//! above sea level. Nothing here panics on its input: a question without an answer is a
//! [`GroundError`].

mod level;

mod error;

mod check;

mod surface;

mod sample;

mod ground;

mod planet;

mod coarse;

mod projection;

mod map_grid;

mod bands;

mod raster;

mod tiles;

mod degree_box;

mod patch;

mod collider;

mod ray;

mod tree;

mod height_field;

pub use check::{checked, direction_at};
pub use coarse::CoarseGround;
pub use degree_box::DegreeBox;
pub use error::GroundError;
pub use ground::Ground;
pub use height_field::{FieldGround, HeightField};
pub use level::{LEVELS, level_for, spacing};
pub use map_grid::{GridPoint, GridProjection, MapGrid};
pub use pangaea_shaders::amplify::rules::Rules;
#[cfg(feature = "export")]
pub(crate) use patch::row_triangles;
pub use patch::{Patch, collider_patch};
pub use planet::PlanetGround;
pub use projection::AzimuthalEquidistant;
pub use raster::{HeightGrid, MapSquare};
pub use ray::{RayHit, cast_ray};
pub use sample::Sample;
pub use surface::{ClimateSample, GroundConditions, GroundSurface, classify};
pub use tiles::TileBlock;
pub use tree::PatchTree;
