//! The smallest land that samples can hold.

use super::*;
use bevy::math::DVec3;

/// Discs of `radius` km spread over the planet.
fn discs(count: u32, radius: f64) -> Vec<DiscRecipe> {
    let mesh = mesh(count);
    let points = mesh.points().iter();
    points.map(|&p| disc_at(p, radius)).collect()
}

fn disc_at(p: DVec3, radius: f64) -> DiscRecipe {
    let center = math::lat_lon(p);
    DiscRecipe { center, radius }
}

/// Whether any of the samples lies in a disc, or an edge beyond.
fn has_any(disc: &DiscRecipe, radius: f64, mesh: &SphereMesh, samples: &[usize]) -> bool {
    let reach = disc.radius / radius + mesh.spacing();
    let center = disc.direction();
    let mut points = samples.iter().map(|&i| mesh.point(i as u32));
    points.any(|p| math::angle_between(p, center) < reach)
}

/// Share of the given discs that have land.
fn with_land(recipe: &PlanetRecipe, crust: &Crust, mesh: &SphereMesh) -> f64 {
    let land: Vec<usize> = (0..mesh.len())
        .filter(|&i| crust.elevation[i] > 0.0)
        .collect();
    let discs = recipe.continents.iter();
    let count = discs.filter(|disc| has_any(disc, recipe.radius, mesh, &land));
    count.count() as f64 / recipe.continents.len() as f64
}

/// Mean share of 100 discs that have land, of a size relative to the smallest that is held.
fn share_with_land(samples: u32, size: f64) -> f64 {
    let mesh = mesh(samples);
    let shares = (1..=4).map(|seed| {
        let mut recipe = PlanetRecipe {
            samples,
            ..seeded(seed, 0.3)
        };
        let radius = size * smallest_continent_km(&recipe);
        recipe.continents = discs(100, radius);
        with_land(&recipe, &grow(&recipe, &mesh), &mesh)
    });
    shares.sum::<f64>() / 4.0
}

#[test]
fn nine_in_ten_continents_of_the_smallest_size_have_land() {
    // On so many samples a hundred of them do not touch.
    for samples in [6000, 20_000] {
        let [small, held] = [0.4, 1.0].map(|size| share_with_land(samples, size));
        assert!(held > 0.85, "{samples}: {held}");
        assert!(small < 0.1, "{samples}: {small}");
    }
}

/// Land that a planet has, relative to the wanted share, which is `factor` times the smallest.
fn land_of_wanted(mesh: &SphereMesh, factor: f64, seed: u64) -> f64 {
    let mut recipe = PlanetRecipe {
        samples: mesh.len() as u32,
        ..seeded(seed, 0.0)
    };
    recipe.land = factor * smallest_land(&recipe);
    let crust = grow(&recipe, mesh);
    share(mesh, |i| crust.elevation[i] > 0.0) / recipe.land
}

#[test]
fn land_of_the_smallest_share_stays_in_part() {
    let mesh = mesh(4000);
    let [held, lost] = [1.0, 0.2].map(|factor| {
        let land = (1..=6).map(|seed| land_of_wanted(&mesh, factor, seed));
        land.sum::<f64>() / 6.0
    });
    assert!(held > 0.5, "{held}");
    assert!(lost < 0.05, "{lost}");
}
