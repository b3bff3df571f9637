//! Edges and faces of the base mesh in the form of the control mesh, and what else of it depends on
//! the seed alone.

use crate::parallel;
use crate::random::{Purpose, Stream};
use crate::sphere::SphereMesh;
use pangaea_shaders::amplify::control::{ControlEdge, ControlFace};
use pangaea_shaders::amplify::fixed::ONE;

/// What every control mesh of a base mesh has in common. Edges run from the lower to the higher
/// vertex here.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Topology {
    /// Directions of the vertices, each component times [`ONE`].
    pub directions: Vec<[i32; 3]>,
    /// Where each vertex's random numbers begin.
    pub seeds: Vec<u32>,
    /// Edges, in the order of their lower vertex and then around it.
    pub edges: Vec<ControlEdge>,
    /// Faces, in the order of the mesh's triangles.
    pub faces: Vec<ControlFace>,
    /// First edge of each vertex.
    first: Vec<u32>,
}

impl Topology {
    /// The topology of `mesh` on the planet `seed`.
    pub fn new(mesh: &SphereMesh, seed: u64) -> Self {
        let stream = Stream::new(seed, Purpose::Control, 0);
        let mut topology = Self {
            directions: parallel::map(mesh.len(), |i| quantised(mesh.point(i).to_array())),
            seeds: parallel::map(mesh.len(), |i| stream.bits(u64::from(i)) as u32),
            edges: Vec::with_capacity(3 * mesh.len()),
            faces: Vec::new(),
            first: Vec::with_capacity(mesh.len()),
        };
        for i in 0..mesh.len() as u32 {
            topology.first.push(topology.edges.len() as u32);
            let higher = mesh.ring(i).iter().filter(|&&j| j > i);
            let edge = |&j: &u32| ControlEdge {
                vertices: [i, j],
                faces: [u32::MAX; 2],
                river: 0,
            };
            topology.edges.extend(higher.map(edge));
        }
        topology.faces = mesh
            .triangles()
            .iter()
            .map(|&vertices| {
                let edge = |k: usize| {
                    topology
                        .edge(mesh, vertices[k], vertices[(k + 1) % 3])
                        .unwrap_or(u32::MAX)
                };
                ControlFace {
                    vertices,
                    edges: [edge(0), edge(1), edge(2)],
                }
            })
            .collect();
        for (f, face) in topology.faces.iter().enumerate() {
            for (k, &e) in face.edges.iter().enumerate() {
                if let Some(edge) = topology.edges.get_mut(e as usize) {
                    edge.faces[usize::from(edge.vertices[0] != face.vertices[k])] = f as u32;
                }
            }
        }
        topology
    }

    /// The edge between two neighbours.
    pub fn edge(&self, mesh: &SphereMesh, a: u32, b: u32) -> Option<u32> {
        let (low, high) = (a.min(b), a.max(b));
        let higher = mesh.ring(low).iter().filter(|&&j| j > low);
        higher
            .into_iter()
            .position(|&j| j == high)
            .map(|k| self.first[low as usize] + k as u32)
    }
}

/// A direction in units of 1 / [`ONE`].
pub fn quantised(direction: [f64; 3]) -> [i32; 3] {
    direction.map(|x| (x * f64::from(ONE)).round() as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_edge_lies_between_two_faces_that_know_it() {
        let mesh = SphereMesh::from_points(crate::sphere::poisson_disk(1, 0.05)).unwrap();
        let topology = Topology::new(&mesh, 1);
        assert_eq!(topology.edges.len(), 3 * mesh.len() - 6);
        assert_eq!(topology.faces.len(), 2 * mesh.len() - 4);
        for (e, edge) in topology.edges.iter().enumerate() {
            for (side, &f) in edge.faces.iter().enumerate() {
                let face = &topology.faces[f as usize];
                let k = face
                    .edges
                    .iter()
                    .position(|&own| own as usize == e)
                    .unwrap();
                let ends = [face.vertices[k], face.vertices[(k + 1) % 3]];
                assert_eq!(ends, [edge.vertices[side], edge.vertices[1 - side]]);
            }
        }
    }

    #[test]
    fn directions_are_exact_to_half_a_unit() {
        let mesh = SphereMesh::from_points(crate::sphere::poisson_disk(2, 0.2)).unwrap();
        let topology = Topology::new(&mesh, 2);
        for (p, d) in mesh.points().iter().zip(&topology.directions) {
            let back = d.map(|x| f64::from(x) / f64::from(ONE));
            assert!(
                p.to_array()
                    .iter()
                    .zip(back)
                    .all(|(a, b)| (a - b).abs() <= 0.5001 / f64::from(ONE))
            );
        }
        let mut seeds = topology.seeds.clone();
        seeds.sort_unstable();
        seeds.dedup();
        assert_eq!(seeds.len(), mesh.len());
    }
}
