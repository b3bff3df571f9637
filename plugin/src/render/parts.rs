//! The entities that draw a globe, children of the planet's entity, and their assets.

use super::assets::{GlobeAssets, GlobeMaterials};
use super::globe::{Globe, GlobeDrawn};
use super::material::GlobeUniforms;
use super::mesh::{GlobePatch, air_shell};
use super::picking::GlobePicker;
use super::task::GlobeTask;
use crate::resample::SurfaceProjection;
use crate::view::PlanetQuery;
use bevy::asset::RenderAssetUsages;
use bevy::camera::visibility::NoFrustumCulling;
use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::prelude::*;
use bevy::render::storage::ShaderBuffer;

/// The entities and assets of a globe. Assets are held here and by the entities alone: all go with
/// the planet.
#[derive(Component)]
pub(super) struct GlobeParts {
    /// An entity per patch of ground.
    pub(super) patches: Vec<Entity>,
    pub(super) lines: Entity,
    pub(super) air: Entity,
    /// The edges of triangles, once they were asked for.
    pub(super) edges: Option<Entity>,
    pub(super) materials: GlobeMaterials,
    samples: Handle<ShaderBuffer>,
}

impl GlobeParts {
    fn entities(&self) -> impl Iterator<Item = Entity> {
        let others = [Some(self.lines), Some(self.air), self.edges];
        let patches = self.patches.iter().copied();
        patches.chain(others.into_iter().flatten())
    }
}

/// The mesh of the air, shared by all globes.
#[derive(Resource)]
pub(super) struct AirShell(Handle<Mesh>);

impl FromWorld for AirShell {
    fn from_world(world: &mut World) -> Self {
        Self(world.resource_mut::<Assets<Mesh>>().add(air_shell()))
    }
}

/// Prepares a planet that is to be drawn: builds need its surface after every step.
pub(super) fn start_globe(added: On<Add, Globe>, mut commands: Commands) {
    commands
        .entity(added.entity)
        .try_insert((GlobeTask::default(), SurfaceProjection::EveryStep));
}

/// Removes all traces of a globe that is no longer drawn.
pub(super) fn remove_globe(
    removed: On<Remove, Globe>,
    mut commands: Commands,
    globes: Query<&GlobeParts>,
) {
    for part in globes
        .get(removed.entity)
        .iter()
        .flat_map(|parts| parts.entities())
    {
        commands.entity(part).try_despawn();
    }
    if let Ok(mut planet) = commands.get_entity(removed.entity) {
        planet.try_remove::<(GlobeTask, GlobeParts, GlobeDrawn, GlobePicker)>();
    }
}

/// The components of every part of a globe.
pub(super) fn part(name: &'static str, planet: Entity) -> impl Bundle {
    (
        Name::new(name),
        ChildOf(planet),
        NoFrustumCulling,
        NotShadowCaster,
        NotShadowReceiver,
    )
}

/// Visible as the planet is, or hidden.
pub(super) fn visibility(shown: bool) -> Visibility {
    if shown {
        Visibility::Inherited
    } else {
        Visibility::Hidden
    }
}

/// Spawns the entities of a globe when the first build on its lattice is there.
pub(super) fn spawn_parts(
    mut commands: Commands,
    mut globes: Query<(
        Entity,
        PlanetQuery,
        &Globe,
        &mut GlobeTask,
        Option<&GlobeParts>,
    )>,
    shell: Res<AirShell>,
    mut assets: GlobeAssets,
) {
    for (entity, planet, globe, mut task, old) in &mut globes {
        let Some(built) = &mut task.built else {
            continue;
        };
        let Some(patches) = built.patches.take() else {
            continue;
        };
        // The meshes of another lattice are of no use.
        for part in old.into_iter().flat_map(GlobeParts::entities) {
            commands.entity(part).try_despawn();
        }
        // Filled by the upload of this build, and anew by each that follows.
        let usages = RenderAssetUsages::RENDER_WORLD;
        let samples = ShaderBuffer::with_size(built.samples.len(), usages);
        let samples = assets.buffers.add(samples);
        let uniforms = GlobeUniforms::new(globe, planet.planet.radius, planet.lattice.spacing());
        let materials = GlobeMaterials::new(uniforms, &samples, &mut assets);
        let meshes = &mut assets.meshes;
        let patches = spawn_patches(&mut commands, entity, patches, &materials, meshes);
        let parts = GlobeParts {
            patches,
            lines: spawn_lines(&mut commands, entity, &materials),
            air: spawn_air(&mut commands, entity, &materials, &shell),
            edges: None,
            materials,
            samples,
        };
        commands.entity(entity).try_insert(parts);
    }
}

fn spawn_lines(commands: &mut Commands, planet: Entity, materials: &GlobeMaterials) -> Entity {
    let material = MeshMaterial3d(materials.lines.clone());
    commands.spawn((part("lines", planet), material)).id()
}

fn spawn_air(
    commands: &mut Commands,
    planet: Entity,
    materials: &GlobeMaterials,
    shell: &AirShell,
) -> Entity {
    let mesh = Mesh3d(shell.0.clone());
    let material = MeshMaterial3d(materials.air.clone());
    commands.spawn((part("air", planet), mesh, material)).id()
}

fn spawn_patches(
    commands: &mut Commands,
    planet: Entity,
    patches: Vec<GlobePatch>,
    materials: &GlobeMaterials,
    meshes: &mut Assets<Mesh>,
) -> Vec<Entity> {
    let mut entities = Vec::with_capacity(patches.len());
    for patch in patches {
        let mesh = Mesh3d(meshes.add(patch.mesh));
        let material = MeshMaterial3d(materials.ground.clone());
        let ground = commands.spawn((part("ground", planet), mesh, material, patch.cap));
        entities.push(ground.id());
    }
    entities
}

/// Hands finished builds to the renderer.
pub(super) fn upload_builds(
    mut commands: Commands,
    mut globes: Query<(Entity, &mut GlobeTask, &GlobeParts)>,
    mut assets: GlobeAssets,
) {
    for (planet, mut task, parts) in &mut globes {
        let Some(built) = task.built.take() else {
            continue;
        };
        if let Some(mut samples) = assets.buffers.get_mut(&parts.samples) {
            samples.data = Some(built.samples);
        }
        let lines = Mesh3d(assets.meshes.add(built.lines));
        commands
            .entity(parts.lines)
            .try_insert((lines, visibility(built.has_lines)));
        commands
            .entity(planet)
            .try_insert((built.drawn, built.picker));
    }
}

#[cfg(test)]
mod tests;
