//! The light of a globe.

use crate::render::axes::to_bevy;
use crate::render::globe::Globe;
use bevy::prelude::*;

/// Unit direction to the sun in the globe's axes; a sun without a direction stands over 0° N 0° E.
pub(super) fn sun(globe: &Globe) -> Vec3 {
    to_bevy(globe.sun).try_normalize().unwrap_or(Vec3::X)
}
