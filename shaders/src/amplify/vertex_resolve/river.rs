//! The nearest river of a vertex: a true distance to a segment.
//!
//! A vertex beside a river sees the river's newest halves; one farther off inherits its parents'
//! segments (and its neighbours', while edges still move), which lag behind by as many levels as it
//! is rings away: they are charged for how far the river may have moved since.

use super::{DrainBeside, VertexContext};
use crate::amplify::arith::isqrt;
use crate::amplify::control::VertexKind;
use crate::amplify::edge_split::STRAIGHT_LEVEL;
use crate::amplify::fixed::mul_high;
use crate::amplify::geometry::nearest_on;
use crate::amplify::rules::{EdgeKind, Rules, meander};
use crate::amplify::scale::PlanetScale;
use crate::amplify::seed::share;
use crate::amplify::vertex::{FAR, RiverSegment, Vertex};

/// Discharge that a tributary brings to a junction: a quarter to a half of what its river has
/// gained since the upstream vertex, so that what came from upstream and what the tributary brings
/// make the junction's discharge.
#[inline]
pub fn tributary(junction: &Vertex, upstream: &Vertex) -> u32 {
    let gain = junction.discharge.saturating_sub(upstream.discharge);
    let quarter = gain / 4;
    quarter + mul_high(quarter, (share(junction.seed, 20) as u32) << 16)
}

/// The segment between two vertices of a river that was born on level `birth`. `arriving` is the
/// discharge at its lower end, where others may join it.
pub fn segment(
    scale: &PlanetScale,
    birth: u8,
    level: u32,
    [up, down]: [&Vertex; 2],
    arriving: u32,
) -> RiverSegment {
    let reach = if birth == 0 {
        FAR
    } else {
        scale.edge_grains(u32::from(birth)) / 2
    };
    RiverSegment {
        ends: [up.direction, down.direction],
        bed: [bed_beside(up), bed_beside(down)],
        water: [up.water, down.water],
        // At its lower end not the junction's flow: that holds the rivers that join there.
        // Nor at its upper end that of all arms of a delta.
        flow: [up.discharge.min(arriving), arriving].map(|q| isqrt(q) as i32),
        tide: [up, down].map(|end| i32::from(end.tide)),
        reach,
        level,
    }
}

/// Bed of a river vertex as the land beside it sees it, grains. A lake's floor is that of its
/// vertices: beside them lies a beach, no bed.
fn bed_beside(vertex: &Vertex) -> i32 {
    if vertex.kind == VertexKind::Lake {
        vertex.water
    } else {
        vertex.bed
    }
}

/// Nearest segment found so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearestRiver {
    /// Distance and charges, grains.
    cost: i32,
    distance: i32,
    along: i32,
    segment: RiverSegment,
    /// Whether it runs along a face of the vertex, or through an end of its edge.
    pub(super) is_beside: bool,
}

impl NearestRiver {
    /// No river yet.
    fn none() -> Self {
        Self {
            cost: i32::MAX,
            distance: FAR,
            along: 0,
            segment: RiverSegment::default(),
            is_beside: false,
        }
    }

    /// Writes the river into a vertex.
    #[inline]
    pub(super) fn write(&self, vertex: &mut Vertex) {
        vertex.river = self.segment;
        vertex.river_distance = self.distance;
        vertex.river_along = self.along;
    }

    /// Takes a segment if it is nearer to `p`; one beyond its reach counts as far.
    fn offer(&mut self, scale: &PlanetScale, p: [i32; 3], segment: &RiverSegment, charge: i32) {
        let (along, off) = nearest_on(segment.ends, p);
        // Quarters of FAR: distance, charge and penalty together stay in 32 bits.
        let distance = scale.grains(off).min(FAR / 4);
        // Beyond its reach a tributary counts only where no other river is known.
        let beyond = if distance > segment.reach { FAR / 4 } else { 0 };
        let cost = distance + charge + beyond;
        if cost < self.cost {
            self.cost = cost;
            self.distance = distance;
            self.along = along;
            self.segment = *segment;
        }
    }
}

/// The nearest river of a new vertex of the level after `level`.
pub(super) fn nearest(
    scale: &PlanetScale,
    rules: &Rules,
    level: u32,
    new: &Vertex,
    around: &VertexContext,
) -> NearestRiver {
    if new.is_wet() {
        // A river or lake vertex lies on a segment of its own.
        let birth = around.edge.birth.max(new.birth);
        return NearestRiver {
            cost: 0,
            distance: 0,
            along: 0,
            segment: segment(scale, birth, level + 1, [new, new], new.discharge),
            is_beside: true,
        };
    }
    let mut nearest = NearestRiver::none();
    offer_beside(scale, rules, level, new, around, &mut nearest);
    let is_found = nearest.cost < i32::MAX;
    if !is_found {
        offer_inherited(scale, level, new, around, &mut nearest);
    }
    nearest.is_beside = is_found || around.ends.iter().any(|end| end.is_wet());
    nearest
}

/// Offers the rivers along the edges of the two faces: their halves while edges still move, else
/// the whole edges.
fn offer_beside(
    scale: &PlanetScale,
    rules: &Rules,
    level: u32,
    new: &Vertex,
    around: &VertexContext,
    nearest: &mut NearestRiver,
) {
    for drain in around.beside.iter().flatten() {
        if drain.edge.kind != EdgeKind::River {
            continue;
        }
        let segments = if meander::may_bend(scale, rules, level, drain.ends) {
            places_of(scale, level, drain)
        } else {
            segments_of(scale, level, drain)
        };
        for segment in segments.iter().flatten() {
            nearest.offer(scale, new.direction, segment, 0);
        }
    }
}

/// Places that a river passes though it may leave its edge between them: the edge's middle and its
/// lower end.
fn places_of(scale: &PlanetScale, level: u32, drain: &DrainBeside) -> [Option<RiverSegment>; 2] {
    [drain.mid, Some(drain.ends[1])].map(|place| {
        let at = place?;
        Some(segment(
            scale,
            drain.edge.birth,
            level + 1,
            [at, at],
            at.discharge,
        ))
    })
}

/// The newest segments that are known of a river edge of a level, upstream first.
#[inline]
fn segments_of(scale: &PlanetScale, level: u32, drain: &DrainBeside) -> [Option<RiverSegment>; 2] {
    let (edge, [up, down]) = (drain.edge, drain.ends);
    let part = |level, ends, arriving| Some(segment(scale, edge.birth, level, ends, arriving));
    match drain.mid {
        // No river runs above a spring.
        Some(mid) if !up.is_wet() => [None, part(level + 1, [mid, down], edge.arriving)],
        Some(mid) if level < STRAIGHT_LEVEL => [
            part(level + 1, [up, mid], mid.discharge),
            part(level + 1, [mid, down], edge.arriving),
        ],
        _ if up.is_wet() => [None, part(level, [up, down], edge.arriving)],
        _ => [None; 2],
    }
}

/// Offers the segments of the parents and, while edges move, of the opposite corners.
fn offer_inherited(
    scale: &PlanetScale,
    level: u32,
    new: &Vertex,
    around: &VertexContext,
    nearest: &mut NearestRiver,
) {
    let opposite = if level < STRAIGHT_LEVEL {
        around.opposite
    } else {
        [None, None]
    };
    let [a, b] = around.ends.map(Some);
    let mut seen: [Option<&RiverSegment>; 4] = [None; 4];
    for (i, from) in [a, b, opposite[0], opposite[1]].into_iter().enumerate() {
        let Some(from) = from.filter(|v| v.river_distance < FAR) else {
            continue;
        };
        // The same segment often comes from several neighbours.
        let is_new = |s: &&RiverSegment| s.ends != from.river.ends;
        if seen.iter().flatten().all(is_new) {
            seen[i] = Some(&from.river);
            let charge = most_move(scale, from.river.level);
            nearest.offer(scale, new.direction, &from.river, charge);
        }
    }
}

/// How far a river of a level may move on finer levels, grains.
fn most_move(scale: &PlanetScale, level: u32) -> i32 {
    if level >= STRAIGHT_LEVEL {
        0
    } else {
        scale.edge_grains(level) / 3
    }
}
