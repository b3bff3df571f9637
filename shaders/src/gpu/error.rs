//! What a device lacks.

use thiserror::Error;

/// Why a device cannot run the passes.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum GpuError {
    /// A limit is below that of every WebGPU device, or below what the ground needs.
    #[error("the GPU has {found} for {name}, the ground needs {needed}")]
    Limit {
        /// Name of the limit, as WebGPU has it.
        name: &'static str,
        /// What the device has.
        found: u64,
        /// What is needed.
        needed: u64,
    },
    /// A shader or a pipeline was refused.
    #[error("the pass {pass} does not compile: {reason}")]
    Shader {
        /// Entry point.
        pass: &'static str,
        /// What the compiler says.
        reason: String,
    },
    /// The GPU has no memory left.
    #[error("the GPU has no memory for {bytes} bytes of ground")]
    Memory {
        /// Bytes that were asked for.
        bytes: u64,
    },
}
