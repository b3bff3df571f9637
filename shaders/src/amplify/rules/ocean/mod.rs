//! The ocean floor's relief, laid on once the subdivision is done (paper 000 §5).
//!
//! Three layers: transform faults, narrow troughs perpendicular to the ridge, hundreds of
//! kilometres long; abyssal hills, low waves parallel to it, here high and there hardly to be seen;
//! and fine gradient noise. The first two follow the recorded ridge direction r, are strong where
//! the floor is young and are buried by sediment as it ages. All fade out towards the shore, and
//! none rises above the sea.

pub mod phasor;

use super::super::arith::{mul_q16, ratio, saturate, smoothstep, square};
use super::super::fixed::{GRAINS, ONE, Q16};
use super::super::vertex::Vertex;
use super::noise::{CornerCache, fbm};
use phasor::{PacketCache, phasor};

/// Age at which half of the young floor's relief is left, 1/64 My: 25 My.
const HALF_AGE: i32 = 25 * 64;

/// What the noises drew for the last vertex: vertices of a patch share most of it. It changes no
/// bit of a relief.
#[derive(Clone, Debug, Default)]
pub struct OceanCache {
    fine: [CornerCache; 13],
    coarse: [CornerCache; 4],
    faults: PacketCache,
    hills: PacketCache,
}

/// Offset of the sea floor at a vertex, grains. `edge` is the mean edge of the control mesh,
/// grains: on small planets the relief shrinks with it.
pub fn relief(cache: &mut OceanCache, vertex: &Vertex, edge: i32) -> i32 {
    let depth = -vertex.height;
    if depth <= 0 {
        return 0;
    }
    // 52 km carry the full relief.
    let size = ratio(edge, 52_000 * GRAINS);
    let fine = fbm(&mut cache.fine, vertex.direction, 21, 31_457, 0x0cea_0001);
    let coarse = fbm(&mut cache.coarse, vertex.direction, 25, 36_045, 0x0cea_0002);
    let rough = mul_q16(120 * GRAINS, fine) + mul_q16(260 * GRAINS, coarse);
    // No spreading is even: hills of one patch are up to five times as high as another's.
    let uneven = Q16 / 4 + saturate(Q16 / 2 + coarse);
    let offset = mul_q16(rough + ridge_relief(cache, vertex, uneven), size);
    // A shelf 130 m deep keeps a fiftieth, the deep sea all.
    let room = smoothstep(0, 2_500 * GRAINS, depth);
    mul_q16(offset, room).min(depth / 2)
}

/// Transform faults and abyssal hills; `uneven` is the hills' height relative to the mean, Q16.
fn ridge_relief(cache: &mut OceanCache, vertex: &Vertex, uneven: i32) -> i32 {
    if vertex.oceanic == 0 || vertex.ridge == [0; 3] {
        return 0;
    }
    let young = ratio(HALF_AGE, HALF_AGE + i32::from(vertex.ocean_age));
    // Packets of 200 km, three waves each: faults run on as far as they agree.
    let faults = phasor(
        &mut cache.faults,
        vertex.direction,
        vertex.ridge,
        26,
        196_608,
        0x0cea_0003,
    );
    // A trough where the cosine is -1: ((1 - cos) / 2)⁴, sharp.
    let trough = square(square((Q16 - faults.cosine) / 2));
    let deep = mul_q16(
        mul_q16(900 * GRAINS, Q16 / 6 - trough),
        smoothstep(9_830, 45_875, faults.presence),
    );
    let hills = phasor(
        &mut cache.hills,
        vertex.direction,
        spreading(vertex),
        22,
        131_072,
        0x0cea_0004,
    );
    let low = mul_q16(
        mul_q16(mul_q16(180 * GRAINS, uneven), hills.cosine),
        hills.presence,
    );
    let buried = mul_q16(deep, Q16 / 5 + mul_q16(young, 52_429))
        + mul_q16(low, Q16 / 4 + mul_q16(young, 49_152));
    mul_q16(buried, i32::from(vertex.oceanic))
}

/// Direction of spreading: perpendicular to the ridge, along the ground; components times 32767.
fn spreading(vertex: &Vertex) -> [i16; 3] {
    let n = vertex.direction.map(|c| c >> 16);
    let r = vertex.ridge.map(i32::from);
    let one = ONE >> 16;
    let cross =
        |a: usize, b: usize| ((n[a] * r[b] - n[b] * r[a]) / one).clamp(-32_767, 32_767) as i16;
    [cross(1, 2), cross(2, 0), cross(0, 1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::amplify::control::VertexKind;

    /// The relief at a vertex that nothing was asked before.
    fn relief(vertex: &Vertex, edge: i32) -> i32 {
        super::relief(&mut OceanCache::default(), vertex, edge)
    }

    fn floor(y: i32, age_my: u16, depth_m: i32) -> Vertex {
        Vertex {
            direction: [ONE - 3_000, y, 40_000_000],
            height: -depth_m * GRAINS,
            kind: VertexKind::Sea,
            oceanic: 65_535,
            ocean_age: age_my * 64,
            ridge: [0, 32_767, 0],
            ..Vertex::default()
        }
    }

    fn spread(age: u16, depth: i32) -> f64 {
        let values: Vec<f64> = (0..2_000)
            .map(|i| f64::from(relief(&floor(i * 400_000, age, depth), 52_000 * GRAINS)) / 1024.0)
            .collect();
        let mean = values.iter().sum::<f64>() / 2_000.0;
        (values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / 2_000.0).sqrt()
    }

    #[test]
    fn young_floor_is_rougher_than_old() {
        assert!(spread(2, 2_600) > 1.3 * spread(150, 5_500));
        assert!(
            (60.0..400.0).contains(&spread(2, 2_600)),
            "{}",
            spread(2, 2_600)
        );
    }

    #[test]
    fn shelves_are_smooth_and_stay_under_water() {
        assert!(spread(100, 100) < 12.0, "{}", spread(100, 100));
        for i in 0..2_000 {
            for depth in [1, 10, 300, 3_000] {
                let vertex = floor(i * 777_777, 5, depth);
                assert!(vertex.height + relief(&vertex, 52_000 * GRAINS) < 0);
            }
        }
        assert_eq!(relief(&floor(1, 1, -5), 52_000 * GRAINS), 0);
    }
}
