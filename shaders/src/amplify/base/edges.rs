//! Edges of level 0: ground, rivers, and the dry drainage lines down which all other land drains.

use super::check::{self, BadMesh};
use crate::amplify::control::{ControlEdge, ControlMesh, ControlVertex, VertexKind};
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, NONE};

/// The edges of level 0, and where they carry water.
pub(super) struct BaseEdges {
    /// Edges; those of rivers without the discharge that arrives along them.
    pub(super) edges: Vec<Edge>,
    /// Numbers of the river edges.
    pub(super) rivers: Vec<u32>,
    /// The edge down which each dry land vertex drains; [`NONE`] at pits, and at all others.
    pub(super) drains: Vec<u32>,
}

impl BaseEdges {
    /// The edges of a mesh whose faces fit; `None` if one of them is too long or has one face alone.
    pub(super) fn new(mesh: &ControlMesh) -> Option<Self> {
        let fits = |edge: &ControlEdge| check::edge_is_short(mesh, edge);
        mesh.edges.iter().all(fits).then(|| Self::of_checked(mesh))
    }

    /// The same, edge by edge, of a mesh that may have edges without faces.
    ///
    /// # Errors
    /// [`BadMesh::Edge`] for the first edge that does not fit.
    pub(super) fn checked(mesh: &ControlMesh) -> Result<Self, BadMesh> {
        check::edges(mesh)?;
        Ok(Self::of_checked(mesh))
    }

    fn of_checked(mesh: &ControlMesh) -> Self {
        let drains = drains(mesh);
        let edges = (0..).zip(&mesh.edges);
        let edges = edges.map(|(i, edge)| base_edge(i, edge, &drains)).collect();
        let rivers = (0..).zip(&mesh.edges).filter(|(_, edge)| edge.river != 0);
        Self {
            edges,
            rivers: rivers.map(|(i, _)| i).collect(),
            drains,
        }
    }
}

/// The `i`th edge, without the discharge that arrives along it. Gullies run down: only its higher
/// end drains along an edge.
fn base_edge(i: u32, edge: &ControlEdge, drains: &[u32]) -> Edge {
    if edge.river != 0 {
        return Edge::new(EdgeKind::River, edge.vertices, edge.faces);
    }
    let [from_first, from_second] = edge.vertices.map(|v| drains[v as usize] == i);
    let mut made = Edge::new(EdgeKind::Terrain, edge.vertices, edge.faces);
    if from_first || from_second {
        made.kind = EdgeKind::Gully;
    }
    if from_second {
        made.reverse();
    }
    made
}

/// The edge of each dry land vertex to its lowest neighbour, where that lies lower; the index
/// decides between equal heights.
fn drains(mesh: &ControlMesh) -> Vec<u32> {
    let heights: Vec<i32> = mesh.vertices.iter().map(ground).collect();
    let key = |v: u32| (heights[v as usize], v);
    let mut drains = vec![NONE; mesh.vertices.len()];
    let mut lowest: Vec<u32> = (0..mesh.vertices.len() as u32).collect();
    for (i, edge) in (0..).zip(&mesh.edges) {
        if edge.river != 0 {
            continue;
        }
        let [a, b] = edge.vertices;
        for (from, to) in [(a, b), (b, a)] {
            // A vertex without a lower neighbour is a pit, and has no drain.
            if key(to) < key(lowest[from as usize]) {
                lowest[from as usize] = to;
                drains[from as usize] = i;
            }
        }
    }
    for (drain, vertex) in drains.iter_mut().zip(&mesh.vertices) {
        if VertexKind::from_number(vertex.kind) != VertexKind::Terrain {
            *drain = NONE;
        }
    }
    drains
}

/// The ground of a vertex in grains, under the water if it is wet.
fn ground(vertex: &ControlVertex) -> i32 {
    match VertexKind::from_number(vertex.kind) {
        VertexKind::River | VertexKind::Lake => vertex.bed,
        _ => vertex.height,
    }
}
