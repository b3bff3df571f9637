//! Character of the land at a vertex: how old, how dry, how steep (paper 002 §3).
//!
//! Steepness stands for rock and uplift: real young belts of collision (Himalayan) keep slopes near
//! 30° at all scales, those of subduction (Andean) near 25°, old belts near 12°, and it falls with
//! the crust's height above the sea, which is all the relief that rivers have to cut.

use super::preset::Rules;
use crate::amplify::arith::{mix, mul_q16, ratio, smoothstep, square};
use crate::amplify::fixed::{Q16, metres, q16};
use crate::amplify::vertex::Vertex;

/// Wetness below which land is fully dry, and above which not at all (release).
const DRY_WETNESS: [i32; 2] = [q16(0.15), q16(0.45)];

/// How far dryness alone makes land look old (release).
const AGE_OF_DRYNESS: i32 = q16(0.38);

/// Crust elevation C₀ at which land is a quarter as steep as its rock could stand, grains:
/// steepness goes with (C / (C + C₀))², so a plain at 0.2 km is a thirteenth as steep as a belt at
/// 1.5 km.
const HALF_RELIEF_CRUST: i32 = metres(1_000);

/// Added to the steepness of the land where its own roughness is drawn, the tangent of 1.1°: level
/// soil is uneven too.
const SOIL_SLOPE: i32 = q16(0.02);

crate::wgsl::shared!(DRY_WETNESS, AGE_OF_DRYNESS, HALF_RELIEF_CRUST, SOIL_SLOPE,);

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

/// How dry land of a wetness is, Q16: fully below 0.15, not at all above 0.45.
#[inline]
pub const fn dryness(wetness: u16) -> i32 {
    Q16 - smoothstep(DRY_WETNESS[0], DRY_WETNESS[1], wetness as i32)
}

impl Landform {
    /// Character of the land at a vertex.
    pub fn of(rules: &Rules, vertex: &Vertex) -> Self {
        let dry = dryness(vertex.wetness);
        let old = i32::from(vertex.worn) + mul_q16(dry, AGE_OF_DRYNESS);
        Self {
            old: old.min(Q16),
            dry,
            steep: steepness(rules, vertex),
        }
    }
}

/// Tangent of the land's slopes with the unevenness of its soil, Q16.
pub fn uneven_steepness(rules: &Rules, vertex: &Vertex) -> i32 {
    steepness(rules, vertex) + SOIL_SLOPE
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
    let steep = mix(young, rules.steep_old, i32::from(vertex.worn));
    // Low land has little to cut; a plateau keeps half its steepness, in the valleys that cut it.
    let crust = vertex.crust.max(0);
    let relief = square(ratio(crust, crust + HALF_RELIEF_CRUST));
    mul_q16(mul_q16(steep, relief), Q16 - i32::from(vertex.plateau) / 2)
}
