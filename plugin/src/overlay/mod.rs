//! Colours of maps and globes: one for every sample, and the legend that explains them.
//!
//! In: the [`Surface`](crate::crust::Surface) of a planet. Out: colours per sample
//! ([`colorize`](fn@colorize)) for the globe, [`Raster`]s ([`MapProjection`]) for files. Nothing
//! here needs a renderer.
//!
//! ```
//! use bevy::prelude::*;
//! use bevy_pangaea::overlay::{MapProjection, Overlay, OverlayInput};
//! use bevy_pangaea::plate::plate_table;
//! use bevy_pangaea::prelude::*;
//! use bevy_pangaea::spawn::PlanetState;
//!
//! let mut app = App::new();
//! app.add_plugins(PangaeaPlugins);
//! let recipe = PlanetRecipe { samples: 1000, plate_count: 8, ..default() };
//! let planet = PlanetState::new(&recipe)?.spawn(app.world_mut());
//!
//! let plates = plate_table(app.world(), planet);
//! let input = OverlayInput::from_world(app.world(), planet, &plates).ok_or("no planet")?;
//! let map = MapProjection::new(input.mesh, 64, 32).draw(Overlay::Elevation, &input);
//! assert_eq!(map.rgb.len(), 3 * 64 * 32);
//!
//! let legend = Overlay::Elevation.legend(&input);
//! assert_eq!((legend.title, legend.unit), ("Elevation", "km"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! ```text
//! kinds        the overlays by name
//! input        the parts of a planet that overlays read
//! palette      colour ramps, and the colours of classes
//! raster       a picture in memory
//! derivatives  gradient, slope, Laplacian and shading of the elevation
//! boundary     kinds of plate boundaries
//! discharge    the ramp of a river's discharge
//! rivers       the rivers of a bake as lines
//! baked        climate, discharge, basins and lakes of a bake
//! field        a quantity at every sample, and how it becomes a colour
//! quantity     which quantity an overlay shows
//! colorize     a colour for every sample
//! legend       title, unit and key of an overlay
//! map          equirectangular rasters
//! ```

mod kinds;

mod input;

pub mod palette;

mod raster;

mod derivatives;

mod boundary;

mod discharge;

pub(crate) mod rivers;

pub(crate) mod baked;

mod field;

mod quantity;

mod colorize;

mod legend;

mod map;

pub use boundary::{BoundaryKind, boundaries};
pub use colorize::colorize;
pub use input::OverlayInput;
pub use kinds::Overlay;
pub use legend::{Legend, LegendEntries};
pub use map::MapProjection;
pub use raster::Raster;
