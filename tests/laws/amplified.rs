//! The amplified ground of grown planets is the land of their simulation: its area, its height on
//! every level, and no summit that no planet has.

use bevy::math::DVec3;
use bevy_pangaea::math::{self, angle_between, lat_lon};
use bevy_pangaea::prelude::*;
use bevy_pangaea::query::{AzimuthalEquidistant, CoarseGround, MapSquare};
use bevy_pangaea::sphere::SphereMesh;
use pangaea_tests::grown::GrownPlanet;

/// Share of the sphere whose samples stand above the sea.
fn land_of_samples(planet: &GrownPlanet) -> f64 {
    let is_land = |i: &usize| planet.elevation[*i] > 0.0;
    let samples = (0..planet.mesh.len()).filter(is_land);
    let area: f64 = samples.map(|i| planet.mesh.area(i as u32)).sum();
    area / (4.0 * math::PI)
}

/// The crust alone, with straight slopes from sample to sample.
fn sloping(planet: &GrownPlanet) -> CoarseGround {
    let heights = planet.elevation.iter().map(|km| 1000.0 * km).collect();
    CoarseGround::new(planet.mesh.clone(), heights, 6_370_000.0).expect("a crust")
}

/// A grown planet whose laws are checked.
struct Amplified(GrownPlanet);

impl Amplified {
    /// The shore runs somewhere between samples of land and of sea: the land's share lies between
    /// that of a crust with straight slopes from sample to sample, where it drowns beside deep sea,
    /// and that of the samples. No level has another share.
    fn assert_the_land_keeps_its_area(&self) {
        let spread = SphereMesh::fibonacci(100_000).expect("a mesh");
        let directions = spread.points();
        let sloping = land(&sloping(&self.0), directions, 0);
        let samples = land_of_samples(&self.0);
        let shares = [5, 6, 7, 8].map(|level| land(&self.0.ground, directions, level));
        eprintln!("{shares:.4?} between {sloping:.4} and {samples:.4}");
        for share in shares {
            assert!((sloping..samples).contains(&share), "{shares:?}");
            assert!((share - shares[0]).abs() < 0.002, "{shares:?}");
        }
    }

    /// Places of the highest summits that control vertices allow, far from each other.
    fn highest(&self, count: usize) -> Vec<DVec3> {
        let mut vertices: Vec<_> = self.0.ground.base().vertices.iter().collect();
        vertices.sort_by_key(|v| -v.crust);
        let mut places: Vec<DVec3> = Vec::new();
        for vertex in vertices {
            let place = DVec3::from_array(vertex.direction.map(f64::from)).normalize();
            if places
                .iter()
                .all(|&other| angle_between(place, other) > 0.05)
            {
                places.push(place);
            }
            if places.len() == count {
                break;
            }
        }
        places
    }

    fn assert_no_summit_is_too_high(&self) {
        let mut highest = f32::MIN;
        for place in self.highest(12) {
            // 60 km at 94 m.
            let [_, top] = self.square(place, 60_000.0, 640, 10);
            highest = highest.max(top);
        }
        eprintln!("the highest summit: {highest:.0} m");
        assert!((5_000.0..9_500.0).contains(&highest), "{highest}");
    }

    fn assert_every_level_has_the_same_height(&self) {
        for place in self.highest(3) {
            let [fine, _] = self.square(place, 1_000_000.0, 256, 8);
            for (level, pixels) in [(0, 64), (1, 64), (2, 128), (3, 128), (4, 256), (6, 256)] {
                let [coarse, _] = self.square(place, 1_000_000.0, pixels, level);
                eprintln!("level {level}: {coarse:.0} of {fine:.0} m");
                assert!((coarse / fine - 1.0).abs() < 0.05, "level {level}");
            }
        }
    }

    /// Mean height and greatest height of a square in m.
    fn square(&self, place: DVec3, side_m: f64, pixels: usize, level: u8) -> [f32; 2] {
        let (lat, lon) = lat_lon(place);
        let about = AzimuthalEquidistant::new(lat, lon, 6_370_000.0).expect("a projection");
        let square = MapSquare::new(about, side_m, pixels).expect("a square");
        let grid = square.heights(&self.0.ground, level).expect("heights");
        let mean =
            grid.values.iter().map(|&z| f64::from(z)).sum::<f64>() / grid.values.len() as f64;
        let [_, top] = grid.range().expect("pixels");
        [mean as f32, top]
    }
}

/// Share of the directions over which a ground stands above the sea.
fn land(ground: &impl Ground, directions: &[DVec3], level: u8) -> f64 {
    let mut heights = vec![0.0; directions.len()];
    ground
        .heights(directions, level, &mut heights)
        .expect("heights");
    heights.iter().filter(|&&z| z > 0.0).count() as f64 / directions.len() as f64
}

fn assert_laws(seed: u64, count: u64) {
    let grown = Amplified(GrownPlanet::new(seed, 20_000, count));
    grown.assert_every_level_has_the_same_height();
    grown.assert_no_summit_is_too_high();
    grown.assert_the_land_keeps_its_area();
}

#[test]
fn the_ground_of_planet_5_is_its_land() {
    assert_laws(5, 75);
}

#[test]
fn the_ground_of_planet_6_is_its_land() {
    assert_laws(6, 100);
}

#[test]
fn the_ground_of_planet_8_is_its_land() {
    assert_laws(8, 125);
}
