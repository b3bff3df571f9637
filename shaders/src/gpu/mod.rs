//! The ground of a view on a GPU: the passes of [`amplify`](crate::amplify) as compute shaders.
//!
//! ```text
//! error      what a device lacks
//! pipelines  one pipeline a pass, made once a device
//! base       the rows of a control mesh
//! sizes      how large its buffers are
//! buffers    the columns of one ground
//! bindings   which columns a pass binds on a level
//! run        a run over all levels, recorded into a command encoder
//! camera     who sees it
//! draw       its triangles and its water, as lit surfaces
//! ```
//!
//! In: a control mesh as [`Base`](crate::amplify::base::Base), a view, the rules. Out: buffers of
//! vertices, what the view shows of them, and triangles, all on the GPU. Its bits are those of
//! [`refine`](crate::amplify::ground::refine).
//!
//! Policies:
//! - The limits of every WebGPU device are enough.
//! - Nothing is read back to drive a run: the passes count the groups of the passes after them.
//! - Where a level would not fit the buffers it is not split: the ground is coarser there and stays
//!   whole. [`GroundRun::sizes`] tells so afterwards.
//! - The crate opens no device. Whoever does hands it over: [`wgpu`], which is exported here.

mod base;
mod bindings;
mod buffers;
mod camera;
mod draw;
mod error;
mod pipelines;
mod run;
mod sizes;

pub use base::BaseRows;
pub use buffers::{GroundBuffers, GroundCaps};
pub use camera::{GroundCamera, GroundColours};
pub use draw::{GroundDrawing, GroundPainter, GroundTarget};
pub use error::GpuError;
pub use pipelines::GroundPipelines;
pub use run::{GroundRun, LEVEL_DISPATCHES};
pub use wgpu;
