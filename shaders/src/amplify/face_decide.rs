//! Pass: a face decides what lies along its inner edges (paper 002 §5.1, rules Ia to Ic with the
//! condition β).
//!
//! Reads the face's corners, edges and new vertices, and the corners beyond its edges; writes three
//! [`Inner`]s. An inner edge at the corner where a river edge begins may become a tributary: it
//! leaves at an acute angle, climbs, and lies in the one of the river's two faces that a draw of
//! both chooses, so that a junction has one tributary. Where β fails it may become a gully.

use super::control::VertexKind;
use super::fixed::difference;
use super::geometry::dot;
use super::rules::{EdgeKind, Rules, STRAIGHT_LEVEL, gully, valley};
use super::scale::PlanetScale;
use super::seed::pcg;
use super::topology::{Edge, EdgeSplit, FaceSplit, Inner, LevelMesh, gather};
use super::uniform::LevelUniform;
use super::vertex::Vertex;
use super::vertices::VertexView;

/// The neighbourhood that a face's decision depends on.
pub struct FaceContext<'a> {
    /// Indices of the corners, as the edges name them.
    pub corners: [u32; 3],
    /// The corners.
    pub vertices: [&'a Vertex; 3],
    /// The edges.
    pub edges: [&'a Edge; 3],
    /// The new vertices on the edges.
    pub mids: [&'a Vertex; 3],
    /// Kinds of the new vertices before any face changed them.
    pub kinds: [VertexKind; 3],
    /// The corners beyond the edges.
    pub beyond: [Option<&'a Vertex>; 3],
}

/// Pass: the inner edges of faces of a level.
pub fn face_decide(
    uniform: LevelUniform,
    mesh: &LevelMesh,
    edges: &[EdgeSplit],
    vertices: VertexView,
    decided: &[u32],
    faces: &mut [FaceSplit],
) {
    if uniform.level >= STRAIGHT_LEVEL {
        return;
    }
    for &f in decided {
        faces[f as usize].inner = inner_of(uniform, mesh, edges, vertices, f);
    }
}

/// The inner edges of one face.
fn inner_of(
    uniform: LevelUniform,
    mesh: &LevelMesh,
    splits: &[EdgeSplit],
    vertices: VertexView,
    f: u32,
) -> [Inner; 3] {
    let face = &mesh.faces[f as usize];
    let edges = gather(&mesh.edges, face.edges);
    // Most faces have no drainage: then nothing is to be decided.
    if edges.iter().all(|e| e.kind == EdgeKind::Terrain) {
        return [Inner::Terrain; 3];
    }
    let mids = vertices.gather(gather(splits, face.edges).map(|e| e.mid));
    let context = FaceContext {
        corners: face.vertices,
        vertices: vertices.gather(face.vertices),
        edges,
        mids,
        kinds: mids.map(|mid| mid.kind),
        beyond: face
            .edges
            .map(|e| mesh.beyond(e, f).map(|v| vertices.get(v))),
    };
    decide(uniform.scale, uniform.rules, uniform.level, &context)
}

/// Decides the three inner edges of a face of a level.
pub fn decide(scale: &PlanetScale, rules: &Rules, level: u32, face: &FaceContext) -> [Inner; 3] {
    if level >= STRAIGHT_LEVEL {
        return [Inner::Terrain; 3];
    }
    [0, 1, 2].map(|k| {
        let other = (k + 2) % 3;
        let is_drained = |e: usize| face.edges[e].kind != EdgeKind::Terrain;
        // Drainage begins between a drained edge and ground: between two of a kind there is no
        // corner to drain, or it drains already.
        let (low, high) = match (is_drained(k), is_drained(other)) {
            (true, false) => (k, other),
            (false, true) => (other, k),
            _ => return Inner::Terrain,
        };
        let corner = Corner { k, low, high };
        match (corner.drainage(scale, rules, level, face), low == k) {
            (EdgeKind::Terrain, _) => Inner::Terrain,
            (EdgeKind::River, true) => Inner::RiverToFirst,
            (EdgeKind::River, false) => Inner::RiverToSecond,
            (EdgeKind::Gully, true) => Inner::GullyToFirst,
            (EdgeKind::Gully, false) => Inner::GullyToSecond,
        }
    })
}

/// The draw of the corner on one side of a river edge, at the junction that halves it: a tributary
/// comes from the side with the higher one.
pub fn junction_draw(junction: &Vertex, side: &Vertex) -> u32 {
    pcg(junction.seed ^ side.seed)
}

/// A corner of a face between an edge with a river or gully and an edge of the ground.
struct Corner {
    /// The corner.
    k: usize,
    /// The drained edge.
    low: usize,
    /// The ground's edge.
    high: usize,
}

impl Corner {
    /// The kind of the inner edge that cuts the corner off.
    fn drainage(
        &self,
        scale: &PlanetScale,
        rules: &Rules,
        level: u32,
        face: &FaceContext,
    ) -> EdgeKind {
        if !self.may_drain(face) {
            return EdgeKind::Terrain;
        }
        let (junction, tip) = (face.mids[self.low], face.mids[self.high]);
        let (height, spring) = (junction.height, tip.height);
        let seed = pcg(junction.seed ^ pcg(tip.seed));
        // A gully has no water to share: off it only gullies branch.
        let off_gully = face.kinds[self.low] == VertexKind::Gully;
        // A river that winds about its axis passes the middle of its edge aside.
        let winds = valley::keeps_course(scale, rules, level, face.vertices[self.k].flow());
        if !off_gully
            && !winds
            && self.is_chosen(face)
            && self.gains_water(face)
            && gully::is_tributary(rules, level, junction.flow(), height, spring, seed)
        {
            EdgeKind::River
        } else if gully::is_gully(rules, level, off_gully, height, spring, seed) {
            EdgeKind::Gully
        } else {
            EdgeKind::Terrain
        }
    }

    /// Whether water from the ground's edge could join the drained one: downhill, and at an acute
    /// angle.
    fn may_drain(&self, face: &FaceContext) -> bool {
        let is_drain = matches!(face.kinds[self.low], VertexKind::River | VertexKind::Gully);
        // Only at the upstream corner can a tributary meet its river at an acute angle.
        let is_upstream = face.corners[self.k] == face.edges[self.low].vertices[0];
        if !is_drain || face.kinds[self.high] != VertexKind::Terrain || !is_upstream {
            return false;
        }
        let (junction, tip) = (face.mids[self.low], face.mids[self.high]);
        let inflow = difference(junction.direction, tip.direction);
        dot(self.flow(face), inflow) > 0 && tip.height > junction.water
    }

    /// The way of the drained edge's water, from the corner downstream.
    fn flow(&self, face: &FaceContext) -> [i32; 3] {
        let next = (self.low + 1) % 3;
        // The edge's two ends are corners `low` and `next`; the water comes from `k`.
        let downstream = if next == self.k { self.low } else { next };
        let [to, from] = [downstream, self.k].map(|k| face.vertices[k].direction);
        difference(to, from)
    }

    /// Whether the draw at the junction falls on this face rather than the one beyond the river.
    fn is_chosen(&self, face: &FaceContext) -> bool {
        // The face beyond compares the same two draws the other way round, so one of them is
        // chosen without either asking the other.
        let draw = |side| junction_draw(face.mids[self.low], side);
        let here = face.vertices[(self.low + 2) % 3];
        face.beyond[self.low].is_some_and(|beyond| draw(here) > draw(beyond))
    }

    /// Whether the river gains water between the corner and the junction, which a tributary can
    /// bring.
    fn gains_water(&self, face: &FaceContext) -> bool {
        let upstream = face.vertices[self.k];
        upstream.is_wet() && face.mids[self.low].discharge > upstream.discharge.saturating_add(1)
    }
}
