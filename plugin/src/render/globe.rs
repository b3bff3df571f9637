//! How a planet is drawn.

use crate::overlay::Overlay;
use crate::plate::PlateId;
use bevy::math::DVec3;
use bevy::prelude::*;
use serde::{Deserialize, Serialize};

/// How a planet is drawn. On the planet's entity; [`PangaeaRenderPlugin`] makes it a required
/// component of planets, so one that is spawned without it has the default.
///
/// Without the component, or once it is removed, the planet is not drawn.
///
/// [`PangaeaRenderPlugin`]: super::PangaeaRenderPlugin
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// use bevy_pangaea::overlay::Overlay;
///
/// fn setup(mut commands: Commands) {
///     let globe = Globe { overlay: Overlay::Plates, boundaries: true, ..default() };
///     commands.spawn((PlanetRecipe::default(), globe));
/// }
/// # bevy::ecs::system::assert_is_system(setup);
/// ```
#[derive(Component, Clone, Debug, PartialEq, Reflect, Serialize, Deserialize)]
#[reflect(Component, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[require(Transform, Visibility)]
pub struct Globe {
    /// The quantity that the colours show.
    pub overlay: Overlay,
    /// Factor on elevations, 0..=200; 1 is true to scale.
    pub exaggeration: f32,
    /// Whether the ocean is filled; if not, its floor is seen.
    pub sea: bool,
    /// Whether plate boundaries are drawn, coloured by kind.
    pub boundaries: bool,
    /// Whether the triangles' edges are drawn.
    pub wireframe: bool,
    /// Unit direction to the sun in planet coordinates.
    pub sun: DVec3,
    /// Strength of the air, 0..=1; 0 draws no air.
    pub air: f32,
    /// A plate that stands out: lighter, in a white outline.
    pub selected: Option<PlateId>,
}

impl Default for Globe {
    fn default() -> Self {
        Self {
            overlay: Overlay::Elevation,
            exaggeration: 15.0,
            sea: true,
            boundaries: false,
            wireframe: false,
            sun: DVec3::new(0.55, -0.75, 0.37).normalize(),
            air: 1.0,
            selected: None,
        }
    }
}

impl Globe {
    /// Largest exaggeration of the relief.
    pub const MAX_EXAGGERATION: f32 = 200.0;

    /// Planet radii per km of elevation on a planet of `radius` km; an exaggeration out of its
    /// limits is clamped, one that is NaN counts as 0.
    pub(super) fn relief(&self, radius: f64) -> f32 {
        let factor = self.exaggeration.clamp(0.0, Self::MAX_EXAGGERATION);
        if factor.is_finite() {
            (f64::from(factor) / radius) as f32
        } else {
            0.0
        }
    }

    /// Elevation in km at which ground is drawn: the sea hides what lies below it.
    pub(super) fn drawn_elevation(&self, elevation: f32) -> f32 {
        if self.sea {
            elevation.max(0.0)
        } else {
            elevation
        }
    }

    /// Distance from the centre of a point at `elevation` km, in planet radii. The vertex shader
    /// does the same.
    pub(super) fn drawn_radius(&self, elevation: f32, relief: f32) -> f32 {
        1.0 + relief * self.drawn_elevation(elevation)
    }

    /// Whether the edges of triangles are drawn.
    pub(super) fn shows_edges(&self) -> bool {
        self.wireframe || self.overlay == Overlay::Mesh
    }
}

/// The surface and overlay that a globe shows at the moment; changes when a new build is uploaded.
/// On the planet's entity.
#[derive(Component, Clone, Debug, PartialEq, Reflect)]
#[reflect(Component)]
pub struct GlobeDrawn {
    /// [`Surface::version`](crate::crust::Surface::version) that is drawn.
    pub version: u64,
    /// The overlay that is drawn.
    pub overlay: Overlay,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn absurd_exaggerations_are_tamed() {
        for (exaggeration, expected) in [(f32::NAN, 0.0), (-3.0, 0.0), (f32::INFINITY, 0.2)] {
            let globe = Globe {
                exaggeration,
                ..default()
            };
            assert_eq!(globe.relief(1000.0), expected);
        }
    }
}
