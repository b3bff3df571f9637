//! Ground and sea, or the edges of triangles.

use super::shaders::SURFACE;
use super::sun::sun;
use crate::overlay::Overlay;
use crate::overlay::palette::HYPSOMETRIC;
use crate::render::globe::Globe;
use crate::render::mesh;
use bevy::mesh::MeshVertexBufferLayoutRef;
use bevy::pbr::{Material, MaterialPipeline, MaterialPipelineKey};
use bevy::prelude::*;
use bevy::render::render_resource::{
    AsBindGroup, RenderPipelineDescriptor, ShaderType, SpecializedMeshPipelineError,
};
use bevy::render::storage::ShaderBuffer;
use bevy::shader::ShaderRef;

/// Most stops of the tint that the surface pass takes.
const MAX_STOPS: usize = 24;

/// Share of light that remains at night.
const NIGHT: f32 = 0.035;

/// Share of light that remains at night on colours that stand for data, which must be read there,
/// too.
const NIGHT_OF_DATA: f32 = 0.3;

/// Colour of the edges of triangles.
const WIRE: [u8; 3] = [12, 14, 18];

/// Bit of [`GroundUniform::flags`]: the ocean is filled.
const SEA: u32 = 1;
/// Bit of [`GroundUniform::flags`]: the shader tints elevations itself.
const TINT: u32 = 2;

/// Bit of [`GroundUniform::flags`]: the shader draws the coast.
const COAST: u32 = 4;

/// `Globe` of `surface.wgsl`.
#[derive(Clone, Debug, PartialEq, ShaderType)]
pub(in crate::render) struct GroundUniform {
    sun: Vec4,
    relief: f32,
    flags: u32,
    stops: u32,
    spacing: f32,
    tint: [Vec4; MAX_STOPS],
    wire: Vec4,
}

impl GroundUniform {
    /// The uniform of a globe of `radius` km whose samples are `spacing` radians apart.
    pub(in crate::render) fn new(globe: &Globe, radius: f64, spacing: f64) -> Self {
        let tinted = globe.overlay == Overlay::Elevation;
        // Stops of the ramp that the shader mixes itself: colour, and elevation in the fourth
        // place.
        let mut tint = [Vec4::ZERO; MAX_STOPS];
        for (slot, &(elevation, color)) in tint.iter_mut().zip(HYPSOMETRIC.0) {
            *slot = linear(color).extend(elevation);
        }
        let night = if tinted { NIGHT } else { NIGHT_OF_DATA };
        Self {
            sun: sun(globe).extend(night),
            relief: globe.relief(radius),
            flags: flags(globe.sea, tinted),
            stops: HYPSOMETRIC.0.len().min(MAX_STOPS) as u32,
            spacing: spacing as f32,
            tint,
            wire: linear(WIRE).extend(1.0),
        }
    }
}

/// Elevations are tinted by the shader; on other colours it draws the coast.
fn flags(sea: bool, tinted: bool) -> u32 {
    let colors = if tinted { TINT } else { COAST };
    if sea { colors | SEA } else { colors }
}

/// An opaque colour of sRGB in the linear space of shaders.
fn linear([r, g, b]: [u8; 3]) -> Vec3 {
    let color = LinearRgba::from(Srgba::rgb_u8(r, g, b));
    Vec3::new(color.red, color.green, color.blue)
}

/// Ground and sea, or the edges of triangles.
#[derive(Asset, AsBindGroup, Clone, TypePath)]
#[bind_group_data(GroundKey)]
pub(in crate::render) struct GroundMaterial {
    #[uniform(0)]
    pub(in crate::render) uniform: GroundUniform,
    #[storage(1, read_only, visibility(vertex))]
    pub(in crate::render) samples: Handle<ShaderBuffer>,
    pub(in crate::render) wire: bool,
}

/// The part of a material that needs a pipeline of its own.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::render) struct GroundKey {
    wire: bool,
}

impl From<&GroundMaterial> for GroundKey {
    fn from(material: &GroundMaterial) -> Self {
        Self {
            wire: material.wire,
        }
    }
}

impl Material for GroundMaterial {
    fn vertex_shader() -> ShaderRef {
        SURFACE.into()
    }

    fn fragment_shader() -> ShaderRef {
        SURFACE.into()
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
        key: MaterialPipelineKey<Self>,
    ) -> Result<(), SpecializedMeshPipelineError> {
        let attributes = [
            Mesh::ATTRIBUTE_POSITION.at_shader_location(0),
            mesh::SAMPLE.at_shader_location(1),
        ];
        descriptor.vertex.buffers = vec![layout.0.get_layout(&attributes)?];
        if key.bind_group_data.wire {
            descriptor.vertex.shader_defs.push("WIREFRAME".into());
            if let Some(fragment) = &mut descriptor.fragment {
                fragment.shader_defs.push("WIREFRAME".into());
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tint_fits_the_uniform() {
        assert!(HYPSOMETRIC.0.len() <= MAX_STOPS);
        let uniform = GroundUniform::new(&Globe::default(), 6370.0, 0.01);
        let used = &uniform.tint[..uniform.stops as usize];
        assert!(used.windows(2).all(|pair| pair[0].w <= pair[1].w));
    }
}
