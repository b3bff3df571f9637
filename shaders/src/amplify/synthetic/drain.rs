//! Rivers and lakes of the made-up planet, by a priority flood from the sea (R. Barnes et al.,
//! Priority-flood, 2014).

use crate::amplify::control::{ControlMesh, ControlVertex, VertexKind};
use crate::amplify::fixed::{GRAINS, Q16, metres};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Runoff of a vertex of a desert, 2⁻³² of 200,000 m³/s.
const RUNOFF: u64 = 300_000;

/// Runoff that every 2⁻¹⁶ of wetness adds to it.
const RUNOFF_PER_WETNESS: u64 = 20;

/// Discharge from which on water is a river.
const RIVER_DISCHARGE: u64 = 8_000_000;

/// Depth of the least river, grains.
const LEAST_DEPTH: i32 = metres(2);

/// Bed of the sea at a river's mouth, grains.
const MOUTH_BED: i32 = -2_000;

/// Least fall of a river's bed from vertex to vertex, grains.
const LEAST_FALL: i32 = metres(2);

/// Least fall of a river's water from vertex to vertex, grains.
const LEAST_WATER_FALL: i32 = GRAINS / 64;

/// Lays rivers with falling beds along the ways down to the sea, and lakes into the depressions.
pub(super) fn drain(mesh: &mut ControlMesh) {
    for vertex in &mut mesh.vertices {
        if is_sea(vertex) {
            vertex.water = 0;
        }
    }
    let flooded = flood(mesh);
    let discharge = accumulate(mesh, &flooded);
    for &v in &flooded.order {
        if !is_sea(&mesh.vertices[v]) && discharge[v] > RIVER_DISCHARGE {
            lay_river(mesh, &flooded, v, discharge[v]);
        }
    }
}

const fn is_sea(vertex: &ControlVertex) -> bool {
    vertex.kind == VertexKind::Sea as u8
}

/// Ways down to the sea.
struct Flooded {
    /// Vertices, each after the one it drains to.
    order: Vec<usize>,
    /// The vertex that each drains to, and the edge there.
    receiver: Vec<(usize, usize)>,
    /// Least height from which water reaches the sea, grains.
    level: Vec<i32>,
}

/// Neighbours of every vertex, and the edges there.
fn neighbours(mesh: &ControlMesh) -> Vec<Vec<(usize, usize)>> {
    let mut around = vec![Vec::new(); mesh.vertices.len()];
    for (i, edge) in mesh.edges.iter().enumerate() {
        let [a, b] = edge.vertices.map(|v| v as usize);
        around[a].push((b, i));
        around[b].push((a, i));
    }
    around
}

impl Flooded {
    /// The sea alone: all land is still to be reached.
    fn sea(mesh: &ControlMesh) -> Self {
        let dry = |vertex| if is_sea(vertex) { 0 } else { i32::MAX };
        Self {
            order: Vec::new(),
            receiver: vec![(usize::MAX, 0); mesh.vertices.len()],
            level: mesh.vertices.iter().map(dry).collect(),
        }
    }
}

fn flood(mesh: &ControlMesh) -> Flooded {
    let around = neighbours(mesh);
    let mut flooded = Flooded::sea(mesh);
    let sea = (0..).zip(&mesh.vertices).filter(|(_, v)| is_sea(v));
    let mut heap: BinaryHeap<_> = sea.map(|(i, v)| Reverse((v.height, i))).collect();
    // The lowest way in comes first, so every vertex drains to where it was reached from.
    while let Some(Reverse((height, v))) = heap.pop() {
        flooded.order.push(v);
        for &(w, edge) in &around[v] {
            if flooded.level[w] == i32::MAX {
                flooded.level[w] = mesh.vertices[w].height.max(height.max(0));
                flooded.receiver[w] = (v, edge);
                heap.push(Reverse((flooded.level[w], w)));
            }
        }
    }
    flooded
}

/// Discharge of every vertex: its own runoff and all that drains to it.
fn accumulate(mesh: &ControlMesh, flooded: &Flooded) -> Vec<u64> {
    let mut discharge = vec![0; mesh.vertices.len()];
    // From the last reached to the sea: each is done before the one it drains to.
    for &v in flooded.order.iter().rev() {
        let vertex = &mesh.vertices[v];
        if !is_sea(vertex) {
            discharge[v] += RUNOFF + u64::from(vertex.wetness) * RUNOFF_PER_WETNESS;
            discharge[flooded.receiver[v].0] += discharge[v];
        }
    }
    discharge
}

/// Makes a vertex a river or a lake, and its way down a river's edge. The vertex below is done.
fn lay_river(mesh: &mut ControlMesh, flooded: &Flooded, v: usize, discharge: u64) {
    let (down, edge) = flooded.receiver[v];
    let lower = mesh.vertices[down];
    let edge = &mut mesh.edges[edge];
    if edge.vertices[0] != v as u32 {
        edge.vertices.swap(0, 1);
        edge.faces.swap(0, 1);
    }
    edge.river = 1;
    let vertex = &mut mesh.vertices[v];
    vertex.flow = flow(discharge);
    if flooded.level[v] > vertex.height {
        vertex.kind = VertexKind::Lake as u8;
        vertex.bed = vertex.height;
        vertex.water = flooded.level[v];
        return;
    }
    lay_bed(vertex, &lower);
}

/// Flow φ of a discharge, Q16.
fn flow(discharge: u64) -> u32 {
    let root = (discharge.min(u64::from(u32::MAX)) as f64).sqrt() as u32;
    root.min(Q16 as u32 - 1)
}

/// Lays the bed of a river above the vertex below it.
fn lay_bed(vertex: &mut ControlVertex, lower: &ControlVertex) {
    let depth = LEAST_DEPTH + (vertex.flow as i32) * 40 / 64;
    let floor = if is_sea(lower) { MOUTH_BED } else { lower.bed };
    vertex.kind = VertexKind::River as u8;
    vertex.bed = (vertex.height - depth).max(floor + LEAST_FALL);
    vertex.water = (vertex.bed + depth).max(lower.water.max(0) + LEAST_WATER_FALL);
    vertex.height = vertex.height.max(vertex.water);
}
