//! Ages, elevation and ridges of the ocean floor of new planets.

use super::*;
use crate::planet::PlateRecipe;
use crate::plate::continents::seafloor::{OLDEST_MY, PAST_SPEED};

/// A plate centred on the equator that turns about the pole with a speed in km/My.
fn turning((longitude, speed): (f64, f64)) -> PlateRecipe {
    PlateRecipe {
        centroid: (0.0, longitude),
        pole: Some((90.0, 0.0)),
        speed,
    }
}

/// Two hemispheres that part along the meridian 90° W with 300 km/My and meet along 90° E.
fn parting_hemispheres() -> PlanetRecipe {
    let mut recipe = PlanetRecipe {
        plates: [(0.0, 150.0), (180.0, -150.0)].map(turning).to_vec(),
        land: 0.0,
        ..Default::default()
    };
    recipe.params.border_warp = 0.0;
    recipe.params.max_speed = 300.0;
    recipe
}

#[test]
fn floor_ages_away_from_its_ridge() {
    let recipe = parting_hemispheres();
    let mesh = mesh(40_000);
    let crust = grow(&recipe, &mesh);
    for lon in [-85.0_f64, -75.0, -60.0, -110.0] {
        let i = mesh.nearest(math::direction(0.0, lon)) as usize;
        let (_, at) = math::lat_lon(mesh.point(i as u32));
        let distance = (at + 90.0).abs().to_radians() * recipe.radius;
        let time = distance / (PAST_SPEED * 300.0);
        let age = OLDEST_MY * (1.0 - math::exp(-time / OLDEST_MY));
        let found = f64::from(crust.ocean_age[i]);
        assert!(
            (found - age).abs() < 0.05 * age + 1.5,
            "{lon}: {found} for {age}"
        );
        let ridge = crust.ridge[i];
        assert!(ridge.z.abs() > 0.97, "the ridge runs north: {ridge}");
    }
}

#[test]
fn floor_sinks_as_it_cools() {
    let recipe = parting_hemispheres();
    let params = &recipe.params;
    let crust = grow(&recipe, &mesh(10_000));
    for (&age, &z) in crust.ocean_age.iter().zip(&crust.elevation) {
        let young = math::exp(-f64::from(age) / params.subsidence_time);
        let law =
            params.abyss_elevation + (params.ridge_elevation - params.abyss_elevation) * young;
        assert!((f64::from(z) - law).abs() < 1e-3);
    }
}

#[test]
fn the_ocean_has_all_ages() {
    let mesh = mesh(20_000);
    for seed in 1..5 {
        let crust = grow(&seeded(seed, 0.3), &mesh);
        let ocean: Vec<usize> = (0..crust.len())
            .filter(|&i| !crust.is_continental(i))
            .collect();
        let mean = ocean.iter().map(|&i| crust.ocean_age[i]).sum::<f32>() / ocean.len() as f32;
        assert!((30.0..90.0).contains(&mean), "mean age {mean} My");
        for &i in &ocean {
            assert!((0.0..=160.0).contains(&crust.ocean_age[i]));
            assert!(crust.ridge[i].dot(mesh.points()[i].as_vec3()).abs() < 1e-5);
        }
        let is_known = |&&i: &&usize| (crust.ridge[i].length() - 1.0).abs() < 1e-5;
        assert!(ocean.iter().filter(is_known).count() * 100 > ocean.len() * 99);
    }
}
