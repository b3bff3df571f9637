//! Which columns a pass binds on a level.

use super::buffers::GroundBuffers;
use super::pipelines::{GroundPipelines, PassPipeline};
use crate::amplify::columns::{WRITTEN, column_named};
use wgpu::{BindGroup, BindGroupDescriptor, BindGroupEntry, Buffer, Device};

/// A level's own columns, and the next level's: those of the control mesh and the first of two, or
/// these in turn.
pub(super) const TURNS: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 1]];

/// The turn of a level.
pub(super) const fn turn(level: u32) -> usize {
    match level {
        0 => 0,
        _ => 2 - (level % 2) as usize,
    }
}

/// Bound columns of all passes, in the order of the pipelines, for each turn.
pub(super) type TurnGroups = Vec<[BindGroup; 3]>;

/// The bound columns of all passes.
pub(super) fn columns(
    device: &Device,
    pipelines: &GroundPipelines,
    buffers: &GroundBuffers,
) -> TurnGroups {
    let of_pass = |pass| TURNS.map(|turn| group(device, pass, buffers, turn));
    pipelines.passes.iter().map(of_pass).collect()
}

/// The bound uniforms of all levels.
pub(super) fn uniforms(
    device: &Device,
    pipelines: &GroundPipelines,
    buffers: &GroundBuffers,
) -> Vec<BindGroup> {
    let bind = |buffer| uniform(device, pipelines, buffer);
    buffers.uniforms.iter().map(bind).collect()
}

fn uniform(device: &Device, pipelines: &GroundPipelines, buffer: &Buffer) -> BindGroup {
    device.create_bind_group(&BindGroupDescriptor {
        label: Some("level_uniform"),
        layout: &pipelines.common,
        entries: &[BindGroupEntry {
            binding: 0,
            resource: buffer.as_entire_binding(),
        }],
    })
}

fn group(
    device: &Device,
    pass: &PassPipeline,
    buffers: &GroundBuffers,
    turn: [usize; 2],
) -> BindGroup {
    let reads = pass.pass.reads.iter().map(|&name| (name, 0));
    let writes = pass.pass.writes.iter().map(|&name| (name, WRITTEN));
    let all = reads.chain(writes);
    let all = all.filter_map(|(name, offset)| column(buffers, turn, name, offset));
    let all: Vec<_> = all.collect();
    device.create_bind_group(&BindGroupDescriptor {
        label: Some(pass.pass.entry),
        layout: &pass.columns,
        entries: &all,
    })
}

/// The binding of a column on a turn.
fn column<'a>(
    buffers: &'a GroundBuffers,
    turn: [usize; 2],
    name: &str,
    offset: u32,
) -> Option<BindGroupEntry<'a>> {
    let binding = column_named(name)?.binding + offset;
    let resource = buffer(buffers, name, turn)?.as_entire_binding();
    Some(BindGroupEntry { binding, resource })
}

/// The buffer of a column on a turn.
fn buffer<'a>(buffers: &'a GroundBuffers, name: &str, turn: [usize; 2]) -> Option<&'a Buffer> {
    let [own, finer] = turn;
    match name.strip_prefix("finer_") {
        Some(name) => buffers.of_level[finer].get(name),
        None => buffers.of_level[own]
            .get(name)
            .or_else(|| buffers.shared.get(name)),
    }
}
