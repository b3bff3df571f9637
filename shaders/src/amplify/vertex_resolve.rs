//! Pass: a new vertex settles its kind and its distances, once the faces on both sides have
//! decided.
//!
//! Reads the two faces' decisions and what drains along their edges; writes the one vertex. A river
//! outranks a gully, a gully outranks ground, whatever the order in which the faces asked.
//!
//! The nearest river is a true distance to a segment. A vertex beside a river sees the river's
//! newest halves; one farther off inherits its parents' segments (and its neighbours', while edges
//! still move), which lag behind by as many levels as it is rings away: they are charged for how
//! far the river may have moved since.

use super::arith::isqrt;
use super::control::VertexKind;
use super::edge_split::STRAIGHT_LEVEL;
use super::geometry::nearest_on;
use super::rules::{EdgeKind, Rules, valley};
use super::scale::PlanetScale;
use super::seed::share;
use super::topology::{Edge, Inner};
use super::vertex::{FAR, RiverSegment, ValleySection, Vertex};

/// An edge beside the vertex: the edge, its ends, its middle where it has one.
pub type Beside<'a> = (&'a Edge, [&'a Vertex; 2], Option<&'a Vertex>);

/// What a vertex's settling depends on.
pub struct VertexContext<'a> {
    /// The edge that the vertex halves.
    pub edge: &'a Edge,
    /// Its ends.
    pub ends: [&'a Vertex; 2],
    /// The corners opposite to it.
    pub opposite: [Option<&'a Vertex>; 2],
    /// Whether a face asks for a gully that starts here.
    pub gully_tip: bool,
    /// Whether a face asks for a tributary that starts here.
    pub river_tip: bool,
    /// Whether a face lets a tributary end here.
    pub branched: bool,
    /// The other edges of the two faces that run along a river or a gully.
    pub beside: [Option<Beside<'a>>; 4],
}

/// What a face's decisions mean for the vertex on its `k`th edge: (gully tip, river tip, junction).
pub fn asks(inner: &[Inner; 3], k: usize) -> (bool, bool, bool) {
    // m_k is first on the inner edge of corner k, second on that of corner k + 1.
    let (first, second) = (inner[k], inner[(k + 1) % 3]);
    (
        first == Inner::GullyToSecond || second == Inner::GullyToFirst,
        first == Inner::RiverToSecond || second == Inner::RiverToFirst,
        first == Inner::RiverToFirst || second == Inner::RiverToSecond,
    )
}

/// What the faces around a new vertex settle of it; the rest stays as its edge made it.
#[derive(Clone, Copy, Debug)]
pub struct Settled {
    kind: VertexKind,
    branched: bool,
    river: NearestRiver,
    section: ValleySection,
    gully_bed: i32,
    gully_distance: i32,
}

impl Settled {
    /// Writes what was settled into the vertex.
    #[inline]
    pub fn write(&self, vertex: &mut Vertex) {
        (vertex.kind, vertex.branched) = (self.kind, self.branched);
        self.river.write(vertex);
        vertex.section = self.section;
        (vertex.gully_bed, vertex.gully_distance) = (self.gully_bed, self.gully_distance);
    }
}

/// What the faces around a vertex settle of it.
pub fn resolve(
    scale: &PlanetScale,
    rules: &Rules,
    level: u32,
    new: &Vertex,
    around: &VertexContext,
) -> Settled {
    let becomes_gully = around.gully_tip && !around.river_tip && new.kind == VertexKind::Terrain;
    let kind = if becomes_gully {
        VertexKind::Gully
    } else {
        new.kind
    };
    let river = near_river(scale, level, new, around);
    let section = if river.is_beside {
        let mut at = *new;
        river.write(&mut at);
        valley::section(rules, &at, scale.edge_grains(0))
    } else {
        new.section
    };
    let (gully_bed, gully_distance) = if kind == VertexKind::Gully {
        (new.height, 0)
    } else {
        near_gully(scale, new, around)
    };
    Settled {
        kind,
        branched: around.branched,
        river,
        section,
        gully_bed,
        gully_distance,
    }
}

/// Discharge that a tributary brings to a junction: a quarter to a half of what its river has
/// gained since the upstream vertex, so that what came from upstream and what the tributary brings
/// make the junction's discharge.
#[inline]
pub fn tributary(junction: &Vertex, upstream: &Vertex) -> u32 {
    let gain = junction.discharge.saturating_sub(upstream.discharge);
    let quarter = gain / 4;
    quarter + super::fixed::mul_high(quarter, (share(junction.seed, 20) as u32) << 16)
}

/// The segment between two vertices of a river. `arriving` is the discharge at its lower end, where
/// others may join it.
pub fn segment(
    scale: &PlanetScale,
    birth: u8,
    level: u32,
    [up, down]: [&Vertex; 2],
    arriving: u32,
) -> RiverSegment {
    // A lake's floor is that of its vertices: beside them lies a beach, no bed.
    let bed = |v: &Vertex| {
        if v.kind == VertexKind::Lake {
            v.water
        } else {
            v.bed
        }
    };
    RiverSegment {
        ends: [up.direction, down.direction],
        bed: [bed(up), bed(down)],
        water: [up.water, down.water],
        flow: [up.flow(), isqrt(arriving) as i32],
        reach: if birth == 0 {
            FAR
        } else {
            scale.edge_grains(u32::from(birth)) / 2
        },
        level,
    }
}

/// Nearest segment found so far.
#[derive(Clone, Copy, Debug)]
struct NearestRiver {
    cost: i32,
    distance: i32,
    along: i32,
    segment: RiverSegment,
    /// Whether it runs along a face of the vertex, or through an end of its edge.
    is_beside: bool,
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

    /// Tells a vertex.
    #[inline]
    fn write(&self, vertex: &mut Vertex) {
        vertex.river = self.segment;
        (vertex.river_distance, vertex.river_along) = (self.distance, self.along);
    }

    /// Takes a segment if it is nearer; one beyond its reach counts as far.
    fn offer(&mut self, scale: &PlanetScale, p: [i32; 3], segment: &RiverSegment, charge: i32) {
        let (along, off) = nearest_on(segment.ends, p);
        let distance = scale.grains(off).min(FAR / 4);
        let beyond = if distance > segment.reach { FAR / 4 } else { 0 };
        let cost = distance + charge + beyond;
        if cost < self.cost {
            *self = Self {
                cost,
                distance,
                along,
                segment: *segment,
                ..*self
            };
        }
    }
}

/// The nearest river of a vertex.
fn near_river(
    scale: &PlanetScale,
    level: u32,
    new: &Vertex,
    around: &VertexContext,
) -> NearestRiver {
    if new.is_wet() {
        let segment = segment(
            scale,
            around.edge.birth,
            level + 1,
            [new, new],
            new.discharge,
        );
        return NearestRiver {
            cost: 0,
            distance: 0,
            along: 0,
            segment,
            is_beside: true,
        };
    }
    let is_beside = around.ends.iter().any(|end| end.is_wet());
    let mut nearest = NearestRiver {
        is_beside,
        ..NearestRiver::none()
    };
    for (edge, [up, down], mid) in around.beside.iter().flatten() {
        if edge.kind != EdgeKind::River {
            continue;
        }
        if up.is_wet() && (level >= STRAIGHT_LEVEL || mid.is_none()) {
            nearest.offer(
                scale,
                new.direction,
                &segment(scale, edge.birth, level, [up, down], edge.arriving),
                0,
            );
        } else if let Some(mid) = mid {
            if up.is_wet() {
                nearest.offer(
                    scale,
                    new.direction,
                    &segment(scale, edge.birth, level + 1, [up, mid], mid.discharge),
                    0,
                );
            }
            nearest.offer(
                scale,
                new.direction,
                &segment(scale, edge.birth, level + 1, [mid, down], edge.arriving),
                0,
            );
        }
    }
    if nearest.cost < i32::MAX {
        nearest.is_beside = true;
    } else {
        inherit(scale, level, new, around, &mut nearest);
    }
    nearest
}

/// Offers the segments of the parents and, while edges move, of the opposite corners.
fn inherit(
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
        if seen.iter().flatten().any(|s| s.ends == from.river.ends) {
            continue;
        }
        seen[i] = Some(&from.river);
        let moved = if from.river.level >= STRAIGHT_LEVEL {
            0
        } else {
            scale.edge_grains(from.river.level) / 3
        };
        nearest.offer(scale, new.direction, &from.river, moved);
    }
}

/// Bed and distance of the nearest gully: that of an edge beside the vertex, else the mean of what
/// the parents know.
fn near_gully(scale: &PlanetScale, new: &Vertex, around: &VertexContext) -> (i32, i32) {
    let [a, b] = around.ends;
    let (mut bed, mut nearest) = match (a.gully_distance, b.gully_distance) {
        (FAR, FAR) => (new.height, FAR),
        (FAR, d) => (b.gully_bed, apart(scale, new, b, d)),
        (d, FAR) => (a.gully_bed, apart(scale, new, a, d)),
        (d, e) if d == 0 && e == 0 => (a.gully_bed / 2 + b.gully_bed / 2, apart(scale, new, a, 0)),
        (d, e) => (a.gully_bed / 2 + b.gully_bed / 2, d / 2 + e / 2),
    };
    for (edge, [up, down], _) in around.beside.iter().flatten() {
        if edge.kind == EdgeKind::Gully {
            let (along, off) = nearest_on([up.direction, down.direction], new.direction);
            let distance = scale.grains(off);
            if distance < nearest {
                (bed, nearest) = (super::arith::mix(up.height, down.height, along), distance);
            }
        }
    }
    (bed, nearest)
}

/// Distance to a parent's gully, at most that of going by the parent.
fn apart(scale: &PlanetScale, new: &Vertex, parent: &Vertex, distance: i32) -> i32 {
    let step = scale.grains(super::fixed::difference(new.direction, parent.direction));
    distance.min(FAR - step.min(FAR)) + step.min(FAR)
}
