//! Control meshes that do not fit are refused.

use super::*;
use crate::amplify::base::BadMesh;
use crate::amplify::control::ControlMesh;

/// The fault that a changed mesh is refused for.
fn refusal(change: impl Fn(&mut ControlMesh)) -> BadMesh {
    let mut mesh = control_mesh(300_000, 3, 7);
    change(&mut mesh);
    Base::new(&mesh).map(|_| ()).unwrap_err()
}

#[test]
fn planets_of_a_bad_size_are_refused() {
    assert_eq!(refusal(|m| m.radius_m = 0), BadMesh::Radius);
    assert_eq!(refusal(|m| m.radius_m = 10_000_001), BadMesh::Radius);
    assert_eq!(refusal(|m| m.faces.clear()), BadMesh::Size);
}

#[test]
fn bad_vertices_are_refused() {
    assert_eq!(
        refusal(|m| m.vertices[5].direction = [0; 3]),
        BadMesh::Vertex(5)
    );
    assert_eq!(
        refusal(|m| m.vertices[6].height = i32::MIN),
        BadMesh::Vertex(6)
    );
    assert_eq!(
        refusal(|m| m.vertices[7].crust = 100_000 * GRAINS + 1),
        BadMesh::Vertex(7)
    );
}

#[test]
fn bad_faces_and_edges_are_refused() {
    assert_eq!(
        refusal(|m| m.faces[7].edges[1] = 1_000_000),
        BadMesh::Face(7)
    );
    assert_eq!(
        refusal(|m| m.faces[8].vertices[0] = m.faces[8].vertices[1]),
        BadMesh::Face(8)
    );
    let fault = refusal(|m| m.edges[9].faces[1] = u32::MAX);
    assert!(matches!(fault, BadMesh::Face(_) | BadMesh::Edge(9)));
}
