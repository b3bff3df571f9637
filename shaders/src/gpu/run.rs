//! A run over all levels, recorded into a command encoder.

use super::base::BaseRows;
use super::bindings::{TurnGroups, columns, turn, uniforms};
use super::buffers::{GroundBuffers, bytes_of};
use super::pipelines::{GroundPipelines, UNIFORM_BYTES};
use crate::amplify::columns::PASSES;
use crate::amplify::ground::FINEST;
use crate::amplify::mark::View;
use crate::amplify::rows::level::GROUP;
use crate::amplify::rows::{LevelArgs, LevelSizes, from_words};
use crate::amplify::rules::Rules;
use crate::amplify::scale::PlanetScale;
use crate::amplify::sight::Sight;
use crate::amplify::uniform::level_words;
use core::ops::RangeInclusive;
use wgpu::{BindGroup, CommandEncoder, ComputePass, ComputePassDescriptor, Device, Queue};

/// Passes of a level with the place of their groups in [`LevelArgs`], bytes; a pass without one runs
/// as one group. Those after the triangles grow the next level.
const LEVEL_PASSES: [(&str, Option<u64>); 16] = [
    ("mark_split", Some(FACES)),
    ("mark_halo", Some(FACES)),
    ("count_edges", Some(EDGE_BLOCKS)),
    ("count_faces", Some(FACE_BLOCKS)),
    ("scan", None),
    ("place_edges", Some(EDGE_BLOCKS)),
    ("place_faces", Some(FACE_BLOCKS)),
    ("edge_split", Some(HALVED)),
    ("face_decide", Some(DECIDED)),
    ("vertex_resolve", Some(HALVED)),
    ("carve_all", Some(HALVED)),
    ("show_all", Some(HALVED)),
    ("emit_leaves", Some(FACE_BLOCKS)),
    ("grow_halves", Some(HALVED)),
    ("grow_inner", Some(DECIDED)),
    ("grow_faces", Some(DECIDED)),
];

/// Dispatches of a level.
pub const LEVEL_DISPATCHES: usize = LEVEL_PASSES.len();

const FACES: u64 = core::mem::offset_of!(LevelArgs, faces) as u64;
const EDGE_BLOCKS: u64 = core::mem::offset_of!(LevelArgs, edge_blocks) as u64;
const FACE_BLOCKS: u64 = core::mem::offset_of!(LevelArgs, face_blocks) as u64;
const HALVED: u64 = core::mem::offset_of!(LevelArgs, halved) as u64;
const DECIDED: u64 = core::mem::offset_of!(LevelArgs, decided) as u64;

/// The ground of one planet on a GPU: its buffers, and the runs that fill them.
#[derive(Clone, Debug)]
pub struct GroundRun {
    pipelines: GroundPipelines,
    buffers: GroundBuffers,
    columns: TurnGroups,
    uniforms: Vec<BindGroup>,
    scale: PlanetScale,
}

impl GroundRun {
    /// The ground of a control mesh whose rows are in the buffers.
    pub fn new(
        device: &Device,
        pipelines: &GroundPipelines,
        buffers: GroundBuffers,
        base: &BaseRows,
    ) -> Self {
        Self {
            columns: columns(device, pipelines, &buffers),
            uniforms: uniforms(device, pipelines, &buffers),
            pipelines: pipelines.clone(),
            buffers,
            scale: base.scale,
        }
    }

    /// Its buffers.
    pub const fn buffers(&self) -> &GroundBuffers {
        &self.buffers
    }

    /// The planet's constants.
    pub const fn scale(&self) -> &PlanetScale {
        &self.scale
    }

    /// Writes a view and rules; the levels that are recorded next have them. Returns how many levels
    /// there are.
    pub fn set(&self, queue: &Queue, view: &View, rules: &Rules) -> u32 {
        let sight = Sight::new(&self.scale, view);
        for (level, uniform) in (0..).zip(&self.buffers.uniforms) {
            let words = level_words(&sight, level, rules, &self.buffers.caps);
            debug_assert_eq!(size_of_val(&words) as u64, UNIFORM_BYTES);
            queue.write_buffer(uniform, 0, &bytes_of(&words));
        }
        view.level.min(FINEST) + 1
    }

    /// Records what a new control mesh needs, once: the final ground of its vertices.
    pub fn carve_base(&self, encoder: &mut CommandEncoder) {
        self.begin(encoder);
        self.over_base(encoder, "carve_base");
    }

    /// Records the beginning of a run: level 0 as it is, and what the view shows of it.
    pub fn start(&self, encoder: &mut CommandEncoder) {
        self.begin(encoder);
        self.over_base(encoder, "show_base");
    }

    /// Gives level 0 its sizes and groups.
    fn begin(&self, encoder: &mut CommandEncoder) {
        for (from, name) in self.buffers.start.iter().zip(["level_sizes", "level_args"]) {
            if let Some(to) = self.buffers.column(name) {
                encoder.copy_buffer_to_buffer(from, 0, to, 0, from.size());
            }
        }
    }

    /// Runs a pass over the vertices of the control mesh.
    fn over_base(&self, encoder: &mut CommandEncoder, entry: &str) {
        let groups = self.buffers.base.first_vertex.div_ceil(GROUP as u32);
        let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor::default());
        if self.bind(&mut pass, entry, 0) {
            pass.dispatch_workgroups(groups, 1, 1);
        }
    }

    /// Records some levels, in order: a run may be spread over frames.
    pub fn levels(&self, encoder: &mut CommandEncoder, levels: RangeInclusive<u32>) {
        let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor::default());
        for level in levels {
            self.level(&mut pass, level);
        }
    }

    fn level(&self, pass: &mut ComputePass, level: u32) {
        let Some(args) = self.buffers.column("level_args") else {
            return;
        };
        let row = u64::from(level) * size_of::<LevelArgs>() as u64;
        for (entry, groups) in LEVEL_PASSES {
            if !self.bind(pass, entry, level) {
                continue;
            }
            match groups {
                Some(at) => pass.dispatch_workgroups_indirect(args, row + at),
                None => pass.dispatch_workgroups(1, 1, 1),
            }
        }
    }

    /// Makes a pass the one that is dispatched next.
    fn bind(&self, pass: &mut ComputePass, entry: &str, level: u32) -> bool {
        let at = PASSES.iter().position(|pass| pass.entry == entry);
        let (Some(at), Some(pipeline)) = (at, self.pipelines.named(entry)) else {
            return false;
        };
        pass.set_pipeline(&pipeline.pipeline);
        pass.set_bind_group(0, &self.uniforms[level as usize], &[]);
        pass.set_bind_group(1, &self.columns[at][turn(level)], &[]);
        true
    }

    /// Sizes of all levels from the words of the column `level_sizes`, which was read back after a
    /// run.
    pub fn sizes(words: &[u32]) -> Vec<LevelSizes> {
        from_words(words)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pass_runs_once_a_level_or_once_a_mesh() {
        let of_level = LEVEL_PASSES.map(|(entry, _)| entry);
        let of_mesh = ["carve_base", "show_base"];
        let known = |entry: &str| of_level.contains(&entry) || of_mesh.contains(&entry);
        assert!(PASSES.iter().all(|pass| known(pass.entry)));
        assert_eq!(PASSES.len(), LEVEL_PASSES.len() + of_mesh.len());
    }
}
