use super::*;
use crate::amplify::fixed::{GRAINS, metres};
use crate::amplify::rules::graph_tests::between_two;
use crate::amplify::seed::pcg;
use crate::amplify::vertex::{CornerBeside, Vertex};

/// Land of a young belt under a crust of 5 km.
fn land(height_m: i32, level: u8, seed: u32) -> Vertex {
    Vertex {
        height: metres(height_m),
        bed: metres(height_m),
        crust: metres(5_000),
        seed: pcg(seed),
        level,
        ..Vertex::default()
    }
}

/// The middle of an edge between two vertices, in metres; `beside` are the heights of the corners
/// next to it.
fn middle(level: u32, ends: [&Vertex; 2], beside: [i32; 2], seed: u32) -> f64 {
    along(false, level, ends, beside, seed)
}

/// The same of a descent, or of an edge that is none.
fn along(is_descent: bool, level: u32, ends: [&Vertex; 2], beside: [i32; 2], seed: u32) -> f64 {
    let length = metres(52_000) >> level;
    let new = Vertex {
        seed: pcg(seed ^ 77),
        ..*ends[0]
    };
    let context = EdgeContext {
        beside: beside.map(|height_m| Some(corner(height_m, length))),
        is_descent,
        ..between_two(ends, &new, level, length)
    };
    f64::from(divide(&Rules::default(), &context)) / f64::from(GRAINS)
}

/// A corner beside an edge of some length.
fn corner(height_m: i32, length: i32) -> CornerBeside {
    CornerBeside {
        height: metres(height_m),
        distance: length / 8 * 7,
    }
}

/// A vertex above the lower end of its edge keeps its way down for ever: what its descent is cut into
/// falls from it to that end, whatever is beside it.
#[test]
fn descents_fall_all_the_way() {
    for seed in 0..500 {
        let (low, high) = (1_000, 1_002 + (pcg(seed) % 900) as i32);
        let level = 1 + seed % 9;
        let ends = [
            land(low, level as u8 - 1, seed),
            land(high, level as u8, seed + 1),
        ];
        let found = along(true, level, [&ends[0], &ends[1]], [900, 900], seed);
        assert!(
            f64::from(low) < found && found < f64::from(high),
            "{level} {found}"
        );
    }
}

/// Between level ends over lower ground there is a divide, on a hillside there is none.
#[test]
fn divides_rise_over_lower_ground_alone() {
    for seed in 0..500 {
        let level = 3 + seed % 3;
        let ends = [2_000, 2_000].map(|height| land(height, level as u8, seed));
        let rise = |beside| middle(level, [&ends[0], &ends[1]], beside, seed) - 2_000.0;
        let (crest, hillside) = (rise([1_900, 1_900]), rise([3_900, 1_000]));
        assert!(crest > 20.0, "level {level}: {crest}");
        assert!(hillside < 2.0, "level {level}: {hillside}");
    }
}

/// The side of a valley is no steeper than its rock bears from any corner around it, 0.7 of the
/// landform's steepness, which is below 1 under 5 km of crust: a floor beside an edge holds its
/// middle down, though both ends stand high.
#[test]
fn valleys_hold_down_the_ground_beside_them() {
    for seed in 0..500 {
        let level = 3;
        let ends = [3_000, 3_000].map(|height| land(height, level as u8, seed));
        let over = |floor| middle(level, [&ends[0], &ends[1]], [floor, floor], seed);
        // 6.5 km edges: the corners are 5.7 km away.
        assert!(over(1_000) < 1_000.0 + 0.7 * 5_700.0);
        assert!(over(-1_500) <= 3_000.0 + 8.0, "{}", over(-1_500));
    }
}
