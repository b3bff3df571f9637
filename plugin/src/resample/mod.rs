//! Back to even sampling: the surface of the moment becomes the new state (paper 000 §4.3, §6).
//!
//! [`project`] finds what covers every sample of the lattice, [`gap`] makes new crust where nothing
//! does, [`conservation`] keeps the continental area and volume that the ledger expects, [`exclaves`] tidies
//! ownership, [`trench`] bends what subducts. The first, second and last are also how the planet is
//! looked at between two resamples ([`Surface`]), so that pictures just before and after a resample
//! agree.
//!
//! A resample is due after 10 to 60 steps, sooner where plates are fast: `10 v_0 / v_max` steps,
//! the time in which the fastest plate moves as far as a plate at v_0 in ten.

pub mod project;

pub mod gap;

pub mod conservation;

pub mod exclaves;

pub mod trench;

mod stage;

pub use stage::{ResamplePlugin, Resampling, SurfaceProjection, due, interval, project_now};

#[allow(unused_imports, reason = "named in the module's documentation")]
use crate::crust::Surface;
