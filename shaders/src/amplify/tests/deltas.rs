//! Rivers that part: the arms of a delta share the discharge to the last unit, at every level.

use super::*;
use crate::amplify::control::ControlMesh;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, Level, NONE};
use std::collections::BTreeMap;

/// Flows of the arms, Q16: unequal, and their squares do not sum to any river's.
const ARM_FLOWS: [u32; 2] = [3_001, 1_517];

/// A planet whose rivers part where two faces of the sea lie at their mouths.
fn planet_with_deltas(seed: u32) -> (Base, Vec<u32>) {
    let mut mesh = control_mesh(300_000, 3, seed);
    let edges = 0..mesh.edges.len() as u32;
    let mouths: Vec<u32> = edges.filter(|&e| is_mouth(&mesh, e)).collect();
    let apexes = mouths.into_iter().filter_map(|e| part(&mut mesh, e));
    let apexes = apexes.collect();
    (Base::new(&mesh).unwrap(), apexes)
}

/// Whether an edge leads a river into the sea.
fn is_mouth(mesh: &ControlMesh, e: u32) -> bool {
    let edge = &mesh.edges[e as usize];
    edge.river == 1 && kind(mesh, edge.vertices[1]) == VertexKind::Sea
}

fn kind(mesh: &ControlMesh, v: u32) -> VertexKind {
    VertexKind::from_number(mesh.vertices[v as usize].kind)
}

/// Lets the river of an edge into the sea run to two vertices of it, which become rivers; returns
/// the vertex where it parts.
fn part(mesh: &mut ControlMesh, main: u32) -> Option<u32> {
    let [apex, arm] = mesh.edges[main as usize].vertices;
    let faces = mesh.edges[main as usize]
        .faces
        .map(|f| mesh.faces[f as usize]);
    let around = faces.iter().flat_map(|f| f.edges);
    let second = around
        .filter(|&e| mesh.edges[e as usize].vertices.contains(&apex))
        .find(|&e| is_free(mesh, e, apex))?;
    let edge = &mut mesh.edges[second as usize];
    edge.river = 1;
    if edge.vertices[0] != apex {
        edge.vertices.swap(0, 1);
        edge.faces.swap(0, 1);
    }
    let ends = [arm, edge.vertices[1]];
    let bed = mesh.vertices[apex as usize].bed.min(0);
    for (end, flow) in ends.into_iter().zip(ARM_FLOWS) {
        let vertex = &mut mesh.vertices[end as usize];
        vertex.kind = VertexKind::River as u8;
        vertex.height = bed - 2048;
        vertex.bed = bed - 2048;
        vertex.water = 0;
        vertex.flow = flow;
    }
    Some(apex)
}

/// Whether an edge leads from a vertex to sea that no river reaches.
fn is_free(mesh: &ControlMesh, e: u32, from: u32) -> bool {
    let edge = &mesh.edges[e as usize];
    let other = edge.vertices[usize::from(edge.vertices[0] == from)];
    edge.river == 0 && kind(mesh, other) == VertexKind::Sea && !reached(mesh, other)
}

/// Whether a river ends at a vertex.
fn reached(mesh: &ControlMesh, v: u32) -> bool {
    let mut rivers = mesh.edges.iter().filter(|e| e.river == 1);
    rivers.any(|e| e.vertices.contains(&v))
}

/// The discharge that rivers of a level carry away from every vertex, and how many there are.
fn leaving(ground: &RefinedGround, level: &Level) -> BTreeMap<u32, (u64, usize)> {
    let mut sums = BTreeMap::new();
    for edge in level
        .mesh
        .edges
        .iter()
        .filter(|e| e.kind == EdgeKind::River)
    {
        let [up, _] = ground.vertices.gather(edge.vertices);
        let (sum, count) = sums.entry(edge.vertices[0]).or_insert((0, 0));
        *sum += u64::from(carried(up, edge));
        *count += 1;
    }
    sums
}

/// Discharge at the upper end of a river's edge.
fn carried(up: &Vertex, edge: &Edge) -> u32 {
    up.discharge.min(edge.arriving)
}

/// Places where rivers part, each with its planet.
fn parting() -> impl Iterator<Item = (Base, u32)> {
    let planets = (0..20).map(planet_with_deltas);
    planets.flat_map(|(base, apexes)| apexes.into_iter().map(move |apex| (base.clone(), apex)))
}

#[test]
fn arms_share_the_discharge_to_the_unit() {
    let mut parted = 0;
    for (base, apex) in parting() {
        let at = base.vertices[apex as usize].direction;
        let ground = refined(&base, &View::disc(at, 3_000, 6));
        for level in &ground.levels {
            let whole = |e: &&Edge| !e.faces.contains(&NONE);
            for (v, (sum, arms)) in leaving(&ground, level) {
                let vertex = &ground.vertices[v as usize];
                let mut around = level.mesh.edges.iter().filter(|e| e.vertices.contains(&v));
                if arms > 1 && around.all(|e| whole(&e)) {
                    assert_eq!(sum, u64::from(vertex.discharge), "{vertex:?}");
                    parted += 1;
                }
            }
        }
    }
    assert!(parted > 50, "{parted}");
}

#[test]
fn an_arm_carries_its_share_from_end_to_end() {
    let mut deltas = 0;
    for (base, apex) in parting() {
        let whole = base.vertices[apex as usize].discharge;
        let is_arm = |e: &&Edge| e.kind == EdgeKind::River && e.vertices[0] == apex;
        let arms = base.level.edges.iter().filter(is_arm);
        let shares: Vec<u32> = arms.map(|e| e.arriving).collect();
        assert_eq!(shares.len(), 2);
        assert_eq!(shares.iter().sum::<u32>(), whole);
        // As 3001² to 1517², in either order.
        let [more, less] = [shares[0].max(shares[1]), shares[0].min(shares[1])].map(f64::from);
        assert!((more / less / 3.913_47 - 1.0).abs() < 1e-3, "{more} {less}");
        deltas += 1;
    }
    assert!(deltas > 10, "{deltas}");
}
