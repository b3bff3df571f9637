//! Pass: a face decides what lies along its inner edges (paper 002 §5.1, rules Ia to Ic with the
//! condition β).
//!
//! Reads the face's corners, edges and new vertices, and the corners beyond its edges; writes three
//! [`Inner`]s. An inner edge at the corner where a river edge begins may become a tributary: it
//! leaves at an acute angle, climbs, and lies in the one of the river's two faces that a draw of
//! both chooses, so that a junction has one tributary. Where β fails it may become a gully.

use super::control::VertexKind;
use super::edge_split::STRAIGHT_LEVEL;
use super::fixed::difference;
use super::geometry::dot;
use super::rules::{EdgeKind, Rules, gully};
use super::seed::pcg;
use super::topology::{Edge, Inner};
use super::vertex::Vertex;

/// What a face's decision depends on.
pub struct FaceContext<'a> {
    /// Indices of the corners, as the edges name them.
    pub corners: [u32; 3],
    /// The corners.
    pub vertices: [&'a Vertex; 3],
    /// The edges.
    pub edges: [&'a Edge; 3],
    /// The new vertices on the edges.
    pub mids: [&'a Vertex; 3],
    /// Their kinds before any face changed them.
    pub kinds: [VertexKind; 3],
    /// The corners beyond the edges.
    pub beyond: [Option<&'a Vertex>; 3],
}

/// Decides the three inner edges of a face of a level.
pub fn decide(rules: &Rules, level: u32, sight: &FaceContext) -> [Inner; 3] {
    let mut inner = [Inner::Terrain; 3];
    if level >= STRAIGHT_LEVEL || sight.edges.iter().all(|e| e.kind == EdgeKind::Terrain) {
        return inner;
    }
    for (k, inner) in inner.iter_mut().enumerate() {
        let other = (k + 2) % 3;
        let drained = [k, other].map(|e| sight.edges[e].kind != EdgeKind::Terrain);
        *inner = match drained {
            [true, false] => drain(
                rules,
                level,
                sight,
                k,
                k,
                other,
                Inner::RiverToFirst,
                Inner::GullyToFirst,
            ),
            [false, true] => drain(
                rules,
                level,
                sight,
                k,
                other,
                k,
                Inner::RiverToSecond,
                Inner::GullyToSecond,
            ),
            _ => Inner::Terrain,
        };
    }
    inner
}

/// What the inner edge at a corner becomes, between the drained edge `low` and the ground's edge
/// `high`.
fn drain(
    rules: &Rules,
    level: u32,
    sight: &FaceContext,
    corner: usize,
    low: usize,
    high: usize,
    river: Inner,
    dry: Inner,
) -> Inner {
    let (edge, junction, tip) = (sight.edges[low], sight.mids[low], sight.mids[high]);
    let (junction_kind, tip_kind) = (sight.kinds[low], sight.kinds[high]);
    let drains = matches!(junction_kind, VertexKind::River | VertexKind::Gully);
    // Only at the upstream corner can a tributary meet its river at an acute angle.
    if !drains || tip_kind != VertexKind::Terrain || sight.corners[corner] != edge.vertices[0] {
        return Inner::Terrain;
    }
    let next = (low + 1) % 3;
    let downstream = if next == corner { low } else { next };
    let flow = difference(
        sight.vertices[downstream].direction,
        sight.vertices[corner].direction,
    );
    if dot(flow, difference(junction.direction, tip.direction)) <= 0 || tip.height <= junction.water
    {
        return Inner::Terrain;
    }
    let seed = pcg(junction.seed ^ pcg(tip.seed));
    let off_gully = junction_kind == VertexKind::Gully;
    let chosen = chosen(junction, sight.vertices[(low + 2) % 3], sight.beyond[low]);
    let gains = junction.discharge > sight.vertices[corner].discharge + 1
        && sight.vertices[corner].is_wet();
    if !off_gully
        && chosen
        && gains
        && gully::is_tributary(
            rules,
            level,
            junction.flow(),
            junction.height,
            tip.height,
            seed,
        )
    {
        return river;
    }
    if gully::is_gully(rules, level, off_gully, junction.height, tip.height, seed) {
        dry
    } else {
        Inner::Terrain
    }
}

/// Whether the draw at a junction falls on the side of `here` rather than that of `beyond`.
fn chosen(junction: &Vertex, here: &Vertex, beyond: Option<&Vertex>) -> bool {
    beyond.is_some_and(|beyond| pcg(junction.seed ^ here.seed) > pcg(junction.seed ^ beyond.seed))
}
