//! The assets that globes are made of.

use super::material::{AirMaterial, GlobeUniforms, GroundMaterial, LineMaterial};
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy::render::storage::ShaderBuffer;

/// The assets that globes are made of.
#[derive(SystemParam)]
pub(super) struct GlobeAssets<'w> {
    pub(super) meshes: ResMut<'w, Assets<Mesh>>,
    pub(super) buffers: ResMut<'w, Assets<ShaderBuffer>>,
    grounds: ResMut<'w, Assets<GroundMaterial>>,
    airs: ResMut<'w, Assets<AirMaterial>>,
    lines: ResMut<'w, Assets<LineMaterial>>,
}

/// The materials of a globe.
pub(super) struct GlobeMaterials {
    pub(super) ground: Handle<GroundMaterial>,
    pub(super) edges: Handle<GroundMaterial>,
    pub(super) air: Handle<AirMaterial>,
    pub(super) lines: Handle<LineMaterial>,
}

impl GlobeMaterials {
    /// The materials of a globe whose samples are in a buffer.
    pub(super) fn new(
        uniforms: GlobeUniforms,
        samples: &Handle<ShaderBuffer>,
        assets: &mut GlobeAssets,
    ) -> Self {
        let GlobeUniforms { ground, air, line } = uniforms;
        let [solid, wire] = [false, true].map(|wire| GroundMaterial {
            uniform: ground.clone(),
            samples: samples.clone(),
            wire,
        });
        Self {
            ground: assets.grounds.add(solid),
            edges: assets.grounds.add(wire),
            air: assets.airs.add(AirMaterial { uniform: air }),
            lines: assets.lines.add(LineMaterial { uniform: line }),
        }
    }

    /// Hands new uniforms to the shaders.
    pub(super) fn update(&self, uniforms: GlobeUniforms, assets: &mut GlobeAssets) {
        let GlobeUniforms { ground, air, line } = uniforms;
        for handle in [&self.ground, &self.edges] {
            if let Some(mut material) = assets.grounds.get_mut(handle) {
                material.uniform = ground.clone();
            }
        }
        if let Some(mut material) = assets.airs.get_mut(&self.air) {
            material.uniform = air;
        }
        if let Some(mut material) = assets.lines.get_mut(&self.lines) {
            material.uniform = line;
        }
    }
}
