//! Rivers that part: from most vertices one river leads on, from the apex of a delta several arms,
//! which share its discharge.

use crate::amplify::control::ControlMesh;
use crate::amplify::vertex::Vertex;

/// River edges of a control mesh as (upper end, lower end).
pub(super) fn river_edges(mesh: &ControlMesh) -> impl Iterator<Item = [usize; 2]> {
    mesh.edges
        .iter()
        .filter(|e| e.river != 0)
        .map(|e| e.vertices.map(|v| v as usize))
}

/// The vertices that rivers lead to: one from most, several from the apex of a delta.
pub(super) struct Below {
    /// Those of vertex v: `to[starts[v]..starts[v + 1]]`.
    starts: Vec<usize>,
    to: Vec<usize>,
}

impl Below {
    pub(super) fn new(mesh: &ControlMesh) -> Self {
        let mut rivers: Vec<[usize; 2]> = river_edges(mesh).collect();
        // Stable, so that arms stay in the order of their edges.
        rivers.sort_by_key(|&[up, _]| up);
        let mut starts = vec![0; mesh.vertices.len() + 1];
        for &[up, _] in &rivers {
            starts[up + 1] += 1;
        }
        for v in 0..mesh.vertices.len() {
            starts[v + 1] += starts[v];
        }
        let to = rivers.into_iter().map(|[_, down]| down).collect();
        Self { starts, to }
    }

    /// Where the rivers from a vertex lead.
    pub(super) fn of(&self, v: usize) -> &[usize] {
        &self.to[self.starts[v]..self.starts[v + 1]]
    }
}

/// The largest river that arrives at each vertex, by its vertex upstream.
pub(super) fn largest_arriving(mesh: &ControlMesh, vertices: &[Vertex]) -> Vec<Option<usize>> {
    largest_of(river_edges(mesh), vertices)
}

/// The largest river that joins that one.
pub(super) fn largest_joining(
    mesh: &ControlMesh,
    vertices: &[Vertex],
    largest: &[Option<usize>],
) -> Vec<Option<usize>> {
    let joins = |&[up, down]: &[usize; 2]| largest[down] != Some(up);
    largest_of(river_edges(mesh).filter(joins), vertices)
}

/// The upper end of the largest of some rivers that arrives at each vertex.
fn largest_of(rivers: impl Iterator<Item = [usize; 2]>, vertices: &[Vertex]) -> Vec<Option<usize>> {
    // Of equal rivers the seed decides, not the number of a vertex.
    let rank = |v: usize| (vertices[v].discharge, vertices[v].seed);
    let mut largest: Vec<Option<usize>> = vec![None; vertices.len()];
    for [up, down] in rivers {
        if largest[down].is_none_or(|other| rank(up) > rank(other)) {
            largest[down] = Some(up);
        }
    }
    largest
}

/// A discharge as its arms share it: in proportion to those that they came with. The parts make
/// the whole to the unit.
pub(super) fn parts(vertices: &[Vertex], whole: u32, arms: &[usize]) -> Vec<u32> {
    let weights = arms
        .iter()
        .map(|&v| u64::from(vertices[v].discharge).max(1));
    let sum: u64 = weights.clone().sum();
    let (mut weight, mut given) = (0, 0);
    let part = |own: u64| {
        weight += own;
        // Differences of rounded sums.
        let up_to_here = (u128::from(whole) * u128::from(weight) / u128::from(sum)) as u32;
        let part = up_to_here - given;
        given = up_to_here;
        part
    };
    weights.map(part).collect()
}

/// Discharge that a river edge carries from its upper end, one of so many `arms` that leave it. An
/// arm ends alone, so its share is what its end has.
pub(super) fn carried([up, down]: [&Vertex; 2], arms: usize) -> u32 {
    if arms > 1 {
        down.discharge
    } else {
        up.discharge
    }
}
