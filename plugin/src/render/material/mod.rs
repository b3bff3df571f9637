//! The passes of `pangaea_shaders::globe` as materials, and the uniforms that they read.

mod air;
mod ground;
mod line;
mod shaders;
mod sun;

pub(super) use air::AirMaterial;
pub(super) use ground::GroundMaterial;
pub(super) use line::LineMaterial;

use super::globe::Globe;
use air::AirUniform;
use bevy::pbr::MaterialPlugin;
use bevy::prelude::*;
use bevy::shader::Shader;
use ground::GroundUniform;
use line::LineUniform;

/// Adds shaders and materials.
pub(super) struct GlobeMaterialPlugin;

impl Plugin for GlobeMaterialPlugin {
    fn build(&self, app: &mut App) {
        shaders::insert(&mut app.world_mut().resource_mut::<Assets<Shader>>());
        app.add_plugins((
            MaterialPlugin::<GroundMaterial>::default(),
            MaterialPlugin::<AirMaterial>::default(),
            MaterialPlugin::<LineMaterial>::default(),
        ));
    }
}

/// The uniforms of a globe's materials.
pub(super) struct GlobeUniforms {
    pub(super) ground: GroundUniform,
    pub(super) air: AirUniform,
    pub(super) line: LineUniform,
}

impl GlobeUniforms {
    /// The uniforms of a globe of `radius` km whose samples are `spacing` radians apart.
    pub(super) fn new(globe: &Globe, radius: f64, spacing: f64) -> Self {
        Self {
            ground: GroundUniform::new(globe, radius, spacing),
            air: AirUniform::new(globe),
            line: LineUniform::new(globe, radius),
        }
    }
}
