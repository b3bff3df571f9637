//! A colour for every sample.

use super::palette::Rgba;
use super::quantity::field_of;
use super::{Overlay, OverlayInput};
use crate::parallel;

/// Colours of all samples under `overlay`, in sRGB; empty if nothing was projected yet.
pub fn colorize(overlay: Overlay, input: &OverlayInput) -> Vec<Rgba> {
    if input.surface.len() != input.mesh.len() {
        return Vec::new();
    }
    let field = field_of(overlay, input);
    parallel::map(input.mesh.len(), |i| {
        field.at_sample(i, &input.surface.crust.kind)
    })
}
