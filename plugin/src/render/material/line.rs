//! Lines of constant width.

use super::shaders::LINE;
use crate::render::globe::Globe;
use crate::render::lines;
use bevy::mesh::MeshVertexBufferLayoutRef;
use bevy::pbr::{Material, MaterialPipeline, MaterialPipelineKey};
use bevy::prelude::*;
use bevy::render::render_resource::{
    AsBindGroup, RenderPipelineDescriptor, ShaderType, SpecializedMeshPipelineError,
};
use bevy::shader::ShaderRef;

/// How much nearer lines are drawn than they are, as a share of their distance.
const LINE_LIFT: f32 = 0.006;

/// `Line` of `line.wgsl`.
#[derive(Clone, Debug, PartialEq, ShaderType)]
pub(in crate::render) struct LineUniform {
    relief: f32,
    lift: f32,
    pad: Vec2,
}

impl LineUniform {
    pub(in crate::render) fn new(globe: &Globe, radius: f64) -> Self {
        Self {
            relief: globe.relief(radius),
            lift: LINE_LIFT,
            pad: Vec2::ZERO,
        }
    }
}

/// Lines of constant width.
#[derive(Asset, AsBindGroup, Clone, TypePath)]
pub(in crate::render) struct LineMaterial {
    #[uniform(0)]
    pub(in crate::render) uniform: LineUniform,
}

impl Material for LineMaterial {
    fn vertex_shader() -> ShaderRef {
        LINE.into()
    }

    fn fragment_shader() -> ShaderRef {
        LINE.into()
    }

    fn enable_prepass() -> bool {
        false
    }

    fn enable_shadows() -> bool {
        false
    }

    fn specialize(
        _: &MaterialPipeline,
        descriptor: &mut RenderPipelineDescriptor,
        layout: &MeshVertexBufferLayoutRef,
        _: MaterialPipelineKey<Self>,
    ) -> Result<(), SpecializedMeshPipelineError> {
        let attributes = [
            Mesh::ATTRIBUTE_POSITION.at_shader_location(0),
            lines::OTHER.at_shader_location(1),
            lines::HEIGHTS.at_shader_location(2),
            lines::SIDE.at_shader_location(3),
            lines::COLOR.at_shader_location(4),
        ];
        descriptor.vertex.buffers = vec![layout.0.get_layout(&attributes)?];
        descriptor.primitive.cull_mode = None;
        Ok(())
    }
}
