//! A whole run on a GPU, beside the same on the CPU.

use super::Gpu;
use bevy::render::render_resource::Buffer;
use pangaea_shaders::amplify::base::Base;
use pangaea_shaders::amplify::carve::carve_all;
use pangaea_shaders::amplify::emit::emit_leaves;
use pangaea_shaders::amplify::ground::{Caps, RefinedGround, refine};
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::rows::{LevelSizes, Row, VertexCore, VertexRiver, words};
use pangaea_shaders::amplify::rules::Rules;
use pangaea_shaders::amplify::show::show_all;
use pangaea_shaders::gpu::{BaseRows, GroundBuffers, GroundCaps, GroundPipelines, GroundRun};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// The ground of a planet on the GPU of this process.
pub struct WholeGround<'a> {
    gpu: &'static Gpu,
    base: &'a Base,
    run: GroundRun,
}

/// What a run has left.
pub struct FinishedRun {
    /// Vertices, the control mesh's among them.
    pub vertices: usize,
    /// Corners of all triangles.
    pub triangles: Vec<[u32; 3]>,
}

impl<'a> WholeGround<'a> {
    /// The ground of a control mesh in buffers of some caps; `None` without an adapter.
    pub fn new(base: &'a Base, caps: &GroundCaps) -> Option<Self> {
        static PIPELINES: OnceLock<GroundPipelines> = OnceLock::new();
        let gpu = Gpu::get()?;
        let (device, queue) = gpu.wgpu();
        let make = || GroundPipelines::new(device).expect("the passes compile");
        let pipelines = PIPELINES.get_or_init(make);
        let rows = BaseRows::new(base);
        let buffers = GroundBuffers::new(device, queue, &rows, caps);
        let run = GroundRun::new(device, pipelines, buffers.expect("buffers"), &rows);
        let ground = Self { gpu, base, run };
        ground.set(&View::whole(0), &Rules::default());
        let mut encoder = gpu.encoder();
        ground.run.carve_base(&mut encoder);
        gpu.submit(encoder);
        Some(ground)
    }

    fn set(&self, view: &View, rules: &Rules) -> u32 {
        self.run.set(self.gpu.wgpu().1, view, rules)
    }

    /// Runs for a view.
    pub fn run(&self, view: &View, rules: &Rules) -> FinishedRun {
        let levels = self.set(view, rules);
        let mut encoder = self.gpu.encoder();
        self.run.start(&mut encoder);
        self.run.levels(&mut encoder, 0..=levels - 1);
        self.gpu.submit(encoder);
        let sizes: Vec<LevelSizes> = GroundRun::sizes(&self.column("level_sizes"));
        let last = sizes[levels as usize];
        let corners = self.column("triangles");
        let triangles = corners.chunks(3).map(|c| [c[0], c[1], c[2]]);
        FinishedRun {
            vertices: last.first_vertex as usize,
            triangles: triangles.take(last.first_triangle as usize).collect(),
        }
    }

    /// Asserts that a run for a view leaves the vertices, the triangles and the shown ground of the
    /// CPU. Returns the triangles.
    pub fn assert_run(&self, view: &View, rules: &Rules) -> Vec<[u32; 3]> {
        let found = self.run(view, rules);
        let wanted = refine(self.base, rules, view, &Caps::default());
        assert_eq!(found.vertices, wanted.vertices.len());
        let vertices = &wanted.vertices;
        self.assert_column("vertex_cores", vertices.iter().map(VertexCore::from));
        self.assert_column("vertex_rivers", vertices.iter().map(VertexRiver::from));
        let scale = &self.base.scale;
        let carved = carve_all(scale, rules, vertices);
        let shown = show_all(scale, rules, view, vertices, &carved);
        self.assert_column("shown", shown);
        let finer = finer_triangles(&wanted);
        let (coarse, found_finer) = found
            .triangles
            .split_at(found.triangles.len() - finer.len());
        assert!(found_finer == finer, "triangles of finer levels");
        // Level 0 is whole on a GPU.
        let level = &wanted.levels[0];
        let unseen = level.mesh.faces.len() - level.items.faces.len();
        assert_eq!(
            coarse.len(),
            wanted.triangles().len() - finer.len() + unseen
        );
        found.triangles
    }

    fn assert_column<R: Row>(&self, name: &str, wanted: impl IntoIterator<Item = R>) {
        let found = self.column(name);
        let wanted = words(wanted);
        let differs = wanted.iter().zip(&found).position(|(a, b)| a != b);
        assert_eq!(differs, None, "{name}");
    }

    fn column(&self, name: &str) -> Vec<u32> {
        let buffer = self.run.buffers().column(name).expect(name).clone();
        let words = self.gpu.download(&[&Buffer::from(buffer)]);
        words.into_iter().next().expect("one buffer")
    }
}

/// The triangles of all levels but the first, as the CPU has them.
fn finer_triangles(ground: &RefinedGround) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    for (index, level) in (0..).zip(&ground.levels).skip(1) {
        let view = ground.vertices.view();
        emit_leaves(index, level, view, &level.items.faces, &mut triangles);
    }
    triangles.iter().map(|triangle| triangle.vertices).collect()
}

/// Asserts that triangles are a closed surface: every edge is used once each way.
pub fn assert_is_closed(triangles: &[[u32; 3]]) {
    let mut uses: BTreeMap<[u32; 2], i32> = BTreeMap::new();
    for corners in triangles {
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            let way = if a < b { 1 } else { -1 };
            *uses.entry([a.min(b), a.max(b)]).or_default() += way;
        }
    }
    let open = uses.values().filter(|&&uses| uses != 0).count();
    assert_eq!(open, 0, "open edges");
}
