//! The control mesh made ready: vertices of level 0 with their nearest river, edges with the
//! discharge that arrives along them.
//!
//! Done once per planet; refining the ground only reads it.

mod arms;
mod check;
mod estuary;
mod rivers;

use super::control::{ControlFace, ControlMesh};
use super::locate::FaceIndex;
use super::scale::PlanetScale;
use super::topology::{Face, Level};
use super::vertex::Vertex;
use arms::{Below, largest_arriving, largest_joining};
pub use check::{BadMesh, RADII_M};

/// Level 0 of the ground.
#[derive(Clone, Debug)]
pub struct Base {
    /// The planet's constants.
    pub scale: PlanetScale,
    /// Vertices of the control mesh.
    pub vertices: Vec<Vertex>,
    /// Its edges and faces.
    pub level: Level,
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
        check::check(mesh)?;
        // Two halves that read the mesh alone; neither changes a bit of the other.
        let (ground, lookup) = std::thread::scope(|scope| {
            let lookup = scope.spawn(|| Lookup::new(mesh));
            (BaseGround::new(mesh), check::joined(lookup.join()))
        });
        Ok(Self {
            scale: ground.scale,
            vertices: ground.vertices,
            level: ground.level,
            starts: lookup.starts,
            around: lookup.around,
            index: lookup.index,
        })
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

/// The part of level 0 that the passes read.
struct BaseGround {
    scale: PlanetScale,
    vertices: Vec<Vertex>,
    level: Level,
}

impl BaseGround {
    fn new(mesh: &ControlMesh) -> Self {
        let scale = PlanetScale::new(mesh);
        let mut vertices: Vec<Vertex> = mesh.vertices.iter().map(Vertex::from_control).collect();
        rivers::settle_water(&mut vertices);
        let below = Below::new(mesh);
        rivers::accumulate(mesh, &below, &mut vertices);
        let largest = largest_arriving(mesh, &vertices);
        rivers::find_headings(&below, &largest, &mut vertices);
        let joins = largest_joining(mesh, &vertices, &largest);
        rivers::find_windings(&scale, &below, &largest, &joins, &mut vertices);
        estuary::flood(&scale, &below, &largest, &mut vertices);
        let mut edges = rivers::edges(mesh, &below, &vertices);
        rivers::add_gullies(&mut vertices, &mut edges);
        let faces: Vec<Face> = (0..)
            .zip(&mesh.faces)
            .map(|(i, f)| Face::new(f.vertices, f.edges, i))
            .collect();
        rivers::find_nearest(&scale, &mut vertices, &edges, &faces);
        Self {
            scale,
            vertices,
            level: Level { edges, faces },
        }
    }
}

/// The part of level 0 that finds faces.
struct Lookup {
    starts: Vec<u32>,
    around: Vec<u32>,
    index: FaceIndex,
}

impl Lookup {
    fn new(mesh: &ControlMesh) -> Self {
        let (starts, around) = incidence(mesh.vertices.len(), &mesh.faces);
        Self {
            starts,
            around,
            index: FaceIndex::new(mesh),
        }
    }
}

/// Faces around every vertex, in the order of the faces: where those of a vertex start, and all of
/// them.
fn incidence(vertices: usize, faces: &[ControlFace]) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; vertices + 1];
    for vertex in faces.iter().flat_map(|f| f.vertices) {
        starts[vertex as usize + 1] += 1;
    }
    for i in 0..vertices {
        starts[i + 1] += starts[i];
    }
    // Counts became starts; the same order of faces fills every list in ascending order.
    let mut next = starts.clone();
    let mut around = vec![0; faces.len() * 3];
    for (i, face) in (0..).zip(faces) {
        for vertex in face.vertices {
            around[next[vertex as usize] as usize] = i;
            next[vertex as usize] += 1;
        }
    }
    (starts, around)
}
