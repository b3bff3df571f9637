//! One pipeline a pass, made once a device.

use super::error::GpuError;
use crate::amplify::columns::{ComputePass, GpuColumn, LEVELS, PASSES, WRITTEN, column_named};
use crate::amplify::rows::{LevelSizes, Row};
use crate::amplify::twins::MODULES;
use crate::wgsl::compose;
use core::num::NonZeroU64;
use wgpu::{
    BindGroupLayout, BindGroupLayoutDescriptor, BindGroupLayoutEntry, BindingType,
    BufferBindingType, ComputePipeline, ComputePipelineDescriptor, Device,
    PipelineLayoutDescriptor, ShaderModuleDescriptor, ShaderSource, ShaderStages,
};

/// Bytes of the uniform of a level.
pub(super) const UNIFORM_BYTES: u64 = 224;

/// Storage buffers that a pass binds at most.
const STORAGE_BUFFERS: u32 = 8;

/// A pass on a device.
#[derive(Clone, Debug)]
pub(super) struct PassPipeline {
    pub(super) pass: ComputePass,
    pub(super) columns: BindGroupLayout,
    pub(super) pipeline: ComputePipeline,
}

/// The passes on a device.
#[derive(Clone, Debug)]
pub struct GroundPipelines {
    /// Layout of the group that holds the uniform of a level.
    pub(super) common: BindGroupLayout,
    pub(super) passes: Vec<PassPipeline>,
}

impl GroundPipelines {
    /// Compiles all passes: seconds on most drivers, so best not on a thread that draws.
    ///
    /// # Errors
    /// [`GpuError::Limit`] for a device below the limits of WebGPU. All that a driver refuses reaches
    /// the device's own handler of errors.
    pub fn new(device: &Device) -> Result<Self, GpuError> {
        let found = device.limits().max_storage_buffers_per_shader_stage;
        if found < STORAGE_BUFFERS {
            return Err(GpuError::Limit {
                name: "maxStorageBuffersPerShaderStage",
                found: found.into(),
                needed: STORAGE_BUFFERS.into(),
            });
        }
        let common = layout(device, &[uniform(0, UNIFORM_BYTES)]);
        let passes = PASSES.iter().map(|pass| compiled(device, &common, *pass));
        let passes = passes.collect();
        Ok(Self { common, passes })
    }

    /// The pass of an entry point, which must be one of [`PASSES`].
    pub(super) fn named(&self, entry: &str) -> Option<&PassPipeline> {
        self.passes.iter().find(|pass| pass.pass.entry == entry)
    }
}

fn compiled(device: &Device, common: &BindGroupLayout, pass: ComputePass) -> PassPipeline {
    let columns = layout(device, &entries(&pass));
    let module = device.create_shader_module(ShaderModuleDescriptor {
        label: Some(pass.module),
        source: ShaderSource::Wgsl(compose(&MODULES, &[pass.module]).wgsl.into()),
    });
    let layout = device.create_pipeline_layout(&PipelineLayoutDescriptor {
        label: Some(pass.entry),
        bind_group_layouts: &[Some(common), Some(&columns)],
        immediate_size: 0,
    });
    let pipeline = device.create_compute_pipeline(&ComputePipelineDescriptor {
        label: Some(pass.entry),
        layout: Some(&layout),
        module: &module,
        entry_point: Some(pass.entry),
        compilation_options: Default::default(),
        cache: None,
    });
    PassPipeline {
        pass,
        columns,
        pipeline,
    }
}

/// The bindings of a pass's columns.
fn entries(pass: &ComputePass) -> Vec<BindGroupLayoutEntry> {
    let reads = pass.reads.iter().filter_map(|name| column_named(name));
    let writes = pass.writes.iter().filter_map(|name| column_named(name));
    let writes = writes.map(|column| storage(column.binding + WRITTEN, false));
    reads.map(read).chain(writes).collect()
}

/// The binding of a column that is read.
const fn read(column: GpuColumn) -> BindGroupLayoutEntry {
    if column.is_uniform {
        uniform(column.binding, (LEVELS * LevelSizes::LAYOUT.size) as u64)
    } else {
        storage(column.binding, true)
    }
}

fn layout(device: &Device, entries: &[BindGroupLayoutEntry]) -> BindGroupLayout {
    device.create_bind_group_layout(&BindGroupLayoutDescriptor {
        label: None,
        entries,
    })
}

const fn uniform(binding: u32, bytes: u64) -> BindGroupLayoutEntry {
    entry(binding, BufferBindingType::Uniform, NonZeroU64::new(bytes))
}

const fn storage(binding: u32, read_only: bool) -> BindGroupLayoutEntry {
    entry(binding, BufferBindingType::Storage { read_only }, None)
}

const fn entry(
    binding: u32,
    ty: BufferBindingType,
    min_binding_size: Option<NonZeroU64>,
) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry {
        binding,
        visibility: ShaderStages::COMPUTE,
        ty: BindingType::Buffer {
            ty,
            has_dynamic_offset: false,
            min_binding_size,
        },
        count: None,
    }
}
