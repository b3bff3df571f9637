//! Pass: an edge gets the vertex that halves it (paper 002 §5.1, rules R1 to R5, and §5.2).
//!
//! Reads the edge, its ends and the corners opposite to it on both sides; writes one vertex. The
//! vertex's kind may still change to a gully ([`vertex_resolve`](super::vertex_resolve)), and its
//! distances are estimates until then.

pub(in crate::amplify) mod course;
mod lakes;
pub(in crate::amplify) mod place;

use super::arith::ratio;
use super::control::VertexKind;
use super::curve::heading_of;
use super::face_decide::junction_draw;
use super::fixed::{Q16, difference};
use super::rules::ocean::OceanCache;
use super::rules::{self, EdgeKind, Rules, STRAIGHT_LEVEL, VertexGround, gully, meander, ocean};
use super::scale::PlanetScale;
use super::seed::between;
use super::topology::{Edge, LevelMesh};
use super::uniform::LevelUniform;
use super::vertex::{CornerBeside, EdgeContext, FAR, RiverSegment, ValleySection, Vertex};
use super::vertices::VertexView;
use course::{Course, on_course};
use place::{Placed, place, shares};

/// Pass: the vertices that halve edges of a level, in the order of the list; `vertices` are those of
/// coarser levels.
pub fn edge_split(
    uniform: LevelUniform,
    mesh: &LevelMesh,
    vertices: VertexView,
    halved: &[u32],
    new: &mut [Vertex],
) {
    let LevelUniform {
        scale,
        rules,
        level,
    } = uniform;
    let mut cache = OceanCache::default();
    for (&e, new) in halved.iter().zip(new) {
        let edge = &mesh.edges[e as usize];
        let ends = vertices.gather(edge.vertices);
        // Straight edges do not move sideways and need no corners; rivers keep their course.
        let opposite = if level < STRAIGHT_LEVEL || edge.kind == EdgeKind::River {
            [0, 1].map(|side| mesh.opposite(e, side).map(|v| vertices.get(v)))
        } else {
            [None; 2]
        };
        *new = split(scale, rules, edge, level, ends, opposite);
        ocean::settle(&mut cache, new, ends);
    }
}

/// The vertex that halves an edge of a level, but for the sea floor's relief. `ends` are those of the
/// edge, in its order.
pub fn split(
    scale: &PlanetScale,
    rules: &Rules,
    edge: &Edge,
    level: u32,
    ends: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> Vertex {
    let [a, b] = ends;
    let mut new = average(a, b, level);
    let length = length(scale, ends);
    let course = course(scale, rules, edge, level, ends);
    let placed = placed(
        rules,
        edge.kind,
        level,
        &new,
        course.as_ref(),
        ends,
        opposite,
    );
    new.direction = placed.direction;
    new.swell = placed.swell;
    new.crust = rules::fold::summits(rules, level, &new, ends);
    if edge.kind == EdgeKind::River {
        lead_river(&mut new, course.as_ref(), ends, opposite, length);
    }
    // An estimate for the rules; the faces beside the edge settle it later.
    new.river_distance = expected_distance(edge.kind, ends, length);
    new.discharge = gathered(a, edge);
    (new.lake, new.lake_level) = lakes::around(level, ends, opposite);
    new.is_drained = gully::is_drained(edge.kind, level, new.seed, ends);
    // The rules see the vertex complete but for its ground.
    let context = edge_context(scale, edge, level, &new, placed.face, ends, opposite);
    let ground = rules::halve(rules, edge.kind, &context);
    let mut new = on_ground(new, ground);
    lakes::settle(rules, edge.kind, &mut new, a, b);
    new
}

/// An edge of a level as the rules of its new vertex see it, on a flat face that is `face` high.
fn edge_context<'a>(
    scale: &PlanetScale,
    edge: &Edge,
    level: u32,
    new: &'a Vertex,
    face: i32,
    [a, b]: [&'a Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> EdgeContext<'a> {
    let ends = [a, b];
    EdgeContext {
        a,
        b,
        new,
        face,
        range: range(ends, opposite),
        is_dammed: lakes::is_dammed(ends, opposite),
        curvature: curvature(ends, opposite),
        beside: opposite.map(|corner| corner.map(|v| beside(scale, new, v))),
        is_descent: edge.is_descent,
        length: length(scale, ends),
        span: scale.edge_grains(level),
        level,
        radius_m: scale.radius_m,
    }
}

/// Length of an edge between two vertices, grains.
fn length(scale: &PlanetScale, [a, b]: [&Vertex; 2]) -> i32 {
    scale.grains(difference(b.direction, a.direction))
}

/// The place of a new vertex: on the course of a river, else beside the middle of its edge.
fn placed(
    rules: &Rules,
    edge: EdgeKind,
    level: u32,
    new: &Vertex,
    course: Option<&Course>,
    ends: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> Placed {
    let shares = match course {
        Some(course) => on_course(course, new.seed, ends, opposite),
        None => shares(rules, edge, level, new, ends, opposite),
    };
    place(new.seed, shares, ends, opposite)
}

/// A vertex with the ground that the rules have decided for it.
fn on_ground(vertex: Vertex, ground: VertexGround) -> Vertex {
    Vertex {
        kind: ground.kind,
        height: ground.height,
        bed: ground.bed,
        water: ground.water,
        ..vertex
    }
}

/// A corner opposite to the edge that a new vertex halves, as the new vertex sees it.
fn beside(scale: &PlanetScale, new: &Vertex, corner: &Vertex) -> CornerBeside {
    CornerBeside {
        height: corner.height,
        distance: scale.grains(difference(corner.direction, new.direction)),
    }
}

/// Lowest and highest ground of an edge's ends and of the corners beyond it.
fn range([a, b]: [&Vertex; 2], opposite: [Option<&Vertex>; 2]) -> [i32; 2] {
    let mut range = [a.height.min(b.height), a.height.max(b.height)];
    for corner in opposite.into_iter().flatten() {
        range = [range[0].min(corner.height), range[1].max(corner.height)];
    }
    range
}

/// Leads a river through the vertex that halves its edge: its heading there, its tide, its winding.
fn lead_river(
    new: &mut Vertex,
    course: Option<&Course>,
    [a, b]: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
    length: i32,
) {
    let chord = difference(b.direction, a.direction);
    let way = course.map_or(chord, |course| course.curve.quarter_tangent(Q16 / 2));
    new.heading = heading_of(way);
    new.tide = mean(a.tide, b.tide);
    // A lake may come to lie here, which has no bends.
    if b.kind != VertexKind::Lake {
        let fall = ratio(a.water.saturating_sub(b.water), length.max(1));
        // The side that a tributary would come from.
        let [left, right] = opposite.map(|side| side.map(|side| junction_draw(new, side)));
        new.winding = meander::winding(fall, new.seed, left > right);
    }
}

/// The course of a river along its edge; `None` where none runs from end to end.
fn course(
    scale: &PlanetScale,
    rules: &Rules,
    edge: &Edge,
    level: u32,
    ends: [&Vertex; 2],
) -> Option<Course> {
    if edge.kind != EdgeKind::River || !rules.landforms || !ends[0].is_wet() {
        return None;
    }
    let river = RiverSegment::between(edge.birth, level, ends, edge.arriving);
    Some(Course {
        curve: river.curve(),
        is_kept: RiverSegment::is_kept(scale, rules, edge, level, ends),
    })
}

/// How far the ground beside an edge bends up, grains: a quarter of the height of the corners over
/// the ends; 0 where edges are straight.
fn curvature([a, b]: [&Vertex; 2], opposite: [Option<&Vertex>; 2]) -> i32 {
    let [Some(x), Some(y)] = opposite else {
        return 0;
    };
    (x.height - a.height) / 4 + (y.height - b.height) / 4
}

/// Discharge in the middle of an edge: on a river, half of what the edge gains has come by then. An
/// arm of a delta loses the other arms' at its upper end.
#[inline]
fn gathered(up: &Vertex, edge: &Edge) -> u32 {
    match edge.kind {
        EdgeKind::River if edge.arriving < up.discharge => edge.arriving,
        EdgeKind::River => up.discharge + (edge.arriving - up.discharge) / 2,
        _ => 0,
    }
}

/// A vertex whose maps are the mean of its parents', without a place, a height or water.
fn average(a: &Vertex, b: &Vertex, level: u32) -> Vertex {
    let seed = between(a.seed, b.seed);
    Vertex {
        direction: a.direction,
        height: 0,
        seed,
        bed: 0,
        water: 0,
        discharge: 0,
        river: RiverSegment::default(),
        river_distance: FAR,
        river_along: 0,
        heading: [0; 3],
        section: ValleySection::between(a.section, b.section),
        lake: 0,
        lake_level: 0,
        crust: a.crust + (b.crust - a.crust) / 2,
        kind: VertexKind::Terrain,
        level: level as u8 + 1,
        valley: if seed & 1 == 0 { a.valley } else { b.valley },
        tide: 0,
        branched: false,
        is_drained: false,
        worn: mean(a.worn, b.worn),
        winding: 0,
        keeps_course: false,
        collision: mean(a.collision, b.collision),
        wetness: mean(a.wetness, b.wetness),
        plateau: mean(a.plateau, b.plateau),
        hills: mean(a.hills, b.hills),
        oceanic: mean(a.oceanic, b.oceanic),
        ocean_age: mean(a.ocean_age, b.ocean_age),
        swell: 0,
        fold: undirected_mean(a.fold, b.fold),
        ridge: undirected_mean(a.ridge, b.ridge),
    }
}

/// Mean of two numbers, rounded down.
const fn mean(x: u16, y: u16) -> u16 {
    ((x as u32 + y as u32) >> 1) as u16
}

/// Mean of two undirected vectors: the second is turned to the first's side.
fn undirected_mean(a: [i16; 3], b: [i16; 3]) -> [i16; 3] {
    let (u, v) = (a.map(i32::from), b.map(i32::from));
    // Components of 15 bits, halved so that three products fit.
    let dot = (0..3).map(|i| (u[i] >> 1) * (v[i] >> 1)).sum::<i32>();
    // An axis has no sign: the nearer of the two directions counts.
    let sign = if dot < 0 { -1 } else { 1 };
    [0, 1, 2].map(|i| ((u[i] + sign * v[i]) / 2) as i16)
}

/// The nearest river's distance as the parents know it.
fn expected_distance(kind: EdgeKind, [a, b]: [&Vertex; 2], length: i32) -> i32 {
    if kind == EdgeKind::River {
        return 0;
    }
    // FAR is no number to average: the end that knows a river counts.
    match (a.river_distance, b.river_distance) {
        (0, 0) => length / 2,
        (FAR, FAR) => FAR,
        (FAR, d) | (d, FAR) => d.min(FAR - length / 2) + length / 2,
        (d, e) => d / 2 + e / 2,
    }
}
