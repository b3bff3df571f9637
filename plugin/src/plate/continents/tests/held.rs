//! The smallest land that samples can hold.

use super::*;

/// Discs of `radius` km spread over the planet.
fn discs(count: u32, radius: f64) -> Vec<DiscRecipe> {
    let mesh = mesh(count);
    let disc = |&p| DiscRecipe {
        center: math::lat_lon(p),
        radius,
    };
    mesh.points().iter().map(disc).collect()
}

/// Share of given discs within which, or an edge beyond, there is land.
fn with_land(recipe: &PlanetRecipe, crust: &Crust, mesh: &SphereMesh) -> f64 {
    let land: Vec<usize> = (0..mesh.len())
        .filter(|&i| crust.elevation[i] > 0.0)
        .collect();
    let has_land = |disc: &&DiscRecipe| {
        let reach = disc.radius / recipe.radius + mesh.spacing();
        let center = disc.direction();
        let is_near = |&i: &usize| math::angle_between(mesh.point(i as u32), center) < reach;
        land.iter().any(is_near)
    };
    let count = recipe.continents.iter().filter(has_land).count();
    count as f64 / recipe.continents.len() as f64
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

#[test]
fn land_of_the_smallest_share_stays_in_part() {
    let mesh = mesh(4000);
    let land = |factor: f64, seed: u64| {
        let mut recipe = PlanetRecipe {
            samples: 4000,
            ..seeded(seed, 0.0)
        };
        recipe.land = factor * smallest_land(&recipe);
        let crust = grow(&recipe, &mesh);
        share(&mesh, |i| crust.elevation[i] > 0.0) / recipe.land
    };
    let mean = |factor: f64| (1..=6).map(|seed| land(factor, seed)).sum::<f64>() / 6.0;
    let [held, lost] = [1.0, 0.2].map(mean);
    assert!(held > 0.5, "{held}");
    assert!(lost < 0.05, "{lost}");
}
