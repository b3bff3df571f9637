//! Climate: annual means of temperature, rain and wetness on a mesh with elevations.
//!
//! In: a [`SphereMesh`](crate::sphere::SphereMesh) and the elevation of its vertices. Out:
//! [`Climate`]. Cheap, smooth and deterministic; two seasons, no currents, no weather.
//!
//! ```text
//! scale         the size of the Earth, on which the model's lengths are given
//! map           equirectangular maps of a user, which replace any field
//! temperature   latitude and altitude
//! wetness       rain against the evaporation that the warmth allows; runoff
//! sweep         the points upwind; a mesh laid out in the order of the wind
//! wind          the prevailing winds of six belts, and the order in which they blow
//! rain          moisture carried along the wind: distance to the sea, uplift, rain shadow
//! field         the fields that a user can give, and the values that they may have
//! fields        all of them together
//! by_field      the maps of a user by the field that they replace
//! ```
//!
//! Lengths along the ground are those of an Earth-sized planet ([`EARTH_RADIUS`]): a small planet
//! has the same belts, deserts and shadows as a large one. Heights are true kilometres.
//!
//! Policies. *Sea* is all ground below 0, lakes included: they are too small to moisten the air
//! much. *A field that a map gives* is used as it is, and the others follow from it: wetness and
//! runoff still come from a given rain. *Voids of a map*, pixels without a value, are filled with
//! the field that the planet would have without that map.

mod scale;

mod map;

mod temperature;

mod wetness;

mod sweep;

mod wind;

mod rain;

mod field;

mod fields;

mod by_field;

pub use field::ClimateField;
pub use fields::{Climate, ClimateMaps};
pub use map::{EquirectMap, MapError};
pub use scale::EARTH_RADIUS;
pub use sweep::{SweepPath, Upwind};
pub use temperature::{LAPSE_RATE_K_PER_KM, mean_temperature};
pub use wind::{WindBelts, Winds};
