//! Width, depth and water of a river at a place of it.
//!
//! Width goes by the root of the discharge Q: W = 4.8 √Q (L. Leopold and T. Maddock, The hydraulic
//! geometry of stream channels, 1953): 37 m at 60 m³/s, 2147 m at 200,000. Brooks are 15 times as
//! wide as deep, the greatest rivers 60 times. Discharges are those of an Earth-sized planet: on
//! a smaller one of the same climate they, and rivers, are smaller.

use crate::amplify::arith::{mix, mul_q16, ratio, saturate, sqrt_q16, square};
use crate::amplify::fixed::{GRAINS, Q16, metres, q16};
use crate::amplify::rules::{Rules, estuary};
use crate::amplify::scale::PlanetScale;
use crate::amplify::vertex::{RiverSegment, Vertex};

/// Half the root of the discharge at φ = 1, 200,000 m³/s, in units of 1/1024.
const HALF_ROOT: i32 = 228_973;

/// Radius of the Earth, metres.
const EARTH_RADIUS_M: i32 = 6_371_000;

/// Least half-width of a bed, grains.
const LEAST_HALF_BED: i32 = GRAINS / 2;

/// Width over depth of a brook's bed and of the greatest river's, Q8.
const WIDTH_OVER_DEPTH: [i32; 2] = [15 << 8, 60 << 8];

/// Half-width of a brook's valley and of the greatest river's, as shares of the control mesh's
/// edge: 200 m to 16 km on edges of 52 km. The slopes beyond are those of the graphs.
const HALF_VALLEY: [i32; 2] = [q16(0.00381), q16(0.30518)];

/// Height of a bank over the water: a share of the depth, and what is added to it, grains.
const BANK: [i32; 2] = [q16(0.25), GRAINS / 5];

/// Most height of a bank over the water, grains.
const HIGHEST_BANK: i32 = metres(4);

/// Most widths of a river that the edge of a piece is long which finer levels keep whole: it has
/// four to nine bends.
const PIECE_WIDTHS: i32 = 48;

/// Part of its piece over which an arm of a delta narrows from the whole river: twelve of its widths
/// at most.
const APEX: i32 = 4;

/// First level whose rivers keep their course whatever their width: brooks of a metre.
const LAST_COURSE_LEVEL: u32 = 10;

crate::wgsl::shared!(
    HALF_ROOT,
    EARTH_RADIUS_M,
    LEAST_HALF_BED,
    WIDTH_OVER_DEPTH,
    HALF_VALLEY,
    BANK,
    HIGHEST_BANK,
    PIECE_WIDTHS,
    APEX,
    LAST_COURSE_LEVEL,
);

/// Half-width of the bed of a river of a flow φ (Q16), grains.
fn half_bed(scale: &PlanetScale, rules: &Rules, flow: i32) -> i32 {
    let on_earth = mul_q16(mul_q16(rules.channel_width, HALF_ROOT), flow);
    // Planets are larger than the Earth, too.
    let size = ratio(scale.radius_m as i32, 2 * EARTH_RADIUS_M);
    (2 * mul_q16(on_earth, size)).max(LEAST_HALF_BED)
}

/// Width of a river of a flow φ (Q16), grains.
pub fn width(scale: &PlanetScale, rules: &Rules, flow: i32) -> i32 {
    2 * half_bed(scale, rules, flow)
}

/// Flow φ along a segment, between those at its ends, Q16: linear, but from the apex of a delta an
/// arm narrows to its own over the first quarter.
fn flow([up, down]: [i32; 2], along: i32) -> i32 {
    if up <= down {
        return mix(up, down, along);
    }
    let near = square(saturate(Q16 - APEX * along));
    mix(down, up, near)
}

/// Whether a river of a flow φ (Q16) keeps its course from the edges of a level on.
pub fn keeps_course(scale: &PlanetScale, rules: &Rules, level: u32, flow: i32) -> bool {
    let longest = width(scale, rules, flow).saturating_mul(PIECE_WIDTHS);
    rules.landforms && (level >= LAST_COURSE_LEVEL || scale.edge_grains(level) <= longest)
}

/// The river at a point of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reach {
    /// Water surface, grains.
    pub water: i32,
    /// Half of the water's width, grains; 0 in a lake.
    pub half_bed: i32,
    /// Depth of the bed in its middle, grains.
    pub depth: i32,
    /// √φ, Q16.
    pub strength: i32,
}

impl Reach {
    /// The river where a vertex is nearest to its segment.
    pub fn of(scale: &PlanetScale, rules: &Rules, vertex: &Vertex) -> Self {
        Self::at(scale, rules, &vertex.river, vertex.river_along)
    }

    /// The river at a share of a segment, Q16. Water is linear between its ends.
    pub fn at(scale: &PlanetScale, rules: &Rules, segment: &RiverSegment, along: i32) -> Self {
        let t = saturate(along);
        let flow = flow(segment.flow, t);
        let strength = sqrt_q16(flow);
        let half_bed = if segment.is_lake {
            0
        } else {
            half_bed(scale, rules, flow)
        };
        let [from, to] = segment.tide.map(i32::from);
        let tide = mix(from, to, t);
        let [brook, greatest] = WIDTH_OVER_DEPTH;
        let slenderness = ratio(1 << 8, mix(brook, greatest, strength));
        Self {
            water: mix(segment.water[0], segment.water[1], t),
            half_bed: estuary::widened(half_bed, tide),
            depth: mul_q16(half_bed.saturating_mul(2), slenderness),
            strength,
        }
    }

    /// Ground in the bed at a distance of at most its half-width from its middle, grains: a
    /// parabola, whose sides stand at 15° in a brook and at 4° in the greatest river.
    pub fn bed(&self, distance: i32) -> i32 {
        let up = square(ratio(distance, self.half_bed));
        self.water - mul_q16(self.depth, Q16 - up)
    }

    /// Height of its banks over the water, grains; 0 in a lake.
    pub fn bank(&self) -> i32 {
        let bank = mul_q16(self.depth, BANK[0]) + BANK[1];
        bank.min(HIGHEST_BANK).min(self.half_bed)
    }

    /// Half-width of its valley in grains, on a planet whose control mesh has edges of `edge`
    /// grains.
    pub fn half_valley(&self, edge: i32) -> i32 {
        let share = mix(HALF_VALLEY[0], HALF_VALLEY[1], square(self.strength));
        mul_q16(edge, share)
    }
}
