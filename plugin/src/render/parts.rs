//! The entities that draw a globe, children of the planet's entity, and what is handed to them.

use super::material::{
    AirMaterial, AirUniform, GroundMaterial, GroundUniform, LineMaterial, LineUniform,
};
use super::painter::Easel;
use super::{Globe, mesh};
use crate::overlay::Overlay;
use crate::planet::{Lattice, Planet};
use bevy::asset::RenderAssetUsages;
use bevy::camera::visibility::NoFrustumCulling;
use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::prelude::*;
use bevy::render::storage::ShaderBuffer;

/// The entities and assets of a globe.
#[derive(Component)]
pub(super) struct Parts {
    /// A patch each.
    pub(super) ground: Vec<Entity>,
    lines: Entity,
    air: Entity,
    edges: Option<Entity>,
    samples: Handle<ShaderBuffer>,
}

impl Parts {
    fn entities(&self) -> impl Iterator<Item = Entity> {
        let others = [Some(self.lines), Some(self.air), self.edges];
        self.ground
            .iter()
            .copied()
            .chain(others.into_iter().flatten())
    }

    /// One entity for each material.
    fn painted(&self) -> impl Iterator<Item = Entity> {
        self.entities().skip(self.ground.len().saturating_sub(1))
    }
}

/// The mesh of the air, shared by all globes.
#[derive(Resource, Default)]
pub(super) struct Shell(Option<Handle<Mesh>>);

/// Makes the entities of a globe when the first picture on its lattice is there.
pub(super) fn build_parts(
    mut commands: Commands,
    mut globes: Query<(
        Entity,
        &Planet,
        &Lattice,
        &Globe,
        &mut Easel,
        Option<&Parts>,
    )>,
    mut shell: ResMut<Shell>,
    mut meshes: ResMut<Assets<Mesh>>,
    mut buffers: ResMut<Assets<ShaderBuffer>>,
    (mut grounds, mut airs, mut line_materials): (
        ResMut<Assets<GroundMaterial>>,
        ResMut<Assets<AirMaterial>>,
        ResMut<Assets<LineMaterial>>,
    ),
) {
    for (planet, &Planet { radius, .. }, lattice, globe, mut easel, old) in &mut globes {
        let Some(picture) = &mut easel.finished else {
            continue;
        };
        let Some(patches) = picture.ground.take() else {
            continue;
        };
        for part in old.into_iter().flat_map(Parts::entities) {
            commands.entity(part).try_despawn();
        }
        let size = picture.columns.len();
        let samples = buffers.add(ShaderBuffer::with_size(
            size,
            RenderAssetUsages::RENDER_WORLD,
        ));
        let part = |name| {
            (
                Name::new(name),
                ChildOf(planet),
                NoFrustumCulling,
                NotShadowCaster,
                NotShadowReceiver,
            )
        };
        let ground = GroundMaterial {
            uniform: GroundUniform::new(globe, radius, lattice.spacing()),
            samples: samples.clone(),
            wire: false,
        };
        let material = MeshMaterial3d(grounds.add(ground));
        let patch = |mesh::Patch { mesh, cap }| {
            commands
                .spawn((
                    part("ground"),
                    Mesh3d(meshes.add(mesh)),
                    material.clone(),
                    cap,
                ))
                .id()
        };
        let ground = patches.into_iter().map(patch).collect();
        let line = LineMaterial {
            uniform: LineUniform::new(globe, radius),
        };
        let lines = commands
            .spawn((part("lines"), MeshMaterial3d(line_materials.add(line))))
            .id();
        let sphere = shell
            .0
            .get_or_insert_with(|| meshes.add(mesh::shell()))
            .clone();
        let air = AirMaterial {
            uniform: AirUniform::new(globe),
        };
        let air = (part("air"), Mesh3d(sphere), MeshMaterial3d(airs.add(air)));
        let air = commands.spawn(air).id();
        commands.entity(planet).insert(Parts {
            ground,
            lines,
            air,
            edges: None,
            samples,
        });
    }
}

/// Hands finished pictures to the renderer.
pub(super) fn show_pictures(
    mut commands: Commands,
    mut globes: Query<(&mut Easel, &Parts)>,
    mut meshes: ResMut<Assets<Mesh>>,
    mut buffers: ResMut<Assets<ShaderBuffer>>,
) {
    for (mut easel, parts) in &mut globes {
        let Some(picture) = easel.finished.take() else {
            continue;
        };
        if let Some(mut samples) = buffers.get_mut(&parts.samples) {
            samples.data = Some(picture.columns);
        }
        let seen = if picture.no_lines {
            Visibility::Hidden
        } else {
            Visibility::Inherited
        };
        commands
            .entity(parts.lines)
            .insert((Mesh3d(meshes.add(picture.lines)), seen));
    }
}

/// Tells the shaders what needs no painting, and makes or hides the edges of triangles.
pub(super) fn shade(
    mut commands: Commands,
    mut globes: Query<
        (Entity, &Planet, &Lattice, &Globe, &mut Parts),
        Or<(Changed<Globe>, Changed<Parts>)>,
    >,
    handles: Query<(
        Option<&MeshMaterial3d<GroundMaterial>>,
        Option<&MeshMaterial3d<AirMaterial>>,
        Option<&MeshMaterial3d<LineMaterial>>,
    )>,
    mut meshes: ResMut<Assets<Mesh>>,
    (mut grounds, mut airs, mut lines): (
        ResMut<Assets<GroundMaterial>>,
        ResMut<Assets<AirMaterial>>,
        ResMut<Assets<LineMaterial>>,
    ),
) {
    for (planet, &Planet { radius, .. }, lattice, globe, mut parts) in &mut globes {
        let wanted = globe.wireframe || globe.overlay == Overlay::Mesh;
        if wanted && parts.edges.is_none() {
            let material = GroundMaterial {
                uniform: GroundUniform::new(globe, radius, lattice.spacing()),
                samples: parts.samples.clone(),
                wire: true,
            };
            let edges = (
                Mesh3d(meshes.add(mesh::edges(lattice))),
                MeshMaterial3d(grounds.add(material)),
            );
            let part = (
                Name::new("edges"),
                ChildOf(planet),
                NoFrustumCulling,
                NotShadowCaster,
            );
            parts.edges = Some(commands.spawn((part, edges)).id());
        }
        for part in parts.painted() {
            let Ok((ground, air, line)) = handles.get(part) else {
                continue;
            };
            if let Some(mut material) = ground.and_then(|m| grounds.get_mut(m)) {
                material.uniform = GroundUniform::new(globe, radius, lattice.spacing());
            }
            if let Some(mut material) = air.and_then(|m| airs.get_mut(m)) {
                material.uniform = AirUniform::new(globe);
            }
            if let Some(mut material) = line.and_then(|m| lines.get_mut(m)) {
                material.uniform = LineUniform::new(globe, radius);
            }
        }
        let visible = |on| {
            if on {
                Visibility::Inherited
            } else {
                Visibility::Hidden
            }
        };
        commands.entity(parts.air).insert(visible(globe.air > 0.0));
        if let Some(edges) = parts.edges {
            commands.entity(edges).insert(visible(wanted));
        }
    }
}
