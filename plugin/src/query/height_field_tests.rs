use super::*;

const R: f64 = 6_370_000.0;

/// Ground at 100 m with bumps of a metre per level, and a pond of 3 m everywhere.
struct Bumpy;

impl Ground for Bumpy {
    fn radius_m(&self) -> f64 {
        R
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        checked(direction, level).map(|_| 100.0 + f32::from(level))
    }

    fn water(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        Ok(self.height(direction, level)? + 3.0)
    }
}

fn about() -> AzimuthalEquidistant {
    AzimuthalEquidistant::new(20.0, 170.0, R).unwrap()
}

/// 40 km by 20 km of pixels of 1 km that rise by 10 m each to the east.
fn ramp() -> HeightGrid {
    HeightGrid {
        width: 40,
        height: 20,
        values: (0..800).map(|i| 1000.0 + 10.0 * (i % 40) as f32).collect(),
        pixel_m: [1000.0; 2],
    }
}

fn field(rim_m: f64) -> Result<HeightField, GroundError> {
    HeightField::new(about(), ramp(), rim_m)
}

fn height(ground: &impl Ground, east: f64, north: f64, level: u8) -> f32 {
    let direction = about().direction(DVec2::new(east, north));
    ground.height(direction, level).unwrap()
}

#[test]
fn the_field_holds_inside_and_blends_at_its_rim() {
    let ground = FieldGround::new(Bumpy, field(4000.0).unwrap());
    // Edges of level 6 are 812 m long: up to it the field alone counts.
    for level in [0, 3, 6] {
        let own = 100.0 + f32::from(level);
        // The middle lies between the 20th pixel and the 21st.
        assert!((height(&ground, 0.0, 0.0, level) - 1195.0).abs() < 0.01);
        assert!((height(&ground, 500.0, 3000.0, level) - 1200.0).abs() < 0.01);
        assert_eq!(height(&ground, 20_001.0, 0.0, level), own);
        assert_eq!(height(&ground, 0.0, -10_001.0, level), own);
        // Half-way across the rim.
        let half = height(&ground, 0.0, 8000.0, level);
        assert!((half - 0.5 * (1195.0 + own)).abs() < 0.01, "{half}");
    }
}

#[test]
fn finer_levels_add_their_roughness() {
    let ground = FieldGround::new(Bumpy, field(4000.0).unwrap());
    // One metre more for each level beyond the sixth.
    assert!((height(&ground, 0.0, 0.0, 17) - 1206.0).abs() < 0.01);
}

#[test]
fn no_step_shows_anywhere() {
    let ground = FieldGround::new(Bumpy, field(4000.0).unwrap());
    let heights = (-2300..=2300).map(|k| height(&ground, 10.0 * f64::from(k), 500.0, 6));
    let heights: Vec<f32> = heights.collect();
    // 1300 m over a rim of 4 km, at most one and a half times as steep, in steps of 10 m.
    let steepest = heights.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    assert!(steepest.fold(0.0, f32::max) < 5.5);
}

#[test]
fn water_rises_with_its_ground_and_the_sea_fills_hollows() {
    let at = about().centre();
    let ground = FieldGround::new(Bumpy, field(4000.0).unwrap());
    assert!((ground.water(at, 6).unwrap() - 1198.0).abs() < 0.01);
    assert_eq!(ground.water(-at, 6), Bumpy.water(-at, 6));
    let bay = HeightGrid {
        values: vec![-50.0; 800],
        ..ramp()
    };
    let bay = FieldGround::new(Bumpy, HeightField::new(about(), bay, 4000.0).unwrap());
    let [height, water] = [bay.height(at, 6), bay.water(at, 6)].map(Result::unwrap);
    assert!(
        (height + 50.0).abs() < 0.01 && water == 0.0,
        "{height} {water}"
    );
}

#[test]
fn impossible_fields_are_refused() {
    assert!(matches!(field(10_001.0), Err(GroundError::Length { .. })));
    assert!(matches!(field(f64::NAN), Err(GroundError::Length { .. })));
    for values in [vec![0.0; 799], vec![f32::NAN; 800], Vec::new()] {
        let grid = HeightGrid { values, ..ramp() };
        let refused = HeightField::new(about(), grid, 0.0);
        assert!(matches!(refused, Err(GroundError::Unavailable(_))));
    }
    let endless = HeightGrid {
        pixel_m: [f64::INFINITY; 2],
        ..ramp()
    };
    assert!(HeightField::new(about(), endless, 0.0).is_err());
}
