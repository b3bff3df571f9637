//! The passes of `pangaea_shaders::globe` as materials, and what they are told each frame.

use super::{Globe, lines, mesh, to_bevy};
use crate::overlay::Overlay;
use crate::overlay::palette::HYPSOMETRIC;
use bevy::asset::{Handle, uuid_handle};
use bevy::mesh::MeshVertexBufferLayoutRef;
use bevy::pbr::{Material, MaterialPipeline, MaterialPipelineKey, MaterialPlugin};
use bevy::prelude::*;
use bevy::render::render_resource::{
    AsBindGroup, RenderPipelineDescriptor, ShaderType, SpecializedMeshPipelineError,
};
use bevy::render::storage::ShaderBuffer;
use bevy::shader::{Shader, ShaderRef};
use pangaea_shaders::globe as wgsl;

const LIBRARIES: [Handle<Shader>; 3] = [
    uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a01"),
    uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a02"),
    uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a03"),
];
const SURFACE: Handle<Shader> = uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a11");
const ATMOSPHERE: Handle<Shader> = uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a12");
const LINE: Handle<Shader> = uuid_handle!("3f6c1b5e-52a5-4c0b-9a0c-6c8e4f0d1a13");

/// Most stops of the tint that the surface pass takes.
const STOPS: usize = 24;

/// Scale height of the drawn air in planet radii, five times the Earth's so that it is seen.
const AIR_HEIGHT: f32 = 0.0065;
/// Radius of the shell of air in planet radii.
const AIR_TOP: f32 = 1.07;

/// How much nearer lines are drawn than they are, as a share of their distance.
const LINE_LIFT: f32 = 0.006;

/// Share of light that remains at night: little for the planet itself, more for data that must be
/// read.
const NIGHT: f32 = 0.035;
const NIGHT_OF_DATA: f32 = 0.3;

/// Bits of [`GroundUniform::flags`].
const SEA: u32 = 1;
const TINT: u32 = 2;
const COAST: u32 = 4;

/// Adds shaders and materials.
pub(super) struct GlobeMaterialPlugin;

impl Plugin for GlobeMaterialPlugin {
    fn build(&self, app: &mut App) {
        let mut shaders = app.world_mut().resource_mut::<Assets<Shader>>();
        let passes = [SURFACE, ATMOSPHERE, LINE];
        let handles = LIBRARIES.into_iter().chain(passes);
        for (handle, source) in handles.zip(wgsl::LIBRARIES.into_iter().chain(wgsl::PASSES)) {
            // The handles are constants, never reserved or freed, so the insertion cannot fail.
            let _ = shaders.insert(&handle, Shader::from_wgsl(source.wgsl, source.path));
        }
        app.add_plugins((
            MaterialPlugin::<GroundMaterial>::default(),
            MaterialPlugin::<AirMaterial>::default(),
            MaterialPlugin::<LineMaterial>::default(),
        ));
    }
}

/// `Globe` of `surface.wgsl`.
#[derive(Clone, Debug, PartialEq, ShaderType)]
pub(super) struct GroundUniform {
    sun: Vec4,
    relief: f32,
    flags: u32,
    stops: u32,
    spacing: f32,
    tint: [Vec4; STOPS],
    wire: Vec4,
}

impl GroundUniform {
    pub(super) fn new(globe: &Globe, radius: f64, spacing: f64) -> Self {
        let tinted = globe.overlay == Overlay::Elevation;
        let mut tint = [Vec4::ZERO; STOPS];
        for (slot, &(elevation, [r, g, b])) in tint.iter_mut().zip(HYPSOMETRIC.0) {
            *slot = linear([r, g, b]).extend(elevation);
        }
        let flag = |on, bit| if on { bit } else { 0 };
        Self {
            sun: sun(globe).extend(if tinted { NIGHT } else { NIGHT_OF_DATA }),
            relief: globe.relief(radius),
            flags: flag(globe.sea, SEA) | flag(tinted, TINT) | flag(!tinted, COAST),
            stops: HYPSOMETRIC.0.len().min(STOPS) as u32,
            spacing: spacing as f32,
            tint,
            wire: linear([12, 14, 18]).extend(1.0),
        }
    }
}

fn linear([r, g, b]: [u8; 3]) -> Vec3 {
    let color = LinearRgba::from(Srgba::rgb_u8(r, g, b));
    Vec3::new(color.red, color.green, color.blue)
}

/// Unit direction to the sun in the globe's axes; a sun that is no direction stands over 0° N 0° E.
fn sun(globe: &Globe) -> Vec3 {
    to_bevy(globe.sun).try_normalize().unwrap_or(Vec3::X)
}

/// Ground and sea, or the edges of triangles.
#[derive(Asset, AsBindGroup, Clone, TypePath)]
#[bind_group_data(GroundKey)]
pub(super) struct GroundMaterial {
    #[uniform(0)]
    pub(super) uniform: GroundUniform,
    #[storage(1, read_only, visibility(vertex))]
    pub(super) samples: Handle<ShaderBuffer>,
    pub(super) wire: bool,
}

/// What pipelines of the ground differ in.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct GroundKey {
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

/// `Air` of `atmosphere.wgsl`.
#[derive(Clone, Debug, PartialEq, ShaderType)]
pub(super) struct AirUniform {
    sun: Vec4,
    top: f32,
    strength: f32,
    pad: Vec2,
}

impl AirUniform {
    pub(super) fn new(globe: &Globe) -> Self {
        let strength = if globe.air.is_finite() {
            globe.air.clamp(0.0, 1.0)
        } else {
            0.0
        };
        // Data stays readable under a thin veil.
        let veil = if globe.overlay == Overlay::Elevation {
            1.0
        } else {
            0.45
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
pub(super) struct AirMaterial {
    #[uniform(0)]
    pub(super) uniform: AirUniform,
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

/// `Line` of `line.wgsl`.
#[derive(Clone, Debug, PartialEq, ShaderType)]
pub(super) struct LineUniform {
    relief: f32,
    lift: f32,
    pad: Vec2,
}

impl LineUniform {
    pub(super) fn new(globe: &Globe, radius: f64) -> Self {
        Self {
            relief: globe.relief(radius),
            lift: LINE_LIFT,
            pad: Vec2::ZERO,
        }
    }
}

/// Lines of constant width.
#[derive(Asset, AsBindGroup, Clone, TypePath)]
pub(super) struct LineMaterial {
    #[uniform(0)]
    pub(super) uniform: LineUniform,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tint_fits_the_uniform() {
        assert!(HYPSOMETRIC.0.len() <= STOPS);
        let uniform = GroundUniform::new(&Globe::default(), 6370.0, 0.01);
        let used = &uniform.tint[..uniform.stops as usize];
        assert!(used.windows(2).all(|pair| pair[0].w <= pair[1].w));
    }
}
