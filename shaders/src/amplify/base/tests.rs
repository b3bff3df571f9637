//! Level 0 by its short cuts is level 0 by the long way.

use super::*;
use crate::amplify::control::VertexKind;
use crate::amplify::rules::EdgeKind;
use crate::amplify::seed::pcg;
use crate::amplify::synthetic::control_mesh;
use crate::amplify::topology::{Edge, NONE, gather};
use crate::amplify::vertex::{FAR, RiverSegment};

fn mesh() -> ControlMesh {
    control_mesh(300_000, 3, 7)
}

/// The first fault of a mesh, item by item.
fn first_fault(mesh: &ControlMesh) -> Result<(), BadMesh> {
    check::size(mesh)?;
    let misfit = mesh.vertices.iter().position(|v| !check::vertex_fits(v));
    misfit.map_or(Ok(()), |i| Err(BadMesh::Vertex(i as u32)))?;
    check::faces(mesh)?;
    check::edges(mesh)
}

/// Damages an item of a mesh.
fn damage(mesh: &mut ControlMesh, k: u32) {
    let [vertex, edge, face] =
        [mesh.vertices.len(), mesh.edges.len(), mesh.faces.len()].map(|n| pcg(k) as usize % n);
    let number = pcg(k ^ 1) % mesh.edges.len() as u32;
    match k % 8 {
        0 => mesh.edges[edge].faces[0] = number,
        1 => mesh.edges[edge].vertices[1] = number,
        2 => mesh.edges[edge].faces = [mesh.edges[edge].faces[1]; 2],
        3 => mesh.faces[face].edges[2] = number,
        4 => mesh.faces[face].vertices.swap(0, 1),
        // Items that nothing names, and items that are missing.
        5 => mesh.edges.push(mesh.edges[edge]),
        6 => mesh.faces.truncate(face),
        _ => mesh.vertices[vertex].direction[0] /= 2,
    }
}

#[test]
fn damaged_meshes_have_the_fault_that_comes_first() {
    let whole = mesh();
    assert!(Base::new(&whole).is_ok() && first_fault(&whole).is_ok());
    for k in 0..400 {
        let mut mesh = whole.clone();
        damage(&mut mesh, k);
        if k % 3 == 0 {
            damage(&mut mesh, pcg(k));
        }
        let fault = Base::new(&mesh).map(|_| ());
        assert_eq!(fault, first_fault(&mesh), "{k}");
        // A number may by chance be the one that was there.
        assert!(fault.is_err() || mesh == whole, "{k}");
    }
}

/// The distance of a dry vertex to the river edge `i`, if it lies beside it.
fn distance(base: &Base, vertex: u32, i: u32, edge: &Edge) -> Option<i32> {
    let faces = edge.faces.iter().filter(|&&f| f != NONE);
    let mut far = faces.map(|&f| base.level.faces[f as usize].opposite(i));
    if edge.kind != EdgeKind::River || (edge.vertices[1] != vertex && !far.any(|v| v == vertex)) {
        return None;
    }
    let ends = gather(&base.vertices, edge.vertices);
    let segment = RiverSegment::between(0, 0, ends, edge.arriving);
    let (_, off) = segment
        .curve()
        .nearest(base.vertices[vertex as usize].direction);
    Some(base.scale.grains(off))
}

#[test]
fn dry_vertices_know_the_nearest_river_beside_them() {
    let base = Base::new(&control_mesh(300_000, 4, 7)).unwrap();
    let mut beside = 0;
    for (v, vertex) in (0..).zip(base.vertices.iter()).filter(|(_, v)| !v.is_wet()) {
        let edges = (0..).zip(&base.level.edges);
        let least = edges
            .filter_map(|(i, edge)| distance(&base, v, i, edge))
            .min();
        assert_eq!(vertex.river_distance, least.unwrap_or(FAR), "{v}");
        beside += u32::from(least.is_some());
    }
    assert!(beside > 10, "{beside}");
}

#[test]
fn gullies_run_to_the_lowest_neighbour_without_a_river_between() {
    let base = Base::new(&mesh()).unwrap();
    let height = |v: u32| (base.vertices[v as usize].height, v);
    for v in 0..base.vertices.len() as u32 {
        let own = base.level.edges.iter().filter(|e| e.vertices.contains(&v));
        let dry = own.filter(|e| e.kind != EdgeKind::River);
        let other = |e: &Edge| e.vertices[usize::from(e.vertices[0] == v)];
        let lowest = dry.min_by_key(|e| height(other(e)));
        let drains = lowest.filter(|e| height(other(e)) < height(v));
        let is_dry = matches!(
            base.vertices[v as usize].kind,
            VertexKind::Terrain | VertexKind::Gully
        );
        let is_gully = base.vertices[v as usize].kind == VertexKind::Gully;
        assert_eq!(is_gully, is_dry && drains.is_some(), "{v}");
        if let Some(edge) = drains.filter(|_| is_gully) {
            assert_eq!((edge.kind, edge.vertices[0]), (EdgeKind::Gully, v));
        }
    }
}
