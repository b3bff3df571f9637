//! Changes of a [`Globe`] that need no build: uniforms, the edges of triangles, the air.

use super::assets::GlobeAssets;
use super::globe::Globe;
use super::material::GlobeUniforms;
use super::mesh;
use super::parts::{GlobeParts, part, visibility};
use crate::planet::{Lattice, Planet};
use bevy::prelude::*;

/// Globes that look different from the frame before.
type ChangedGlobe = Or<(Changed<Globe>, Changed<GlobeParts>)>;

/// Hands new uniforms to the shaders.
pub(super) fn update_materials(
    globes: Query<(&Planet, &Lattice, &Globe, &GlobeParts), ChangedGlobe>,
    mut assets: GlobeAssets,
) {
    for (planet, lattice, globe, parts) in &globes {
        let uniforms = GlobeUniforms::new(globe, planet.radius, lattice.spacing());
        parts.materials.update(uniforms, &mut assets);
    }
}

/// Spawns the edges of triangles when they are first asked for.
pub(super) fn spawn_edges(
    mut commands: Commands,
    mut globes: Query<(Entity, &Lattice, &Globe, &mut GlobeParts), ChangedGlobe>,
    mut assets: GlobeAssets,
) {
    for (planet, lattice, globe, mut parts) in &mut globes {
        if globe.shows_edges() && parts.edges.is_none() {
            // Three edges a sample: too many to make them for globes that never show them.
            let mesh = Mesh3d(assets.meshes.add(mesh::edges(lattice)));
            let material = MeshMaterial3d(parts.materials.edges.clone());
            let edges = commands.spawn((part("edges", planet), mesh, material));
            parts.edges = Some(edges.id());
        }
    }
}

/// Shows or hides the air and the edges of triangles.
pub(super) fn update_visibility(
    globes: Query<(&Globe, &GlobeParts), ChangedGlobe>,
    mut visibilities: Query<&mut Visibility>,
) {
    for (globe, parts) in &globes {
        if let Ok(mut air) = visibilities.get_mut(parts.air) {
            air.set_if_neq(visibility(globe.air > 0.0));
        }
        let edges = parts
            .edges
            .and_then(|edges| visibilities.get_mut(edges).ok());
        if let Some(mut edges) = edges {
            edges.set_if_neq(visibility(globe.shows_edges()));
        }
    }
}
