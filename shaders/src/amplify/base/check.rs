//! Whether a control mesh can be refined.

use crate::amplify::control::{ControlEdge, ControlFace, ControlMesh, ControlVertex};
use crate::amplify::fixed::{ONE, metres};

/// Radii of planets that have ground, metres.
pub const RADII_M: core::ops::RangeInclusive<u32> = 50_000..=10_000_000;

/// Most height and depth of the ground, the water and the crust, grains.
const MOST_HEIGHT: i32 = metres(100_000);

/// Most that a vertex may lie off the sphere, in radii.
const OFF_SPHERE: f64 = 1e-6;

/// Most difference of the ends of an edge in one component of their directions: 15 degrees.
const LONGEST_EDGE: u32 = 1 << 29;

/// Most vertices, edges or faces, so that 32 bits can number those of all levels.
const MOST_ITEMS: usize = 1 << 28;

/// The first fault of a control mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BadMesh {
    /// The radius is outside 50,000..=10,000,000 m.
    Radius,
    /// It has fewer than four faces, or so many items that 32 bits cannot number them.
    Size,
    /// This vertex is off the sphere by more than a millionth, or more than 100 km high, deep, or
    /// under water.
    Vertex(u32),
    /// This face names an edge that does not exist, or that is another face's.
    Face(u32),
    /// This edge lacks a face, or is longer than about 15 degrees.
    Edge(u32),
}

impl core::fmt::Display for BadMesh {
    fn fmt(&self, f: &mut core::fmt::Formatter) -> core::fmt::Result {
        match self {
            Self::Radius => write!(f, "the radius of a control mesh must be 50 km to 10,000 km"),
            Self::Size => write!(
                f,
                "a control mesh must have at least four faces, and items that 32 bits can number"
            ),
            Self::Vertex(i) => write!(
                f,
                "vertex {i} of the control mesh is off the sphere or beyond 100 km"
            ),
            Self::Face(i) => write!(
                f,
                "face {i} of the control mesh does not fit its edges and vertices"
            ),
            Self::Edge(i) => write!(
                f,
                "edge {i} of the control mesh does not fit its faces, or is too long"
            ),
        }
    }
}

impl core::error::Error for BadMesh {}

/// Refuses a radius that has no ground, and numbers of items that no mesh has, or that 32 bits
/// cannot number.
pub(super) fn size(mesh: &ControlMesh) -> Result<(), BadMesh> {
    if !RADII_M.contains(&mesh.radius_m) {
        return Err(BadMesh::Radius);
    }
    let items = mesh.vertices.len().max(mesh.edges.len());
    if mesh.faces.len() < 4 || items.max(mesh.faces.len()) > MOST_ITEMS {
        return Err(BadMesh::Size);
    }
    Ok(())
}

/// Refuses the first face that does not fit.
pub(super) fn faces(mesh: &ControlMesh) -> Result<(), BadMesh> {
    all_fit(&mesh.faces, |i, face| face_fits(mesh, i, face)).map_err(BadMesh::Face)
}

/// Refuses the first edge that does not fit.
pub(super) fn edges(mesh: &ControlMesh) -> Result<(), BadMesh> {
    all_fit(&mesh.edges, |i, edge| edge_fits(mesh, i, edge)).map_err(BadMesh::Edge)
}

/// Whether the edges of a mesh whose faces all fit have faces that name them: those name three edges
/// each, and none twice on one side, so that no side is left where there are as many of both.
pub(super) fn edges_follow(mesh: &ControlMesh) -> bool {
    3 * mesh.faces.len() == 2 * mesh.edges.len()
}

/// Refuses the first item that does not fit.
fn all_fit<T>(items: &[T], fits: impl Fn(u32, &T) -> bool) -> Result<(), u32> {
    let misfit = (0..).zip(items).find(|&(i, item)| !fits(i, item));
    misfit.map_or(Ok(()), |(i, _)| Err(i))
}

/// Whether a vertex lies on the sphere, and no higher or deeper than ground may.
pub(super) fn vertex_fits(vertex: &ControlVertex) -> bool {
    let square: f64 = vertex
        .direction
        .iter()
        .map(|&x| f64::from(x) * f64::from(x))
        .sum();
    // In f64: 64 bits of squares do not fit 32.
    let on_sphere = (square.sqrt() / f64::from(ONE) - 1.0).abs() < OFF_SPHERE;
    let heights = [vertex.height, vertex.bed, vertex.water, vertex.crust];
    on_sphere
        && heights
            .iter()
            .all(|h| h.unsigned_abs() <= MOST_HEIGHT as u32)
}

/// Whether the edges of the `i`th face join its corners and name it on the right side.
fn face_fits(mesh: &ControlMesh, i: u32, face: &ControlFace) -> bool {
    (0..3).all(|k| {
        let (a, b) = (face.vertices[k], face.vertices[(k + 1) % 3]);
        let Some(edge) = mesh.edges.get(face.edges[k] as usize) else {
            return false;
        };
        let is_left = edge.faces[0] == i && edge.vertices == [a, b];
        let is_right = edge.faces[1] == i && edge.vertices == [b, a];
        (a as usize) < mesh.vertices.len() && a != b && (is_left || is_right)
    })
}

/// Whether the `i`th edge is short and has two faces that name it.
fn edge_fits(mesh: &ControlMesh, i: u32, edge: &ControlEdge) -> bool {
    let [left, right] = edge.faces.map(|f| mesh.faces.get(f as usize));
    let is_shared = left
        .zip(right)
        .is_some_and(|(f, g)| f.edges.contains(&i) && g.edges.contains(&i));
    edge_is_short(mesh, edge) && is_shared
}

/// Whether an edge is short and lies between two faces, if its faces are those of the mesh.
pub(super) fn edge_is_short(mesh: &ControlMesh, edge: &ControlEdge) -> bool {
    let [a, b] = edge.vertices.map(|v| mesh.vertices.get(v as usize));
    let is_short = a.zip(b).is_some_and(|(a, b)| {
        (0..3).all(|i| a.direction[i].abs_diff(b.direction[i]) < LONGEST_EDGE)
    });
    is_short && edge.faces[0] != edge.faces[1]
}
