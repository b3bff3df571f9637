//! The ground in a camera's main pass.

use super::extract::SeenGround;
use super::gpu::{CameraGround, GroundGpu};
use super::view::{GroundStatus, Reports};
use bevy::core_pipeline::core_3d::CORE_3D_DEPTH_FORMAT;
use bevy::prelude::*;
use bevy::render::camera::ExtractedCamera;
use bevy::render::render_resource::{RenderPassDescriptor, StoreOp};
use bevy::render::renderer::{RenderContext, RenderDevice, RenderQueue, ViewQuery};
use bevy::render::view::{Msaa, ViewDepthTexture, ViewTarget};
use pangaea_shaders::gpu::wgpu::RenderPass;
use pangaea_shaders::gpu::{GroundDrawing, GroundPainter, GroundTarget};

type Drawn<'a> = (
    &'a SeenGround,
    &'a ExtractedCamera,
    &'a ViewTarget,
    &'a ViewDepthTexture,
    &'a Msaa,
);

/// Draws the ground of a camera that has one.
pub(super) fn draw(
    view: ViewQuery<Drawn>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
    reports: Res<Reports>,
    mut gpu: ResMut<GroundGpu>,
    mut context: RenderContext,
) {
    let (ground, camera, target, depth, msaa) = view.into_inner();
    let into = GroundTarget {
        colour: target.main_texture_format(),
        depth: CORE_3D_DEPTH_FORMAT,
        samples: msaa.samples(),
    };
    let Some((painter, held)) = gpu.drawable(&device, ground.camera, into) else {
        return;
    };
    let drawing = held.drawing_for(into, &painter, &device, &queue);
    drawing.look(&queue, &ground.looks);
    let encoder = context.command_encoder();
    drawing.finish(encoder, &held.run, ground.view.level + 1);
    let colours = [Some(target.get_color_attachment())];
    let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
        label: Some("draw_ground"),
        color_attachments: &colours,
        depth_stencil_attachment: Some(depth.get_attachment(StoreOp::Store)),
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    });
    set_viewport(&mut pass, camera);
    drawing.draw(&mut pass, &painter);
    reports.say(ground.camera, GroundStatus::Drawn(held.runs));
}

/// Draws into the camera's part of its target alone.
fn set_viewport(pass: &mut RenderPass, camera: &ExtractedCamera) {
    let Some(viewport) = &camera.viewport else {
        return;
    };
    let (at, size) = (viewport.physical_position, viewport.physical_size);
    let [x, y, w, h] = [at.x, at.y, size.x, size.y].map(|pixels| pixels as f32);
    pass.set_viewport(x, y, w, h, viewport.depth.start, viewport.depth.end);
}

impl GroundGpu {
    /// The pipelines for a target and the ground of a camera; `None` before its first run.
    fn drawable(
        &mut self,
        device: &RenderDevice,
        camera: Entity,
        into: GroundTarget,
    ) -> Option<(GroundPainter, &mut CameraGround)> {
        let held = self.cameras.get_mut(&camera)?;
        held.grown.as_ref()?;
        let painter = self.painters.entry(into);
        let make = || GroundPainter::new(device.wgpu_device(), into);
        Some((painter.or_insert_with(make).clone(), held))
    }
}

impl CameraGround {
    /// The drawing of its ground into a kind of target.
    fn drawing_for(
        &mut self,
        into: GroundTarget,
        painter: &GroundPainter,
        device: &RenderDevice,
        queue: &RenderQueue,
    ) -> GroundDrawing {
        if let Some((target, drawing)) = &self.drawing
            && *target == into
        {
            return drawing.clone();
        }
        let drawing = GroundDrawing::new(device.wgpu_device(), queue, painter, &self.run);
        self.drawing = Some((into, drawing.clone()));
        drawing
    }
}
