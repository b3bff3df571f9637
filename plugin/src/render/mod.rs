//! The globe: a planet drawn from orbit.
//!
//! ```text
//! painter    watches Surface and Globe, paints off the main thread, hands the result over
//! parts      the entities that draw a globe
//! columns    what is uploaded per sample: relief, gradient, colour, coast
//! mesh       triangles in patches, triangle edges and the shell of air, built once per lattice
//! horizon    which patches of ground no camera can see
//! lines      plate boundaries and arrows
//! material   the passes of pangaea_shaders::globe as materials
//! picking    what a ray hits
//! adapter    whether there is a GPU to draw with
//! ```
//!
//! In: [`Surface`](crate::crust::Surface) and [`Globe`]. Out: child entities of the planet that
//! Bevy draws.
//!
//! Policies:
//! - The planet's entity may be moved, turned and scaled evenly like any other; one unit is one
//!   planet radius.
//! - The planet's axis (+z) is Bevy's +y: [`to_bevy`] and [`from_bevy`] convert.
//! - Painting runs on [`AsyncComputeTaskPool`](bevy::tasks::AsyncComputeTaskPool), one picture at a
//!   time; a
//!   picture that is out of date when it is ready is shown and the next one begun.
//! - The picture hides the lattice: relief is drawn a little smoothed, coasts ragged below the
//!   spacing of samples.
//!   Numbers are never read from the picture; ask [`Surface`](crate::crust::Surface).
//! - The light is the globe's own ([`Globe::sun`]); lights of the scene do not touch it.

pub mod adapter;

mod columns;

mod horizon;

mod lines;

mod material;

mod mesh;

mod painter;

mod parts;

pub mod picking;

pub use painter::GlobeDrawn;
pub use picking::{GlobePicker, GlobeRay, Hit};

use crate::overlay::Overlay;
use crate::plate::PlateId;
use bevy::math::DVec3;
use bevy::pbr::PbrPlugin;
use bevy::prelude::*;

/// How a planet is drawn. On the planet's entity; [`PangaeaRenderPlugin`] gives one to planets that
/// have none.
#[derive(Component, Clone, Debug, PartialEq, Reflect)]
#[reflect(Component)]
#[require(Transform, Visibility)]
pub struct Globe {
    /// What the colours show.
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
    /// Strength of the air, 0..=1; 0 for none.
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

    /// Planet radii per km of elevation; values out of range or not a number are tamed.
    fn relief(&self, radius: f64) -> f32 {
        let factor = self.exaggeration.clamp(0.0, Self::MAX_EXAGGERATION);
        if factor.is_finite() {
            (f64::from(factor) / radius) as f32
        } else {
            0.0
        }
    }

    /// Distance from the centre of a point at `elevation` km, in planet radii. The vertex shader
    /// does the same.
    fn drawn_radius(&self, elevation: f32, relief: f32) -> f32 {
        1.0 + relief
            * if self.sea {
                elevation.max(0.0)
            } else {
                elevation
            }
    }
}

/// A planet direction or position in Bevy's axes: (x, y, z) becomes (x, z, -y).
#[inline]
pub fn to_bevy(v: DVec3) -> Vec3 {
    Vec3::new(v.x as f32, v.z as f32, -v.y as f32)
}

/// The inverse of [`to_bevy`].
#[inline]
pub fn from_bevy(v: Vec3) -> DVec3 {
    DVec3::new(f64::from(v.x), -f64::from(v.z), f64::from(v.y))
}

/// Draws planets as globes. Add it after Bevy's `PbrPlugin` (`DefaultPlugins`).
///
/// Without that plugin it does nothing: an app with no renderer pays nothing.
pub struct PangaeaRenderPlugin;

impl Plugin for PangaeaRenderPlugin {
    fn build(&self, app: &mut App) {
        app.register_type::<Globe>();
        if app.is_plugin_added::<PbrPlugin>() {
            app.add_plugins((material::GlobeMaterialPlugin, painter::PainterPlugin));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_right_handed_and_invertible() {
        let v = DVec3::new(0.25, -0.5, 0.75);
        assert_eq!(from_bevy(to_bevy(v)), v);
        assert_eq!(to_bevy(DVec3::Z), Vec3::Y);
        let x_cross_y = to_bevy(DVec3::X).cross(to_bevy(DVec3::Y));
        assert_eq!(x_cross_y, to_bevy(DVec3::Z));
    }

    #[test]
    fn absurd_exaggerations_are_tamed() {
        let relief = |exaggeration| {
            Globe {
                exaggeration,
                ..default()
            }
            .relief(1000.0)
        };
        assert_eq!(relief(f32::NAN), 0.0);
        assert_eq!(relief(-3.0), 0.0);
        assert_eq!(relief(f32::INFINITY), 0.2);
    }
}
