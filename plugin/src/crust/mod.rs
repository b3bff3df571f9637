//! What a sample of the lattice holds, and how crust floats and is accounted for.
//!
//! In: a [`SphereMesh`](crate::sphere::SphereMesh). Out: columns that every process reads and
//! writes.

pub mod columns;

pub mod isostasy;

pub mod frame;

pub mod surface;

pub mod ledger;

pub use crate::ids::FrameId;
pub use columns::{Crust, CrustKind, Orogeny};
pub use frame::{Frame, Frames};
pub use ledger::{Cause, Ledger};
pub use surface::{Cover, PlanetSurface, Surface};
