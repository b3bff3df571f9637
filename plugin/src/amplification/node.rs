//! Runs of the passes, before any camera draws.

use super::extract::SeenGround;
use super::gpu::GroundGpu;
use bevy::prelude::*;
use bevy::render::renderer::{RenderContext, RenderQueue};

/// Grows the ground of every camera whose view has changed since its last run.
pub(super) fn run(
    seen: Query<&SeenGround>,
    queue: Res<RenderQueue>,
    mut gpu: ResMut<GroundGpu>,
    mut context: RenderContext,
) {
    for ground in &seen {
        let Some(held) = gpu.cameras.get_mut(&ground.camera) else {
            continue;
        };
        let wanted = (ground.view, ground.rules);
        if held.grown == Some(wanted) {
            continue;
        }
        let levels = held.run.set(&queue, &ground.view, &ground.rules);
        let encoder = context.command_encoder();
        if !held.is_carved {
            held.run.carve_base(encoder);
            held.is_carved = true;
        }
        held.run.start(encoder);
        held.run.levels(encoder, 0..=levels - 1);
        held.grown = Some(wanted);
        held.runs += 1;
    }
}
