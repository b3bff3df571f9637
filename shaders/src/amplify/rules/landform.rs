//! What kind of land a vertex lies in: how old, how dry, how steep (paper 002 §3; DESIGN's Andean
//! and Himalayan belts).
//!
//! Steepness stands for rock and uplift: real young belts of collision keep slopes near 30° at all
//! scales, those of subduction near 25°, old belts near 12°, and it falls with the crust's height
//! above the sea, which is all the relief that rivers have to cut.

use super::super::arith::{mix, mul_q16, ratio, smoothstep, square};
use super::super::fixed::{GRAINS, Q16};
use super::super::vertex::Vertex;
use super::preset::Rules;

/// Character of the land at a vertex; shares and tangents in Q16.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Landform {
    /// 0 for a young orogeny, 1 from 200 My on; dryness ages land too (release: + 0.38).
    pub old: i32,
    /// 1 where rock is bare of water and soil.
    pub dry: i32,
    /// Tangent of its slopes.
    pub steep: i32,
}

/// 200 My in the unit of ages.
const OLD_AGE: i32 = 200 * 64;

/// How dry land of a wetness is, Q16: fully below 0.15, not at all above 0.45.
#[inline]
pub const fn dryness(wetness: u16) -> i32 {
    Q16 - smoothstep(9_830, 29_491, wetness as i32)
}

impl Landform {
    /// Character of the land at a vertex.
    pub fn of(rules: &Rules, vertex: &Vertex) -> Self {
        let dry = dryness(vertex.wetness);
        let aged = worn(vertex) + mul_q16(dry, 24_904);
        let old = if aged < Q16 { aged } else { Q16 };
        Self {
            old,
            dry,
            steep: steepness(rules, vertex),
        }
    }
}

/// How far age has worn the land, 0 for a young orogeny, 1 from 200 My on; Q16.
#[inline]
pub const fn worn(vertex: &Vertex) -> i32 {
    smoothstep(0, OLD_AGE, vertex.age as i32)
}

/// Tangent of the land's slopes, Q16.
pub fn steepness(rules: &Rules, vertex: &Vertex) -> i32 {
    if !rules.landforms {
        return rules.steep_old;
    }
    let young = mix(
        rules.steep_subduction,
        rules.steep_collision,
        i32::from(vertex.collision),
    );
    let steep = mix(young, rules.steep_old, worn(vertex));
    // Low land has little to cut: a plain at 0.2 km is a tenth as steep as a belt at 1.5 km.
    let crust = vertex.crust.max(0);
    let rise = square(ratio(crust, crust + 1_000 * GRAINS));
    mul_q16(mul_q16(steep, rise), Q16 - i32::from(vertex.plateau) / 2)
}
