//! The crust at the samples of the lattice, how it floats, and the account of it.
//!
//! In: a [`SphereMesh`](crate::sphere::SphereMesh). Out: columns that every process reads and
//! writes.

mod kinds;

mod value;

pub mod columns;

pub mod isostasy;

pub mod frame;

pub mod surface;

pub mod ledger;

pub use crate::ids::FrameId;
pub use columns::{ColumnInfo, Crust, CrustChunk, CrustRow};
pub use frame::{Frame, Frames};
pub use kinds::{CrustKind, Orogeny};
pub use ledger::{Cause, Ledger};
pub use surface::{Cover, PlanetSurface, Surface};
pub use value::{ColumnError, ColumnValue, decode_column, encode_column};
