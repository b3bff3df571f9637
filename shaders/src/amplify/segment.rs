//! A piece of river between two of its vertices, and its course.

use super::arith::isqrt;
use super::control::VertexKind;
use super::curve::Curve;
use super::rules::meander;
use super::scale::PlanetScale;
use super::vertex::{FAR, RiverSegment, Vertex};

impl RiverSegment {
    /// The segment between two vertices of a river that was born on level `birth`; `level` is that
    /// of its edge. `arriving` is the discharge at its lower end, where others may join it.
    pub fn between(
        scale: &PlanetScale,
        birth: u8,
        level: u32,
        [up, down]: [&Vertex; 2],
        arriving: u32,
    ) -> Self {
        let reach = if birth == 0 {
            FAR
        } else {
            scale.edge_grains(u32::from(birth)) / 2
        };
        // A smaller river ends across the larger one that it joins, and the sea has no heading.
        let runs_on = down.is_wet() && arriving >= down.discharge / 2;
        let [leaves, arrives] = meander::headings([up, down]);
        let arrives = if runs_on { arrives } else { [0; 3] };
        let is_lake = [up, down].iter().all(|v| v.kind == VertexKind::Lake);
        Self {
            ends: [up.direction, down.direction],
            headings: [leaves, arrives],
            water: [up.water, down.water],
            // At its lower end not the junction's flow: that holds the rivers that join there.
            // Nor at its upper end that of all arms of a delta.
            flow: [up.discharge.min(arriving), arriving].map(|q| isqrt(q) as i32),
            tide: [up.tide, down.tide],
            reach,
            level: level as u16,
            is_lake: u16::from(is_lake),
        }
    }

    /// Whether it is a single vertex of a river.
    #[inline]
    pub fn is_point(&self) -> bool {
        self.ends[0] == self.ends[1]
    }

    /// Its course.
    #[inline]
    pub fn curve(&self) -> Curve {
        Curve::new(self.ends, self.headings)
    }
}
