//! The control mesh made ready: vertices of level 0 with their nearest river, edges with the
//! discharge that arrives along them.
//!
//! Done once per bake; refining the ground only reads it. Half of the time is memory that is touched
//! for the first time: every column is written once, and three threads write one kind of items
//! each. What rivers add follows on the few vertices that have one.

mod arms;
mod check;
mod edges;
mod estuary;
mod faces;
mod rivers;
#[cfg(test)]
mod tests;

use super::control::{ControlMesh, ControlVertex};
use super::locate::FaceIndex;
use super::scale::PlanetScale;
use super::topology::LevelMesh;
use super::vertex::Vertex;
use arms::BaseRivers;
pub use check::{BadMesh, RADII_M};
use edges::BaseEdges;
use faces::BaseFaces;
use std::sync::Arc;
use std::thread;

/// Level 0 of the ground. All runs of a planet share its vertices, edges and faces, which nothing
/// changes.
#[derive(Clone, Debug)]
pub struct Base {
    /// The planet's constants.
    pub scale: PlanetScale,
    /// Vertices of the control mesh.
    pub vertices: Arc<Vec<Vertex>>,
    /// Its edges and faces.
    pub level: Arc<LevelMesh>,
    /// Faces around vertex v: `around[starts[v]..starts[v + 1]]`.
    pub starts: Vec<u32>,
    /// Faces around all vertices, vertex after vertex; see `starts`.
    pub around: Vec<u32>,
    /// Where to look for the face of a direction.
    pub index: FaceIndex,
}

impl Base {
    /// Makes a control mesh ready. Every face must have its three edges, every edge its two faces.
    ///
    /// ```
    /// use pangaea_shaders::amplify::base::{BadMesh, Base};
    /// use pangaea_shaders::amplify::synthetic::control_mesh;
    ///
    /// let mut mesh = control_mesh(6_371_000, 3, 1);
    /// assert!(Base::new(&mesh).is_ok());
    /// mesh.radius_m = 10;
    /// assert_eq!(Base::new(&mesh).unwrap_err(), BadMesh::Radius);
    /// ```
    ///
    /// # Errors
    ///
    /// A [`BadMesh`] that names the first item that does not fit.
    pub fn new(mesh: &ControlMesh) -> Result<Self, BadMesh> {
        check::size(mesh)?;
        // None reads what another writes.
        let (vertices, faces, edges) = thread::scope(|scope| {
            let faces = scope.spawn(|| BaseFaces::new(mesh));
            let edges = scope.spawn(|| BaseEdges::new(mesh));
            (vertices(mesh), joined(faces.join()), joined(edges.join()))
        });
        let (vertices, faces) = (vertices?, faces?);
        let edges = match edges {
            Some(edges) if check::edges_follow(mesh) => edges,
            _ => BaseEdges::checked(mesh)?,
        };
        Ok(Self::joined(mesh, vertices, edges, faces))
    }

    /// Level 0 of its three kinds of items, with what rivers add to them.
    fn joined(
        mesh: &ControlMesh,
        mut vertices: Vec<Vertex>,
        edges: BaseEdges,
        faces: BaseFaces,
    ) -> Self {
        let BaseEdges {
            mut edges,
            rivers,
            drains,
        } = edges;
        let scale = PlanetScale::new(mesh);
        let network = BaseRivers::new(mesh, rivers);
        rivers::lay(&scale, &network, &mut vertices, &mut edges);
        rivers::lay_at_vertices(&drains, &mut vertices);
        rivers::lay_beside(&scale, &network, &mut vertices, &edges, &faces.faces);
        Self {
            scale,
            vertices: Arc::new(vertices),
            level: Arc::new(LevelMesh {
                edges,
                faces: faces.faces,
            }),
            starts: faces.starts,
            around: faces.around,
            index: faces.index,
        }
    }

    /// Faces around a vertex.
    pub fn faces_around(&self, vertex: u32) -> &[u32] {
        let [start, end] = [vertex, vertex + 1].map(|v| self.starts[v as usize] as usize);
        &self.around[start..end]
    }

    /// The face of the control mesh that a direction lies in; `hint` is a face likely to be near.
    pub fn locate(&self, direction: [i32; 3], hint: Option<u32>) -> u32 {
        self.index
            .locate(&self.level, &self.vertices, direction, hint)
    }
}

/// Vertices of level 0, without what rivers add.
fn vertices(mesh: &ControlMesh) -> Result<Vec<Vertex>, BadMesh> {
    let mut vertices = Vec::with_capacity(mesh.vertices.len());
    for (i, control) in (0..).zip(&mesh.vertices) {
        if !check::vertex_fits(control) {
            return Err(BadMesh::Vertex(i));
        }
        vertices.push(settled(control));
    }
    Ok(vertices)
}

/// A vertex of level 0: wet ground at its bed, with water over it; dry ground without a discharge.
fn settled(control: &ControlVertex) -> Vertex {
    let mut vertex = Vertex::from_control(control);
    if vertex.is_wet() {
        vertex.height = vertex.bed;
        vertex.water = vertex.water.max(vertex.bed);
    } else {
        vertex.discharge = 0;
    }
    vertex
}

/// The result of a thread; a panic there is one here.
fn joined<T>(result: thread::Result<T>) -> T {
    result.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}
