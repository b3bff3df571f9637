//! A made-up control mesh for tests, benches and examples: a jittered icosphere with continents,
//! rivers and lakes.
//!
//! No geology: heights are a few smooth waves and bumps, drained by a priority flood.

use super::control::{ControlEdge, ControlFace, ControlMesh, ControlVertex, VertexKind};
use super::fixed::{GRAINS, ONE, Q16};
use super::seed::{draw, pcg, share};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

/// A planet of 20·4^`depth` faces and a radius in metres.
pub fn control_mesh(radius_m: u32, depth: u32, seed: u32) -> ControlMesh {
    let (points, triangles) = icosphere(depth);
    let points = jitter(&points, &triangles, seed);
    let (edges, faces) = connect(&triangles);
    let vertices = points
        .iter()
        .enumerate()
        .map(|(i, &p)| vertex(p, pcg(seed ^ pcg(i as u32)), seed))
        .collect();
    let mut mesh = ControlMesh {
        radius_m,
        vertices,
        edges,
        faces,
    };
    drain(&mut mesh);
    mesh
}

type UnitVector = [f64; 3];

fn unit(p: UnitVector) -> UnitVector {
    let n = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    p.map(|x| x / n)
}

fn icosphere(depth: u32) -> (Vec<UnitVector>, Vec<[u32; 3]>) {
    let g = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut points = Vec::new();
    for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
        points.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]].map(unit));
    }
    let distance = |i: usize, j: usize| {
        (0..3)
            .map(|k| (points[i][k] - points[j][k]).powf2())
            .sum::<f64>()
    };
    let mut triangles = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if distance(i, j) < 1.2 && distance(j, k) < 1.2 && distance(k, i) < 1.2 {
                    let t = [i as u32, j as u32, k as u32];
                    triangles.push(if facing(t.map(|v| points[v as usize])) > 0.0 {
                        t
                    } else {
                        [t[0], t[2], t[1]]
                    });
                }
            }
        }
    }
    for _ in 0..depth {
        let mut middles = BTreeMap::new();
        let mut middle = |a: u32, b: u32, points: &mut Vec<UnitVector>| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let (p, q) = (points[a as usize], points[b as usize]);
                points.push(unit([p[0] + q[0], p[1] + q[1], p[2] + q[2]]));
                points.len() as u32 - 1
            })
        };
        let mut finer = Vec::with_capacity(triangles.len() * 4);
        for [a, b, c] in triangles {
            let m = [
                middle(a, b, &mut points),
                middle(b, c, &mut points),
                middle(c, a, &mut points),
            ];
            finer.extend([[a, m[0], m[2]], [b, m[1], m[0]], [c, m[2], m[1]], m]);
        }
        triangles = finer;
    }
    (points, triangles)
}

trait Square {
    fn powf2(self) -> Self;
}

impl Square for f64 {
    fn powf2(self) -> Self {
        self * self
    }
}

/// Positive where three points turn counter-clockwise seen from outside.
pub fn facing([a, b, c]: [UnitVector; 3]) -> f64 {
    let (u, v) = (
        [0, 1, 2].map(|i| b[i] - a[i]),
        [0, 1, 2].map(|i| c[i] - a[i]),
    );
    let n = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    n[0] * a[0] + n[1] * a[1] + n[2] * a[2]
}

/// Moves every point by up to a fifth of an edge towards or from two of its neighbours.
fn jitter(points: &[UnitVector], triangles: &[[u32; 3]], seed: u32) -> Vec<UnitVector> {
    let mut moved = points.to_vec();
    let mut done = vec![false; points.len()];
    for t in triangles {
        for k in 0..3 {
            let v = t[k] as usize;
            if !std::mem::replace(&mut done[v], true) {
                let random = |i| f64::from(share(pcg(seed ^ t[k]), i)) / 65_536.0 - 0.5;
                let (a, b) = (
                    points[t[(k + 1) % 3] as usize],
                    points[t[(k + 2) % 3] as usize],
                );
                let (x, y) = (random(1) * 0.45, random(2) * 0.45);
                moved[v] =
                    unit([0, 1, 2].map(|i| {
                        points[v][i] + x * (a[i] - points[v][i]) + y * (b[i] - points[v][i])
                    }));
            }
        }
    }
    moved
}

fn connect(triangles: &[[u32; 3]]) -> (Vec<ControlEdge>, Vec<ControlFace>) {
    let mut index = BTreeMap::new();
    let mut edges: Vec<ControlEdge> = Vec::new();
    let mut faces = Vec::new();
    for (f, &t) in triangles.iter().enumerate() {
        let made = [0, 1, 2].map(|k| {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            let e = *index.entry((a.min(b), a.max(b))).or_insert_with(|| {
                edges.push(ControlEdge {
                    vertices: [a, b],
                    faces: [f as u32, u32::MAX],
                    river: 0,
                });
                edges.len() - 1
            });
            if edges[e].vertices != [a, b] {
                edges[e].faces[1] = f as u32;
            }
            e as u32
        });
        faces.push(ControlFace {
            vertices: t,
            edges: made,
        });
    }
    (edges, faces)
}

fn vertex(p: UnitVector, seed: u32, planet: u32) -> ControlVertex {
    // Three waves of random direction make continents; a share of noise makes depressions.
    let mut wave = -0.15;
    for k in 0..6 {
        let f = 1.5 + f64::from(k);
        let d = [0, 1, 2].map(|i| f64::from(share(planet, 10 * k + i)) / 32_768.0 - 1.0);
        let x = f * (p[0] * d[0] + p[1] * d[1] + p[2] * d[2]) + f64::from(k);
        let x = x - x.floor();
        wave += (16.0 * x * (1.0 - x) * (1.0 - 2.0 * x)) / (1.0 + f64::from(k));
    }
    let noise = f64::from(share(seed, 3)) / 65_536.0;
    let height = (wave * 1500.0 + noise * 250.0 + 0.01) * f64::from(GRAINS);
    let land = height > 0.0;
    let q16 = |x: f64| (x.clamp(0.0, 1.0) * 65_535.0) as u16;
    ControlVertex {
        direction: p.map(|x| (x * f64::from(ONE)).round() as i32),
        seed,
        height: height as i32,
        bed: height as i32,
        water: height as i32,
        flow: 0,
        crust: if land {
            height as i32 * 2 + 300 * GRAINS
        } else {
            height as i32
        },
        kind: if land {
            VertexKind::Terrain
        } else {
            VertexKind::Sea
        } as u8,
        valley: (draw(seed, 4) & 3) as u8,
        age: (share(planet, 77) + (p[0] * 3000.0) as i32).clamp(0, 60_000) as u16,
        collision: q16(p[1]),
        wetness: q16(0.5 + p[2]),
        plateau: q16(p[0] * p[1]),
        hills: q16(p[1] - p[2]),
        oceanic: if land { 0 } else { u16::MAX },
        ocean_age: q16(p[0] + 0.5),
        fold: [0; 3],
        ridge: [0; 3],
    }
}

/// Priority flood from the sea: receivers, discharge, river edges with falling beds, lakes in the
/// depressions.
fn drain(mesh: &mut ControlMesh) {
    let n = mesh.vertices.len();
    let mut around = vec![Vec::new(); n];
    for (i, edge) in mesh.edges.iter().enumerate() {
        let [a, b] = edge.vertices;
        around[a as usize].push((b as usize, i));
        around[b as usize].push((a as usize, i));
    }
    let mut receiver = vec![(usize::MAX, 0); n];
    let mut level = vec![i32::MAX; n];
    let mut heap = BinaryHeap::new();
    for (v, vertex) in mesh.vertices.iter_mut().enumerate() {
        if vertex.kind == VertexKind::Sea as u8 {
            (vertex.water, level[v]) = (0, 0);
            heap.push(Reverse((vertex.height, v)));
        }
    }
    let mut order = Vec::new();
    while let Some(Reverse((h, v))) = heap.pop() {
        order.push(v);
        for &(w, e) in &around[v] {
            if level[w] == i32::MAX {
                level[w] = mesh.vertices[w].height.max(h.max(0));
                receiver[w] = (v, e);
                heap.push(Reverse((level[w], w)));
            }
        }
    }
    let mut discharge = vec![0_u64; n];
    for &v in order.iter().rev() {
        if mesh.vertices[v].kind != VertexKind::Sea as u8 {
            discharge[v] += 300_000 + u64::from(mesh.vertices[v].wetness) * 20;
            discharge[receiver[v].0] += discharge[v];
        }
    }
    let river = |v: usize| discharge[v] > 8_000_000;
    for &v in &order {
        let (down, edge) = receiver[v];
        if mesh.vertices[v].kind == VertexKind::Sea as u8 || !river(v) {
            continue;
        }
        let lower = mesh.vertices[down];
        let made = &mut mesh.edges[edge];
        if made.vertices[0] != v as u32 {
            made.vertices.swap(0, 1);
            made.faces.swap(0, 1);
        }
        made.river = 1;
        let vertex = &mut mesh.vertices[v];
        vertex.flow =
            ((discharge[v].min(u64::from(u32::MAX)) as f64).sqrt() as u32).min(Q16 as u32 - 1);
        let depth = 2 * GRAINS + (vertex.flow as i32) * 40 / 64;
        if level[v] > vertex.height {
            vertex.kind = VertexKind::Lake as u8;
            (vertex.bed, vertex.water) = (vertex.height, level[v]);
        } else {
            vertex.kind = VertexKind::River as u8;
            let floor = if lower.kind == VertexKind::Sea as u8 {
                -2000
            } else {
                lower.bed
            };
            let water = lower.water.max(0);
            vertex.bed = (vertex.height - depth).max(floor + 2048);
            vertex.water = (vertex.bed + depth).max(water + 16);
            vertex.height = vertex.height.max(vertex.water);
        }
    }
}
