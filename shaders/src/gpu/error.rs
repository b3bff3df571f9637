//! Devices that cannot run the passes.

use thiserror::Error;

/// Why a device cannot run the passes.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum GpuError {
    /// A limit is below that of every WebGPU device, or below what the ground needs.
    #[error("the GPU has {found} for {name}, the ground needs {needed}")]
    Limit {
        /// Name of the limit, as WebGPU has it.
        name: &'static str,
        /// That of the device.
        found: u64,
        /// That which is needed.
        needed: u64,
    },
}
