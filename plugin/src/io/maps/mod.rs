//! Maps of the whole planet, as a user gives them: equirectangular, north up, longitude -180 at the
//! left edge.
//!
//! A GeoTIFF of one band holds the values themselves; one that says where it is may begin at any
//! meridian, its rows in the south, hold values at nodes, and leave out latitudes. A PNG holds
//! greys, in whatever form: what black and white stand for is told by a sidecar NAME.json,
//! `{"min": -40, "max": 35}`, or by the caller; values between are linear.
//!
//! Pixels without a value, such as the sea in an archive of land, are voids: nodata of a GeoTIFF,
//! transparent pixels of a PNG, latitudes that a map does not reach.
//!
//! ```text
//! error    why a file is no map
//! units    units of the quantities that maps show
//! regrid   from the pixels of a raster to those of a map
//! doubt    maps whose values look like those of another unit
//! load     files of maps, read
//! climate  maps of the climate, and what to say of them
//! reduce   maps that are finer than the base mesh
//! ```

mod error;

mod units;

mod regrid;

mod doubt;

mod reduce;

mod load;

mod climate;

pub use climate::{LoadedClimate, load_climate_maps};
pub use error::MapFileError;
pub use load::{LoadedMap, load_map, load_map_of};
pub(super) use reduce::reduced;
pub use units::MapQuantity;
