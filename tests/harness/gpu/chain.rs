//! The passes of a level in one submission, with as many groups as the passes before them wrote:
//! nothing is read back between them.

use super::pass::{ColumnWords, PassCase, SIZES, assert_words, guarded, pipeline};
use super::{Gpu, each_pass};
use bevy::render::render_resource::{BindGroup, Buffer, BufferUsages, ComputePassDescriptor};
use pangaea_shaders::amplify::base::Base;
use pangaea_shaders::amplify::columns::{ComputePass, WRITTEN, column_named, pass_named};
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::rows::{LevelArgs, LevelCaps, LevelSizes, Row, words};
use pangaea_shaders::amplify::rules::Rules;
use pangaea_shaders::amplify::uniform::level_words;
use std::collections::BTreeMap;

/// The column of the dispatches' arguments.
const ARGS: &str = "level_args";

/// Asserts that the passes from marks to places, run as one, leave the words of their Rust twins on
/// every level of a run. Returns how many levels there were.
pub fn assert_chains(base: &Base, rules: &Rules, view: &View) -> usize {
    let Some(gpu) = Gpu::get() else { return 0 };
    let mut levels = 0;
    let mut chain = Chain::default();
    each_pass(base, rules, view, &mut |case| {
        if case.entry == "mark_split" {
            chain = Chain::default();
        }
        chain.add(case);
        if case.entry == "place_faces" {
            chain.assert(gpu, case);
            levels += 1;
        }
    });
    levels
}

/// Passes that run as one.
#[derive(Default)]
struct Chain {
    passes: Vec<ComputePass>,
    /// Columns before the first pass that has them.
    before: ColumnWords,
    /// Columns after the last pass that writes them.
    after: ColumnWords,
    /// Sizes of the level, as the first pass finds them.
    sizes: LevelSizes,
}

impl Chain {
    fn add(&mut self, case: &PassCase) {
        if self.passes.is_empty() {
            self.sizes = case.sizes;
        }
        let pass = pass_named(case.entry).expect(case.entry);
        for (&name, words) in &case.before {
            self.before.entry(name).or_insert_with(|| words.clone());
        }
        for (&name, words) in &case.after {
            self.after.insert(name, words.clone());
        }
        self.passes.push(pass);
    }

    /// Runs it and compares all columns that it writes. `last` is its last pass.
    fn assert(&mut self, gpu: &Gpu, last: &PassCase) {
        self.give_args(last.level as usize);
        let buffers = self.buffers(gpu);
        let uniform = level_words(last.sight, last.level, &last.rules, &LevelCaps::default());
        let uniform = gpu.upload(&uniform, BufferUsages::UNIFORM);
        let bound = self.passes.iter().map(|pass| {
            let pipeline = pipeline(gpu, pass);
            let groups = bind(gpu, pass, &uniform, &buffers);
            (pass, pipeline, groups)
        });
        let bound: Vec<_> = bound.collect();
        let mut encoder = gpu.encoder();
        let mut compute = encoder.begin_compute_pass(&ComputePassDescriptor::default());
        for (pass, pipeline, [common, columns]) in &bound {
            compute.set_pipeline(pipeline);
            compute.set_bind_group(0, &**common, &[]);
            compute.set_bind_group(1, &**columns, &[]);
            match args_at(pass.entry, last.level) {
                Some(at) => compute.dispatch_workgroups_indirect(&buffers[ARGS], at),
                None => compute.dispatch_workgroups(1, 1, 1),
            }
        }
        drop(compute);
        gpu.submit(encoder);
        let names: Vec<&str> = self.after.keys().copied().collect();
        let found: Vec<&Buffer> = names.iter().map(|name| &buffers[name]).collect();
        for (name, found) in names.iter().zip(gpu.download(&found)) {
            let column = column_named(name).expect(name);
            assert_words("a chain", last, column, &found, &self.after[name]);
        }
    }

    /// The groups of the level, which the level before wrote.
    fn give_args(&mut self, level: usize) {
        let row = LevelArgs::LAYOUT.size / 4;
        let place = level * row..(level + 1) * row;
        let known = words([LevelArgs::new(&self.sizes)]);
        let args = self.before.get_mut(ARGS).expect("a chain scans");
        args[place].copy_from_slice(&known);
    }

    fn buffers(&self, gpu: &Gpu) -> BTreeMap<&'static str, Buffer> {
        let usage = |name| {
            let all = BufferUsages::STORAGE | BufferUsages::COPY_SRC;
            match name {
                SIZES => all | BufferUsages::UNIFORM,
                ARGS => all | BufferUsages::INDIRECT,
                _ => all,
            }
        };
        let columns = self.before.iter();
        let columns = columns.map(|(&name, words)| {
            let buffer = gpu.upload(&guarded(words), usage(name));
            (name, buffer)
        });
        columns.collect()
    }
}

/// The groups of bindings of a pass.
fn bind(
    gpu: &Gpu,
    pass: &ComputePass,
    uniform: &Buffer,
    buffers: &BTreeMap<&'static str, Buffer>,
) -> [BindGroup; 2] {
    let pipeline = pipeline(gpu, pass);
    let binding = |name: &&'static str| column_named(name).expect(name).binding;
    let reads = pass
        .reads
        .iter()
        .map(|name| (binding(name), &buffers[name]));
    let writes = pass.writes.iter();
    let writes = writes.map(|name| (binding(name) + WRITTEN, &buffers[name]));
    let columns: Vec<_> = reads.chain(writes).collect();
    [
        gpu.group(&pipeline, 0, &[(0, uniform)]),
        gpu.group(&pipeline, 1, &columns),
    ]
}

/// Where the arguments of a pass lie, bytes; `None` for the one that runs one group.
fn args_at(entry: &str, level: u32) -> Option<u64> {
    let member = match entry {
        "mark_split" | "mark_halo" => "faces",
        "count_edges" | "place_edges" => "edge_blocks",
        "count_faces" | "place_faces" => "face_blocks",
        _ => return None,
    };
    let layout = LevelArgs::LAYOUT;
    let mut members = layout.members.iter();
    let &(_, offset, _) = members.find(|(name, ..)| *name == member)?;
    Some((level as usize * layout.size + offset) as u64)
}
