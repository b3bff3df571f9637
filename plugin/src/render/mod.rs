//! The globe: a planet drawn from orbit.
//!
//! ```text
//! axes           from a planet's axes to Bevy's
//! globe          how a planet is drawn
//! cap            spherical caps around patches, and the horizon
//! mesh           triangles in patches, triangle edges and the shell of air, once per lattice
//! relief         the relief as it is drawn
//! sample_buffer  the buffer of samples that shaders read
//! lines          plate boundaries, arrows, axes, rivers
//! picking        where a ray meets a globe
//! build          all of these, from a planet
//! task           builds on other threads
//! material       the passes of pangaea_shaders::globe as materials
//! assets         the assets of globes
//! parts          the entities that draw a globe
//! shading        changes that need no build
//! horizon        which patches of ground no camera sees
//! adapter        whether there is a GPU to draw with
//! ```
//!
//! In: [`Surface`](crate::crust::Surface) and [`Globe`]. Out: child entities of the planet that
//! Bevy draws.
//!
//! Policies:
//! - The planet's entity may be moved, turned and scaled evenly like any other; one unit is one
//!   planet radius.
//! - The planet's axis (+z) is Bevy's +y: [`to_bevy`] and [`from_bevy`] convert.
//! - Builds run on a thread of their own, one at a time per planet; a build that is out of date when
//!   it is ready is shown and the next one begun. The main thread only hands over the surface and
//!   takes finished buffers.
//! - The globe hides the lattice: relief is drawn a little smoothed, coasts ragged below the
//!   spacing of samples. Numbers are never read from the globe; ask
//!   [`Surface`](crate::crust::Surface).
//! - The light is the globe's own ([`Globe::sun`]); lights of the scene do not touch it.
//! - Meshes, materials and children go when the planet is despawned or its [`Globe`] is removed.

mod axes;

mod globe;

mod cap;

mod mesh;

mod relief;

mod sample_buffer;

mod lines;

mod picking;

mod build;

mod task;

mod material;

mod assets;

mod parts;

mod shading;

mod horizon;

pub mod adapter;

pub use axes::{from_bevy, to_bevy};
pub use globe::{Globe, GlobeDrawn};
pub use picking::{GlobeHit, GlobePicker, GlobeRay};

use crate::planet::Planet;
use bevy::asset::AssetEventSystems;
use bevy::ecs::component::RequiredComponentsError;
use bevy::pbr::PbrPlugin;
use bevy::prelude::*;

/// Draws planets as globes. Add it after Bevy's `PbrPlugin` (`DefaultPlugins`) and before the first
/// planet is spawned.
///
/// It makes [`Globe`] a required component of [`Planet`]. A game whose planets look different by
/// default says so before it adds the plugin:
///
/// ```
/// use bevy::prelude::*;
/// use bevy_pangaea::prelude::*;
/// use bevy_pangaea::render::{Globe, PangaeaRenderPlugin};
///
/// let mut app = App::new();
/// app.register_required_components_with::<Planet, Globe>(|| Globe { air: 0.0, ..default() });
/// app.add_plugins(PangaeaRenderPlugin);
/// ```
///
/// Without Bevy's plugin it does nothing: an app with no renderer pays nothing.
pub struct PangaeaRenderPlugin;

impl Plugin for PangaeaRenderPlugin {
    fn build(&self, app: &mut App) {
        app.register_type::<Globe>().register_type::<GlobeDrawn>();
        if app.is_plugin_added::<PbrPlugin>() {
            app.add_plugins((material::GlobeMaterialPlugin, GlobePlugin));
        }
    }
}

/// The systems of globes, which need assets but no renderer.
struct GlobePlugin;

#[derive(SystemSet, Clone, Debug, PartialEq, Eq, Hash)]
struct GlobeSystems;

impl Plugin for GlobePlugin {
    fn build(&self, app: &mut App) {
        require_globe(app);
        app.init_resource::<parts::AirShell>()
            .add_observer(parts::start_globe)
            .add_observer(parts::remove_globe)
            .configure_sets(PostUpdate, GlobeSystems.before(AssetEventSystems))
            .add_systems(
                PostUpdate,
                (
                    task::receive_builds,
                    parts::spawn_parts,
                    parts::upload_builds,
                    shading::spawn_edges,
                    shading::update_materials,
                    shading::update_visibility,
                    horizon::hide_far_side,
                    task::queue_builds,
                )
                    .chain()
                    .in_set(GlobeSystems),
            );
    }
}

/// Gives every planet a globe, unless the app has already said which.
fn require_globe(app: &mut App) {
    match app.try_register_required_components::<Planet, Globe>() {
        Ok(()) | Err(RequiredComponentsError::DuplicateRegistration(..)) => {}
        Err(error) => error!("planets get no globe by themselves: {error}"),
    }
}
