//! The amplified ground, grown and drawn on the GPU for cameras.
//!
//! ```text
//! view      a camera that sees the ground
//! rows      the control mesh as the GPU wants it, made in the background
//! frame     where a camera stands in the planet's axes, and what it sees
//! extract   all that into the render world
//! gpu       pipelines, and the buffers of every camera
//! node      runs of the passes, before any camera draws
//! draw      the ground in a camera's main pass
//! ```
//!
//! In: [`PlanetBake`](crate::control::PlanetBake), and cameras with a [`GroundView`]. Out: what the
//! camera draws. The simulation goes on meanwhile: each new bake replaces the ground.
//!
//! Policies:
//! - A run has the bits of [`PlanetGround`](crate::query::PlanetGround): what is seen is what
//!   queries and colliders answer.
//! - A camera that stands still costs no pass.
//! - Where the GPU cannot do it, [`GroundStatus`] says why, and the globe is drawn as before.

mod draw;
mod extract;
mod frame;
mod gpu;
mod node;
mod rows;
mod view;

pub use pangaea_shaders::gpu::GroundColours;
pub use view::{GroundStatus, GroundView};

use bevy::core_pipeline::Core3d;
use bevy::core_pipeline::core_3d::main_opaque_pass_3d;
use bevy::core_pipeline::schedule::{Core3dSystems, camera_driver};
use bevy::pbr::PbrPlugin;
use bevy::prelude::*;
use bevy::render::renderer::RenderGraph;
use bevy::render::{ExtractSchedule, Render, RenderApp, RenderStartup, RenderSystems};

/// Grows and draws the ground for cameras with a [`GroundView`]. Add it after Bevy's `PbrPlugin`
/// (`DefaultPlugins`).
///
/// ```
/// use bevy::prelude::*;
/// use bevy_pangaea::amplification::{GroundView, PangaeaGroundPlugin};
/// use bevy_pangaea::prelude::*;
///
/// fn look(mut commands: Commands, planet: Single<Entity, With<Planet>>) {
///     // Two metres over the sea on the planet's equator, looking north.
///     let place = Vec3::X * (1.0 + 2.0 / 6_370_000.0);
///     let camera = Transform::from_translation(place).looking_to(Vec3::Y, Vec3::X);
///     commands.spawn((Camera3d::default(), camera, GroundView::of(*planet)));
/// }
///
/// App::new().add_plugins(PangaeaGroundPlugin).add_systems(Startup, look);
/// ```
///
/// Without Bevy's plugin it does nothing: an app with no renderer pays nothing.
pub struct PangaeaGroundPlugin;

impl Plugin for PangaeaGroundPlugin {
    fn build(&self, app: &mut App) {
        app.register_type::<GroundView>()
            .register_type::<GroundStatus>();
        if !app.is_plugin_added::<PbrPlugin>() {
            return;
        }
        app.add_systems(Last, (rows::collect, rows::start, view::report).chain());
        let reports = view::Reports::default();
        app.insert_resource(reports.clone());
        let Some(render) = app.get_sub_app_mut(RenderApp) else {
            return;
        };
        render
            .insert_resource(reports)
            .init_resource::<gpu::GroundGpu>()
            .add_systems(ExtractSchedule, extract::extract)
            .add_systems(RenderStartup, gpu::compile)
            .add_systems(Render, gpu::prepare.in_set(RenderSystems::PrepareResources))
            .add_systems(RenderGraph, node::run.before(camera_driver))
            .add_systems(
                Core3d,
                draw::draw
                    .in_set(Core3dSystems::MainPass)
                    .before(main_opaque_pass_3d),
            );
    }
}
