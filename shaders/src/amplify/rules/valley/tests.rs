//! Laws of the cross-section of a valley.

use super::*;
use crate::amplify::control::{ValleyShape, VertexKind};
use crate::amplify::fixed::{GRAINS, Q16, metres, q16};
use crate::amplify::rules::Rules;
use crate::amplify::scale::PlanetScale;
use crate::amplify::synthetic::control_mesh;
use crate::amplify::vertex::{RiverSegment, Vertex};

/// Level of the water of all rivers here, grains.
const WATER: i32 = metres(105);

/// A planet of a radius, its control mesh's edges 52 km long on an Earth-sized one.
fn scale(radius_m: u32) -> PlanetScale {
    PlanetScale {
        edge: (f64::from(radius_m) / 6_371_000.0 * 52_000.0 * 16.0) as u32,
        ..PlanetScale::new(&control_mesh(radius_m, 1, 1))
    }
}

fn earth() -> PlanetScale {
    scale(6_371_000)
}

/// Flow φ of a discharge in m³/s, Q16.
fn flow(discharge: f64) -> i32 {
    ((discharge / 200_000.0).sqrt() * 65_536.0).round() as i32
}

fn river(flow: i32) -> RiverSegment {
    RiverSegment {
        water: [WATER; 2],
        flow: [flow; 2],
        ..RiverSegment::default()
    }
}

/// Land at a distance from a river, in grains, that stood at a height before.
fn land(distance: i32, height: i32, flow: i32, valley: ValleyShape) -> Vertex {
    let mut vertex = Vertex {
        direction: [1_500_000_000, distance, distance / 3],
        kind: VertexKind::Terrain,
        height,
        crust: metres(3_000),
        river: river(flow),
        river_distance: distance,
        river_along: Q16 / 2,
        valley: valley as u8,
        ..Vertex::default()
    };
    vertex.section = section(&earth(), &Rules::default(), &vertex);
    vertex
}

fn carved(scale: &PlanetScale, rules: &Rules, vertex: &Vertex) -> Carved {
    carve(&mut CarveCache::default(), scale, rules, vertex)
}

/// The ground at a distance in metres from a river, that stood at a height in metres before.
fn beside_river(distance_m: f64, height_m: i32, flow: i32, valley: ValleyShape) -> Carved {
    let distance = (distance_m * 1024.0) as i32;
    let vertex = land(distance, metres(height_m), flow, valley);
    carved(&earth(), &Rules::default(), &vertex)
}

/// Width in metres of the water of a straight river, by steps of a 2000th of what is expected.
fn wetted_width(scale: &PlanetScale, rules: &Rules, discharge: f64, expected: f64) -> f64 {
    let step = expected / 2_000.0;
    let distances = (0..4_000).map(|k| (f64::from(k) * step * 1024.0) as i32);
    let half = distances
        .map(|distance| land(distance, metres(400), flow(discharge), ValleyShape::V))
        .take_while(|vertex| carved(scale, rules, vertex).is_wet())
        .count();
    2.0 * half as f64 * step
}

#[test]
fn width_is_that_of_leopold_and_maddock() {
    for discharge in [5.0, 60.0, 1_000.0, 38_600.0, 199_000.0_f64] {
        let expected = 4.8 * discharge.sqrt();
        let found = wetted_width(&earth(), &Rules::default(), discharge, expected);
        assert!(
            (found / expected - 1.0).abs() < 0.01,
            "{discharge}: {found} {expected}"
        );
        let wide = Rules {
            channel_width: q16(9.6),
            ..Rules::default()
        };
        let found = wetted_width(&earth(), &wide, discharge, 2.0 * expected);
        assert!(
            (found / expected - 2.0).abs() < 0.02,
            "{discharge}: {found}"
        );
    }
    // A planet half as large has a quarter of the rain, and rivers half as wide.
    let found = wetted_width(&scale(3_185_500), &Rules::default(), 1_000.0, 76.0);
    assert!((found / 76.0 - 1.0).abs() < 0.02, "{found}");
}

#[test]
fn depth_is_a_fifteenth_of_a_brook_and_a_sixtieth_of_the_greatest_river() {
    for (discharge, least, most) in [
        (0.5, 15.0, 17.0),
        (60.0, 20.0, 22.0),
        (199_900.0, 59.5, 60.5),
    ] {
        let reach = Reach::at(&earth(), &Rules::default(), &river(flow(discharge)), 0);
        let depth =
            f64::from(WATER - beside_river(0.0, 300, flow(discharge), ValleyShape::V).ground);
        let slenderness = 2.0 * f64::from(reach.half_bed) / depth;
        assert!(
            (least..most).contains(&slenderness),
            "{discharge}: {slenderness}"
        );
    }
}

/// Half-widths of the bed at some eighths of a segment.
fn half_beds(segment: RiverSegment) -> [i32; 5] {
    let at = |eighth| Reach::at(&earth(), &Rules::default(), &segment, Q16 / 8 * eighth);
    [0, 1, 2, 3, 8].map(|eighth| at(eighth).half_bed)
}

#[test]
fn an_arm_leaves_the_apex_of_a_delta_as_wide_as_its_river() {
    let [whole, own] = [20_000.0, 3_000.0].map(flow);
    let arm = RiverSegment {
        flow: [whole, own],
        ..river(own)
    };
    let [at_apex, below, quarter, rest @ ..] = half_beds(arm);
    let [river, own] = [whole, own].map(|flow| half_beds(river(flow))[0]);
    assert_eq!(at_apex, river);
    assert!(own + own / 8 < below && below < river, "{below}");
    assert_eq!([quarter, rest[0], rest[1]], [own; 3]);
}

#[test]
fn cross_section_is_continuous_and_above_the_bed() {
    for valley in ValleyShape::ALL {
        for flow in [200, 3_000, 20_000, 60_000] {
            let reach = Reach::at(&earth(), &Rules::default(), &river(flow), 0);
            let half_valley = reach.half_valley(metres(52_000));
            let height = (105 + half_valley / metres(2)).min(3_000);
            let mut last: Option<Carved> = None;
            for k in 0..60_000 {
                let now = beside_river(f64::from(k) * 0.5, height, flow, valley);
                assert!(now.ground >= WATER - reach.depth);
                // The land stands half the width above the river at most: nowhere steeper than
                // three times that.
                let is_even = |last: Carved| (now.ground - last.ground).abs() < 768;
                assert!(
                    last.is_none_or(is_even),
                    "{valley:?} {flow} {k} {last:?} {now:?}"
                );
                last = Some(now);
            }
        }
    }
}

#[test]
fn water_fills_the_bed_and_keeps_its_level_under_the_bank() {
    let reach = Reach::at(&earth(), &Rules::default(), &river(2_000), 0);
    for k in 0..8_000 {
        let distance = k * GRAINS / 64;
        let now = beside_river(f64::from(distance) / 1024.0, 300, 2_000, ValleyShape::V);
        // The shore is right to a thirtieth of a metre.
        if (distance - reach.half_bed).abs() > GRAINS / 30 {
            assert_eq!(
                now.is_wet(),
                distance < reach.half_bed,
                "one river, one shore"
            );
        }
        let knows_water = distance <= 2 * reach.half_bed;
        assert_eq!(now.water, if knows_water { WATER } else { NO_WATER });
    }
}

/// Land that lies lower than a river is dry beyond its levee.
#[test]
fn no_river_drowns_the_land_beside_it() {
    for flow in [200, 2_000, 30_000] {
        for k in 0..4_000 {
            let distance = f64::from(k) * 2.0;
            let now = beside_river(distance, 40, flow, ValleyShape::FlatFloor);
            let half_bed = Reach::at(&earth(), &Rules::default(), &river(flow), 0).half_bed;
            assert!(
                !now.is_wet() || distance * 1024.0 < f64::from(half_bed),
                "{flow} {k}"
            );
        }
    }
}

/// A level plain beside a river of 130 m: the levee stands over it, and no two neighbours of a
/// metre have one height but where the relief turns.
#[test]
fn flood_plains_have_levees_and_relief() {
    let height = |k: i32| beside_river(f64::from(k), 104, 4_000, ValleyShape::FlatFloor).ground;
    let heights: Vec<i32> = (90..260).map(height).collect();
    let level = heights.windows(2).filter(|w| w[0] == w[1]).count();
    assert!(level * 20 < heights.len(), "{level}");
    let mean = |part: &[i32]| part.iter().sum::<i32>() / part.len() as i32;
    let (near, far) = (mean(&heights[..60]), mean(&heights[120..]));
    assert!(near > far + GRAINS / 8, "{near} {far}");
    let steepest = heights.windows(2).map(|w| (w[0] - w[1]).abs()).max();
    assert!(steepest < Some(GRAINS / 4), "{steepest:?}");
}

#[test]
fn the_sea_and_a_coast_know_the_level_of_the_sea() {
    for kind in [VertexKind::Sea, VertexKind::Coast] {
        let vertex = Vertex {
            kind,
            height: if kind == VertexKind::Sea {
                -metres(50)
            } else {
                0
            },
            ..Vertex::default()
        };
        let found = carved(&earth(), &Rules::default(), &vertex);
        assert_eq!((found.water, found.is_wet()), (0, kind == VertexKind::Sea));
    }
    let inland = Carved::dry(-metres(300));
    assert!(!inland.is_wet());
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
    let edge = metres(52_000);
    let reach = |flow| Reach::at(&earth(), &Rules::default(), &river(flow), 0);
    assert!(reach(60_000).half_valley(edge) > 3 * reach(1_000).half_valley(edge));
    let ground = |flow| beside_river(2_000.0, 900, flow, ValleyShape::V).ground;
    assert!(ground(60_000) < ground(100));
}
