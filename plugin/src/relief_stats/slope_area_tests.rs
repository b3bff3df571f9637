use super::*;

/// Rows of the valleys.
const ROWS: usize = 600;

/// Valleys side by side, 10 columns wide, as steep as 0.3 n^-θ along row n: 10 cells a row drain to
/// their floors, so that the area upstream is 10 n cells.
fn valleys(theta: f64) -> HeightGrid {
    let width = 200;
    let mut floor = 5000.0;
    let mut values = Vec::new();
    for row in 0..ROWS {
        let side = |x: usize| (x % 10).abs_diff(5) as f64 * 100.0;
        values.extend((0..width).map(|x| (floor + side(x)) as f32));
        floor -= 92.6 * 0.3 * math::pow(row.max(1) as f64, -theta);
    }
    HeightGrid {
        width,
        height: ROWS,
        values,
        pixel_m: [92.6; 2],
    }
}

#[test]
fn valleys_have_the_exponent_that_made_them() {
    for theta in [0.0, 0.3, 0.5] {
        let found = slope_area_exponent(&valleys(theta)).unwrap();
        assert!((found - theta).abs() < 0.01, "{theta} {found}");
    }
}

/// Lakes on every second kilometre of the floors have no slope, and do not count.
#[test]
fn lakes_are_left_out() {
    let mut lakes = valleys(0.4);
    let columns = lakes.width;
    for x in (5..columns).step_by(10) {
        for row in (0..ROWS - 11).filter(|row| row / 11 % 2 == 1) {
            // The floor of each stretch lies as low as its end.
            let end = row / 11 * 11 + 10;
            lakes.values[row * columns + x] = lakes.values[end * columns + x];
        }
    }
    let found = slope_area_exponent(&lakes).unwrap();
    assert!((found - 0.4).abs() < 0.1, "{found}");
}

#[test]
fn level_and_small_tiles_have_none() {
    let mut level = valleys(0.3);
    level.values.fill(3.0);
    assert_eq!(slope_area_exponent(&level), None);
    let small = HeightGrid {
        width: 20,
        height: 20,
        values: (0..400).map(|i| (i % 20) as f32).collect(),
        pixel_m: [92.6; 2],
    };
    assert_eq!(slope_area_exponent(&small), None);
}

#[test]
fn bins_are_a_quarter_of_a_decade() {
    assert_eq!(bin_of(0.31), None);
    assert_eq!(bin_of(0.32), Some(0));
    assert_eq!(bin_of(0.57), Some(1));
    assert_eq!(bin_of(1.01), Some(2));
    assert_eq!(bin_of(99.0), Some(BINS - 1));
    assert_eq!(bin_of(100.0), None);
}
