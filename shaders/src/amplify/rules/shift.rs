//! How far a new vertex moves sideways from the middle of its edge (paper 002 §5.2, "Horizontal
//! displacement").
//!
//! It lies at `along` of the edge, then moves by `inward` towards the barycentre of the triangle on
//! one side, then back towards the middle where `weight` is below 1. Within a third of its
//! triangle, so that no face turns over.

use super::super::arith::{linear_step, mul_q16, smooth};
use super::super::control::VertexKind;
use super::super::fixed::Q16;
use super::super::seed::share;
use super::landform::dryness;
use super::{EdgeKind, Rules};

/// A sideways displacement; shares in Q16.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shift {
    /// Place along the edge from its first end: 0.33..0.66.
    pub along: i32,
    /// Share of the way to the triangle's barycentre: 0.33..0.66.
    pub inward: i32,
    /// Whether the triangle is that of the edge's second face.
    pub second: bool,
    /// Share of the displacement that is kept; 0 keeps the middle.
    pub weight: i32,
}

/// The displacement of the vertex that halves an edge between two kinds of vertices.
pub fn shift(
    rules: &Rules,
    edge: EdgeKind,
    kinds: [VertexKind; 2],
    level: u32,
    seed: u32,
    wetness: u16,
) -> Shift {
    let third = |k| 21_627 + mul_q16(share(seed, k), 21_627);
    let side = share(seed, 13);
    Shift {
        along: third(12),
        inward: third(14),
        second: side >= Q16 / 2,
        weight: weight(rules, edge, kinds, level, wetness),
    }
}

/// How much of the displacement an edge takes.
fn weight(rules: &Rules, edge: EdgeKind, kinds: [VertexKind; 2], level: u32, wetness: u16) -> i32 {
    use VertexKind::{Coast, Lake, Sea};
    let has = |kind| kinds[0] == kind || kinds[1] == kind;
    // Ours moves less in between: what was moved often stretches its triangles. Rocks are broken
    // again.
    let calm = if rules.landforms && (4..8).contains(&level) {
        46_000
    } else {
        Q16
    };
    match edge {
        EdgeKind::Gully if rules.landforms => mul_q16(calm, 40_000),
        EdgeKind::Gully => Q16,
        // The finest reaches straighten.
        EdgeKind::River if rules.landforms || level > 2 => {
            Q16 - smooth(linear_step(8, 16, level as i32)) / 2
        }
        EdgeKind::River => 0,
        EdgeKind::Terrain if has(Lake) => Q16 / 4,
        EdgeKind::Terrain if has(Coast) || has(Sea) => {
            if level < 11 {
                Q16
            } else {
                0
            }
        }
        EdgeKind::Terrain if level < 9 || rules.landforms => {
            mul_q16(calm, 28_000 + mul_q16(dryness(wetness), 20_000))
        }
        EdgeKind::Terrain => 0,
    }
}
