//! Edges and faces of the base mesh in the form of the control mesh, and all else of it that
//! depends on the seed alone.

use crate::parallel;
use crate::random::{Purpose, Stream};
use crate::sphere::SphereMesh;
use pangaea_shaders::amplify::control::{ControlEdge, ControlFace};
use pangaea_shaders::amplify::fixed::ONE;

/// The part that all control meshes of a base mesh share. Edges run from the lower to the higher
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
        topology.number_edges(mesh);
        let triangles = mesh.triangles();
        topology.faces = parallel::map(triangles.len(), |k| {
            topology.face(mesh, triangles[k as usize])
        });
        topology.link_faces();
        topology
    }

    /// Gives every pair of neighbours an edge, without its faces.
    fn number_edges(&mut self, mesh: &SphereMesh) {
        for i in 0..mesh.len() as u32 {
            self.first.push(self.edges.len() as u32);
            // Each pair once, by its lower vertex.
            let higher = mesh.ring(i).iter().filter(|&&j| j > i);
            self.edges.extend(higher.map(|&j| ControlEdge {
                vertices: [i, j],
                faces: [u32::MAX; 2],
                river: 0,
            }));
        }
    }

    /// A triangle with its edges: edge k joins corners k and k + 1.
    fn face(&self, mesh: &SphereMesh, vertices: [u32; 3]) -> ControlFace {
        let [a, b, c] = vertices;
        let edges = [(a, b), (b, c), (c, a)];
        ControlFace {
            vertices,
            edges: edges.map(|(a, b)| self.edge(mesh, a, b).unwrap_or(u32::MAX)),
        }
    }

    /// Tells every edge its faces: the first is the one that runs along it in its own direction.
    fn link_faces(&mut self) {
        for (f, face) in (0..).zip(&self.faces) {
            for (k, &e) in face.edges.iter().enumerate() {
                if let Some(edge) = self.edges.get_mut(e as usize) {
                    let side = usize::from(edge.vertices[0] != face.vertices[k]);
                    edge.faces[side] = f;
                }
            }
        }
    }

    /// The edge between two neighbours.
    pub fn edge(&self, mesh: &SphereMesh, a: u32, b: u32) -> Option<u32> {
        let (low, high) = (a.min(b), a.max(b));
        let mut higher = mesh.ring(low).iter().filter(|&&j| j > low);
        let k = higher.position(|&j| j == high)?;
        Some(self.first[low as usize] + k as u32)
    }
}

/// A direction in units of 1 / [`ONE`].
fn quantised(direction: [f64; 3]) -> [i32; 3] {
    direction.map(|x| (x * f64::from(ONE)).round() as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn topology(seed: u64, spacing: f64) -> (SphereMesh, Topology) {
        let mesh = SphereMesh::from_points(crate::sphere::poisson_disk(seed, spacing)).unwrap();
        let topology = Topology::new(&mesh, seed);
        (mesh, topology)
    }

    #[test]
    fn every_edge_lies_between_two_faces_that_know_it() {
        let (mesh, topology) = topology(1, 0.05);
        assert_eq!(topology.edges.len(), 3 * mesh.len() - 6);
        assert_eq!(topology.faces.len(), 2 * mesh.len() - 4);
        for (e, edge) in (0..).zip(&topology.edges) {
            for (side, &f) in edge.faces.iter().enumerate() {
                let face = &topology.faces[f as usize];
                let k = face.edges.iter().position(|&own| own == e).unwrap();
                let ends = [face.vertices[k], face.vertices[(k + 1) % 3]];
                assert_eq!(ends, [edge.vertices[side], edge.vertices[1 - side]]);
            }
        }
    }

    #[test]
    fn directions_are_exact_to_half_a_unit() {
        let (mesh, topology) = topology(2, 0.2);
        for (p, d) in mesh.points().iter().zip(&topology.directions) {
            for (exact, units) in p.to_array().into_iter().zip(d) {
                let error = exact * f64::from(ONE) - f64::from(*units);
                assert!(error.abs() <= 0.5001);
            }
        }
    }

    #[test]
    fn every_vertex_has_a_seed_of_its_own() {
        let (mesh, topology) = topology(2, 0.2);
        let mut seeds = topology.seeds;
        seeds.sort_unstable();
        seeds.dedup();
        assert_eq!(seeds.len(), mesh.len());
    }
}
