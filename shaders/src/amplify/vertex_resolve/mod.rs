//! Pass: a new vertex settles its kind and its distances, once the faces on both sides have
//! decided.
//!
//! Reads the two faces' decisions and the rivers and gullies along their edges; writes the one
//! vertex. A river outranks a gully, a gully outranks ground, whatever the order in which the faces
//! asked.

pub(in crate::amplify) mod river;

use super::control::VertexKind;
use super::rules::{EdgeKind, Rules};
use super::scale::PlanetScale;
use super::topology::{Edge, EdgeSplit, Inner, Level, SplitMark};
use super::uniform::LevelUniform;
use super::vertex::{ValleySection, Vertex};
use super::vertices::{VertexView, Vertices};
use river::NearestRiver;
pub use river::most_move;

/// Pass: the vertices of split edges settle. Each reads the middles of the edges beside its own, but
/// of those only what no settling changes.
pub fn vertex_resolve(
    uniform: LevelUniform,
    level: &Level,
    halved: &[u32],
    vertices: &mut Vertices,
) {
    for &e in halved {
        let EdgeSplit { mid, mark, .. } = level.edges[e as usize];
        if mark == SplitMark::Split {
            let around = around_edge(level, vertices.view(), e);
            let new = vertices.view().get(mid);
            let settled = resolve(uniform.scale, uniform.rules, uniform.level, new, &around);
            settled.write(vertices.grown_mut(mid));
        }
    }
}

/// The surroundings of the vertex that halves an edge.
fn around_edge<'a>(level: &'a Level, vertices: VertexView<'a>, e: u32) -> VertexContext<'a> {
    let mesh = &level.mesh;
    let edge = &mesh.edges[e as usize];
    let mut around = VertexContext {
        edge,
        ends: vertices.gather(edge.vertices),
        opposite: [0, 1].map(|side| mesh.opposite(e, side).map(|v| vertices.get(v))),
        requests: Requests::default(),
        beside: [None; 4],
    };
    for side in 0..2 {
        let Some(face) = mesh.faces.get(edge.faces[side] as usize) else {
            continue;
        };
        let inner = &level.faces[edge.faces[side] as usize].inner;
        let k = face.edges.iter().position(|&other| other == e).unwrap_or(0);
        around.requests = around.requests.and(Requests::of(inner, k));
        for j in 0..2 {
            // The face's other two edges, in the order of its winding.
            let other = face.edges[(k + 1 + j) % 3];
            around.beside[side * 2 + j] = drain_beside(level, vertices, other);
        }
    }
    around
}

/// An edge that runs along a river or a gully; `None` for another.
fn drain_beside<'a>(level: &'a Level, vertices: VertexView<'a>, e: u32) -> Option<DrainBeside<'a>> {
    let (edge, split) = (&level.mesh.edges[e as usize], &level.edges[e as usize]);
    (edge.kind != EdgeKind::Terrain).then(|| DrainBeside {
        edge,
        ends: vertices.gather(edge.vertices),
        mid: (split.mark != SplitMark::Leaf).then(|| vertices.get(split.mid)),
    })
}

/// An edge beside a vertex that runs along a river or a gully.
#[derive(Clone, Copy, Debug)]
pub struct DrainBeside<'a> {
    /// The edge.
    pub edge: &'a Edge,
    /// Its ends.
    pub ends: [&'a Vertex; 2],
    /// Its middle, where it has one.
    pub mid: Option<&'a Vertex>,
}

/// The neighbourhood that the settling of a new vertex depends on.
pub struct VertexContext<'a> {
    /// The edge that the vertex halves.
    pub edge: &'a Edge,
    /// Its ends.
    pub ends: [&'a Vertex; 2],
    /// The corners opposite to it.
    pub opposite: [Option<&'a Vertex>; 2],
    /// Requests of the two faces.
    pub requests: Requests,
    /// The other edges of the two faces that run along a river or a gully.
    pub beside: [Option<DrainBeside<'a>>; 4],
}

/// Requests of faces to a new vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Requests {
    /// Whether a gully starts here.
    pub gully_tip: bool,
    /// Whether a tributary starts here.
    pub river_tip: bool,
    /// Whether a tributary ends here.
    pub junction: bool,
}

impl Requests {
    /// The requests of a face to the vertex on its `k`th edge.
    pub fn of(inner: &[Inner; 3], k: usize) -> Self {
        // m_k is first on the inner edge of corner k, second on that of corner k + 1.
        let (first, second) = (inner[k], inner[(k + 1) % 3]);
        Self {
            gully_tip: first == Inner::GullyToSecond || second == Inner::GullyToFirst,
            river_tip: first == Inner::RiverToSecond || second == Inner::RiverToFirst,
            junction: first == Inner::RiverToFirst || second == Inner::RiverToSecond,
        }
    }

    /// The requests of both faces.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self {
            gully_tip: self.gully_tip | other.gully_tip,
            river_tip: self.river_tip | other.river_tip,
            junction: self.junction | other.junction,
        }
    }
}

/// Everything that the faces around a new vertex settle of it; the rest stays as its edge made it.
#[derive(Clone, Copy, Debug)]
pub struct Settled {
    kind: VertexKind,
    branched: bool,
    river: NearestRiver,
    section: ValleySection,
}

impl Settled {
    /// Writes what was settled into the vertex.
    #[inline]
    pub fn write(&self, vertex: &mut Vertex) {
        vertex.kind = self.kind;
        vertex.branched = self.branched;
        self.river.write(vertex);
        vertex.section = self.section;
    }
}

/// Settles a new vertex from the faces around it.
pub fn resolve(
    scale: &PlanetScale,
    rules: &Rules,
    level: u32,
    new: &Vertex,
    around: &VertexContext,
) -> Settled {
    let Requests {
        gully_tip,
        river_tip,
        junction,
    } = around.requests;
    // Only ground becomes a gully, and not where a tributary will spring.
    let becomes_gully = gully_tip && !river_tip && new.kind == VertexKind::Terrain;
    let kind = if becomes_gully {
        VertexKind::Gully
    } else {
        new.kind
    };
    let river = river::nearest(scale, rules, level, new, around);
    // Beside a river the side is measured; elsewhere it stays the mean of the parents.
    let section = if river.is_beside || river.is_near(scale, rules) {
        river.section(scale, rules, *new)
    } else {
        new.section
    };
    Settled {
        kind,
        branched: junction,
        river,
        section,
    }
}
