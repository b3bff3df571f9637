use super::*;
use crate::query::Patch;
use crate::random::{Purpose, Stream};
use pangaea_shaders::amplify::synthetic::control_mesh;

const RADIUS_M: f64 = 6_370_000.0;

fn ground() -> PlanetGround {
    PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default()).unwrap()
}

/// A ground whose temperature at sea level is 20 °C.
fn warm_ground() -> PlanetGround {
    let control = control_mesh(6_370_000, 3, 7);
    let heights = control.vertices.iter();
    let heights = heights.map(|v| (v.height.max(0) / GRAINS) as f32);
    let temperature: Vec<f32> = heights
        .map(|height| 20.0 - LAPSE_RATE_C_PER_M * height)
        .collect();
    ground().with_temperature(&control, &temperature).unwrap()
}

fn directions(n: u64) -> Vec<DVec3> {
    let stream = Stream::new(1, Purpose::ReliefSites, 0);
    (0..n).map(|i| stream.direction(2 * i)).collect()
}

/// A ground that answers samples by single questions.
struct BySingleQuestions(PlanetGround);

impl Ground for BySingleQuestions {
    fn radius_m(&self) -> f64 {
        self.0.radius_m()
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        self.0.height(direction, level)
    }

    fn water(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        self.0.water(direction, level)
    }

    fn climate(&self, direction: DVec3, height_m: f32) -> Result<ClimateSample, GroundError> {
        self.0.climate(direction, height_m)
    }
}

#[test]
fn a_sample_has_the_bits_of_single_questions() {
    let (ground, single) = (warm_ground(), BySingleQuestions(warm_ground()));
    for (k, direction) in directions(400).into_iter().enumerate() {
        let (far, level) = (direction * 2.5, (k % 18) as u8);
        assert_eq!(ground.sample(far, level), single.sample(far, level));
    }
    for (direction, level) in [(DVec3::ZERO, 3), (DVec3::X, 18), (DVec3::NAN, 0)] {
        let refused = ground.sample(direction, level);
        assert!(refused.is_err() && refused == single.sample(direction, level));
    }
}

#[test]
fn climate_has_the_weights_of_the_leaf_of_level_0() {
    let ground = ground();
    for direction in directions(300) {
        let at = quantised(checked(direction, 0).unwrap());
        let leaf = ground.leaf(direction, 0).unwrap();
        assert_eq!(ground.base.locate(at, None), leaf.base_face);
        let [a, b, c] = &leaf.vertices;
        assert_eq!(weights_in([a, b, c], at), leaf.weights(at));
    }
}

#[test]
fn a_batch_has_the_bits_of_single_questions_in_any_order() {
    let (batch, single) = (ground(), ground());
    let directions = directions(1500);
    let mut heights = vec![0.0; directions.len()];
    batch.heights(&directions, 6, &mut heights).unwrap();
    for (direction, height) in directions.iter().zip(&heights).rev().step_by(7) {
        let found = single.height(*direction * 3.5, 6).unwrap();
        assert_eq!(found.to_bits(), height.to_bits());
    }
    let clone = single.clone().height(directions[0], 6);
    assert_eq!(clone, batch.height(directions[0], 6));
}

#[test]
fn water_is_never_below_the_ground_and_the_ground_is_within_its_bounds() {
    let ground = ground();
    let [low, high] = ground.bounds_m();
    for direction in directions(300) {
        let here = ground.sample(direction, 9).unwrap();
        let height = f64::from(here.height_m);
        assert!(here.water_m >= here.height_m);
        assert!((low..=high).contains(&height), "{height} m");
        assert!(here.normal.dot(direction) > 0.0);
    }
}

#[test]
fn fine_levels_refine_what_coarse_ones_say() {
    let ground = ground();
    for direction in directions(40) {
        let height = |level| ground.height(direction, level).unwrap();
        let [coarse, fine, finest] = [12, 15, 17].map(height);
        // Triangles of 13 m and of 0.4 m on the same slope.
        assert!((coarse - fine).abs() < 30.0, "{coarse} {fine}");
        assert!((fine - finest).abs() < 5.0, "{fine} {finest}");
    }
}

#[test]
fn temperature_follows_height_from_what_the_control_mesh_has() {
    let ground = warm_ground();
    for direction in directions(20) {
        let found = ground.climate(direction, 1000.0).unwrap();
        assert!((found.temperature_c - 13.5).abs() < 1e-3);
        assert!((0.0..=1.0).contains(&found.wetness));
    }
    let refused = ground.with_temperature(&control_mesh(6_370_000, 3, 7), &[1.0]);
    assert!(matches!(refused, Err(GroundError::Count { .. })));
}

/// Holds every triangle to the ground below its middle; their area seen from above in m².
fn area_on(ground: &PlanetGround, patch: &Patch, up: DVec3, level: u8) -> f64 {
    let mut area = 0.0;
    for triangle in &patch.triangles {
        let [a, b, c] = triangle.map(|i| patch.origin + patch.positions[i as usize].as_dvec3());
        let normal = (b - a).cross(c - a);
        area += 0.5 * normal.dot(up);
        assert!(normal.dot(a) > 0.0, "a face is flipped");
        let middle = (a + b + c) / 3.0;
        let height = f64::from(ground.height(middle, level).unwrap());
        let error = middle.length() - RADIUS_M - height;
        // A flat triangle sinks below the ball by its edge squared over twice the radius; 5 mm are
        // those of f32.
        let edge = (b - a).length().max((c - b).length()).max((a - c).length());
        let sag = edge * edge / (2.0 * RADIUS_M);
        assert!(error.abs() < sag + 0.005, "{error} m at edges of {edge} m");
    }
    area
}

#[test]
fn a_collider_is_the_ground_and_covers_its_square() {
    let ground = ground();
    let flank = DVec3::new(0.3, -0.2, 0.9);
    for (direction, side, level) in [(DVec3::X, 300.0, 17), (flank, 40_000.0, 10)] {
        let patch = ground.collider(direction, side, level).unwrap();
        // The test's control mesh is some sixteen times coarser than a planet's.
        let count = patch.triangles.len();
        assert!(count > 100, "{count} triangles");
        let area = area_on(&ground, &patch, direction.normalize(), level);
        assert!(area > side * side, "{area} m² for a square of {side} m");
    }
    for side in [1e6, f64::NAN] {
        let refused = ground.collider(DVec3::X, side, 17);
        assert!(matches!(refused, Err(GroundError::Length { .. })));
    }
}

#[test]
fn bad_questions_are_errors() {
    let ground = ground();
    assert_eq!(ground.height(DVec3::X, 18), Err(GroundError::Level(18)));
    let refused = ground.heights(&[DVec3::X, DVec3::NAN], 3, &mut [0.0; 2]);
    assert_eq!(refused, Err(GroundError::NotADirection));
}

#[test]
fn bad_meshes_are_errors() {
    let mut broken = control_mesh(6_370_000, 2, 7);
    broken.faces.pop();
    let sizeless = ControlMesh {
        radius_m: 0,
        ..control_mesh(6_370_000, 2, 7)
    };
    for mesh in [broken, sizeless] {
        let refused = PlanetGround::new(&mesh, Rules::default());
        assert!(matches!(refused, Err(GroundError::Unavailable(_))));
    }
}
