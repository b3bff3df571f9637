//! Transverse valleys and river beds, carved once the subdivision is done (paper 002 §6, Fig. 17).
//!
//! A vertex knows the nearest piece of river, its distance d and where along it lies. There the
//! bed, the water and the flow φ are read off. Around the river lies its bed, half as wide as its
//! depth over the slope of its banks; beyond it the valley rises to half-width D along the
//! archetype e_r's curve, blended into the ground by a cubic Hermite step. Widths follow φ, the
//! root of the discharge: the power law of exponent ½ (release: D = 50 km at φ = 1, 4 km at 0).
//!
//! The side is measured where a vertex touches its river; between such vertices and beyond it is
//! halved as the ground is ([`ValleySection`]). Nearest pieces of river change from one vertex to the
//! next, and a side measured from each would break off along seams.
//!
//! Departures: D is bounded by a share of the control mesh's edge, so that small planets have
//! valleys too; the curve never raises ground above the land beside it; a bank always overtops its
//! water.

use super::super::arith::{mix, mul_q16, ratio, saturate, smooth, smoothstep, sqrt_q16, square};
use super::super::control::{ValleyShape, VertexKind};
use super::super::fixed::{GRAINS, Q16};
use super::super::vertex::{FAR, ValleySection, Vertex};
use super::ocean;
use super::preset::Rules;

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
}

impl Reach {
    /// What a vertex's segment says where the vertex is nearest to it.
    pub fn of(vertex: &Vertex) -> Self {
        let (piece, t) = (&vertex.river, saturate(vertex.river_along));
        let flow = mix(piece.flow[0], piece.flow[1], t);
        Self {
            bed: mix(piece.bed[0], piece.bed[1], t),
            water: mix(piece.water[0], piece.water[1], t),
            strength: sqrt_q16(flow),
        }
    }

    /// Half-width of its bed in grains: the water's depth and a metre, over the tangent of 14° to
    /// 5°.
    pub fn half_bed(&self) -> i32 {
        let depth = (self.water - self.bed).max(0).saturating_add(GRAINS);
        // 1 / tan 14° = 4.01, 1 / tan 5° = 11.43.
        let spread = mix(262_800, 749_000, self.strength);
        mul_q16(depth.min(200 * GRAINS), spread)
    }

    /// Height of its banks, grains: a metre over its water.
    fn shoulder(&self) -> i32 {
        self.water.max(self.bed).saturating_add(GRAINS)
    }

    /// Half-width of its valley in grains, on a planet whose control mesh has edges of `edge`
    /// grains.
    pub fn half_valley(&self, edge: i32) -> i32 {
        // 200 m to 16 km on edges of 52 km: the slopes beyond are those of the graphs.
        mul_q16(edge, mix(250, 20_000, square(self.strength)))
    }
}

/// The four archetypes of a valley's side, height over distance, both 0..1 in Q16; monotone, 0 at 0
/// and 1 at 1.
pub const fn archetype(shape: ValleyShape, x: i32) -> i32 {
    let x = saturate(x);
    match shape {
        ValleyShape::V => x / 2 + square(x) / 2,
        ValleyShape::FlatFloor => {
            mul_q16(smoothstep(9_830, 52_429, x), Q16 - x / 4) + square(x) / 4
        }
        ValleyShape::IceTrough => mul_q16(square(x), x),
        ValleyShape::Terraced => (smoothstep(3_277, 22_938, x) + smoothstep(36_045, 62_259, x)) / 2,
    }
}

/// The ground of a vertex after its river has carved it. `edge` is the mean edge of the control
/// mesh, grains; `cache` is what the vertex before left.
pub fn carve(cache: &mut ocean::OceanCache, vertex: &Vertex, edge: i32) -> Carved {
    match vertex.kind {
        VertexKind::Lake => Carved {
            ground: vertex.bed.min(vertex.water),
            water: vertex.water,
        },
        VertexKind::River => Carved {
            ground: vertex.bed,
            water: vertex.water.max(vertex.bed),
        },
        VertexKind::Sea => {
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

/// What the valley of a vertex's river makes of its ground, `edge` as in [`carve`].
pub fn section(rules: &Rules, vertex: &Vertex, edge: i32) -> ValleySection {
    if vertex.river_distance >= FAR || vertex.river.flow == [0, 0] {
        // A lake's shore: no stream shapes it.
        return ValleySection::outside(vertex.height);
    }
    let reach = Reach::of(vertex);
    let across = (vertex.river_distance - reach.half_bed()).max(0);
    let width = width(vertex, &reach, edge);
    if across >= width {
        return ValleySection::outside(vertex.height);
    }
    let x = ratio(across, width);
    let shape = if rules.archetypes {
        ValleyShape::from_number(vertex.valley)
    } else {
        ValleyShape::V
    };
    // Slopes of 20° beside brooks, 3.5° beside great rivers; the plain's own height bounds them.
    let tangent = mix(23_853, 4_008, reach.strength);
    let rise = mul_q16(mul_q16(width, tangent), archetype(shape, x));
    let shoulder = reach.shoulder();
    let height = shoulder.saturating_add(rise.min((vertex.crust - shoulder).max(0)));
    ValleySection {
        height,
        own: smoothstep(6_554, 58_982, x),
    }
}

/// Half-width of a vertex's valley, grains. A tributary is known no farther than its reach: its
/// valley ends before.
fn width(vertex: &Vertex, reach: &Reach, edge: i32) -> i32 {
    reach
        .half_valley(edge)
        .min(vertex.river.reach / 8 * 7)
        .max(1)
}

/// The ground beside a river.
fn beside(vertex: &Vertex, edge: i32) -> Carved {
    if vertex.river.flow == [0, 0] {
        return dry(vertex.height);
    }
    let reach = Reach::of(vertex);
    let (distance, raw) = (vertex.river_distance, vertex.height);
    let (bed, shoulder) = (reach.half_bed(), reach.shoulder());
    if distance < bed {
        let ground = mix(reach.bed, shoulder, smooth(ratio(distance, bed)));
        return Carved {
            ground,
            water: reach.water.max(ground),
        };
    }
    let ValleySection { height, own } = vertex.section;
    let carved = mix(height.min(raw.max(shoulder)), raw, own);
    // No ground near a river lies below its water.
    let near = distance - bed < width(vertex, &reach, edge).min(3 * bed);
    dry(carved.max(if near {
        shoulder
    } else {
        shoulder.min(carved.saturating_add(2 * GRAINS))
    }))
}

#[cfg(test)]
mod tests {
    use super::super::super::vertex::RiverSegment;
    use super::*;

    fn beside_river(distance_m: f64, height_m: i32, flow: i32, valley: ValleyShape) -> Carved {
        let m = |x: i32| x * GRAINS;
        let mut vertex = Vertex {
            kind: VertexKind::Terrain,
            height: m(height_m),
            crust: m(3_000),
            river: RiverSegment {
                bed: [m(100); 2],
                water: [m(105); 2],
                flow: [flow; 2],
                reach: FAR,
                ..RiverSegment::default()
            },
            river_distance: (distance_m * 1024.0) as i32,
            river_along: Q16 / 2,
            valley: valley as u8,
            ..Vertex::default()
        };
        vertex.section = section(&Rules::default(), &vertex, m(52_000));
        carve(&mut ocean::OceanCache::default(), &vertex, m(52_000))
    }

    #[test]
    fn cross_section_is_continuous_and_above_the_bed() {
        for valley in ValleyShape::ALL {
            for flow in [200, 3_000, 20_000, Q16] {
                let reach = Reach {
                    bed: 0,
                    water: 0,
                    strength: sqrt_q16(flow),
                };
                let height = (105 + reach.half_valley(52_000 * GRAINS) / (2 * GRAINS)).min(3_000);
                let mut last: Option<Carved> = None;
                for k in 0..60_000 {
                    let distance = f64::from(k) * 0.5;
                    let now = beside_river(distance, height, flow, valley);
                    assert!(now.ground >= 100 * GRAINS && now.water >= now.ground);
                    if let Some(last) = last {
                        // The land stands half the width above the river at most: nowhere steeper
                        // than three times that.
                        assert!(
                            (now.ground - last.ground).abs() < 768,
                            "{valley:?} {flow} {distance} {last:?} {now:?} {height}"
                        );
                    }
                    last = Some(now);
                }
            }
        }
    }

    #[test]
    fn water_fills_the_bed_and_ends_at_its_bank() {
        let mut wet = true;
        for k in 0..2_000 {
            let now = beside_river(f64::from(k) * 0.25, 300, 2_000, ValleyShape::V);
            let is_wet = now.water > now.ground;
            assert!(wet || !is_wet, "one river, one shore");
            assert!(!is_wet || now.water == 105 * GRAINS);
            wet = is_wet;
        }
        assert!(!wet);
        assert!(beside_river(0.0, 300, 2_000, ValleyShape::V).ground == 100 * GRAINS);
    }

    #[test]
    fn archetypes_rise_from_floor_to_rim() {
        for valley in ValleyShape::ALL {
            let mut last = 0;
            for x in 0..=Q16 {
                let y = archetype(valley, x);
                assert!(
                    y + 3 >= last && (0..=Q16 + 3).contains(&y),
                    "{valley:?} {x} {y} {last}"
                );
                last = last.max(y);
            }
            assert_eq!(archetype(valley, 0), 0);
            assert!((archetype(valley, Q16) - Q16).abs() <= 2, "{valley:?}");
        }
    }

    #[test]
    fn archetypes_are_what_they_are_called() {
        let at = |shape, percent: i32| archetype(shape, Q16 * percent / 100) * 100 / Q16;
        // How high the side stands at an eighth, a half and three quarters of the way, in percent.
        for (shape, low, half, high) in [
            (ValleyShape::V, 6..9, 36..39, 64..67),
            (ValleyShape::FlatFloor, 0..2, 50..60, 90..95),
            (ValleyShape::IceTrough, 0..1, 11..14, 41..44),
            (ValleyShape::Terraced, 5..8, 49..51, 70..80),
        ] {
            let [a, b, c] = [12, 50, 75].map(|percent| at(shape, percent));
            assert!(
                low.contains(&a) && half.contains(&b) && high.contains(&c),
                "{shape:?} {a} {b} {c}"
            );
        }
        // Between the risers of a terrace the ground is level.
        assert_eq!(at(ValleyShape::Terraced, 36), at(ValleyShape::Terraced, 54));
        for (number, shape) in (0..).zip(ValleyShape::ALL) {
            assert_eq!(
                (ValleyShape::from_number(number), shape as u8),
                (shape, number)
            );
        }
    }

    #[test]
    fn more_water_makes_wider_and_gentler_valleys() {
        let reach = |strength| Reach {
            bed: 0,
            water: 10 * GRAINS,
            strength,
        };
        let edge = 52_000 * GRAINS;
        assert!(reach(60_000).half_valley(edge) > 3 * reach(10_000).half_valley(edge));
        assert!(reach(60_000).half_bed() > reach(0).half_bed());
        let ground = |flow| beside_river(2_000.0, 900, flow, ValleyShape::V).ground;
        assert!(ground(Q16) < ground(100));
    }
}
