//! The ground that lines lie on.

use super::list::LineEnd;
use crate::overlay::OverlayInput;
use crate::render::globe::Globe;
use bevy::math::DVec3;

/// The ground as a globe draws it.
pub(super) struct LineGround<'a> {
    /// The planet.
    pub(super) input: &'a OverlayInput<'a>,
    /// The globe.
    pub(super) globe: &'a Globe,
    /// Elevation in km at which a sample is drawn, the sea apart.
    pub(super) elevation: &'a dyn Fn(usize) -> f32,
}

impl LineGround<'_> {
    /// Elevation in km of lines at sample `i`: that of the sea where it hides the ground.
    pub(super) fn height(&self, i: u32) -> f32 {
        self.globe.drawn_elevation((self.elevation)(i as usize))
    }

    /// The end of a line at a direction, between samples.
    pub(super) fn end(&self, direction: DVec3) -> LineEnd {
        let place = self.input.mesh.locate(direction);
        LineEnd {
            direction,
            elevation: place.interpolate(|k| f64::from(self.height(k))) as f32,
        }
    }
}
