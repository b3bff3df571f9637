//! The ground and its water as lit triangles, drawn from the run's own buffers.
//!
//! A triangle is an instance of three corners, so the number of triangles is all that a draw needs,
//! and the GPU has it: nothing is read back.

use super::buffers::bytes_of;
use super::camera::{self, CAMERA_BYTES, GroundCamera};
use super::run::GroundRun;
use crate::amplify::columns::{COLUMNS, LEVELS, column_named};
use crate::amplify::rows::{LevelSizes, Row};
use crate::amplify::twins::MODULES;
use crate::wgsl::{WgslModule, compose};
use core::num::NonZeroU64;
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor,
    BindGroupLayoutEntry, BindingType, BlendState, Buffer, BufferBindingType, BufferDescriptor,
    BufferUsages, ColorTargetState, ColorWrites, CommandEncoder, CompareFunction,
    DepthStencilState, Device, Face, FragmentState, MultisampleState, PipelineLayout,
    PipelineLayoutDescriptor, PrimitiveState, Queue, RenderPass, RenderPipeline,
    RenderPipelineDescriptor, ShaderModule, ShaderModuleDescriptor, ShaderSource, ShaderStages,
    TextureFormat, VertexState,
};

const DRAW: WgslModule = WgslModule {
    path: "gpu/draw",
    wgsl: include_str!("draw.wgsl"),
    needs: &[
        "amplify/fixed",
        "amplify/rules/valley/carve",
        "amplify/rows/vertex",
        "amplify/columns",
    ],
    constants: camera::shared_constants,
};

/// Columns that drawing reads.
const DRAWN: [&str; 5] = [
    "vertex_cores",
    "vertex_courses",
    "vertex_lands",
    "triangles",
    "shown",
];

/// The kind of images that the ground is drawn into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct GroundTarget {
    /// Format of the colours, which are linear.
    pub colour: TextureFormat,
    /// Format of the depth, which is reversed.
    pub depth: TextureFormat,
    /// Samples a pixel.
    pub samples: u32,
}

/// Pipelines that draw ground into targets of one kind.
#[derive(Clone, Debug)]
pub struct GroundPainter {
    camera: BindGroupLayout,
    columns: BindGroupLayout,
    ground: RenderPipeline,
    water: RenderPipeline,
}

impl GroundPainter {
    /// Compiles them.
    pub fn new(device: &Device, target: GroundTarget) -> Self {
        let modules: Vec<WgslModule> = MODULES.into_iter().chain([DRAW]).collect();
        let module = device.create_shader_module(ShaderModuleDescriptor {
            label: Some(DRAW.path),
            source: ShaderSource::Wgsl(compose(&modules, &[DRAW.path]).wgsl.into()),
        });
        let camera = layout(device, &[camera_entry()]);
        let columns: Vec<_> = DRAWN.iter().filter_map(|name| column_entry(name)).collect();
        let columns = layout(device, &columns);
        let both = device.create_pipeline_layout(&PipelineLayoutDescriptor {
            label: Some(DRAW.path),
            bind_group_layouts: &[Some(&camera), Some(&columns)],
            immediate_size: 0,
        });
        let pipeline = |entries, blend| pipeline(device, &module, &both, target, entries, blend);
        Self {
            ground: pipeline(["draw_ground", "light_ground"], None),
            water: pipeline(
                ["draw_water", "light_water"],
                Some(BlendState::ALPHA_BLENDING),
            ),
            camera,
            columns,
        }
    }
}

/// One ground, drawn for one camera.
#[derive(Clone, Debug)]
pub struct GroundDrawing {
    uniform: Buffer,
    args: Buffer,
    camera: BindGroup,
    columns: BindGroup,
    radius_m: f64,
}

impl GroundDrawing {
    /// For a run's buffers.
    pub fn new(device: &Device, queue: &Queue, painter: &GroundPainter, run: &GroundRun) -> Self {
        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let uniform = buffer(device, "ground_camera", CAMERA_BYTES, uniform);
        let args = BufferUsages::INDIRECT | BufferUsages::COPY_DST;
        let args = buffer(device, "ground_triangles", 16, args);
        // Three corners an instance; how many, the end of a run tells.
        queue.write_buffer(&args, 0, &bytes_of(&[3, 0, 0, 0]));
        let columns = COLUMNS.iter().filter(|column| DRAWN.contains(&column.name));
        let columns = columns.filter_map(|column| {
            let resource = run.buffers().column(column.name)?.as_entire_binding();
            let binding = column.binding;
            Some(BindGroupEntry { binding, resource })
        });
        let columns: Vec<_> = columns.collect();
        let camera = [BindGroupEntry {
            binding: 1,
            resource: uniform.as_entire_binding(),
        }];
        Self {
            camera: group(device, &painter.camera, &camera),
            columns: group(device, &painter.columns, &columns),
            radius_m: f64::from(run.scale().radius_m),
            uniform,
            args,
        }
    }

    /// Records the end of a run of so many levels: what is drawn next has its triangles.
    pub fn finish(&self, encoder: &mut CommandEncoder, run: &GroundRun, levels: u32) {
        let row = u64::from(levels).min(LEVELS as u64 - 1) * size_of::<LevelSizes>() as u64;
        let at = row + core::mem::offset_of!(LevelSizes, first_triangle) as u64;
        if let Some(sizes) = run.buffers().column("level_sizes") {
            encoder.copy_buffer_to_buffer(sizes, at, &self.args, 4, 4);
        }
    }

    /// Writes the camera.
    pub fn look(&self, queue: &Queue, camera: &GroundCamera) {
        let words = camera.words(self.radius_m);
        queue.write_buffer(&self.uniform, 0, &bytes_of(&words));
    }

    /// Draws the ground, then its water.
    pub fn draw(&self, pass: &mut RenderPass, painter: &GroundPainter) {
        pass.set_bind_group(0, &self.camera, &[]);
        pass.set_bind_group(1, &self.columns, &[]);
        for pipeline in [&painter.ground, &painter.water] {
            pass.set_pipeline(pipeline);
            pass.draw_indirect(&self.args, 0);
        }
    }
}

fn buffer(device: &Device, label: &str, size: u64, usage: BufferUsages) -> Buffer {
    device.create_buffer(&BufferDescriptor {
        label: Some(label),
        size,
        usage,
        mapped_at_creation: false,
    })
}

fn group(device: &Device, layout: &BindGroupLayout, entries: &[BindGroupEntry]) -> BindGroup {
    device.create_bind_group(&BindGroupDescriptor {
        label: None,
        layout,
        entries,
    })
}

fn layout(device: &Device, entries: &[BindGroupLayoutEntry]) -> BindGroupLayout {
    device.create_bind_group_layout(&BindGroupLayoutDescriptor {
        label: None,
        entries,
    })
}

fn camera_entry() -> BindGroupLayoutEntry {
    entry(
        1,
        ShaderStages::VERTEX_FRAGMENT,
        BufferBindingType::Uniform,
        NonZeroU64::new(CAMERA_BYTES),
    )
}

fn column_entry(name: &str) -> Option<BindGroupLayoutEntry> {
    let column = column_named(name)?;
    let ty = BufferBindingType::Storage { read_only: true };
    let least = NonZeroU64::new(column.row.size as u64);
    Some(entry(column.binding, ShaderStages::VERTEX, ty, least))
}

fn entry(
    binding: u32,
    visibility: ShaderStages,
    ty: BufferBindingType,
    min_binding_size: Option<NonZeroU64>,
) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry {
        binding,
        visibility,
        ty: BindingType::Buffer {
            ty,
            has_dynamic_offset: false,
            min_binding_size,
        },
        count: None,
    }
}

fn pipeline(
    device: &Device,
    module: &ShaderModule,
    layout: &PipelineLayout,
    target: GroundTarget,
    [vertex, fragment]: [&str; 2],
    blend: Option<BlendState>,
) -> RenderPipeline {
    let colours = [Some(ColorTargetState {
        format: target.colour,
        blend,
        write_mask: ColorWrites::ALL,
    })];
    device.create_render_pipeline(&RenderPipelineDescriptor {
        label: Some(vertex),
        layout: Some(layout),
        vertex: VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: PrimitiveState {
            cull_mode: Some(Face::Back),
            ..Default::default()
        },
        depth_stencil: Some(DepthStencilState {
            format: target.depth,
            depth_write_enabled: Some(true),
            depth_compare: Some(CompareFunction::GreaterEqual),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: MultisampleState {
            count: target.samples,
            ..Default::default()
        },
        fragment: Some(FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: Default::default(),
            targets: &colours,
        }),
        multiview_mask: None,
        cache: None,
    })
}

const _: () = assert!(LevelSizes::LAYOUT.size == size_of::<LevelSizes>());
