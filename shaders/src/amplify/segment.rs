//! A piece of river between two of its vertices, and its course.

use super::arith::isqrt;
use super::control::VertexKind;
use super::curve::{Curve, heading_of};
use super::fixed::difference;
use super::rules::{Rules, valley};
use super::scale::PlanetScale;
use super::topology::Edge;
use super::vertex::{FAR, RiverSegment, Vertex};

impl RiverSegment {
    /// The segment between two vertices of a river that was born on level `birth`; `level` is that
    /// of its edge. `arriving` is the discharge at its lower end, where others may join it.
    pub fn between(birth: u8, level: u32, [up, down]: [&Vertex; 2], arriving: u32) -> Self {
        let joins = !runs_into([up, down], arriving);
        // At its lower end not the junction's flow: that holds the rivers that join there. At its
        // upper end that of all arms of a delta, though: they leave it as one.
        let flow = [up.discharge, arriving].map(|q| isqrt(q) as i32);
        let is_lake = [up, down].iter().all(|v| v.kind == VertexKind::Lake);
        Self {
            ends: [up.direction, down.direction],
            headings: [up.heading, arrival([up, down], arriving)],
            water: [up.water, down.water],
            flow,
            tide: [up.tide, down.tide],
            // A smaller river joins with waves of its own, and straight.
            waves: [
                flow[0].min(flow[1]),
                if joins { flow[1] } else { down.flow() },
            ]
            .map(|flow| flow as u16),
            winding: [up.winding, if joins { 0 } else { down.winding }],
            birth,
            level: level as u8,
            is_lake,
        }
    }

    /// The piece of its own river that an edge of a level follows, where finer levels keep it: that
    /// of a coarser level, of which the edge is a part, or the edge's own.
    pub fn kept(
        scale: &PlanetScale,
        rules: &Rules,
        edge: &Edge,
        level: u32,
        ends: [&Vertex; 2],
    ) -> Option<Self> {
        let own = || Self::between(edge.birth, level, ends, edge.arriving);
        let coarser = Self::of_coarser_level(edge, ends);
        coarser.or_else(|| keeps_own(scale, rules, edge, level, ends).then(own))
    }

    /// Whether there is such a piece.
    pub fn is_kept(
        scale: &PlanetScale,
        rules: &Rules,
        edge: &Edge,
        level: u32,
        ends: [&Vertex; 2],
    ) -> bool {
        Self::of_coarser_level(edge, ends).is_some() || keeps_own(scale, rules, edge, level, ends)
    }

    /// The piece of a coarser level that an edge is a part of.
    fn of_coarser_level(edge: &Edge, ends: [&Vertex; 2]) -> Option<Self> {
        // A tributary that joins the piece was born later.
        let is_part = |end: &&&Vertex| end.keeps_course && end.river.birth == edge.birth;
        ends.iter().find(is_part).map(|end| end.river)
    }

    /// Widest half-width of its valley, grains: half the edge from which a tributary was born, so
    /// that ground of coarser levels never lies in it; [`FAR`] for a river of the control mesh.
    pub fn reach(&self, scale: &PlanetScale) -> i32 {
        match self.birth {
            0 => FAR,
            level => scale.edge_grains(u32::from(level)) / 2,
        }
    }

    /// Whether it is a single vertex of a river.
    #[inline]
    pub fn is_point(&self) -> bool {
        self.ends[0] == self.ends[1]
    }

    /// The axis of its valley.
    #[inline]
    pub fn curve(&self) -> Curve {
        Curve::new(self.ends, self.headings)
    }
}

/// Whether the river along an edge has come to a larger one, in whose bed an end lies: until their
/// junction it has no course of its own.
pub fn is_lost(ends: [&Vertex; 2]) -> bool {
    ends.iter().any(|end| end.is_in_larger_river())
}

/// Whether finer levels keep the piece that an edge of a level makes.
fn keeps_own(
    scale: &PlanetScale,
    rules: &Rules,
    edge: &Edge,
    level: u32,
    ends: [&Vertex; 2],
) -> bool {
    let flow = isqrt(edge.arriving) as i32;
    runs_on(ends) && valley::keeps_course(scale, rules, level, flow)
}

/// Whether a river of its own runs from end to end: a spring or a lake may yet come to lie in
/// between, or it has come to a larger river.
fn runs_on(ends: [&Vertex; 2]) -> bool {
    let [up, down] = ends;
    !is_lost(ends)
        && up.kind == VertexKind::River
        && matches!(down.kind, VertexKind::River | VertexKind::Sea)
}

/// Whether a river goes on beyond the lower end of its piece: the sea and a larger river end it.
fn runs_into([_, down]: [&Vertex; 2], arriving: u32) -> bool {
    down.is_wet() && arriving >= down.discharge / 2
}

/// Heading of a river where it arrives at the lower end of its piece.
fn arrival(ends: [&Vertex; 2], arriving: u32) -> [i16; 3] {
    let [up, down] = ends;
    if runs_into(ends, arriving) {
        return down.heading;
    }
    if !down.is_wet() {
        // The sea has no heading.
        return [0; 3];
    }
    // A smaller river joins the larger one at an acute angle.
    let way = heading_of(difference(down.direction, up.direction));
    heading_of([0, 1, 2].map(|i| i32::from(way[i]) + i32::from(down.heading[i])))
}
