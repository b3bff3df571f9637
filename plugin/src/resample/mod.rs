//! Back to even sampling: the surface of the moment becomes the new state (paper 000 §4.3, §6).
//!
//! | file | what it does |
//! |---|---|
//! | `project` | finds the crust that covers every sample, by `blend` |
//! | `gap`, [`ridge`] | fills samples that nothing covers; new ocean floor between parting plates |
//! | `conservation` | brings continents to the area and volume that the ledger expects |
//! | `exclaves` | gives small pieces of plates to the plate around them |
//! | `trench` | bends crust that goes under |
//! | `work` | does all of this in time slices, and makes the result the state |
//! | `stage` | decides when it is due |
//!
//! Projection, gaps and trenches are also how a planet is looked at between two resamples
//! ([`Surface`](crate::crust::Surface)), so that pictures just before and after a resample agree.

mod input;

mod blend;

mod project;

pub mod ridge;

mod gap;

mod conservation;

mod exclaves;

mod trench;

mod work;

mod stage;

pub use stage::{ResamplePlugin, SurfaceProjection, due, interval, project_now};
pub use work::Resampling;
