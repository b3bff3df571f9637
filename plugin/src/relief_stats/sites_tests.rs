use super::*;
use crate::math::PI;
use crate::query::checked;
use bevy::math::DVec3;

/// A planet with a young belt in the north, an old one at the equator and a plain in the south.
struct BeltPlanet {
    mesh: SphereMesh,
    elevation: Vec<f32>,
    orogeny: Vec<Orogeny>,
    orogeny_age: Vec<f32>,
}

impl BeltPlanet {
    fn new() -> Self {
        let mesh = SphereMesh::fibonacci(5000).unwrap();
        let mut planet = Self {
            elevation: Vec::new(),
            orogeny: Vec::new(),
            orogeny_age: Vec::new(),
            mesh,
        };
        for p in planet.mesh.points() {
            let (elevation, orogeny, age) = match p.z {
                z if z > 0.5 => (4.0, Orogeny::Himalayan, 10.0),
                z if z > 0.3 => (2.0, Orogeny::Andean, 5.0),
                z if z > -0.3 => (0.6, Orogeny::Andean, 300.0),
                z if z > -0.8 => (0.1, Orogeny::None, 0.0),
                _ => (-4.0, Orogeny::None, 0.0),
            };
            planet.elevation.push(elevation);
            planet.orogeny.push(orogeny);
            planet.orogeny_age.push(age);
        }
        planet
    }

    fn input(&self, seed: u64) -> SiteInput<'_> {
        SiteInput {
            mesh: &self.mesh,
            elevation: &self.elevation,
            orogeny: &self.orogeny,
            orogeny_age: &self.orogeny_age,
            seed,
        }
    }

    fn holds(&self, class: ReliefClass, i: u32) -> bool {
        let i = i as usize;
        class.holds(self.elevation[i], self.orogeny[i], self.orogeny_age[i])
    }
}

#[test]
fn sites_and_their_neighbours_belong_to_their_class() {
    let planet = BeltPlanet::new();
    for class in ReliefClass::ALL {
        for site in sites(&planet.input(3), class) {
            let mut around = planet.mesh.ring(site).iter().chain([&site]);
            assert!(around.all(|&i| planet.holds(class, i)), "{class:?}");
        }
    }
}

#[test]
fn sites_differ_and_hang_on_the_seed_alone() {
    let planet = BeltPlanet::new();
    for class in ReliefClass::ALL {
        let drawn = sites(&planet.input(3), class);
        let mut unique = drawn.clone();
        unique.sort_unstable();
        unique.dedup();
        assert_eq!(unique.len(), SITES, "{class:?}");
        assert_eq!(sites(&planet.input(3), class), drawn);
        assert_ne!(sites(&planet.input(4), class), drawn);
    }
}

#[test]
fn a_planet_of_sea_has_no_sites() {
    let planet = BeltPlanet::new();
    let sea = SiteInput {
        elevation: &vec![-1.0; planet.mesh.len()],
        orogeny: &vec![Orogeny::None; planet.mesh.len()],
        ..planet.input(1)
    };
    assert!(
        ReliefClass::ALL
            .iter()
            .all(|&class| sites(&sea, class).is_empty())
    );
}

/// Ridges of 1000 m, 5 km apart, along the meridians.
struct Ridges;

impl Ground for Ridges {
    fn radius_m(&self) -> f64 {
        6_370_000.0
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let (_, lon) = math::lat_lon(checked(direction, level)?);
        let across = lon.to_radians() * self.radius_m();
        Ok((1000.0 + 500.0 * math::sin(2.0 * PI * across / 5000.0)) as f32)
    }
}

#[test]
fn tiles_around_sites_are_measured_on_the_ground() {
    let mesh = SphereMesh::fibonacci(5000).unwrap();
    let equator: Vec<u32> = (0..5000)
        .filter(|&i| mesh.point(i).z.abs() < 0.01)
        .take(2)
        .collect();
    let mut seen = 0;
    let found = class_relief(&Ridges, &mesh, &equator, || seen += 1).unwrap();
    assert_eq!((found.len(), seen), (2, 2));
    let [relief10, p90, exponent] = medians(&found);
    assert!((relief10.unwrap() - 1000.0).abs() < 1.0);
    let steepest = math::atan2(500.0 * 2.0 * PI / 5000.0, 1.0).to_degrees();
    assert!((p90.unwrap() / steepest - 1.0).abs() < 0.02);
    assert!(exponent.is_some());
    assert_eq!(medians(&[]), [None; 3]);
}
