//! Pass: an edge gets the vertex that halves it (paper 002 §5.1, rules R1 to R5, and §5.2).
//!
//! Reads the edge, its ends and the corners opposite to it on both sides; writes one vertex. The
//! vertex's kind may still change to a gully ([`vertex_resolve`](super::vertex_resolve)), and its
//! distances are estimates until then.

mod place;

use super::control::VertexKind;
use super::fixed::difference;
use super::rules::{self, EdgeKind, Rules};
use super::scale::PlanetScale;
use super::seed::between;
use super::topology::Edge;
use super::vertex::{Bend, EdgeContext, FAR, RiverSegment, ValleySection, Vertex};
use place::place;

/// First level whose edges stay straight and whose faces decide nothing: a vertex then follows from
/// its parents alone, but for a river beside it. Its edges are 25 m long on an Earth-sized planet.
pub const STRAIGHT_LEVEL: u32 = 11;

/// The vertex that halves an edge of a level. `ends` are those of the edge, in its order.
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
    let length = scale.grains(difference(b.direction, a.direction));
    let placed = place(rules, edge.kind, level, &new, ends, opposite);
    new.direction = placed.direction;
    new.heading = placed.heading;
    if placed.heading != [0; 3] {
        new.bend = Bend::LIMB;
    }
    // An estimate for the rules; the faces beside the edge settle it later.
    new.river_distance = expected_distance(edge.kind, ends, length);
    new.discharge = gathered(a, edge);
    if edge.kind == EdgeKind::River {
        new.tide = mean(a.tide, b.tide);
    }
    let context = EdgeContext {
        a,
        b,
        new: &new,
        face: placed.face,
        length,
        span: scale.edge_grains(level),
        level,
        radius_m: scale.radius_m,
    };
    // The rules see the vertex complete but for its ground.
    let ground = rules::halve(rules, edge.kind, &context);
    let mut new = Vertex {
        kind: ground.kind,
        height: ground.height,
        bed: ground.bed,
        water: ground.water,
        ..new
    };
    settle_water(edge.kind, &mut new, a, b);
    new
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

/// Keeps lakes level and water from rising downstream, whatever the graph says.
fn settle_water(kind: EdgeKind, new: &mut Vertex, a: &Vertex, b: &Vertex) {
    // 0 is no lake.
    let lake = a.lake | b.lake;
    // Between two vertices of one lake its surface goes on, whatever was drawn.
    if lake != 0 && is_one_lake(a, b) {
        new.kind = VertexKind::Lake;
        new.height = a.bed + (b.bed - a.bed) / 2;
        new.bed = new.height;
        new.water = a.water;
        new.lake = lake;
        new.discharge = new.discharge.max(a.discharge.min(b.discharge));
    } else if new.kind == VertexKind::Lake {
        // Its flow shapes its shores; it brings its river nothing.
        new.lake = if lake == 0 { new.seed | 1 } else { lake };
        new.discharge = a.discharge.max(b.discharge) / 16;
    } else if kind == EdgeKind::River {
        // Water never lies below that of the lower end.
        new.water = new.water.max(new.bed).max(b.water);
    } else if new.kind == VertexKind::Terrain {
        hold_back_lakes(new, [a, b]);
    }
    if !new.is_wet() {
        new.discharge = 0;
    }
}

/// Whether two vertices lie in the same lake, or in a lake and in a river that has its level.
fn is_one_lake(a: &Vertex, b: &Vertex) -> bool {
    let is_wet = a.is_wet() && b.is_wet();
    is_wet && a.water == b.water && (a.lake == b.lake || a.lake == 0 || b.lake == 0)
}

/// Raises dry land above the lakes beside it: a lake does not spill over its shore.
fn hold_back_lakes(new: &mut Vertex, ends: [&Vertex; 2]) {
    for lake in ends.iter().filter(|v| v.kind == VertexKind::Lake) {
        new.height = new.height.max(lake.water + 1);
    }
    new.bed = new.height;
    new.water = new.height;
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
        section: ValleySection::between(a.section, b.section),
        gully_bed: 0,
        gully_distance: FAR,
        lake: 0,
        crust: a.crust + (b.crust - a.crust) / 2,
        kind: VertexKind::Terrain,
        level: level as u8 + 1,
        valley: if seed & 1 == 0 { a.valley } else { b.valley },
        tide: 0,
        branched: false,
        bend: Bend::default(),
        birth: 0,
        age: mean(a.age, b.age),
        collision: mean(a.collision, b.collision),
        wetness: mean(a.wetness, b.wetness),
        plateau: mean(a.plateau, b.plateau),
        hills: mean(a.hills, b.hills),
        oceanic: mean(a.oceanic, b.oceanic),
        ocean_age: mean(a.ocean_age, b.ocean_age),
        fold: undirected_mean(a.fold, b.fold),
        ridge: undirected_mean(a.ridge, b.ridge),
        heading: [0; 3],
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
