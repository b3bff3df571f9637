use super::*;

fn percent_of(values: Vec<f32>) -> f64 {
    let width = 22;
    let height = values.len() / width;
    let tile = HeightGrid {
        width,
        height,
        values,
        pixel_m: [92.6; 2],
    };
    pits_percent(&tile).unwrap()
}

/// Of 20 x 20 cells with all neighbours, every ninth is a pit: every third one each way.
#[test]
fn pits_are_counted_where_they_are() {
    let is_low = |i: usize| i % 22 % 3 == 1 && i / 22 % 3 == 1;
    let found = percent_of((0..484).map(|i| f32::from(u8::from(!is_low(i)))).collect());
    assert!((found - 100.0 * 49.0 / 400.0).abs() < 1e-12, "{found}");
}

#[test]
fn slopes_floors_and_edges_have_none() {
    assert_eq!(percent_of((0..484).map(|i| (i % 22) as f32).collect()), 0.0);
    // Two cells as low as each other: neither lies lower than all of its neighbours.
    let mut floor = vec![5.0; 484];
    floor[200] = 1.0;
    floor[201] = 1.0;
    assert_eq!(percent_of(floor), 0.0);
    let mut edge = vec![5.0; 484];
    edge[43] = 1.0;
    assert_eq!(percent_of(edge), 0.0);
}
