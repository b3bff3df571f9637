//! A device for compute shaders, without a window.

use bevy::render::render_resource::{
    BindGroupEntry, Buffer, BufferDescriptor, BufferUsages, CommandEncoderDescriptor,
    ComputePassDescriptor, MapMode, PollType, RawComputePipelineDescriptor, ShaderModuleDescriptor,
    ShaderSource, WgpuFeatures, WgpuLimits,
};
use bevy::render::renderer::{RenderDevice, RenderQueue};
use bevy::render::settings::{RenderCreation, RenderResources, WgpuSettings};
use bevy_pangaea::render::adapter::open_adapter_with;
use std::sync::OnceLock;

/// Threads of a work group of the shaders that run here.
const GROUP: usize = 64;

/// A device with the limits and features that every WebGPU device has.
pub struct Gpu {
    device: RenderDevice,
    queue: RenderQueue,
    /// Name of the adapter.
    pub name: String,
}

impl Gpu {
    /// The device of this process. Without one tests are skipped and say so, and fail where
    /// `PANGAEA_GPU=require`.
    pub fn get() -> Option<&'static Self> {
        static GPU: OnceLock<Option<Gpu>> = OnceLock::new();
        GPU.get_or_init(Self::open).as_ref()
    }

    fn open() -> Option<Self> {
        let settings = WgpuSettings {
            constrained_limits: Some(WgpuLimits::default()),
            disabled_features: Some(WgpuFeatures::all()),
            features: WgpuFeatures::empty(),
            ..WgpuSettings::default()
        };
        match open_adapter_with(&settings) {
            Ok(RenderCreation::Manual(RenderResources(device, queue, info, ..))) => Some(Self {
                device,
                queue,
                name: info.name.clone(),
            }),
            Ok(RenderCreation::Automatic(_)) => None,
            Err(error) => {
                let required = std::env::var("PANGAEA_GPU").as_deref() == Ok("require");
                assert!(!required, "{error}");
                eprintln!("SKIPPED: {error}");
                None
            }
        }
    }

    /// Runs `call_twin` of a shader on `count` inputs; an output has `words` words.
    pub fn run(&self, wgsl: &str, inputs: &[u32], count: usize, words: usize) -> Vec<u32> {
        let module = self
            .device
            .create_and_validate_shader_module(ShaderModuleDescriptor {
                label: None,
                source: ShaderSource::Wgsl(wgsl.into()),
            });
        let pipeline = self
            .device
            .create_compute_pipeline(&RawComputePipelineDescriptor {
                label: None,
                layout: None,
                module: &module,
                entry_point: Some("call_twin"),
                compilation_options: Default::default(),
                cache: None,
            });
        let input = self.buffer(inputs.len(), BufferUsages::STORAGE | BufferUsages::COPY_DST);
        let bytes: Vec<u8> = inputs.iter().flat_map(|word| word.to_le_bytes()).collect();
        self.queue.write_buffer(&input, 0, &bytes);
        let size = count * words;
        let output = self.buffer(size, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let group = self.device.create_bind_group(
            None,
            &pipeline.get_bind_group_layout(0).into(),
            &[entry(0, &input), entry(1, &output)],
        );
        let mut encoder = self
            .device
            .create_command_encoder(&CommandEncoderDescriptor::default());
        let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &*group, &[]);
        pass.dispatch_workgroups(count.div_ceil(GROUP) as u32, 1, 1);
        drop(pass);
        let copy = self.buffer(size, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
        encoder.copy_buffer_to_buffer(&output, 0, &copy, 0, copy.size());
        self.queue.submit([encoder.finish()]);
        self.read(&copy)
    }

    fn buffer(&self, words: usize, usage: BufferUsages) -> Buffer {
        self.device.create_buffer(&BufferDescriptor {
            label: None,
            size: 4 * words as u64,
            usage,
            mapped_at_creation: false,
        })
    }

    fn read(&self, buffer: &Buffer) -> Vec<u32> {
        let slice = buffer.slice(..);
        slice.map_async(MapMode::Read, |mapped| mapped.expect("a buffer is mapped"));
        let wait = PollType::Wait {
            submission_index: None,
            timeout: None,
        };
        self.device.poll(wait).expect("the device answers");
        let bytes = slice.get_mapped_range();
        let words = bytes
            .chunks(4)
            .map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        words.collect()
    }
}

fn entry(binding: u32, buffer: &Buffer) -> BindGroupEntry<'_> {
    BindGroupEntry {
        binding,
        resource: buffer.as_entire_binding(),
    }
}
