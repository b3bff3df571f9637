//! Pipelines, and the buffers of every camera.

use super::extract::SeenGround;
use super::view::{GroundStatus, Reports};
use crate::background::{BackgroundJob, BackgroundPool};
use crate::query::Rules;
use bevy::platform::collections::{HashMap, HashSet};
use bevy::prelude::*;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::gpu::{
    BaseRows, GpuError, GroundBuffers, GroundCaps, GroundDrawing, GroundPainter, GroundPipelines,
    GroundRun, GroundTarget,
};
use std::sync::Arc;

static POOL: BackgroundPool = BackgroundPool::new("ground shaders", |_| 1);

/// All that the ground has on the GPU.
#[derive(Resource, Default)]
pub(super) struct GroundGpu {
    pipelines: Pipelines,
    pub(super) painters: HashMap<GroundTarget, GroundPainter>,
    pub(super) cameras: HashMap<Entity, CameraGround>,
}

/// The passes, which take seconds to compile.
#[derive(Default)]
enum Pipelines {
    #[default]
    None,
    Compiling(BackgroundJob<Result<GroundPipelines, GpuError>>),
    Ready(Result<GroundPipelines, GpuError>),
}

/// The ground of a camera.
pub(super) struct CameraGround {
    rows: Arc<BaseRows>,
    leaves: u32,
    pub(super) run: GroundRun,
    /// Whether its control mesh has its final ground.
    pub(super) is_carved: bool,
    /// The view that it was grown for last.
    pub(super) grown: Option<(View, Rules)>,
    pub(super) runs: u64,
    pub(super) drawing: Option<(GroundTarget, GroundDrawing)>,
}

/// Starts to compile the passes for a device.
pub(super) fn compile(device: Res<RenderDevice>, mut gpu: ResMut<GroundGpu>) {
    let device = device.wgpu_device().clone();
    *gpu = GroundGpu {
        pipelines: Pipelines::Compiling(POOL.start(move || GroundPipelines::new(&device))),
        ..default()
    };
}

/// Makes the buffers of cameras that are new, or whose planet is.
pub(super) fn prepare(
    seen: Query<&SeenGround>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
    reports: Res<Reports>,
    mut gpu: ResMut<GroundGpu>,
) {
    let gpu = &mut *gpu;
    let cameras: HashSet<Entity> = seen.iter().map(|ground| ground.camera).collect();
    gpu.cameras.retain(|camera, _| cameras.contains(camera));
    if let Pipelines::Compiling(job) = &gpu.pipelines
        && let Some(result) = job.take()
    {
        gpu.pipelines = Pipelines::Ready(result);
    }
    let Pipelines::Ready(pipelines) = &gpu.pipelines else {
        return;
    };
    for ground in &seen {
        let held = gpu.cameras.get(&ground.camera);
        if held.is_some_and(|held| held.is_of(ground)) {
            continue;
        }
        let made = pipelines
            .as_ref()
            .map_err(Clone::clone)
            .and_then(|pipelines| {
                CameraGround::new(device.wgpu_device(), &queue, pipelines, ground)
            });
        match made {
            Ok(made) => {
                gpu.cameras.insert(ground.camera, made);
            }
            Err(error) => {
                gpu.cameras.remove(&ground.camera);
                reports.say(ground.camera, GroundStatus::Failed(error.to_string()));
            }
        }
    }
}

impl CameraGround {
    fn new(
        device: &pangaea_shaders::gpu::wgpu::Device,
        queue: &pangaea_shaders::gpu::wgpu::Queue,
        pipelines: &GroundPipelines,
        ground: &SeenGround,
    ) -> Result<Self, GpuError> {
        let caps = GroundCaps::for_leaves(ground.leaves);
        let buffers = GroundBuffers::new(device, queue, &ground.rows, &caps)?;
        Ok(Self {
            rows: ground.rows.clone(),
            leaves: ground.leaves,
            run: GroundRun::new(device, pipelines, buffers, &ground.rows),
            is_carved: false,
            grown: None,
            runs: 0,
            drawing: None,
        })
    }

    /// Whether its buffers are those that a camera asks for.
    fn is_of(&self, ground: &SeenGround) -> bool {
        Arc::ptr_eq(&self.rows, &ground.rows) && self.leaves == ground.leaves
    }
}
