//! Hydrology: the way of the rain to the sea (paper 002 §4).
//!
//! In: the base mesh, its ground and its climate. Out: [`Drainage`].
//!
//! ```text
//! base          the base mesh: Poisson-disk points, triangles, winds; once per seed
//! landform      relief around a vertex, by the age and kind of its crust
//! terrain_maps  a user's maps instead of a simulation
//! terrain       the ground and the landforms of its vertices, from the crust or from a user's maps
//! coast         sea, coast and land, such that estuaries have room
//! flood         which way water leaves every place
//! flow          discharge, to the last cubic metre
//! sinks         basins without an outlet
//! network       the choice of a river network
//! growth        the paper's own network, grown from the coasts; a preset
//! profile       levels, beds and lakes along the rivers
//! order         Horton-Strahler order, basins
//! drainage      all of them together
//! delta         land that great rivers build into shallow seas
//! stats         figures: Horton's ratios, Hack's exponent
//! ```
//!
//! Heights are whole grains of 1/1024 m ([`pangaea_shaders::amplify::fixed`]), water is whole cubic
//! metres per year: conserved quantities are conserved to the last unit.

mod base;

mod landform;

mod terrain_maps;

mod terrain;

mod coast;

mod flood;

mod flow;

mod sinks;

mod network;

mod growth;

mod profile;

mod order;

mod drainage;

mod delta;

mod stats;

pub use base::{BASE_SPACING, BaseMesh, Transfer};
pub use coast::ShoreClass;
pub(crate) use coast::ground_of_coast;
pub(crate) use delta::{Delta, deltas};
pub use drainage::{Drainage, LakeKind};
pub use flood::{Depression, NO_VERTEX, Routes};
pub(crate) use landform::worn;
pub use network::RiverNetwork;
pub(crate) use profile::MIN_FALL;
pub use profile::{Lake, NO_LAKE, Profile};
pub use stats::{Horton, HydrologyStats};
pub use terrain::Terrain;
pub use terrain_maps::TerrainMaps;
