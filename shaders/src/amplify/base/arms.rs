//! Rivers of level 0 as a network. Rivers part: from most vertices one river leads on, from the apex
//! of a delta several arms, which share its discharge.

use crate::amplify::control::ControlMesh;
use crate::amplify::topology::NONE;
use crate::amplify::vertex::Vertex;

/// A river's edge.
#[derive(Clone, Copy)]
pub(super) struct RiverEdge {
    /// Its number.
    pub(super) edge: u32,
    /// Its upper and its lower end.
    pub(super) ends: [usize; 2],
}

impl RiverEdge {
    /// That of a control mesh with this number.
    fn of(mesh: &ControlMesh, edge: u32) -> Self {
        let ends = mesh.edges[edge as usize].vertices;
        Self {
            edge,
            ends: ends.map(|v| v as usize),
        }
    }
}

/// The river edges of a control mesh, and where they lead.
pub(super) struct BaseRivers {
    /// River edges in the order of their numbers.
    pub(super) edges: Vec<RiverEdge>,
    /// Where rivers lead from each vertex.
    pub(super) below: Below,
}

impl BaseRivers {
    /// The network of the river edges with these numbers, in their order.
    pub(super) fn new(mesh: &ControlMesh, numbers: Vec<u32>) -> Self {
        let river_edge = |edge| RiverEdge::of(mesh, edge);
        let edges: Vec<RiverEdge> = numbers.into_iter().map(river_edge).collect();
        let below = Below::new(mesh.vertices.len(), &edges);
        Self { edges, below }
    }

    /// The vertices that rivers leave, in order.
    pub(super) fn upper_ends(&self) -> &[usize] {
        &self.below.from
    }
}

/// The largest river that arrives at each vertex.
pub(super) struct LargestAbove(Vec<u32>);

impl LargestAbove {
    /// Those of a network whose discharges are settled.
    pub(super) fn new(network: &BaseRivers, vertices: &[Vertex]) -> Self {
        Self::of_rivers(network.edges.iter().map(|river| river.ends), vertices)
    }

    /// The largest river that joins each of these.
    pub(super) fn joining(&self, network: &BaseRivers, vertices: &[Vertex]) -> Self {
        let rivers = network.edges.iter().map(|river| river.ends);
        let joins = |&[up, down]: &[usize; 2]| self.of(down) != Some(up);
        Self::of_rivers(rivers.filter(joins), vertices)
    }

    fn of_rivers(rivers: impl Iterator<Item = [usize; 2]>, vertices: &[Vertex]) -> Self {
        // Of equal rivers the seed decides, not the number of a vertex.
        let rank = |v: usize| (vertices[v].discharge, vertices[v].seed);
        let mut largest = Self(vec![NONE; vertices.len()]);
        for [up, down] in rivers {
            if largest.of(down).is_none_or(|other| rank(up) > rank(other)) {
                largest.0[down] = up as u32;
            }
        }
        largest
    }

    /// The vertex upstream from which the largest river arrives.
    pub(super) fn of(&self, v: usize) -> Option<usize> {
        let up = self.0[v];
        (up != NONE).then_some(up as usize)
    }
}

/// The vertices that rivers lead to: one from most, several from the apex of a delta.
pub(super) struct Below {
    /// Vertices that rivers leave, in order.
    from: Vec<usize>,
    /// Those of vertex v: `to[starts[v]..starts[v + 1]]`.
    starts: Vec<u32>,
    to: Vec<usize>,
}

impl Below {
    fn new(vertices: usize, edges: &[RiverEdge]) -> Self {
        let mut rivers: Vec<[usize; 2]> = edges.iter().map(|river| river.ends).collect();
        // Stable, so that arms stay in the order of their edges.
        rivers.sort_by_key(|&[up, _]| up);
        let mut starts = vec![0; vertices + 1];
        for &[up, _] in &rivers {
            starts[up + 1] += 1;
        }
        for v in 0..vertices {
            starts[v + 1] += starts[v];
        }
        let mut from: Vec<usize> = rivers.iter().map(|&[up, _]| up).collect();
        from.dedup();
        let to = rivers.into_iter().map(|[_, down]| down).collect();
        Self { from, starts, to }
    }

    /// Where the rivers from a vertex lead.
    pub(super) fn of(&self, v: usize) -> &[usize] {
        &self.to[self.starts[v] as usize..self.starts[v + 1] as usize]
    }
}

/// A discharge as its arms share it: in proportion to those that they came with. The parts make
/// the whole to the unit.
pub(super) fn parts(vertices: &[Vertex], whole: u32, arms: &[usize]) -> Vec<u32> {
    let weights = arms
        .iter()
        .map(|&v| u64::from(vertices[v].discharge).max(1));
    let sum: u64 = weights.clone().sum();
    let mut parts = Vec::with_capacity(arms.len());
    let (mut weight, mut given) = (0, 0);
    for own in weights {
        weight += own;
        // Differences of rounded sums.
        let up_to_here = (u128::from(whole) * u128::from(weight) / u128::from(sum)) as u32;
        parts.push(up_to_here - given);
        given = up_to_here;
    }
    parts
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
