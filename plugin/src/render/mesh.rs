//! The meshes of a globe that never change: triangles in patches, their edges, the shell of air.
//!
//! Vertices carry a direction and the number of their sample. Heights and colours come from the
//! buffer of samples, so neither directions nor indices are uploaded again.

use super::axes::to_bevy;
use super::cap::SphericalCap;
use crate::sphere::SphereMesh;
use bevy::asset::RenderAssetUsages;
use bevy::mesh::{Indices, MeshVertexAttribute, PrimitiveTopology, VertexFormat};
use bevy::prelude::*;

/// Attribute: the number of a vertex's sample.
pub(super) const SAMPLE: MeshVertexAttribute =
    MeshVertexAttribute::new("PangaeaSample", 0x70a9_6ae5_0000_0001, VertexFormat::Uint32);

/// Subdivisions of the shell of air: its facets are not seen.
const AIR_SUBDIVISIONS: u32 = 24;

/// Most patches that a globe is cut into.
const MAX_PATCHES: usize = 96;
/// Fewest triangles of a patch, unless the globe has fewer.
const MIN_PATCH_TRIANGLES: usize = 2048;

/// A run of triangles that lie close together, for they are ordered along a curve.
pub(super) struct GlobePatch {
    /// The triangles.
    pub(super) mesh: Mesh,
    /// Where they lie.
    pub(super) cap: SphericalCap,
}

/// All triangles of the lattice.
pub(super) fn ground_patches(mesh: &SphereMesh) -> Vec<GlobePatch> {
    let triangles = mesh.triangles();
    let size = triangles
        .len()
        .div_ceil(MAX_PATCHES)
        .max(MIN_PATCH_TRIANGLES);
    triangles.chunks(size).map(|run| patch(mesh, run)).collect()
}

/// A mesh of these triangles and of the samples that they need.
fn patch(mesh: &SphereMesh, triangles: &[[u32; 3]]) -> GlobePatch {
    // Neighbouring triangles share their samples: each is stored once.
    let corners = triangles.as_flattened();
    let mut samples = corners.to_vec();
    samples.sort_unstable();
    samples.dedup();
    // Every corner is among the samples, so the search always succeeds.
    let local = |i: &u32| samples.binary_search(i).unwrap_or_default() as u32;
    let indices = corners.iter().map(local).collect();
    let cap = SphericalCap::around(samples.iter().map(|&i| mesh.point(i)));
    GlobePatch {
        mesh: with_samples(mesh, PrimitiveTopology::TriangleList, samples, indices),
        cap,
    }
}

/// All edges of the lattice, each once.
pub(super) fn edges(mesh: &SphereMesh) -> Mesh {
    let mut indices = Vec::with_capacity(6 * mesh.len());
    for i in 0..mesh.len() as u32 {
        // From the lower end of an edge only.
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

/// A mesh of these samples.
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
pub(super) fn air_shell() -> Mesh {
    let sphere = Sphere::new(1.0).mesh();
    sphere
        .ico(AIR_SUBDIVISIONS)
        .unwrap_or_else(|_| sphere.uv(96, 48))
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
        let patches = ground_patches(&lattice);
        let triangles = patches
            .iter()
            .filter_map(|patch| patch.mesh.indices())
            .map(Indices::len);
        assert_eq!(triangles.sum::<usize>(), 3 * (2 * 100_000 - 4));
        // Most patches are compact, so that they lie before or behind the horizon as a whole.
        let mut angles: Vec<f64> = patches.iter().map(|patch| patch.cap.angle).collect();
        angles.sort_by(f64::total_cmp);
        assert_eq!(angles.len(), MAX_PATCHES);
        assert!(angles[MAX_PATCHES / 2] < 0.45, "{angles:?}");
    }
    #[test]
    fn a_small_globe_is_one_patch() {
        let lattice = SphereMesh::fibonacci(100).unwrap();
        assert_eq!(ground_patches(&lattice).len(), 1);
    }
}
