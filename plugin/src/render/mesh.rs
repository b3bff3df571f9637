//! The meshes of a globe that never change: triangles, their edges, the shell of air.
//!
//! Vertices carry a direction and the number of their sample. Heights and colours come from the buffer
//! of samples, so neither directions nor indices are uploaded again.

use super::to_bevy;
use crate::sphere::SphereMesh;
use bevy::asset::RenderAssetUsages;
use bevy::mesh::{Indices, MeshVertexAttribute, PrimitiveTopology, VertexFormat};
use bevy::prelude::*;

/// The number of a vertex's sample.
pub(super) const SAMPLE: MeshVertexAttribute =
    MeshVertexAttribute::new("PangaeaSample", 0x70a9_6ae5_0000_0001, VertexFormat::Uint32);

/// Subdivisions of the shell of air: flat enough that its facets are not seen.
const SHELL: u32 = 24;

/// All triangles of the lattice.
pub(super) fn ground(mesh: &SphereMesh) -> Mesh {
    with_samples(mesh, PrimitiveTopology::TriangleList, mesh.triangles().as_flattened().to_vec())
}

/// All edges of the lattice, each once.
pub(super) fn edges(mesh: &SphereMesh) -> Mesh {
    let mut indices = Vec::with_capacity(6 * mesh.len());
    for i in 0..mesh.len() as u32 {
        let longer = mesh.ring(i).iter().filter(|&&j| j > i);
        indices.extend(longer.flat_map(|&j| [i, j]));
    }
    with_samples(mesh, PrimitiveTopology::LineList, indices)
}

fn with_samples(mesh: &SphereMesh, topology: PrimitiveTopology, indices: Vec<u32>) -> Mesh {
    let directions: Vec<[f32; 3]> = mesh.points().iter().map(|&p| to_bevy(p).to_array()).collect();
    let samples: Vec<u32> = (0..mesh.len() as u32).collect();
    Mesh::new(topology, RenderAssetUsages::RENDER_WORLD)
        .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, directions)
        .with_inserted_attribute(SAMPLE, samples)
        .with_inserted_indices(Indices::U32(indices))
}

/// A unit sphere for the air.
pub(super) fn shell() -> Mesh {
    let sphere = Sphere::new(1.0).mesh();
    sphere.ico(SHELL).unwrap_or_else(|_| sphere.uv(96, 48))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_those_of_the_triangles() {
        let lattice = SphereMesh::fibonacci(500).unwrap();
        // A closed triangulation of n points has 3n - 6 edges.
        let mesh = edges(&lattice);
        assert_eq!(mesh.indices().map(Indices::len), Some(2 * (3 * 500 - 6)));
        let mesh = ground(&lattice);
        assert_eq!(mesh.indices().map(Indices::len), Some(3 * (2 * 500 - 4)));
        assert_eq!(mesh.count_vertices(), 500);
    }
}
