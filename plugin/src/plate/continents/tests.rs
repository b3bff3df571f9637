//! Land, margins, coasts, ocean floor and belts of new planets.

mod held;

mod seafloor;

use super::*;
use crate::crust::Orogeny;
use crate::math;
use crate::params::TectonicParams;
use crate::planet::DiscRecipe;
use crate::plate::partition::{connected_regions, initial_partition};
use crate::sphere::components::Components;

fn mesh(samples: u32) -> SphereMesh {
    SphereMesh::fibonacci(samples).unwrap()
}

fn grow(recipe: &PlanetRecipe, mesh: &SphereMesh) -> Crust {
    recipe.validate().unwrap();
    initial_crust(recipe, mesh, &initial_partition(recipe, mesh))
}

/// Share of the sphere on which `is` holds.
fn share(mesh: &SphereMesh, is: impl Fn(usize) -> bool) -> f64 {
    let area = (0..mesh.len())
        .filter(|&i| is(i))
        .map(|i| mesh.area(i as u32))
        .sum::<f64>();
    area / (4.0 * math::PI)
}

fn seeded(seed: u64, land: f64) -> PlanetRecipe {
    PlanetRecipe {
        seed,
        land,
        ..Default::default()
    }
}

#[test]
fn land_has_the_wanted_share() {
    for samples in [2000, 10_000, 30_000] {
        let mesh = mesh(samples);
        for seed in 1..4 {
            for land in [0.0, 0.05, 0.3, 0.6, 0.9] {
                let crust = grow(&seeded(seed, land), &mesh);
                let found = share(&mesh, |i| crust.elevation[i] > 0.0);
                assert!(
                    (found - land).abs() < 0.005,
                    "{samples} {seed}: {found} for {land}"
                );
                let continental = share(&mesh, |i| crust.is_continental(i));
                assert!(continental >= found && continental <= 1.35 * land + 0.002);
                if samples > 2000 && land > 0.2 && land < 0.7 {
                    assert!(continental > 1.14 * land, "{continental} for {land}");
                }
            }
        }
    }
}

/// Edges of the mesh between land and sea.
fn coast_edges(mesh: &SphereMesh, crust: &Crust) -> usize {
    let is_land = |i: u32| crust.elevation[i as usize] > 0.0;
    let samples = 0..mesh.len() as u32;
    samples
        .filter(|&i| is_land(i))
        .map(|i| mesh.ring(i).iter().filter(|&&j| !is_land(j)).count())
        .sum()
}

#[test]
fn rough_coasts_are_longer() {
    let mesh = mesh(20_000);
    let lengths = [0.0, 1.0, 2.0].map(|coast_roughness| {
        let recipe = PlanetRecipe {
            coast_roughness,
            ..seeded(2, 0.3)
        };
        let crust = grow(&recipe, &mesh);
        let land = share(&mesh, |i| crust.elevation[i] > 0.0);
        assert!((land - 0.3).abs() < 0.005, "{land}");
        coast_edges(&mesh, &crust) as f64
    });
    assert!(lengths[1] > 1.3 * lengths[0], "{lengths:?}");
    assert!(lengths[2] > 1.1 * lengths[1], "{lengths:?}");
}

#[test]
fn islands_are_as_many_as_asked_for() {
    let mesh = mesh(60_000);
    let pieces = [0, 14, 60].map(|islands| {
        let recipe = PlanetRecipe {
            islands,
            coast_roughness: 0.0,
            ..seeded(3, 0.3)
        };
        let crust = grow(&recipe, &mesh);
        let land = share(&mesh, |i| crust.elevation[i] > 0.0);
        assert!((land - 0.3).abs() < 0.005, "{land}");
        let of_land = |i: u32| crust.elevation[i as usize] > 0.0;
        Components::new(&mesh, of_land, |_, _| true).count
    });
    // Continents have four to seven pieces; islands may touch them.
    assert!(pieces[0] <= 7, "{pieces:?}");
    assert!(pieces[1] >= pieces[0] + 5, "{pieces:?}");
    assert!(pieces[2] >= pieces[1] + 10, "{pieces:?}");
}

#[test]
fn land_is_continental_and_low() {
    let mesh = mesh(20_000);
    for seed in 1..5 {
        let crust = grow(&seeded(seed, 0.3), &mesh);
        let land: Vec<f32> = crust
            .elevation
            .iter()
            .copied()
            .filter(|&z| z > 0.0)
            .collect();
        let mean = land.iter().sum::<f32>() / land.len() as f32;
        assert!((0.15..0.45).contains(&mean), "{mean}");
        assert!(land.iter().all(|&z| (0.01..2.0).contains(&z)));
        assert!((0..crust.len()).all(|i| crust.elevation[i] <= 0.0 || crust.is_continental(i)));
    }
}

#[test]
fn crust_floats() {
    let mesh = mesh(10_000);
    let params = TectonicParams::default();
    let law = Isostasy::new(&params);
    let crust = grow(&seeded(3, 0.3), &mesh);
    for i in 0..crust.len() {
        if crust.is_continental(i) {
            assert!((law.elevation(crust.thickness[i]) - crust.elevation[i]).abs() < 1e-4);
            assert!((15.0..50.0).contains(&crust.thickness[i]));
            assert_eq!((crust.ocean_age[i], crust.ridge[i].length()), (0.0, 0.0));
        } else {
            assert_eq!(crust.thickness[i], params.ocean_thickness as f32);
            assert!((-6.0..0.0).contains(&crust.elevation[i]));
        }
    }
}

#[test]
fn no_margin_is_a_cliff() {
    let mesh = mesh(60_000);
    for seed in 1..4 {
        let crust = grow(&seeded(seed, 0.3), &mesh);
        let z = |i: u32| crust.elevation[i as usize];
        let edges = (0..60_000).flat_map(|i| mesh.ring(i).iter().map(move |&j| (i, j)));
        let largest = edges.map(|(i, j)| (z(i) - z(j)).abs()).fold(0.0, f32::max);
        assert!(largest < 2.5, "{largest} km between neighbours");
    }
}

/// Label and size of the connected regions of a column of labels over the whole mesh.
fn regions(mesh: &SphereMesh, labels: &[u16]) -> Vec<(u16, u32)> {
    let samples: Vec<u32> = (0..mesh.len() as u32).collect();
    let regions = connected_regions(mesh, &samples, labels);
    regions.label.into_iter().zip(regions.size).collect()
}

#[test]
fn there_are_no_specks() {
    let mesh = mesh(30_000);
    for seed in 1..6 {
        let crust = grow(&seeded(seed, 0.3), &mesh);
        let land: Vec<u16> = crust
            .elevation
            .iter()
            .map(|&z| u16::from(z > 0.0))
            .collect();
        let land = regions(&mesh, &land);
        assert!(land.iter().all(|&(_, size)| size >= 5), "{land:?}");
        let islands = land.iter().filter(|&&(label, _)| label == 1).count();
        assert!(
            (6..80).contains(&islands),
            "{islands} islands and continents"
        );
        let kinds: Vec<u16> = crust.kind.iter().map(|&kind| kind as u16).collect();
        assert!(regions(&mesh, &kinds).iter().all(|&(_, size)| size >= 5));
    }
}

#[test]
fn coasts_are_rough() {
    let mesh = mesh(30_000);
    for seed in 1..6 {
        let crust = grow(&seeded(seed, 0.3), &mesh);
        let is_land = |i: u32| crust.elevation[i as usize] > 0.0;
        let is_coast = |&i: &u32| is_land(i) && mesh.ring(i).iter().any(|&j| !is_land(j));
        let coast = (0..30_000).filter(is_coast).count() as f64 * mesh.spacing();
        // Seven round continents would have 2π r each, with 7 caps of area 0.3 · 4π / 7.
        let round = 7.0 * math::TAU * math::sin(math::acos(1.0 - 2.0 * 0.3 / 7.0));
        assert!((1.1..4.0).contains(&(coast / round)), "{}", coast / round);
    }
}

/// Share of land on every plate.
fn land_of_plates(recipe: &PlanetRecipe, mesh: &SphereMesh) -> Vec<f64> {
    let owner = initial_partition(recipe, mesh);
    let crust = initial_crust(recipe, mesh, &owner);
    let plates = usize::from(*owner.iter().max().unwrap()) + 1;
    let mut samples = vec![0.0; plates];
    let mut land = vec![0.0; plates];
    for (&plate, &z) in owner.iter().zip(&crust.elevation) {
        samples[usize::from(plate)] += 1.0;
        land[usize::from(plate)] += f64::from(u8::from(z > 0.0));
    }
    land.iter()
        .zip(&samples)
        .map(|(land, all)| land / all)
        .collect()
}

#[test]
fn continents_lie_on_some_plates_only() {
    let mesh = mesh(20_000);
    for seed in 1..5 {
        let land = land_of_plates(&seeded(seed, 0.3), &mesh);
        let oceanic = land.iter().filter(|land| **land < 0.05).count();
        assert!(oceanic >= 5, "{oceanic} oceanic plates");
        let mixed = land
            .iter()
            .filter(|land| (0.2..0.8).contains(*land))
            .count();
        assert!(mixed >= 5, "{mixed} plates with land and sea");
    }
}

#[test]
fn crust_does_not_depend_on_threads() {
    let mesh = mesh(12_000);
    let recipe = seeded(8, 0.3);
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let one = pool(1).unwrap().install(|| grow(&recipe, &mesh));
    let three = pool(3).unwrap().install(|| grow(&recipe, &mesh));
    assert_eq!(one, three);
    assert_ne!(one.elevation, grow(&seeded(9, 0.3), &mesh).elevation);
}

#[test]
fn discs_become_continents() {
    let mesh = mesh(30_000);
    let continents = vec![disc((10.0, 20.0), 3000.0), disc((-40.0, -150.0), 1000.0)];
    let recipe = PlanetRecipe {
        continents: continents.clone(),
        ..Default::default()
    };
    let crust = grow(&recipe, &mesh);
    let cap = |radius: f64| 0.5 * (1.0 - math::cos(radius / recipe.radius));
    let wanted = cap(3000.0) + cap(1000.0);
    let land = share(&mesh, |i| crust.elevation[i] > 0.0);
    assert!((land / wanted - 1.0).abs() < 0.35, "{land} for {wanted}");
    for disc in &continents {
        assert!(crust.elevation[mesh.nearest(disc.direction()) as usize] > 0.0);
    }
    for (&p, &z) in mesh.points().iter().zip(&crust.elevation) {
        let angle = |d: &DiscRecipe| math::angle_between(p, d.direction());
        let off = continents
            .iter()
            .map(|d| angle(d) * recipe.radius - d.radius);
        assert!(off.fold(f64::INFINITY, f64::min) <= 1800.0 || z < -0.5);
    }
}

#[test]
fn old_belts_are_old_and_few() {
    let mesh = mesh(30_000);
    for seed in 1..5 {
        let crust = grow(&seeded(seed, 0.3), &mesh);
        let folded = share(&mesh, |i| crust.orogeny[i] != Orogeny::None) / 0.3;
        assert!((0.005..0.2).contains(&folded), "{folded} of the land");
        for i in 0..crust.len() {
            if crust.orogeny[i] == Orogeny::None {
                assert_eq!((crust.fold[i].length(), crust.orogeny_age[i]), (0.0, 0.0));
            } else {
                assert!((200.0..=400.0).contains(&crust.orogeny_age[i]));
                assert!((crust.fold[i].length() - 1.0).abs() < 1e-5);
                assert!(crust.fold[i].dot(mesh.point(i as u32).as_vec3()).abs() < 1e-5);
            }
        }
    }
}

#[test]
fn strange_planets_are_finite() {
    for samples in [100, 3000] {
        let mesh = mesh(samples);
        for recipe in strange_planets() {
            let crust = grow(&recipe, &mesh);
            assert_eq!(crust.len(), samples as usize);
            for i in 0..crust.len() {
                assert!(crust.elevation[i].is_finite() && crust.thickness[i] > 0.0);
                assert!(crust.ocean_age[i].is_finite());
                assert!(crust.ridge[i].is_finite() && crust.fold[i].is_finite());
            }
        }
    }
}

fn planet(radius: f64, land: f64, continents: Vec<DiscRecipe>) -> PlanetRecipe {
    PlanetRecipe {
        plate_count: 2,
        radius,
        land,
        continents,
        ..Default::default()
    }
}

fn disc(center: (f64, f64), radius: f64) -> DiscRecipe {
    DiscRecipe { center, radius }
}

/// Very small and very large planets, all land and hardly any.
fn strange_planets() -> [PlanetRecipe; 4] {
    [
        planet(50.0, 0.3, vec![]),
        planet(100_000.0, 0.9, vec![]),
        planet(50.0, 0.3, vec![disc((0.0, 0.0), 20_000.0)]),
        planet(6370.0, 0.3, vec![disc((90.0, 0.0), 1.0)]),
    ]
}
