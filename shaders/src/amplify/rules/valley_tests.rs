//! Laws of the cross-section of a valley.

use super::*;
use crate::amplify::fixed::GRAINS;
use crate::amplify::vertex::RiverSegment;

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
                tide: 0,
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

/// A river ten metres deep of a strength √φ.
fn reach(strength: i32) -> Reach {
    Reach {
        tide: 0,
        bed: 0,
        water: 10 * GRAINS,
        strength,
    }
}

#[test]
fn more_water_makes_wider_and_gentler_valleys() {
    let edge = 52_000 * GRAINS;
    assert!(reach(60_000).half_valley(edge) > 3 * reach(10_000).half_valley(edge));
    assert!(reach(60_000).half_bed() > reach(0).half_bed());
    let ground = |flow| beside_river(2_000.0, 900, flow, ValleyShape::V).ground;
    assert!(ground(Q16) < ground(100));
}
