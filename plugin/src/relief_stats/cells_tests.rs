use super::*;

fn grid(
    [width, height]: [usize; 2],
    pixel_m: [f64; 2],
    z: impl Fn(usize, usize) -> f32,
) -> HeightGrid {
    let values = (0..width * height)
        .map(|i| z(i % width, i / width))
        .collect();
    HeightGrid {
        width,
        height,
        values,
        pixel_m,
    }
}

#[test]
fn pixels_of_three_arc_seconds_are_cells() {
    let tile = grid([5, 4], [92.6, 92.77], |x, y| (x * y) as f32);
    assert!(matches!(on_cells(&tile, 3), Some(Cow::Borrowed(same)) if same == &tile));
    assert!(on_cells(&tile, 5).is_none());
}

#[test]
fn cells_of_whole_pixels_are_their_means() {
    let tile = grid([6, 6], [46.3, 46.3], |x, y| (x + 10 * y) as f32);
    let cells = on_cells(&tile, 3).unwrap();
    assert_eq!([cells.width, cells.height], [3, 3]);
    assert_eq!(cells.pixel_m, [CELL_M; 2]);
    let expected = [5.5, 7.5, 9.5, 25.5, 27.5, 29.5, 45.5, 47.5, 49.5];
    assert_eq!(cells.values, expected);
}

/// The mean of a ramp over a cell is its height at the middle of the cell, wherever pixels end.
#[test]
fn parts_of_pixels_count_by_their_area() {
    let pixel = 30.0;
    let tile = grid([100, 100], [pixel, 92.6], |x, _| x as f32);
    let cells = on_cells(&tile, 3).unwrap();
    assert_eq!([cells.width, cells.height], [32, 100]);
    // Steps of a ramp are off by what a part of a pixel leans to a side: 1/8 of a pixel at most.
    let middle = 49.5;
    for (i, z) in cells.row(7).iter().enumerate() {
        let expected = middle + (i as f64 - 15.5) * CELL_M / pixel;
        assert!((f64::from(*z) - expected).abs() < 0.125, "{i} {z}");
    }
}

#[test]
fn shares_of_a_footprint_sum_to_one() {
    for (from, to) in [(0.0, 1.4), (1.4, 2.8), (2.8, 4.2), (2.0, 3.0)] {
        let found = footprint(from, to, 6);
        assert!((found.shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert!(found.shares.iter().all(|&share| share > 0.0), "{found:?}");
    }
    assert_eq!(footprint(2.0, 3.0, 6).first, 2);
    assert_eq!(footprint(1.5, 3.5, 6).shares, [0.25, 0.5, 0.25]);
}

#[test]
fn coarse_and_broken_tiles_have_no_cells() {
    assert!(on_cells(&grid([50, 50], [98.0, 92.6], |_, _| 0.0), 3).is_none());
    assert!(on_cells(&grid([2, 50], [92.6; 2], |_, _| 0.0), 1).is_none());
    assert!(on_cells(&grid([50, 50], [f64::NAN; 2], |_, _| 0.0), 3).is_none());
    assert!(on_cells(&grid([50, 50], [1.0; 2], |_, _| 0.0), 3).is_none());
    let mut broken = grid([50, 50], [92.6; 2], |_, _| 0.0);
    broken.values[3] = f32::NAN;
    assert!(on_cells(&broken, 3).is_none());
}
