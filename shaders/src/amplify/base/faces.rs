//! Faces of level 0, and how they are found: around a vertex, and by a direction.

use super::check::{self, BadMesh};
use crate::amplify::control::{ControlFace, ControlMesh};
use crate::amplify::locate::FaceIndex;
use crate::amplify::topology::Face;

/// The faces of level 0 with their indexes.
pub(super) struct BaseFaces {
    pub(super) faces: Vec<Face>,
    pub(super) starts: Vec<u32>,
    pub(super) around: Vec<u32>,
    pub(super) index: FaceIndex,
}

impl BaseFaces {
    /// The faces of a mesh.
    ///
    /// # Errors
    /// [`BadMesh::Face`] for the first that does not fit.
    pub(super) fn new(mesh: &ControlMesh) -> Result<Self, BadMesh> {
        check::faces(mesh)?;
        let (starts, around) = incidence(mesh.vertices.len(), &mesh.faces);
        let faces = mesh.faces.iter().map(|f| Face {
            vertices: f.vertices,
            edges: f.edges,
        });
        Ok(Self {
            faces: faces.collect(),
            starts,
            around,
            index: FaceIndex::new(mesh),
        })
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
