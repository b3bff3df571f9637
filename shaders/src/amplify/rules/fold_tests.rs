//! Folds are uneven, run along their axis, lean to the front, and leave land that was never folded.

use super::*;
use crate::amplify::fixed::{ONE, metres};

/// Direction units in a km on an Earth-sized planet.
const KM: i32 = ONE / 6_371;

/// Half-waves of ranges in km that are told apart, 2 km each.
const LONGEST: usize = 40;

/// A vertex north and east of (1, 0, 0), whose folds run east, across the north.
fn vertex(north_km: i32, east_km: i32) -> Vertex {
    Vertex {
        direction: [ONE - 1, east_km * KM, north_km * KM],
        crust: metres(3_000),
        fold: [0, 32_767, 0],
        ..Vertex::default()
    }
}

/// The great ranges and the folds at a vertex.
fn waves(vertex: &Vertex, lean: i32) -> [FoldWave; 2] {
    let axis = FoldAxis::of(vertex);
    let [ranges, folds] = axis.strengths();
    [
        axis.wave(RANGES, ranges, lean),
        axis.wave(FOLDS, folds, lean),
    ]
}

/// Heights of great ranges along a line of 2,000 km across them, every 2 km.
fn section(east_km: i32) -> Vec<i32> {
    let places = (0..1_000).map(|k| vertex(2 * k - 1_000, east_km));
    places.map(|v| waves(&v, 0)[0].height).collect()
}

#[test]
fn ranges_are_unevenly_spaced() {
    // How often a crest follows the trough before it after so many steps of 2 km.
    let mut counts = [0_u32; LONGEST];
    for east in 0..12 {
        let heights = section(300 * east);
        let mut since = 0_usize;
        for pair in heights.windows(2) {
            since += 1;
            if (pair[0] < Q16 / 2) != (pair[1] < Q16 / 2) {
                counts[since.min(LONGEST - 1)] += 1;
                since = 0;
            }
        }
    }
    let all: u32 = counts.iter().sum();
    // A grating of 35 km would have nearly all in one bin of 4 km.
    let fullest = counts.windows(2).map(|c| c[0] + c[1]).max().unwrap();
    assert!(all > 500 && 5 * fullest < 2 * all, "{fullest} of {all}");
}

/// Squares of how folds differ between places so many times 4 km apart.
fn change(north: i32, east: i32) -> f64 {
    let pairs =
        (0..500).map(|k| [0, 4].map(|d| vertex(7 * k - 1_500 + d * north, 5 * k + d * east)));
    let heights = pairs.map(|pair| pair.map(|v| waves(&v, 0)[1].height));
    heights
        .map(|[a, b]| f64::from(a - b) * f64::from(a - b))
        .sum::<f64>()
}

#[test]
fn stripes_run_along_the_axis() {
    assert!(change(1, 0) > 3.0 * change(0, 1));
}

/// The skewness of slopes of ranges that lean to the north, or to the south.
fn skewness(lean: i32) -> f64 {
    let heights = (0..4_000).map(|k| waves(&vertex(k - 2_000, 0), lean)[0].height);
    let heights: Vec<f64> = heights.map(f64::from).collect();
    let slopes = heights.windows(2).map(|h| h[1] - h[0]);
    let mean = |power: fn(f64) -> f64| slopes.clone().map(power).sum::<f64>() / 4_000.0;
    let variance = mean(|s| s * s);
    mean(|s| s * s * s) / (variance * variance.sqrt())
}

#[test]
fn a_crest_is_steeper_on_the_side_that_it_leans_to() {
    let [north, south] = [VERGENCE, -VERGENCE].map(skewness);
    // The way across points south of an axis that points east; both sides mirror each other.
    assert!(north.abs() > 0.2 && north * south < 0.0, "{north} {south}");
}

/// Strengths of ranges and folds of land that is worn, and hilly.
fn strengths(worn: u16, hills: u16) -> [i32; 2] {
    let vertex = Vertex {
        worn,
        hills,
        ..vertex(0, 0)
    };
    FoldAxis::of(&vertex).strengths()
}

#[test]
fn age_leaves_ridges_of_old_belts_alone() {
    let young = strengths(0, 0);
    assert!(young.iter().all(|&s| s > q16(0.99)), "{young:?}");
    let old = strengths(u16::MAX, u16::MAX);
    assert!(
        old[0] < q16(0.001) && (q16(0.5)..q16(0.95)).contains(&old[1]),
        "{old:?}"
    );
    // A foreland has 0.7 of hills at most.
    let foreland = strengths(u16::MAX, 45_875);
    assert!(foreland.iter().all(|&s| s < q16(0.001)), "{foreland:?}");
}

#[test]
fn summits_sink_between_ranges_and_never_under_the_ground() {
    let rules = Rules::default();
    let end = Vertex {
        height: metres(1_000),
        ..vertex(0, 0)
    };
    let sunken = (0..600).map(|k| {
        let new = vertex(3 * k - 900, 2 * k);
        let summits = summits(&rules, 0, &new, [&end, &end]);
        assert!((metres(1_000)..=new.crust).contains(&summits));
        summits
    });
    let [low, high] = [sunken.clone().min().unwrap(), sunken.max().unwrap()];
    assert!(high - low > metres(200), "{low} {high}");
    let new = vertex(0, 0);
    for rules in [Rules::PAPER, Rules::RELEASE] {
        assert_eq!(summits(&rules, 0, &new, [&end, &end]), new.crust);
    }
}
