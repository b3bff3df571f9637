//! Relief of the sea floor.

use super::*;
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::GRAINS;
use crate::amplify::rules::noise::gradient;
use crate::amplify::seed::pcg;

/// The relief at a vertex, from an empty cache.
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

/// Places, or vertices, of which a mean is taken.
const COUNT: u32 = 4_000;

/// Mean of the squares of so many values.
fn mean_square(value: impl Fn(u32) -> i32) -> f64 {
    let values = (0..COUNT).map(|k| f64::from(value(k)));
    values.map(|x| x * x).sum::<f64>() / f64::from(COUNT)
}

/// Under the levels that draw, the floor between an edge's ends goes on as rough as the octaves
/// of its noise would be that are left out there.
#[test]
fn draws_go_on_where_the_noise_ends() {
    let sea = floor(0, 5, 3_000);
    for level in SWELL_LEVEL + 1..=17 {
        let drawn = mean_square(|k| {
            let mut new = Vertex {
                level,
                seed: pcg(k),
                swell: 7_000,
                ..sea
            };
            settle(&mut OceanCache::default(), &mut new, [&sea; 2]);
            new.swell - 7_000
        });
        let octave = u32::from(level - SWELL_LEVEL) + 4;
        let height = (0..octave).fold(FINE.height, |h, _| mul_q16(h, FINE.gain));
        let noise = mean_square(|k| {
            let at = [k, k + 70_000, k + 140_000].map(|k| (pcg(k) >> 1) as i32);
            let one = gradient(&mut CornerCache::default(), at, FINE.cell - octave, 5);
            mul_q16(height, one)
        });
        assert!(
            (0.6..1.7).contains(&(drawn / noise)),
            "{level}: {drawn} {noise}"
        );
    }
}

#[test]
fn land_has_no_swell() {
    let land = floor(0, 5, -10);
    let mut new = Vertex { level: 12, ..land };
    settle(&mut OceanCache::default(), &mut new, [&land; 2]);
    assert_eq!(new.swell, 0);
}

/// The relief of a floor whose ridge has a direction.
fn relief_beside(ridge: [i16; 3], of: Vertex) -> i32 {
    relief(&Vertex { ridge, ..of }, 52_000 * GRAINS)
}

/// Where the ridge's directions around a place are at right angles their mean is one of two, by
/// chance. Whichever it is, the floor is the same: no scarp opens between the two.
#[test]
fn directions_that_disagree_make_no_scarp() {
    for i in 0..2_000 {
        let floor = floor(i * 400_000, 2, 2_600);
        let [a, b] = [16_383, -16_383].map(|z| relief_beside([0, 16_383, z], floor));
        assert_eq!(a, b, "{i}");
    }
}

/// A mean direction is shorter than those that it is the mean of. Its length is no wavelength:
/// stripes keep theirs, and grow shallower.
#[test]
fn short_directions_bend_no_stripes() {
    for i in 0..2_000 {
        let floor = floor(i * 400_000, 2, 2_600);
        let [whole, short] = [32_767, 31_500].map(|y| relief_beside([0, y, 0], floor));
        assert!((whole - short).abs() < 200, "{i}: {whole} {short}");
    }
}
