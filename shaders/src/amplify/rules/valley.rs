//! Transverse valleys and river beds, carved once the subdivision is done (paper 002 §6, Fig. 17).
//!
//! A vertex knows the nearest piece of river, its distance d and where along it lies. There the
//! bed, the water and the flow φ are read off. Around the river lies its bed, half as wide as its
//! depth over the slope of its banks; beyond it the valley rises to half-width D along the
//! archetype e_r's curve, blended into the ground by a cubic Hermite step. Widths follow φ, the
//! root of the discharge: the power law of exponent ½ (release: D = 50 km at φ = 1, 4 km at 0).
//!
//! The side is measured where a vertex touches its river; between such vertices and beyond it is
//! halved as the ground is ([`ValleySection`]). Nearest pieces of river change from one vertex to
//! the next, and a side measured from each would break off along seams.
//!
//! Departures: D is bounded by a share of the control mesh's edge, so that small planets have
//! valleys too; the curve never raises ground above the land beside it; a bank always overtops its
//! water.

use super::preset::Rules;
use super::{estuary, ocean};
use crate::amplify::arith::{mix, mul_q16, ratio, saturate, smooth, smoothstep, sqrt_q16, square};
use crate::amplify::control::{ValleyShape, VertexKind};
use crate::amplify::fixed::{Q16, metres, q16, tan_deg};
use crate::amplify::vertex::{FAR, ValleySection, Vertex};

/// Cotangent of a bed's sides, of a brook's (14°) and of the greatest river's (5°).
const BED_SPREAD: [i32; 2] = [q16(4.01001), q16(11.42883)];

/// Deepest bed whose width still grows with its depth, grains.
const DEEPEST_BED: i32 = metres(200);

/// Height of banks over the water, grains.
const BANK: i32 = metres(1);

/// Half-width of a brook's valley and of the greatest river's, as shares of the control mesh's
/// edge: 200 m to 16 km on edges of 52 km. The slopes beyond are those of the graphs.
const HALF_VALLEY: [i32; 2] = [q16(0.00381), q16(0.30518)];

/// Tangent of a valley's sides beside a brook and beside the greatest river.
const SIDE_SLOPE: [i32; 2] = [tan_deg(20.0), tan_deg(3.5)];

/// Share of the valley's width at which the ground's own height sets in, and at which it is full.
const OWN_HEIGHT: [i32; 2] = [q16(0.1), q16(0.9)];

/// Where the side of a flat floor begins and ends to rise, as shares of the valley's width.
const FLOOR_RISER: [i32; 2] = [q16(0.15), q16(0.8)];

/// The same of a terraced side's lower riser.
const LOWER_RISER: [i32; 2] = [q16(0.05), q16(0.35)];

/// The same of a terraced side's upper riser.
const UPPER_RISER: [i32; 2] = [q16(0.55), q16(0.95)];

/// Most that land beyond a river's banks is raised towards their height, grains.
const MOST_RAISE: i32 = metres(2);

/// Ground and water after carving.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Carved {
    /// Ground, grains.
    pub ground: i32,
    /// Water surface, grains; equals `ground` where it is dry.
    pub water: i32,
}

/// The river at the point of it that is nearest to a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reach {
    /// Bed, grains.
    pub bed: i32,
    /// Water surface, grains.
    pub water: i32,
    /// √φ, Q16.
    pub strength: i32,
    /// How much wider it is than its discharge makes it, in 256ths of an octave.
    pub tide: i32,
}

impl Reach {
    /// The river where a vertex is nearest to its segment.
    pub fn of(vertex: &Vertex) -> Self {
        let (piece, t) = (&vertex.river, saturate(vertex.river_along));
        // Bed, water and flow are linear between the ends of the segment.
        let flow = mix(piece.flow[0], piece.flow[1], t);
        Self {
            bed: mix(piece.bed[0], piece.bed[1], t),
            water: mix(piece.water[0], piece.water[1], t),
            strength: sqrt_q16(flow),
            tide: mix(piece.tide[0], piece.tide[1], t),
        }
    }

    /// Half-width of its bed in grains: the depth up to its banks, over the tangent of 14° to 5°.
    pub fn half_bed(&self) -> i32 {
        let depth = (self.water - self.bed).max(0).saturating_add(BANK);
        let spread = mix(BED_SPREAD[0], BED_SPREAD[1], self.strength);
        estuary::widened(mul_q16(depth.min(DEEPEST_BED), spread), self.tide)
    }

    /// Ground and water in the bed at a distance from its middle, grains.
    fn in_bed(&self, distance: i32) -> Carved {
        let up = smooth(ratio(distance, self.half_bed()));
        let ground = mix(self.bed, self.shoulder(), up);
        Carved {
            ground,
            water: self.water.max(ground),
        }
    }

    /// Height of the top of its banks above the sea, grains.
    fn shoulder(&self) -> i32 {
        self.water.max(self.bed).saturating_add(BANK)
    }

    /// Half-width of its valley in grains, on a planet whose control mesh has edges of `edge`
    /// grains.
    pub fn half_valley(&self, edge: i32) -> i32 {
        let share = mix(HALF_VALLEY[0], HALF_VALLEY[1], square(self.strength));
        mul_q16(edge, share)
    }
}

/// The four archetypes of a valley's side, height over distance, both 0..1 in Q16; monotone, 0 at 0
/// and 1 at 1.
pub const fn archetype(shape: ValleyShape, x: i32) -> i32 {
    let x = saturate(x);
    match shape {
        // Half linear, so that the side starts steeply at the river.
        ValleyShape::V => x / 2 + square(x) / 2,
        // A riser, and a quarter of a parabola that keeps the floor from being level.
        ValleyShape::FlatFloor => mul_q16(riser(FLOOR_RISER, x), Q16 - x / 4) + square(x) / 4,
        ValleyShape::IceTrough => mul_q16(square(x), x),
        ValleyShape::Terraced => (riser(LOWER_RISER, x) + riser(UPPER_RISER, x)) / 2,
    }
}

/// A smooth rise from 0 to 1 between two places.
const fn riser([foot, top]: [i32; 2], x: i32) -> i32 {
    smoothstep(foot, top, x)
}

/// The ground of a vertex after its river has carved it. `edge` is the mean edge of the control
/// mesh, grains; `cache` is shared by the vertices of a patch.
pub fn carve(cache: &mut ocean::OceanCache, vertex: &Vertex, edge: i32) -> Carved {
    match vertex.kind {
        // Lakes and rivers have settled their own bed and water.
        VertexKind::Lake => Carved {
            ground: vertex.bed.min(vertex.water),
            water: vertex.water,
        },
        VertexKind::River => Carved {
            ground: vertex.bed,
            water: vertex.water.max(vertex.bed),
        },
        VertexKind::Sea => {
            // Relief that would emerge is held under the sea by its own bounds.
            let ground = vertex.height + ocean::relief(cache, vertex, edge);
            Carved {
                ground,
                water: ground.max(0),
            }
        }
        _ if vertex.river_distance >= FAR => dry(vertex.height),
        _ => beside(vertex, edge),
    }
}

/// Dry ground.
const fn dry(ground: i32) -> Carved {
    Carved {
        ground,
        water: ground,
    }
}

/// The side that the valley of a vertex's river has at the vertex; `edge` as in [`carve`].
pub fn section(rules: &Rules, vertex: &Vertex, edge: i32) -> ValleySection {
    if vertex.river_distance >= FAR || vertex.river.flow == [0, 0] {
        // A lake's shore: no stream shapes it.
        return ValleySection::outside(vertex.height);
    }
    let reach = Reach::of(vertex);
    // The side begins where the bed ends.
    let across = (vertex.river_distance - reach.half_bed()).max(0);
    let width = width(vertex, &reach, edge);
    if across >= width {
        return ValleySection::outside(vertex.height);
    }
    let x = ratio(across, width);
    let shape = shape(rules, vertex);
    // Greater rivers have gentler sides.
    let tangent = mix(SIDE_SLOPE[0], SIDE_SLOPE[1], reach.strength);
    let rise = mul_q16(mul_q16(width, tangent), archetype(shape, x));
    let shoulder = reach.shoulder();
    // It stands on the bank and never above the crust.
    let height = shoulder.saturating_add(rise.min((vertex.crust - shoulder).max(0)));
    ValleySection {
        height,
        own: riser(OWN_HEIGHT, x),
    }
}

const fn shape(rules: &Rules, vertex: &Vertex) -> ValleyShape {
    if rules.archetypes {
        ValleyShape::from_number(vertex.valley)
    } else {
        ValleyShape::V
    }
}

/// Half-width of a vertex's valley, grains. A tributary is known no farther than its reach: its
/// valley ends before.
fn width(vertex: &Vertex, reach: &Reach, edge: i32) -> i32 {
    // An eighth short, so that the valley has ended where vertices no longer know the river.
    reach
        .half_valley(edge)
        .min(vertex.river.reach / 8 * 7)
        .max(1)
}

/// The ground beside a river.
fn beside(vertex: &Vertex, edge: i32) -> Carved {
    // A lake without a stream leaves its shore as the graphs made it.
    if vertex.river.flow == [0, 0] {
        return dry(vertex.height);
    }
    let reach = Reach::of(vertex);
    let (distance, raw) = (vertex.river_distance, vertex.height);
    let (bed, shoulder) = (reach.half_bed(), reach.shoulder());
    if distance < bed {
        return reach.in_bed(distance);
    }
    // The valley's side never raises ground above the land beside it.
    let ValleySection { height, own } = vertex.section;
    let carved = mix(height.min(raw.max(shoulder)), raw, own);
    // No ground near a river lies below its water; farther off it is raised a little at most.
    let is_near = distance - bed < width(vertex, &reach, edge).min(3 * bed);
    let least = if is_near {
        shoulder
    } else {
        shoulder.min(carved.saturating_add(MOST_RAISE))
    };
    dry(carved.max(least))
}

#[cfg(test)]
#[path = "valley_tests.rs"]
mod tests;
