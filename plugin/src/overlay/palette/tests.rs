use super::*;

#[test]
fn ramps_ascend_and_pass_through_their_stops() {
    for ramp in [
        HYPSOMETRIC,
        AGE,
        AMOUNT,
        STEEPNESS,
        DIVERGING,
        TEMPERATURE,
        RAIN,
        DISCHARGE,
    ] {
        assert!(ramp.0.windows(2).all(|w| w[0].0 <= w[1].0));
        for (i, &(x, color)) in ramp.0.iter().enumerate() {
            let last_of_step = ramp.0.get(i + 1).is_none_or(|next| next.0 > x);
            assert!(!last_of_step || ramp.at(x) == opaque(color), "{x}");
        }
        assert_eq!(ramp.at(-1e9), opaque(ramp.0[0].1));
        assert_eq!(ramp.at(f32::INFINITY), opaque(ramp.0[ramp.0.len() - 1].1));
        assert_eq!(ramp.at(f32::NAN), opaque(ramp.0[0].1));
    }
}

#[test]
fn the_sea_ends_where_land_begins() {
    let (sea, land) = (HYPSOMETRIC.at(-1e-4), HYPSOMETRIC.at(0.0));
    assert!(sea[2] > sea[0] && land[1] > land[2], "{sea:?} {land:?}");
}

#[test]
fn sequential_ramps_change_steadily_in_lightness() {
    let luma =
        |c: Rgba| 0.2126 * f32::from(c[0]) + 0.7152 * f32::from(c[1]) + 0.0722 * f32::from(c[2]);
    for (ramp, sign) in [
        (AGE, -1.0),
        (AMOUNT, 1.0),
        (STEEPNESS, -1.0),
        (DISCHARGE, -1.0),
    ] {
        for i in 0..64 {
            let step = luma(ramp.at((i + 1) as f32 / 64.0)) - luma(ramp.at(i as f32 / 64.0));
            assert!(step * sign > -0.6, "{i}: {step}");
        }
    }
}

#[test]
fn oklch_knows_black_white_and_red() {
    assert_eq!(oklch(0.0, 0.0, 0.0), [0, 0, 0, 255]);
    assert_eq!(oklch(1.0, 0.0, 0.3), [255, 255, 255, 255]);
    let red = oklch(0.627_955, 0.257_683, 29.2339 / 360.0);
    assert!(red[0] >= 254 && red[1] <= 2 && red[2] <= 2, "{red:?}");
}
