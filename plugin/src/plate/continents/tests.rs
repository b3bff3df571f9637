use super::*;
use crate::math;
use crate::params::TectonicParams;
use crate::planet::{DiscRecipe, PlateRecipe};
use crate::plate::partition::{connected_regions, initial_plates};

fn mesh(samples: u32) -> SphereMesh {
    SphereMesh::fibonacci(samples).unwrap()
}

fn grow(recipe: &PlanetRecipe, mesh: &SphereMesh) -> Crust {
    recipe.validate().unwrap();
    let (_, owner) = initial_plates(recipe, mesh);
    initial_crust(recipe, mesh, &owner)
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
        let drop = |i: u32| {
            let fall = |&j: &u32| (crust.elevation[i as usize] - crust.elevation[j as usize]).abs();
            mesh.ring(i).iter().map(fall).fold(0.0, f32::max)
        };
        let largest = (0..60_000).map(drop).fold(0.0, f32::max);
        assert!(largest < 2.5, "{largest} km between neighbours");
    }
}

#[test]
fn there_are_no_specks_and_coasts_are_rough() {
    let mesh = mesh(30_000);
    let samples: Vec<u32> = (0..30_000).collect();
    for seed in 1..6 {
        let crust = grow(&seeded(seed, 0.3), &mesh);
        let land: Vec<u16> = crust
            .elevation
            .iter()
            .map(|&z| u16::from(z > 0.0))
            .collect();
        let regions = connected_regions(&mesh, &samples, &land);
        assert!(
            regions.size.iter().all(|&size| size >= 5),
            "{:?}",
            regions.size
        );
        let islands = regions.label.iter().filter(|&&land| land == 1).count();
        assert!(
            (6..80).contains(&islands),
            "{islands} islands and continents"
        );
        let kinds: Vec<u16> = crust.kind.iter().map(|&kind| kind as u16).collect();
        let regions = connected_regions(&mesh, &samples, &kinds);
        assert!(regions.size.iter().all(|&size| size >= 5));
        let coast = |i: &u32| {
            land[*i as usize] == 1 && mesh.ring(*i).iter().any(|&j| land[j as usize] == 0)
        };
        let coast = samples.iter().filter(|i| coast(i)).count() as f64 * mesh.spacing();
        // Seven round continents would have 2π r each, with 7 caps of area 0.3 · 4π / 7.
        let round = 7.0 * math::TAU * math::sin(math::acos(1.0 - 2.0 * 0.3 / 7.0));
        assert!((1.1..4.0).contains(&(coast / round)), "{}", coast / round);
    }
}

#[test]
fn continents_lie_on_some_plates_only() {
    let mesh = mesh(20_000);
    for seed in 1..5 {
        let recipe = seeded(seed, 0.3);
        let (motions, owner) = initial_plates(&recipe, &mesh);
        let crust = initial_crust(&recipe, &mesh, &owner);
        let mut count = vec![(0.0, 0.0); motions.len()];
        for i in 0..crust.len() {
            let entry = &mut count[usize::from(owner[i])];
            entry.0 += 1.0;
            entry.1 += f64::from(u8::from(crust.elevation[i] > 0.0));
        }
        let oceanic = count.iter().filter(|(all, land)| land / all < 0.05).count();
        let mixed = count
            .iter()
            .filter(|(all, land)| (0.2..0.8).contains(&(land / all)))
            .count();
        assert!(oceanic >= 5, "{oceanic} oceanic plates");
        assert!(mixed >= 5, "{mixed} plates with land and sea");
    }
}

#[test]
fn crust_does_not_depend_on_threads() {
    let mesh = mesh(12_000);
    let recipe = seeded(8, 0.3);
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| grow(&recipe, &mesh))
    };
    assert_eq!(run(1), run(3));
    assert_ne!(run(1).elevation, grow(&seeded(9, 0.3), &mesh).elevation);
}

#[test]
fn discs_become_continents() {
    let mesh = mesh(30_000);
    let disc = |center, radius| DiscRecipe { center, radius };
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
    let far = |i: usize| {
        let reach = |d: &DiscRecipe| {
            math::angle_between(mesh.point(i as u32), d.direction()) * recipe.radius - d.radius
        };
        continents.iter().map(reach).fold(f64::INFINITY, f64::min) > 1800.0
    };
    assert!((0..crust.len()).all(|i| !far(i) || crust.elevation[i] < -0.5));
}

/// Two hemispheres that part along half of a meridian: closed forms for age and ridge direction.
#[test]
fn floor_ages_away_from_its_ridge() {
    let plate = |lon, speed| PlateRecipe {
        centroid: (0.0, lon),
        pole: Some((90.0, 0.0)),
        speed,
    };
    let mut recipe = PlanetRecipe {
        plates: vec![plate(0.0, 150.0), plate(180.0, -150.0)],
        land: 0.0,
        ..Default::default()
    };
    recipe.params.border_warp = 0.0;
    recipe.params.max_speed = 300.0;
    let mesh = mesh(40_000);
    let crust = grow(&recipe, &mesh);
    // The plate around 0° E goes east, away from the border at 90° W.
    for lon in [-85.0_f64, -75.0, -60.0, -110.0] {
        let i = mesh.nearest(math::direction(0.0, lon)) as usize;
        let (_, at) = math::lat_lon(mesh.point(i as u32));
        let distance = (at + 90.0).abs().to_radians() * recipe.radius;
        let time = distance / (seafloor::PAST * 300.0);
        let age = seafloor::OLDEST * (1.0 - math::exp(-time / seafloor::OLDEST));
        assert!(
            (f64::from(crust.ocean_age[i]) - age).abs() < 0.05 * age + 1.5,
            "{lon}: {age}"
        );
        assert!(
            crust.ridge[i].z.abs() > 0.97,
            "the ridge runs north: {}",
            crust.ridge[i]
        );
    }
    let params = &recipe.params;
    for i in 0..crust.len() {
        let young = math::exp(-f64::from(crust.ocean_age[i]) / params.subsidence_time);
        let z = params.abyss_elevation + (params.ridge_elevation - params.abyss_elevation) * young;
        assert!((f64::from(crust.elevation[i]) - z).abs() < 1e-3);
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
            let (p, ridge) = (mesh.point(i as u32).as_vec3(), crust.ridge[i]);
            assert!((0.0..=160.0).contains(&crust.ocean_age[i]));
            assert!(ridge.dot(p).abs() < 1e-5);
        }
        let known = ocean
            .iter()
            .filter(|&&i| (crust.ridge[i].length() - 1.0).abs() < 1e-5)
            .count();
        assert!(known * 100 > ocean.len() * 99);
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
    let base = PlanetRecipe {
        plate_count: 2,
        ..Default::default()
    };
    let everything = vec![DiscRecipe {
        center: (0.0, 0.0),
        radius: 20_000.0,
    }];
    let recipes = [
        PlanetRecipe {
            radius: 50.0,
            ..base.clone()
        },
        PlanetRecipe {
            radius: 100_000.0,
            land: 0.9,
            ..base.clone()
        },
        PlanetRecipe {
            radius: 50.0,
            continents: everything,
            ..base.clone()
        },
        PlanetRecipe {
            continents: vec![DiscRecipe {
                center: (90.0, 0.0),
                radius: 1.0,
            }],
            ..base
        },
    ];
    for samples in [100, 3000] {
        let mesh = mesh(samples);
        for recipe in &recipes {
            let crust = grow(recipe, &mesh);
            assert_eq!(crust.len(), samples as usize);
            let finite = |i: usize| {
                crust.elevation[i].is_finite()
                    && crust.thickness[i] > 0.0
                    && crust.ocean_age[i].is_finite()
                    && crust.ridge[i].is_finite()
                    && crust.fold[i].is_finite()
            };
            assert!((0..crust.len()).all(finite));
        }
    }
}

#[test]
fn distances_are_great_circles() {
    let mesh = mesh(6000);
    let stream = crate::random::Stream::new(4, crate::random::Purpose::Coast, 99);
    // Of equal sources the nearest is found almost always; of unequal ones a corner may be missed.
    for (slowest, tolerance) in [(1.0, 0.1), (2.0, 1.0)] {
        let source = |k| {
            let (point, slowness) = (stream.direction(k), stream.range(200 + k, 1.0, slowest));
            distance::Source {
                sample: mesh.nearest(point),
                point,
                slowness,
            }
        };
        let sources: Vec<_> = (0..40).map(source).collect();
        let found = distance::nearest(&mesh, &sources);
        for i in 0..6000 {
            let cost =
                |s: &distance::Source| s.slowness * math::angle_between(mesh.point(i), s.point);
            let least = sources.iter().map(cost).fold(f64::INFINITY, f64::min);
            let difference = found.cost[i as usize] - least;
            assert!(difference > -0.03 * least - 1e-12, "{difference}");
            assert!(
                difference < tolerance * mesh.spacing(),
                "{slowest}: {difference}"
            );
        }
    }
    let none = distance::nearest(&mesh, &[]);
    assert!(none.cost.iter().all(|d| *d == f64::INFINITY));
    for degrees in 0..=128 {
        let angle = f64::from(degrees).to_radians();
        let found = field::arc(2.0 * math::sin(0.5 * angle));
        assert!((found - angle).abs() <= 0.01 * angle, "{degrees}: {found}");
    }
}
