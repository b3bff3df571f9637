//! Pass: an edge gets the vertex that halves it (paper 002 §5.1, rules R1 to R5, and §5.2).
//!
//! Reads the edge, its ends and the corners opposite to it on both sides; writes one vertex. The
//! vertex's kind may still change to a gully ([`vertex_resolve`](super::vertex_resolve)), and its
//! distances are estimates until then.

use super::arith::{linear_step, ratio};
use super::control::VertexKind;
use super::fixed::{Q16, difference, lift, mul_high, q16, square_q32, weigh};
use super::geometry::{Q12, Stance};
use super::rules::{self, EdgeKind, Rules, shift::Shift};
use super::scale::PlanetScale;
use super::seed::between;
use super::topology::Edge;
use super::vertex::{EdgeContext, FAR, RiverSegment, ValleySection, Vertex};

/// First level whose edges stay straight and whose faces decide nothing: a vertex then follows from
/// its parents alone, but for a river beside it. Its edges are 25 m long on an Earth-sized planet.
pub const STRAIGHT_LEVEL: u32 = 11;

/// Most of a far corner that a displaced vertex may have or owe, Q16: 0.17.
const DEPTH: i32 = q16(0.17);

/// What a displaced vertex may lose of an end from its half, Q16: a sixth less what rounding may
/// take.
const SLACK: i32 = q16(0.15666);

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
    let face;
    (new.direction, face) = place(rules, edge.kind, level, &new, ends, opposite);
    new.river_distance = expected_distance(edge.kind, ends, length);
    new.discharge = if edge.kind == EdgeKind::River {
        gathered(a, edge)
    } else {
        0
    };
    let span = scale.edge_grains(level);
    let context = EdgeContext {
        a,
        b,
        new: &new,
        face,
        length,
        span,
        level,
        radius_m: scale.radius_m,
    };
    let ground = rules::halve(rules, edge.kind, &context);
    (new.kind, new.height, new.bed, new.water) =
        (ground.kind, ground.height, ground.bed, ground.water);
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
    let same_lake = a.is_wet()
        && b.is_wet()
        && a.water == b.water
        && (a.lake == b.lake || a.lake == 0 || b.lake == 0);
    if same_lake && (a.lake | b.lake) != 0 {
        let bed = a.bed + (b.bed - a.bed) / 2;
        (new.kind, new.height, new.bed, new.water) = (VertexKind::Lake, bed, bed, a.water);
        new.lake = a.lake | b.lake;
        new.discharge = new.discharge.max(a.discharge.min(b.discharge));
    } else if new.kind == VertexKind::Lake {
        // Its flow shapes its shores; it brings its river nothing.
        new.lake = if (a.lake | b.lake) == 0 {
            new.seed | 1
        } else {
            a.lake | b.lake
        };
        new.discharge = a.discharge.max(b.discharge) / 16;
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
        (FAR, d) | (d, FAR) => d.min(FAR - length / 2) + length / 2,
        (d, e) => d / 2 + e / 2,
    }
}

/// Where the new vertex lies: the edge's middle, moved sideways within its safe zone (§5.2), on the
/// sphere. And the height of the flat face there.
fn place(
    rules: &Rules,
    kind: EdgeKind,
    level: u32,
    new: &Vertex,
    [a, b]: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> ([i32; 3], i32) {
    let ab = difference(b.direction, a.direction);
    let rise = b.height - a.height;
    if level < STRAIGHT_LEVEL
        && let [Some(x), Some(y)] = opposite
    {
        let shift = rules::shift::shift(rules, kind, [a.kind, b.kind], level, new);
        if shift.weight > 0 {
            let (x, y) = if shift.second { (y, x) } else { (x, y) };
            let to = [x, y].map(|v| difference(v.direction, a.direction));
            let [wb, wx] = weights(&shift, to.map(|corner| Stance::of(ab, corner)));
            let face = a.height + weigh(wb, rise) + weigh(wx, x.height - a.height);
            return (displaced(a.direction, ab, to[0], wb, wx), face);
        }
    }
    // Halves round to either side by the seed, so that no direction is favoured.
    let odd = (new.seed >> 7 & 1) as i32;
    let middle = [0, 1, 2].map(|i| a.direction[i] + ((ab[i] + odd) >> 1));
    (lift(middle, square_q32(ab) / 4), a.height + rise / 2)
}

/// Shares of the edge's end and of the corner `x` that the new vertex is drawn to; that of the
/// start is the rest.
///
/// Written in the barycentric coordinates of either face beside the edge, the vertex keeps at least
/// a third of both ends and at most [`DEPTH`] of the far corner. Whatever their edges' vertices do
/// within such bounds, all four children of a face keep at least 0.045 of its area (least
/// determinant over the corners of the bounds): none turns over.
fn weights(shift: &Shift, [x, y]: [Stance; 2]) -> [i32; 2] {
    // Flat triangles would get flatter.
    let low = x.height.min(y.height);
    let weight = weigh(shift.weight, linear_step(Q12 / 6, Q12 / 2, low));
    let third = shift.inward / 3;
    let wx = weigh(weight, third);
    let along = weigh(Q16 - shift.inward, shift.along) + third;
    // A corner that leans over an end of the edge draws upwards only, not along.
    let towards_b = weigh(weight, along - Q16 / 2) - q12(wx, x.overhang());
    // In the face beyond, the vertex has -ρ·wx of its corner, ρ the ratio of the heights.
    let depth = wx * (x.height >> 3) / (y.height >> 3).max(1);
    let in_beyond = towards_b + q12(wx, x.along) + q12(depth, y.along);
    let loss = (-towards_b)
        .max(towards_b + wx)
        .max(-in_beyond)
        .max(in_beyond - depth);
    let kept = ratio(SLACK, loss)
        .min(ratio(DEPTH, wx))
        .min(ratio(DEPTH, depth));
    [Q16 / 2 + weigh(kept, towards_b), weigh(kept, wx)]
}

/// A share times a number in Q12 of at most 7.
#[inline]
const fn q12(share: i32, number: i32) -> i32 {
    (share * (number >> 4)) >> 8
}

/// The point a + w_b·ab + w_x·ax, lifted to the sphere by its exact deficit Σ wᵢwⱼ|pᵢ - pⱼ|².
fn displaced(a: [i32; 3], ab: [i32; 3], ax: [i32; 3], wb: i32, wx: i32) -> [i32; 3] {
    let wa = Q16 - wb - wx;
    let point = [0, 1, 2].map(|i| a[i] + weigh(wb, ab[i]) + weigh(wx, ax[i]));
    let squares = [
        square_q32(ab),
        square_q32(ax),
        square_q32(difference(ax, ab)),
    ];
    // Shares below 1 in Q16, their products in Q32.
    let part = |u: i32, v: i32, square: u32| mul_high((u as u32) * (v as u32), square);
    lift(
        point,
        part(wa, wb, squares[0]) + part(wa, wx, squares[1]) + part(wb, wx, squares[2]),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::amplify::seed::pcg;

    type Shares = [f64; 3];

    /// Corners of the polygon of barycentric coordinates (start, end, far corner) that a vertex on
    /// an edge may have.
    fn bounds() -> [Shares; 4] {
        let (third, depth) = (1.0 / 3.0, f64::from(DEPTH) / 65_536.0 + 0.005);
        let at = |far: f64| {
            [
                [third, 1.0 - far - third, far],
                [1.0 - far - third, third, far],
            ]
        };
        let [[a, b], [c, d]] = [at(depth), at(-depth)];
        [a, b, c, d]
    }

    fn determinant(p: Shares, q: Shares, r: Shares) -> f64 {
        p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
            + p[2] * (q[0] * r[1] - q[1] * r[0])
    }

    #[test]
    fn no_child_turns_over_within_the_bounds() {
        // The areas are linear in each vertex, so their least values lie at corners of the bounds.
        let mut least = f64::MAX;
        for p in bounds() {
            for q in bounds().map(|[b, c, a]| [a, b, c]) {
                for r in bounds().map(|[c, a, b]| [a, b, c]) {
                    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                    least = least
                        .min(determinant(corners[0], p, r))
                        .min(determinant(corners[1], q, p))
                        .min(determinant(corners[2], r, q))
                        .min(determinant(p, q, r));
                }
            }
        }
        assert!(least > 0.045, "{least}");
    }

    #[test]
    fn displaced_vertices_keep_the_bounds_in_both_faces() {
        for k in 0..200_000_u32 {
            let random =
                |i: u32, low: i32, high: i32| low + (pcg(pcg(k) ^ i) % (high - low) as u32) as i32;
            let [x, y] = [0, 2].map(|i| Stance {
                along: random(i, -8192, 12_288),
                height: random(i + 1, 300, 12_288),
            });
            let shift = Shift {
                along: random(4, 21_627, 43_254),
                inward: random(5, 21_627, 43_254),
                second: false,
                weight: random(6, 0, 65_537),
            };
            let [wb, wx] = weights(&shift, [x, y]).map(|w| f64::from(w) / 65_536.0);
            let real = |v: i32| f64::from(v) / 4096.0;
            // In the face beyond: x = s·a + t·b - ρ·y.
            let ratio = real(x.height) / real(y.height);
            let (far, end) = (
                -wx * ratio,
                wb + wx * (real(x.along) + ratio * real(y.along)),
            );
            for shares in [[1.0 - wb - wx, wb, wx], [1.0 - end - far, end, far]] {
                let least = 1.0 / 3.0;
                assert!(
                    shares[0] > least && shares[1] > least && shares[2].abs() < 0.175,
                    "{k} {shares:?} {x:?} {y:?}"
                );
            }
        }
    }
}
