use super::*;
use GroundSurface::{Forest, Grass, Ice, Mud, Rock, Sand, Scree, SeaFloor, Snow};

/// The material of dry ground.
fn dry(height_m: f32, slope_deg: f32, temperature_c: f32, wetness: f32) -> GroundSurface {
    wet(height_m, height_m, slope_deg, temperature_c, wetness)
}

/// The material of ground with water on it.
fn wet(
    height_m: f32,
    water_m: f32,
    slope_deg: f32,
    temperature_c: f32,
    wetness: f32,
) -> GroundSurface {
    classify(&GroundConditions {
        height_m,
        water_m,
        slope_deg,
        climate: ClimateSample {
            temperature_c,
            wetness,
        },
    })
}

#[test]
fn waters_have_their_floors() {
    assert_eq!(wet(-4000.0, 0.0, 1.0, 10.0, 0.5), SeaFloor, "abyss");
    assert_eq!(wet(300.0, 320.0, 2.0, 10.0, 0.5), Mud, "lake");
    assert_eq!(wet(300.0, 301.0, 12.0, 10.0, 0.5), Scree, "rapids");
}

#[test]
fn deserts_and_mountains_are_bare() {
    assert_eq!(dry(1.0, 3.0, 20.0, 0.5), Sand, "beach");
    assert_eq!(dry(400.0, 4.0, 25.0, 0.02), Sand, "dunes");
    assert_eq!(dry(400.0, 20.0, 25.0, 0.02), Rock, "wadi");
    assert_eq!(dry(2600.0, 35.0, 0.0, 0.6), Scree, "talus");
    assert_eq!(dry(3500.0, 65.0, -6.0, 0.6), Rock, "north face");
    assert_eq!(dry(3500.0, 30.0, -5.0, 0.6), Snow, "firn");
    assert_eq!(dry(2500.0, 1.0, -30.0, 0.3), Ice, "ice cap");
}

#[test]
fn the_rest_is_overgrown() {
    assert_eq!(dry(400.0, 2.0, 8.0, 0.3), Grass, "steppe");
    assert_eq!(dry(200.0, 10.0, 26.0, 0.95), Forest, "jungle");
    assert_eq!(dry(50.0, 0.2, 10.0, 0.95), Mud, "marsh");
    assert_eq!(dry(2300.0, 20.0, 0.0, 0.6), Grass, "alp");
    let nan = f32::NAN;
    assert_eq!(wet(nan, nan, nan, nan, nan), Grass, "no rule fits");
}

#[test]
fn climate_cools_to_the_poles_and_upwards() {
    let t = |sin, height| ClimateSample::of_latitude(sin, height).temperature_c;
    assert!(t(0.0, 0.0) > 25.0 && t(1.0, 0.0) < -10.0);
    assert!((t(0.0, 0.0) - t(0.0, 1000.0) - 6.5).abs() < 1e-4);
    // One law for bakes and for questions.
    assert_eq!(t(0.3, 2500.0), mean_temperature(0.3, 2.5));
    assert_eq!(t(0.5, -4000.0), t(-0.5, 0.0));
}

#[test]
fn names_and_numbers_are_unique() {
    let mut names = GroundSurface::ALL.map(GroundSurface::name).to_vec();
    for (i, surface) in GroundSurface::ALL.into_iter().enumerate() {
        assert_eq!(surface as usize, i);
    }
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), GroundSurface::ALL.len());
}
