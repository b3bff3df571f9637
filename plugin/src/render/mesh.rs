//! The meshes of a globe that never change: triangles in patches, their edges, the shell of air.
//!
//! Vertices carry a direction and the number of their sample. Heights and colours come from the
//! buffer of samples, so neither directions nor indices are uploaded again.

use super::horizon::Cap;
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

/// Most patches that a globe is cut into, and fewest triangles of a patch.
const PATCHES: usize = 96;
const PATCH_TRIANGLES: usize = 2048;

/// A run of triangles that lie close together, for they are ordered along a curve.
pub(super) struct Patch {
    /// The triangles.
    pub(super) mesh: Mesh,
    /// Where they lie.
    pub(super) cap: Cap,
}

/// All triangles of the lattice.
pub(super) fn ground(mesh: &SphereMesh) -> Vec<Patch> {
    let triangles = mesh.triangles();
    let size = triangles.len().div_ceil(PATCHES).max(PATCH_TRIANGLES);
    triangles.chunks(size).map(|run| patch(mesh, run)).collect()
}

fn patch(mesh: &SphereMesh, triangles: &[[u32; 3]]) -> Patch {
    let corners = triangles.as_flattened();
    let mut samples = corners.to_vec();
    samples.sort_unstable();
    samples.dedup();
    // Every corner is among the samples.
    let local = |i: &u32| samples.binary_search(i).unwrap_or_default() as u32;
    let indices = corners.iter().map(local).collect();
    let cap = Cap::around(samples.iter().map(|&i| mesh.point(i)));
    Patch {
        mesh: with_samples(mesh, PrimitiveTopology::TriangleList, samples, indices),
        cap,
    }
}

/// All edges of the lattice, each once.
pub(super) fn edges(mesh: &SphereMesh) -> Mesh {
    let mut indices = Vec::with_capacity(6 * mesh.len());
    for i in 0..mesh.len() as u32 {
        let longer = mesh.ring(i).iter().filter(|&&j| j > i);
        indices.extend(longer.flat_map(|&j| [i, j]));
    }
    with_samples(
        mesh,
        PrimitiveTopology::LineList,
        (0..mesh.len() as u32).collect(),
        indices,
    )
}

fn with_samples(
    mesh: &SphereMesh,
    topology: PrimitiveTopology,
    samples: Vec<u32>,
    indices: Vec<u32>,
) -> Mesh {
    let directions: Vec<[f32; 3]> = samples
        .iter()
        .map(|&i| to_bevy(mesh.point(i)).to_array())
        .collect();
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
    }

    #[test]
    fn patches_hold_every_triangle_once() {
        let lattice = SphereMesh::fibonacci(100_000).unwrap();
        let patches = ground(&lattice);
        let triangles = patches
            .iter()
            .filter_map(|patch| patch.mesh.indices())
            .map(Indices::len);
        assert_eq!(triangles.sum::<usize>(), 3 * (2 * 100_000 - 4));
        // Most patches are compact, so that they lie before or behind the horizon as a whole.
        let mut angles: Vec<f64> = patches.iter().map(|patch| patch.cap.angle).collect();
        angles.sort_by(f64::total_cmp);
        assert!(
            angles.len() == PATCHES && angles[PATCHES / 2] < 0.45,
            "{angles:?}"
        );
        assert_eq!(ground(&SphereMesh::fibonacci(100).unwrap()).len(), 1);
    }
}
