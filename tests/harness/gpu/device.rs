//! A device for compute shaders, without a window.

use bevy::render::render_resource::{
    BindGroup, BindGroupEntry, Buffer, BufferDescriptor, BufferUsages, CommandEncoder,
    CommandEncoderDescriptor, ComputePassDescriptor, ComputePipeline, MapMode, PollType,
    RawComputePipelineDescriptor, ShaderModuleDescriptor, ShaderSource, WgpuFeatures, WgpuLimits,
};
use bevy::render::renderer::{RenderDevice, RenderQueue};
use bevy::render::settings::{RenderCreation, RenderResources, WgpuSettings};
use bevy_pangaea::render::adapter::open_adapter_with;
use pangaea_shaders::gpu::wgpu::{Device, Queue};
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

    /// The device and its queue, without Bevy's types around them.
    pub fn wgpu(&self) -> (&Device, &Queue) {
        (self.device.wgpu_device(), &self.queue)
    }

    /// Runs `call_twin` of a shader on `count` inputs; an output has `words` words.
    pub fn run(&self, wgsl: &str, inputs: &[u32], count: usize, words: usize) -> Vec<u32> {
        let pipeline = self.pipeline(wgsl, "call_twin");
        let input = self.upload(inputs, BufferUsages::STORAGE);
        let output = self.buffer(
            count * words,
            BufferUsages::STORAGE | BufferUsages::COPY_SRC,
        );
        let group = self.group(&pipeline, 0, &[(0, &input), (1, &output)]);
        let groups = count.div_ceil(GROUP) as u32;
        self.dispatch(&pipeline, &[group], groups);
        let copies = self.download(&[&output]);
        copies.into_iter().next().expect("one buffer")
    }

    /// The pipeline of an entry point, with the layout that follows from its text.
    pub fn pipeline(&self, wgsl: &str, entry: &str) -> ComputePipeline {
        let source = ShaderSource::Wgsl(wgsl.into());
        let module = self
            .device
            .create_and_validate_shader_module(ShaderModuleDescriptor {
                label: None,
                source,
            });
        self.device
            .create_compute_pipeline(&RawComputePipelineDescriptor {
                label: None,
                layout: None,
                module: &module,
                entry_point: Some(entry),
                compilation_options: Default::default(),
                cache: None,
            })
    }

    /// Buffers at bindings of a group of a pipeline.
    pub fn group(
        &self,
        pipeline: &ComputePipeline,
        group: u32,
        buffers: &[(u32, &Buffer)],
    ) -> BindGroup {
        let layout = pipeline.get_bind_group_layout(group).into();
        let entries = buffers.iter().map(|&(binding, buffer)| BindGroupEntry {
            binding,
            resource: buffer.as_entire_binding(),
        });
        let entries: Vec<BindGroupEntry> = entries.collect();
        self.device.create_bind_group(None, &layout, &entries)
    }

    /// Runs so many groups of a pipeline alone.
    pub fn dispatch(&self, pipeline: &ComputePipeline, bound: &[BindGroup], groups: u32) {
        let mut encoder = self.encoder();
        let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor::default());
        pass.set_pipeline(pipeline);
        for (i, group) in (0..).zip(bound) {
            pass.set_bind_group(i, &**group, &[]);
        }
        pass.dispatch_workgroups(groups, 1, 1);
        drop(pass);
        self.submit(encoder);
    }

    /// Hands commands to the device.
    pub fn submit(&self, commands: CommandEncoder) {
        self.queue.submit([commands.finish()]);
    }

    /// An encoder of commands.
    pub fn encoder(&self) -> CommandEncoder {
        self.device
            .create_command_encoder(&CommandEncoderDescriptor::default())
    }

    /// A buffer of words; one word where there are none, for no buffer is empty.
    pub fn upload(&self, words: &[u32], usage: BufferUsages) -> Buffer {
        let buffer = self.buffer(words.len().max(1), usage | BufferUsages::COPY_DST);
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        self.queue.write_buffer(&buffer, 0, &bytes);
        buffer
    }

    /// The words of buffers that can be copied from, once all that was submitted is done.
    pub fn download(&self, buffers: &[&Buffer]) -> Vec<Vec<u32>> {
        let mut encoder = self.encoder();
        let copies = buffers.iter().map(|from| {
            let words = from.size() as usize / 4;
            let to = self.buffer(words, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
            encoder.copy_buffer_to_buffer(from, 0, &to, 0, to.size());
            to
        });
        let copies: Vec<Buffer> = copies.collect();
        self.queue.submit([encoder.finish()]);
        copies.iter().map(|copy| self.read(copy)).collect()
    }

    fn buffer(&self, words: usize, usage: BufferUsages) -> Buffer {
        self.device.create_buffer(&BufferDescriptor {
            label: None,
            size: 4 * words as u64,
            usage,
            mapped_at_creation: false,
        })
    }

    /// Waits until all that was submitted is done.
    pub fn wait(&self) {
        let wait = PollType::Wait {
            submission_index: None,
            timeout: None,
        };
        self.device.poll(wait).expect("the device answers");
    }

    fn read(&self, buffer: &Buffer) -> Vec<u32> {
        let slice = buffer.slice(..);
        slice.map_async(MapMode::Read, |mapped| mapped.expect("a buffer is mapped"));
        self.wait();
        let bytes = slice.get_mapped_range();
        let words = bytes
            .chunks(4)
            .map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
        words.collect()
    }
}
