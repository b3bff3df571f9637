//! Plates of random planets and of presets.

use super::*;
use crate::math;
use crate::params::OceanFloor;
use crate::planet::PlateRecipe;
use crate::plate::partition::{connected_regions, sites};
use bevy::math::DVec3;

fn mesh(samples: u32) -> SphereMesh {
    SphereMesh::fibonacci(samples).unwrap()
}

fn recipe(seed: u64, plate_count: u32) -> PlanetRecipe {
    PlanetRecipe {
        seed,
        plate_count,
        ..Default::default()
    }
}

fn all(mesh: &SphereMesh) -> Vec<u32> {
    (0..mesh.len() as u32).collect()
}

#[test]
fn every_plate_is_one_region() {
    let sizes = [
        (100, 2),
        (100, 10),
        (2000, 200),
        (10_000, 1000),
        (20_000, 40),
    ];
    for (samples, plates) in sizes {
        let mesh = mesh(samples);
        for seed in 1..4 {
            let (motions, owner) = initial_plates(&recipe(seed, plates), &mesh);
            assert_eq!(motions.len(), plates as usize);
            let regions = connected_regions(&mesh, &all(&mesh), &owner);
            let mut labels = regions.label.clone();
            labels.sort_unstable();
            let expected: Vec<u16> = (0..plates as u16).collect();
            assert_eq!(labels, expected, "{samples} samples, seed {seed}");
            assert_eq!(regions.size.iter().sum::<u32>(), samples);
        }
    }
}

#[test]
fn plates_on_the_same_spot_still_have_samples() {
    let recipe = PlanetRecipe {
        plates: vec![plate((10.0, 20.0), None, 0.0); 5],
        ..Default::default()
    };
    let mesh = mesh(500);
    let (_, owner) = initial_plates(&recipe, &mesh);
    let regions = connected_regions(&mesh, &all(&mesh), &owner);
    assert_eq!(regions.size.len(), 5);
}

#[test]
fn sizes_vary_as_on_earth() {
    let mesh = mesh(20_000);
    for seed in 1..6 {
        let (_, owner) = initial_plates(&recipe(seed, 40), &mesh);
        let mut share = [0.0; 40];
        for &plate in &owner {
            share[usize::from(plate)] += 1.0 / 20_000.0;
        }
        share.sort_by(f64::total_cmp);
        assert!((0.08..0.3).contains(&share[39]), "largest {}", share[39]);
        assert!((0.0005..0.012).contains(&share[0]), "smallest {}", share[0]);
        let upper: f64 = share[20..].iter().sum();
        assert!(upper > 0.75, "half of the plates hold most");
    }
}

#[test]
fn the_partition_does_not_depend_on_threads() {
    let mesh = mesh(12_000);
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let one = pool(1)
        .unwrap()
        .install(|| initial_plates(&recipe(8, 30), &mesh));
    let three = pool(3)
        .unwrap()
        .install(|| initial_plates(&recipe(8, 30), &mesh));
    assert_eq!(one, three);
    assert_ne!(one.1, initial_plates(&recipe(9, 30), &mesh).1);
}

fn plate(centroid: (f64, f64), pole: Option<(f64, f64)>, speed: f64) -> PlateRecipe {
    PlateRecipe {
        centroid,
        pole,
        speed,
    }
}

/// Plates with and without a pole and a speed, on a planet of 3000 km.
fn given_plates() -> PlanetRecipe {
    PlanetRecipe {
        radius: 3000.0,
        plates: vec![
            plate((0.0, 0.0), Some((90.0, 0.0)), 60.0),
            plate((0.0, 120.0), Some((90.0, 0.0)), -30.0),
            plate((0.0, -120.0), None, 0.0),
            plate((80.0, 0.0), None, -25.0),
        ],
        ..Default::default()
    }
}

#[test]
fn given_motions_are_kept() {
    let recipe = given_plates();
    let (motions, _) = initial_plates(&recipe, &mesh(1000));
    // 60 km/My to the east and 30 km/My to the west on the equator.
    let at_equator = |k: usize| motions[k].velocity(DVec3::X) * recipe.radius;
    assert!((at_equator(0) - DVec3::new(0.0, 60.0, 0.0)).length() < 1e-12);
    assert!((at_equator(1) - DVec3::new(0.0, -30.0, 0.0)).length() < 1e-12);
    assert!(motions[2].speed * recipe.radius > 10.0);
    assert!((motions[3].speed * recipe.radius - 25.0).abs() < 1e-12);
    for motion in &motions {
        assert!(motion.speed >= 0.0 && (motion.axis.length() - 1.0).abs() < 1e-12);
    }
}

/// Speeds of the centroids of 40 random plates in km/My.
fn random_speeds(seed: u64) -> Vec<f64> {
    let recipe = recipe(seed, 40);
    let motions = initial_motions(&recipe);
    let sites = sites(&recipe);
    let velocities = motions
        .iter()
        .zip(&sites)
        .map(|(m, s)| m.velocity(s.centroid));
    velocities.map(|v| v.length() * recipe.radius).collect()
}

#[test]
fn random_plates_travel_at_plausible_speeds() {
    let speeds: Vec<f64> = (1..8).flat_map(random_speeds).collect();
    let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
    assert!((45.0..70.0).contains(&mean), "mean {mean} km/My");
    assert!(speeds.iter().all(|s| (10.0..=95.0).contains(s)));
}

const PRESETS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/presets");

fn preset(name: &str) -> PlanetRecipe {
    let text = std::fs::read_to_string(format!("{PRESETS}/{name}.planet.ron")).unwrap();
    let recipe: PlanetRecipe = ron::from_str(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
    recipe.validate().unwrap_or_else(|e| panic!("{name}: {e}"));
    recipe
}

#[test]
fn presets_are_valid() {
    let mut count = 0;
    for entry in std::fs::read_dir(PRESETS).unwrap() {
        let file = entry.unwrap().file_name().into_string().unwrap();
        let recipe = preset(file.strip_suffix(".planet.ron").unwrap());
        let again: PlanetRecipe = ron::from_str(&ron::to_string(&recipe).unwrap()).unwrap();
        assert_eq!(again, recipe);
        count += 1;
    }
    assert!(count >= 6);
    assert_eq!(preset("earth_like"), PlanetRecipe::default());
    assert_eq!(preset("paper").params.ocean_floor, OceanFloor::Paper);
}

#[test]
fn the_two_continents_approach() {
    let recipe = preset("two_continents_colliding");
    let mesh = mesh(4000);
    let (motions, owner) = initial_plates(&recipe, &mesh);
    let plate_at = |lon| owner[mesh.nearest(math::direction(0.0, lon)) as usize];
    assert_eq!((plate_at(-30.0), plate_at(30.0)), (0, 1));
    let at = DVec3::X;
    let closing = (motions[0].velocity(at) - motions[1].velocity(at)).dot(DVec3::Y);
    assert!((closing * recipe.radius - 90.0).abs() < 1e-9);
}
