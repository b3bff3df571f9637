//! The shell of air.

use super::shaders::ATMOSPHERE;
use super::sun::sun;
use crate::overlay::Overlay;
use crate::render::globe::Globe;
use bevy::mesh::MeshVertexBufferLayoutRef;
use bevy::pbr::{Material, MaterialPipeline, MaterialPipelineKey};
use bevy::prelude::*;
use bevy::render::render_resource::{
    AsBindGroup, RenderPipelineDescriptor, ShaderType, SpecializedMeshPipelineError,
};
use bevy::shader::ShaderRef;

/// Scale height of the drawn air in planet radii, five times the Earth's so that it is seen.
const AIR_HEIGHT: f32 = 0.0065;
/// Radius of the shell of air in planet radii.
const AIR_TOP: f32 = 1.07;
/// Factor on the strength of the air above colours that stand for data, which it must not hide.
const VEIL_OF_DATA: f32 = 0.45;

/// `Air` of `atmosphere.wgsl`.
#[derive(Clone, Debug, PartialEq, ShaderType)]
pub(in crate::render) struct AirUniform {
    sun: Vec4,
    top: f32,
    strength: f32,
    pad: Vec2,
}

impl AirUniform {
    pub(in crate::render) fn new(globe: &Globe) -> Self {
        let strength = if globe.air.is_finite() {
            globe.air.clamp(0.0, 1.0)
        } else {
            0.0
        };
        // Data stays readable under a thin veil.
        let veil = match globe.overlay {
            Overlay::Elevation => 1.0,
            _ => VEIL_OF_DATA,
        };
        Self {
            sun: sun(globe).extend(AIR_HEIGHT),
            top: AIR_TOP,
            strength: veil * strength,
            pad: Vec2::ZERO,
        }
    }
}

/// The shell of air.
#[derive(Asset, AsBindGroup, Clone, TypePath)]
pub(in crate::render) struct AirMaterial {
    #[uniform(0)]
    pub(in crate::render) uniform: AirUniform,
}

impl Material for AirMaterial {
    fn vertex_shader() -> ShaderRef {
        ATMOSPHERE.into()
    }

    fn fragment_shader() -> ShaderRef {
        ATMOSPHERE.into()
    }

    fn alpha_mode(&self) -> AlphaMode {
        AlphaMode::Premultiplied
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
        let attributes = [Mesh::ATTRIBUTE_POSITION.at_shader_location(0)];
        descriptor.vertex.buffers = vec![layout.0.get_layout(&attributes)?];
        descriptor.primitive.cull_mode = None;
        Ok(())
    }
}
