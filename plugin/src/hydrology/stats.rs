//! s
/// s
pub struct HydrologyStats;
