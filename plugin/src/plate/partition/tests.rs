use super::*;
use crate::math;
use crate::planet::PlateRecipe;
use crate::random::Stream;

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

fn centroids(n: u64) -> Vec<DVec3> {
    let stream = Stream::new(5, Purpose::PlateCentroids, 9);
    (0..n).map(|k| stream.direction(k)).collect()
}

/// Number of edges between samples of different plates, each counted twice.
fn perimeter(mesh: &SphereMesh, owner: &[u16]) -> usize {
    let foreign = |i: u32| {
        mesh.ring(i)
            .iter()
            .filter(|&&j| owner[j as usize] != owner[i as usize])
            .count()
    };
    (0..mesh.len() as u32).map(foreign).sum()
}

#[test]
fn every_plate_is_one_region() {
    for (samples, plates) in [
        (100, 2),
        (100, 10),
        (2000, 200),
        (10_000, 1000),
        (20_000, 40),
    ] {
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
    let plate = PlateRecipe {
        centroid: (10.0, 20.0),
        pole: None,
        speed: 0.0,
    };
    let recipe = PlanetRecipe {
        plates: vec![plate; 5],
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
        owner
            .iter()
            .for_each(|&plate| share[usize::from(plate)] += 1.0 / 20_000.0);
        share.sort_by(f64::total_cmp);
        assert!((0.08..0.3).contains(&share[39]), "largest {}", share[39]);
        assert!((0.0005..0.012).contains(&share[0]), "smallest {}", share[0]);
        assert!(
            share[20..].iter().sum::<f64>() > 0.75,
            "half of the plates hold most"
        );
    }
}

#[test]
fn the_partition_does_not_depend_on_threads() {
    let mesh = mesh(12_000);
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| initial_plates(&recipe(8, 30), &mesh))
    };
    assert_eq!(run(1), run(3));
    assert_ne!(run(1).1, initial_plates(&recipe(9, 30), &mesh).1);
}

#[test]
fn cells_without_warp_are_voronoi_cells() {
    let mesh = mesh(5000);
    let centroids = centroids(50);
    let noise = Noise::new(1, Purpose::BorderWarp, 0);
    let owner = warped_voronoi(&mesh, &all(&mesh), &centroids, &[], &noise, 0.0);
    for (i, &plate) in owner.iter().enumerate() {
        let distance = |k: usize| math::angle_between(mesh.point(i as u32), centroids[k]);
        let nearest = (0..50).map(distance).fold(9.0, f64::min);
        assert!(distance(usize::from(plate)) - nearest < 1e-12);
    }
}

/// Blocks choose nearby centroids and octaves stop early; neither may change an answer.
#[test]
fn pruning_changes_nothing() {
    let mesh = mesh(3000);
    let centroids = centroids(30);
    let weights: Vec<f64> = (0..30).map(|k| 0.01 * f64::from(k)).collect();
    let noise = Noise::new(1, Purpose::BorderWarp, 0);
    let together = warped_voronoi(&mesh, &all(&mesh), &centroids, &weights, &noise, 0.4);
    // Scattered samples make blocks that span the sphere, so that all centroids are near.
    let scattered: Vec<u32> = (0..3000).map(|i| i * 1117 % 3000).collect();
    let apart = warped_voronoi(&mesh, &scattered, &centroids, &weights, &noise, 0.4);
    for (entry, &i) in scattered.iter().enumerate() {
        assert_eq!(apart[entry], together[i as usize]);
    }
    let cells = Cells::new(&mesh, &centroids, &weights, &noise, 0.4);
    for i in (0..3000).step_by(7) {
        let p = mesh.point(i);
        let octave = |o: i32| {
            let scale = f64::from(1 << o);
            let q = p * (cells.frequency * scale) + DVec3::splat(17.3 * f64::from(o + 1));
            let shifted = |shift| noise.octave(q + DVec3::splat(shift));
            let push = DVec3::new(shifted(0.0), shifted(31.7), shifted(73.1));
            push.clamp_length_max(LONGEST) * (cells.amplitude / scale)
        };
        let moved = p + (0..cells.octaves).map(octave).sum::<DVec3>();
        assert_eq!(closest(moved, &cells.cells).0, together[i as usize]);
    }
}

#[test]
fn warp_makes_borders_irregular_but_not_speckled() {
    let mesh = mesh(40_000);
    let centroids = centroids(40);
    let noise = Noise::new(2, Purpose::BorderWarp, 0);
    let plain = warped_voronoi(&mesh, &all(&mesh), &centroids, &[], &noise, 0.0);
    let mut warped = warped_voronoi(&mesh, &all(&mesh), &centroids, &[], &noise, 0.3);
    let stray = connected_regions(&mesh, &all(&mesh), &warped).size.len() - 40;
    assert!(stray < 200, "{stray} stray pieces");
    keep_connected(&mesh, &all(&mesh), &mut warped);
    assert_eq!(
        connected_regions(&mesh, &all(&mesh), &warped).size.len(),
        40
    );
    let ratio = perimeter(&mesh, &warped) as f64 / perimeter(&mesh, &plain) as f64;
    assert!((1.15..2.5).contains(&ratio), "perimeter grew {ratio} times");
}

#[test]
fn weights_move_borders() {
    let mesh = mesh(20_000);
    let (a, b) = (DVec3::X, DVec3::Y);
    let noise = Noise::new(2, Purpose::BorderWarp, 0);
    let share = |weight: f64| {
        let owner = warped_voronoi(&mesh, &all(&mesh), &[a, b], &[weight, 0.0], &noise, 0.0);
        owner.iter().filter(|&&plate| plate == 0).count() as f64 / 20_000.0
    };
    assert!((share(0.0) - 0.5).abs() < 0.002);
    assert!(share(0.3) > 0.55 && share(-0.3) < 0.45);
}

#[test]
fn only_strays_change_and_the_largest_region_stays() {
    let mesh = mesh(2000);
    let mut labels: Vec<u16> = mesh.points().iter().map(|p| u16::from(p.z > 0.0)).collect();
    let before = labels.clone();
    let north = mesh.nearest(DVec3::Z);
    labels[north as usize] = 0;
    labels[mesh.nearest(-DVec3::Z) as usize] = 7;
    keep_connected(&mesh, &all(&mesh), &mut labels);
    // Label 7 has no other region, so its only sample is its largest one.
    labels[mesh.nearest(-DVec3::Z) as usize] = 0;
    assert_eq!(labels, before);
}

#[test]
fn a_part_of_the_mesh_is_its_own_world() {
    let mesh = mesh(4000);
    let part: Vec<u32> = all(&mesh)
        .into_iter()
        .filter(|&i| mesh.point(i).z > 0.3)
        .collect();
    let sites = [
        math::direction(60.0, 0.0),
        math::direction(60.0, 120.0),
        math::direction(60.0, 240.0),
    ];
    let noise = Noise::new(4, Purpose::RiftWarp, 0);
    let mut labels = warped_voronoi(&mesh, &part, &sites, &[], &noise, 0.4);
    keep_connected(&mesh, &part, &mut labels);
    let regions = connected_regions(&mesh, &part, &labels);
    assert_eq!(regions.label.len(), 3);
    assert!(
        regions
            .size
            .iter()
            .all(|&size| size as usize * 8 > part.len())
    );
}

#[test]
fn given_motions_are_kept() {
    let plate = |centroid, pole, speed| PlateRecipe {
        centroid,
        pole,
        speed,
    };
    let recipe = PlanetRecipe {
        radius: 3000.0,
        plates: vec![
            plate((0.0, 0.0), Some((90.0, 0.0)), 60.0),
            plate((0.0, 120.0), Some((90.0, 0.0)), -30.0),
            plate((0.0, -120.0), None, 0.0),
            plate((80.0, 0.0), None, -25.0),
        ],
        ..Default::default()
    };
    let (motions, _) = initial_plates(&recipe, &mesh(1000));
    // 60 km/My to the east and 30 km/My to the west on the equator.
    let east = |k: usize, lon: f64| motions[k].velocity(math::direction(0.0, lon)) * recipe.radius;
    assert!((east(0, 0.0) - DVec3::new(0.0, 60.0, 0.0)).length() < 1e-12);
    assert!((east(1, 0.0) - DVec3::new(0.0, -30.0, 0.0)).length() < 1e-12);
    assert!(motions[2].speed * recipe.radius > 10.0);
    assert!((motions[3].speed * recipe.radius - 25.0).abs() < 1e-12);
    assert!(
        motions
            .iter()
            .all(|m| m.speed >= 0.0 && (m.axis.length() - 1.0).abs() < 1e-12)
    );
}

#[test]
fn random_plates_travel_at_plausible_speeds() {
    let speeds = |seed| {
        let recipe = recipe(seed, 40);
        let sites = sites(&recipe);
        let motions = motions(&recipe, &sites);
        let speed = |(m, s): (&PlateMotion, &Site)| m.velocity(s.centroid).length() * recipe.radius;
        motions.iter().zip(&sites).map(speed).collect::<Vec<_>>()
    };
    let speeds: Vec<f64> = (1..8).flat_map(speeds).collect();
    let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
    assert!((45.0..70.0).contains(&mean), "mean {mean} km/My");
    assert!(speeds.iter().all(|s| (10.0..=95.0).contains(s)));
}

fn preset(name: &str) -> PlanetRecipe {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/presets");
    let text = std::fs::read_to_string(format!("{folder}/{name}.planet.ron")).unwrap();
    let recipe: PlanetRecipe = ron::from_str(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
    recipe.validate().unwrap_or_else(|e| panic!("{name}: {e}"));
    recipe
}

#[test]
fn presets_are_valid() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/presets");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let file = entry.unwrap().file_name().into_string().unwrap();
        let recipe = preset(file.strip_suffix(".planet.ron").unwrap());
        let again: PlanetRecipe = ron::from_str(&ron::to_string(&recipe).unwrap()).unwrap();
        assert_eq!(again, recipe);
        count += 1;
    }
    assert!(count >= 6);
    assert_eq!(preset("earth_like"), PlanetRecipe::default());
    assert_eq!(
        preset("paper").params.ocean_floor,
        crate::params::OceanFloor::Paper
    );
}

#[test]
fn the_two_continents_approach() {
    let recipe = preset("two_continents_colliding");
    let (motions, owner) = initial_plates(&recipe, &mesh(4000));
    let mesh = mesh(4000);
    let plate_at = |lon| owner[mesh.nearest(math::direction(0.0, lon)) as usize];
    assert_eq!((plate_at(-30.0), plate_at(30.0)), (0, 1));
    let at = DVec3::X;
    let closing = (motions[0].velocity(at) - motions[1].velocity(at)).dot(DVec3::Y);
    assert!((closing * recipe.radius - 90.0).abs() < 1e-9);
}
