//! The nearest river of a vertex: a true distance to the course of a segment, less half of its bed.
//!
//! A vertex beside a river sees the river's newest halves; one farther off inherits its parents'
//! segments (and its neighbours', while edges still move), which lag behind by as many levels as it
//! is rings away: they are charged for how far the river may have moved since.

use super::{DrainBeside, VertexContext};
use crate::amplify::control::VertexKind;
use crate::amplify::rules::valley::{Reach, RiverPlace};
use crate::amplify::rules::{EdgeKind, Rules, STRAIGHT_LEVEL, valley};
use crate::amplify::scale::PlanetScale;
use crate::amplify::segment::is_lost;
use crate::amplify::vertex::{FAR, RiverSegment, ValleySection, Vertex};

/// Half-widths of a winding river within which no lesser river counts as nearer.
const NEAR_BANK: i32 = 4;

/// Half-widths of a river up to which its bends reach.
const BENDS: i32 = 10;

crate::wgsl::shared!(NEAR_BANK, BENDS,);

/// Nearest segment found so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearestRiver {
    /// Distance to its bank, negative in its bed, and charges; grains.
    cost: i32,
    distance: i32,
    /// Distance to the belt of its bends, grains.
    belt: i32,
    along: i32,
    segment: RiverSegment,
    /// Whether it runs along a face of the vertex, or through an end of its edge.
    pub(super) is_beside: bool,
    /// Whether it is the vertex's own, and keeps its course on finer levels.
    keeps_course: bool,
}

impl NearestRiver {
    /// No river yet.
    fn none() -> Self {
        Self {
            cost: i32::MAX,
            distance: FAR,
            belt: FAR,
            along: 0,
            segment: RiverSegment::default(),
            is_beside: false,
            keeps_course: false,
        }
    }

    /// Whether the vertex lies among the bends of a river, which winds away from the edges beside
    /// which valleys are measured.
    pub(super) fn is_near(&self, scale: &PlanetScale, rules: &Rules) -> bool {
        let reach = Reach::at(scale, rules, &self.segment, self.along);
        self.segment.winding != [0, 0] && self.distance / BENDS < reach.half_bed
    }

    /// The side of its valley at a vertex, which rises beside the belt of its bends.
    pub(super) fn section(
        &self,
        scale: &PlanetScale,
        rules: &Rules,
        mut vertex: Vertex,
    ) -> ValleySection {
        self.write(&mut vertex);
        vertex.river_distance = vertex.river_distance.min(self.belt);
        valley::section(scale, rules, &vertex)
    }

    /// Writes the river into a vertex.
    #[inline]
    pub(super) fn write(&self, vertex: &mut Vertex) {
        vertex.river = self.segment;
        vertex.river_distance = self.distance;
        vertex.river_along = self.along;
        vertex.keeps_course = self.keeps_course;
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
    let mut search = Search {
        scale,
        rules,
        level,
        new,
        found: NearestRiver::none(),
    };
    if new.is_wet() {
        search.offer_itself(around);
        return search.found;
    }
    search.offer_beside(around);
    let is_found = search.found.cost < i32::MAX;
    // A vertex beside a brook may lie in the bed of the river that the brook joins.
    search.offer_inherited(around, 0);
    search.found.is_beside = is_found || around.ends.iter().any(|end| end.is_wet());
    search.found
}

/// The search for the nearest river of a new vertex.
struct Search<'a> {
    scale: &'a PlanetScale,
    rules: &'a Rules,
    level: u32,
    new: &'a Vertex,
    found: NearestRiver,
}

impl Search<'_> {
    /// Takes a segment if its bank is nearer; one beyond its reach counts as far.
    fn offer(&mut self, segment: &RiverSegment, charge: i32) {
        let place = RiverPlace::nearest(self.scale, self.rules, segment, self.new.direction);
        // Quarters of FAR: distance, charge and penalty together stay in 32 bits.
        let distance = place.distance.min(FAR / 4);
        // Beyond its reach a tributary counts only where no other river is known.
        let is_beyond = distance > segment.reach(self.scale);
        let beyond = if is_beyond { FAR / 4 } else { 0 };
        let bank = self.cost_of_bank(segment, distance, place.reach.half_bed);
        let cost = bank + charge + beyond;
        if cost < self.found.cost {
            self.found.cost = cost;
            self.found.distance = distance;
            self.found.belt = place.belt;
            self.found.along = place.along;
            self.found.segment = *segment;
        }
    }

    /// Distance to a bank, negative in the bed. A winding river may come to the vertices that are
    /// made around this one, and those of its edges that tell them of it lie on its axis: until it
    /// is farther off than they are, it counts as the nearest.
    fn cost_of_bank(&self, segment: &RiverSegment, distance: i32, half_bed: i32) -> i32 {
        let bank = distance - half_bed;
        if segment.winding == [0, 0] || bank <= 0 {
            return bank;
        }
        let around = self.scale.edge_grains(self.level);
        (bank - around.min(NEAR_BANK * half_bed)).max(bank / 64)
    }

    /// Offers a wet vertex the river that it lies on, and a larger one in whose bed it lies.
    fn offer_itself(&mut self, around: &VertexContext) {
        let new = self.new;
        let edge = around.edge;
        let (scale, rules) = (self.scale, self.rules);
        let level = self.level;
        let is_river = edge.kind == EdgeKind::River && new.kind == VertexKind::River;
        let ends = around.ends;
        let kept = if is_river {
            RiverSegment::kept(scale, rules, edge, level, ends)
        } else {
            None
        };
        let point = || RiverSegment::between(edge.birth, level + 1, [new, new], new.discharge);
        // Between a larger river, into which its course has led, and their junction it has no other.
        let is_lost = is_river && is_lost(ends);
        if kept.is_some() || !is_lost {
            self.offer(&kept.unwrap_or_else(point), 0);
        }
        if new.kind == VertexKind::River {
            let least = if kept.is_none() && is_lost {
                0
            } else {
                2 * new.flow()
            };
            self.offer_inherited(around, least);
        }
        self.found.is_beside = true;
        self.found.keeps_course = kept.is_some_and(|kept| kept == self.found.segment);
    }

    /// Offers the rivers along the edges of the two faces: their halves while edges still move,
    /// else the whole edges.
    fn offer_beside(&mut self, around: &VertexContext) {
        for drain in around.beside.iter().flatten() {
            if drain.edge.kind != EdgeKind::River {
                continue;
            }
            let (scale, level) = (self.scale, self.level);
            let segments =
                match RiverSegment::kept(scale, self.rules, drain.edge, level, drain.ends) {
                    Some(kept) => [Some(kept), None],
                    None if is_lost(drain.ends) => [None; 2],
                    None => segments_of(level, drain),
                };
            for segment in segments.iter().flatten() {
                self.offer(segment, 0);
            }
        }
    }

    /// Offers the segments of the parents and, while edges move, of the opposite corners, if they
    /// have more than a flow.
    fn offer_inherited(&mut self, around: &VertexContext, flow: i32) {
        let opposite = if self.level < STRAIGHT_LEVEL {
            around.opposite
        } else {
            [None, None]
        };
        let [a, b] = around.ends.map(Some);
        let mut seen: [Option<&RiverSegment>; 4] = [None; 4];
        for (i, from) in [a, b, opposite[0], opposite[1]].into_iter().enumerate() {
            let knows_river = |v: &&Vertex| v.river_distance < FAR && v.river.flow[1] >= flow;
            let Some(from) = from.filter(knows_river) else {
                continue;
            };
            // The same segment often comes from several neighbours.
            let is_new = |s: &&RiverSegment| s.ends != from.river.ends;
            if seen.iter().flatten().all(is_new) {
                seen[i] = Some(&from.river);
                let charge = most_move(self.scale, self.rules, &from.river);
                self.offer(&from.river, charge);
            }
        }
    }
}

/// The newest segments that are known of a river edge of a level, upstream first.
#[inline]
fn segments_of(level: u32, drain: &DrainBeside) -> [Option<RiverSegment>; 2] {
    let (edge, [up, down]) = (drain.edge, drain.ends);
    let part = |level, ends, arriving| RiverSegment::between(edge.birth, level, ends, arriving);
    let lower = |level, up| Some(part(level, [up, down], edge.arriving));
    match drain.mid {
        // No river runs above a spring.
        Some(mid) if !up.is_wet() => [None, lower(level + 1, mid)],
        Some(mid) if level < STRAIGHT_LEVEL => {
            let upper = part(level + 1, [up, mid], mid.discharge);
            [Some(upper), lower(level + 1, mid)]
        }
        _ if up.is_wet() => [None, lower(level, up)],
        _ => [None; 2],
    }
}

/// How far the river of a segment may move on finer levels, grains.
pub fn most_move(scale: &PlanetScale, rules: &Rules, segment: &RiverSegment) -> i32 {
    let level = u32::from(segment.level);
    // A single vertex stays where it is.
    let keeps_course = valley::keeps_course(scale, rules, level, segment.flow[1]);
    if segment.is_point() || keeps_course || level >= STRAIGHT_LEVEL {
        0
    } else {
        scale.edge_grains(level) / 3
    }
}
