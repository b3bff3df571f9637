//! How far a new vertex moves sideways from the middle of its edge (paper 002 §5.2, "Horizontal
//! displacement").
//!
//! It lies at `along` of the edge, then moves by `inward` towards the barycentre of the triangle on
//! one side, then back towards the middle where `weight` is below 1. Within a third of its
//! triangle, so that no face turns over.

use super::{EdgeKind, Rules, river};
use crate::amplify::arith::{linear_step, mul_q16, smooth};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{Q16, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::Vertex;

/// Least share of the edge, and of the way to the barycentre, that a vertex moves to; the greatest
/// is twice as much (paper 002 §5.2).
pub(in crate::amplify) const LEAST: i32 = q16(0.33);

/// Levels on which vertices of ours move less, first and one beyond the last: what stretches their triangles stretches all that are
/// made within them.
const CALM_LEVELS: [u32; 2] = [0, 3];

/// Share of the displacement that is left on those levels.
const CALM: i32 = q16(0.7019);

/// Share of the displacement that gullies keep in ours.
const GULLY_WEIGHT: i32 = q16(0.61035);

/// Last level on which rivers of print and release run straight.
const LAST_STRAIGHT_RIVER: u32 = 2;

/// Levels over which reaches straighten, to half the displacement.
const STRAIGHTENING_LEVELS: [i32; 2] = [8, 16];

/// Share of the displacement that lakes' shores keep.
const LAKE_WEIGHT: i32 = q16(0.25);

/// Share of the displacement that coasts of ours keep.
const COAST_WEIGHT: i32 = q16(0.6);

/// One beyond the last level whose coasts are moved.
const COAST_LEVELS: u32 = 11;

/// One beyond the last level whose ground is moved in print and release.
const GROUND_LEVELS: u32 = 9;

/// Share of the displacement that wet ground of ours keeps, and how much more dry ground keeps.
const GROUND_WEIGHT: [i32; 2] = [q16(0.42725), q16(0.30518)];

/// The same in print and release (release).
const RELEASED_GROUND_WEIGHT: [i32; 2] = [q16(0.5), q16(0.45)];

/// Least share of the way up from its mouth at which a spring of print and release lies, and how
/// much the draw adds to it (release).
const SPRING_PLACE: [i32; 2] = [q16(0.6), q16(0.2)];

crate::wgsl::shared!(
    LEAST_SHIFT = LEAST,
    CALM_LEVELS,
    CALM,
    GULLY_WEIGHT,
    LAST_STRAIGHT_RIVER,
    STRAIGHTENING_LEVELS,
    LAKE_WEIGHT,
    COAST_WEIGHT,
    COAST_LEVELS,
    GROUND_LEVELS,
    GROUND_WEIGHT,
    RELEASED_GROUND_WEIGHT,
    SPRING_PLACE,
);

/// A sideways displacement; shares in Q16.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shift {
    /// Place along the edge from its first end: 0.33..0.66; of springs 0.2..0.8, of which the
    /// bounds of a face's corners leave 0.34..0.66.
    pub along: i32,
    /// Share of the way to the triangle's barycentre: 0.33..0.66, or 0 of springs.
    pub inward: i32,
    /// Whether the triangle is that of the edge's second face.
    pub second: bool,
    /// Share of the displacement that is kept; 0 keeps the middle.
    pub weight: i32,
}

/// The displacement of the vertex that halves an edge between two kinds of vertices. Of the new
/// vertex the seed and the wetness are read.
pub fn shift(
    rules: &Rules,
    edge: EdgeKind,
    kinds: [VertexKind; 2],
    level: u32,
    new: &Vertex,
) -> Shift {
    if !rules.landforms
        && edge == EdgeKind::River
        && let Some(mouth) = river::mouth(kinds)
    {
        return spring(new.seed, mouth);
    }
    // Uniform between a third and two thirds.
    let drawn = |k| LEAST + mul_q16(share(new.seed, k), LEAST);
    Shift {
        along: drawn(12),
        inward: drawn(14),
        second: share(new.seed, 13) >= Q16 / 2,
        weight: weight(rules, edge, kinds, level, new.wetness),
    }
}

/// The place of a spring whose tributary joins at an end of its edge: on the edge, nearer to the
/// land.
fn spring(seed: u32, mouth: usize) -> Shift {
    let up = SPRING_PLACE[0] + mul_q16(share(seed, 12), SPRING_PLACE[1]);
    Shift {
        along: if mouth == 0 { up } else { Q16 - up },
        inward: 0,
        second: false,
        weight: Q16,
    }
}

/// Share of the displacement that a level keeps, Q16.
fn calm(rules: &Rules, level: u32) -> i32 {
    let [first, end] = CALM_LEVELS;
    if rules.landforms && (first..end).contains(&level) {
        CALM
    } else {
        Q16
    }
}

/// How much of the displacement an edge takes, Q16.
fn weight(rules: &Rules, edge: EdgeKind, kinds: [VertexKind; 2], level: u32, wetness: u16) -> i32 {
    use VertexKind::{Coast, Lake, Sea};
    let calm = calm(rules, level);
    match edge {
        EdgeKind::Gully if rules.landforms => mul_q16(calm, GULLY_WEIGHT),
        EdgeKind::Gully => Q16,
        EdgeKind::River if rules.landforms || level > LAST_STRAIGHT_RIVER => {
            let [first, last] = STRAIGHTENING_LEVELS;
            Q16 - smooth(linear_step(first, last, level as i32)) / 2
        }
        EdgeKind::River => 0,
        EdgeKind::Terrain if kinds.contains(&Lake) => LAKE_WEIGHT,
        EdgeKind::Terrain if rules.landforms && kinds.contains(&Coast) => {
            // The shore's noise bends it: what is moved less keeps the shape of its triangles.
            if level < COAST_LEVELS {
                mul_q16(calm, COAST_WEIGHT)
            } else {
                0
            }
        }
        EdgeKind::Terrain if kinds.contains(&Coast) || kinds.contains(&Sea) => {
            if level < COAST_LEVELS { Q16 } else { 0 }
        }
        EdgeKind::Terrain if rules.landforms => mul_q16(calm, by_dryness(GROUND_WEIGHT, wetness)),
        EdgeKind::Terrain if level < GROUND_LEVELS => by_dryness(RELEASED_GROUND_WEIGHT, wetness),
        EdgeKind::Terrain => 0,
    }
}

/// A share of wet ground, and what dry ground adds to it; Q16.
const fn by_dryness([wet, dry]: [i32; 2], wetness: u16) -> i32 {
    wet + mul_q16(super::landform::dryness(wetness), dry)
}
