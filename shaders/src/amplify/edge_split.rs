//! Pass: an edge gets the vertex that halves it (paper 002 §5.1, rules R1 to R5, and §5.2).
//!
//! Reads the edge, its ends and the corners opposite to it on both sides; writes one vertex. The vertex's kind may
//! still change to a gully ([`vertex_resolve`](super::vertex_resolve)), and its distances are estimates until then.

use super::control::VertexKind;
use super::fixed::{Q16, difference, lift, mul_high, square_q32, weigh};
use super::geometry::{is_tall, overhang, stands_over};
use super::planet::Planet;
use super::rules::{self, EdgeKind, Rules, shift::Shift};
use super::seed::between;
use super::topology::Edge;
use super::vertex::{EdgeContext, FAR, Segment, Vertex};

/// First level whose edges stay straight and whose faces decide nothing: a vertex then follows from its parents alone,
/// but for a river beside it. Its edges are 25 m long on an Earth-sized planet.
pub const STRAIGHT_LEVEL: u32 = 11;

/// Share of its displacement that an edge takes beside a flat or leaning triangle, Q16.
const LEANING: i32 = 30_000;

/// The vertex that halves an edge of a level. `ends` are those of the edge, in its order.
pub fn split(
    planet: &Planet,
    rules: &Rules,
    edge: &Edge,
    level: u32,
    ends: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> Vertex {
    let [a, b] = ends;
    let mut new = average(a, b, level);
    let length = planet.grains(difference(b.direction, a.direction));
    new.direction = place(rules, edge.kind, level, &new, ends, opposite);
    new.river_distance = expected_distance(edge.kind, ends, length);
    new.discharge = if edge.kind == EdgeKind::River { gathered(a, edge) } else { 0 };
    let context = EdgeContext { a, b, new: &new, length, level, radius_m: planet.radius_m };
    let ground = rules::halve(rules, edge.kind, &context);
    (new.kind, new.height, new.bed, new.water) = (ground.kind, ground.height, ground.bed, ground.water);
    settle_water(edge.kind, &mut new, a, b);
    new
}

/// Discharge in the middle of a river edge: half of what the edge gains has come by then.
#[inline]
fn gathered(up: &Vertex, edge: &Edge) -> u32 {
    up.discharge + edge.arriving.saturating_sub(up.discharge) / 2
}

/// Keeps lakes level and water from rising downstream, whatever the graph says.
fn settle_water(kind: EdgeKind, new: &mut Vertex, a: &Vertex, b: &Vertex) {
    let same_lake =
        a.is_wet() && b.is_wet() && a.water == b.water && (a.lake == b.lake || a.lake == 0 || b.lake == 0);
    if same_lake && (a.lake | b.lake) != 0 {
        let bed = a.bed + (b.bed - a.bed) / 2;
        (new.kind, new.height, new.bed, new.water) = (VertexKind::Lake, bed, bed, a.water);
        new.lake = a.lake | b.lake;
    } else if new.kind == VertexKind::Lake {
        new.lake = new.seed | 1;
    } else if kind == EdgeKind::River {
        new.water = new.water.max(new.bed).max(b.water);
    } else if new.kind == VertexKind::Terrain {
        // A lake does not spill over its shore.
        for lake in [a, b] {
            if lake.kind == VertexKind::Lake {
                new.height = new.height.max(lake.water + 1);
            }
        }
        (new.bed, new.water) = (new.height, new.height);
    }
    if new.kind != VertexKind::River && new.kind != VertexKind::Lake {
        new.discharge = 0;
    }
}

/// Everything that is the mean of the parents'.
fn average(a: &Vertex, b: &Vertex, level: u32) -> Vertex {
    let seed = between(a.seed, b.seed);
    let mean = |x: u16, y: u16| ((u32::from(x) + u32::from(y)) >> 1) as u16;
    Vertex {
        direction: a.direction,
        height: 0,
        seed,
        bed: 0,
        water: 0,
        discharge: 0,
        river: Segment::default(),
        river_distance: FAR,
        river_along: 0,
        gully_bed: 0,
        gully_distance: FAR,
        lake: 0,
        crust: a.crust + (b.crust - a.crust) / 2,
        kind: VertexKind::Terrain,
        level: level as u8 + 1,
        valley: if seed & 1 == 0 { a.valley } else { b.valley },
        branched: false,
        age: mean(a.age, b.age),
        collision: mean(a.collision, b.collision),
        wetness: mean(a.wetness, b.wetness),
        plateau: mean(a.plateau, b.plateau),
        hills: mean(a.hills, b.hills),
        oceanic: mean(a.oceanic, b.oceanic),
        ocean_age: mean(a.ocean_age, b.ocean_age),
        fold: undirected_mean(a.fold, b.fold),
        ridge: undirected_mean(a.ridge, b.ridge),
    }
}

/// Mean of two undirected vectors: the second is turned to the first's side.
fn undirected_mean(a: [i16; 3], b: [i16; 3]) -> [i16; 3] {
    let (u, v) = (a.map(i32::from), b.map(i32::from));
    // Components of 15 bits, halved so that three products fit.
    let dot = (0..3).map(|i| (u[i] >> 1) * (v[i] >> 1)).sum::<i32>();
    let sign = if dot < 0 { -1 } else { 1 };
    [0, 1, 2].map(|i| ((u[i] + sign * v[i]) / 2) as i16)
}

/// The nearest river's distance as the parents know it.
fn expected_distance(kind: EdgeKind, [a, b]: [&Vertex; 2], length: i32) -> i32 {
    if kind == EdgeKind::River {
        return 0;
    }
    match (a.river_distance, b.river_distance) {
        (0, 0) => length / 2,
        (FAR, FAR) => FAR,
        (FAR, d) | (d, FAR) => (d + length / 2).min(FAR),
        (d, e) => d / 2 + e / 2,
    }
}

/// Where the new vertex lies: the edge's middle, moved sideways within its safe zone (§5.2), on the sphere.
fn place(
    rules: &Rules,
    kind: EdgeKind,
    level: u32,
    new: &Vertex,
    [a, b]: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> [i32; 3] {
    let ab = difference(b.direction, a.direction);
    if level < STRAIGHT_LEVEL
        && let [Some(x), Some(y)] = opposite
    {
        let shift = rules::shift::shift(rules, kind, [a.kind, b.kind], level, new.seed, new.wetness);
        let (ax, ay) = (difference(x.direction, a.direction), difference(y.direction, a.direction));
        let mut shift = shift;
        if !(stands_over(ab, ax) && stands_over(ab, ay)) {
            let tall = is_tall(ab, ax, 2) && is_tall(ab, ay, 2);
            shift.weight = if tall { weigh(shift.weight, LEANING) } else { 0 };
        }
        if shift.weight > 0 {
            return displaced(&shift, a.direction, ab, if shift.second { ay } else { ax });
        }
    }
    // Halves round to either side by the seed, so that no direction is favoured.
    let odd = (new.seed >> 7 & 1) as i32;
    lift([0, 1, 2].map(|i| a.direction[i] + ((ab[i] + odd) >> 1)), square_q32(ab) / 4)
}

/// The point a + w_b·ab + w_x·ax, lifted to the sphere by its exact deficit Σ wᵢwⱼ|pᵢ - pⱼ|².
fn displaced(shift: &Shift, a: [i32; 3], ab: [i32; 3], ax: [i32; 3]) -> [i32; 3] {
    let third = shift.inward / 3;
    let along = weigh(Q16 - shift.inward, shift.along) + third;
    let wx = weigh(shift.weight, third);
    // A corner that leans over an end of the edge draws upwards only, not along.
    let wb = Q16 / 2 + weigh(shift.weight, along - Q16 / 2) - weigh(wx, overhang(ab, ax));
    let wa = Q16 - wb - wx;
    let point = [0, 1, 2].map(|i| a[i] + weigh(wb, ab[i]) + weigh(wx, ax[i]));
    let squares = [square_q32(ab), square_q32(ax), square_q32(difference(ax, ab))];
    // Shares below 1 in Q16, their products in Q32.
    let part = |u: i32, v: i32, square: u32| mul_high((u as u32) * (v as u32), square);
    lift(point, part(wa, wb, squares[0]) + part(wa, wx, squares[1]) + part(wb, wx, squares[2]))
}
