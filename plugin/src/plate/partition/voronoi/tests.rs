//! Cells against brute force, and what warp and weights do to borders.

use super::*;
use crate::math;
use crate::plate::partition::regions::{connected_regions, keep_connected};
use crate::random::{Purpose, Stream};

fn mesh(samples: u32) -> SphereMesh {
    SphereMesh::fibonacci(samples).unwrap()
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
    let own = |i: u32| owner[i as usize];
    let foreign = |i: u32| mesh.ring(i).iter().filter(|&&j| own(j) != own(i)).count();
    (0..mesh.len() as u32).map(foreign).sum()
}

#[test]
fn cells_without_warp_are_voronoi_cells() {
    let mesh = mesh(5000);
    let centroids = centroids(50);
    let noise = Noise::new(1, Purpose::BorderWarp, 0);
    let owner = warped_voronoi(&mesh, &all(&mesh), &centroids, &[], &noise, 0.0);
    for (&p, &plate) in mesh.points().iter().zip(&owner) {
        let distance = |k: usize| math::angle_between(p, centroids[k]);
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
        let octaves = (0..cells.octaves).map(|octave| displacement(&cells, p, octave));
        let moved = p + octaves.sum::<DVec3>();
        assert_eq!(closest(moved, &cells.cells).0, together[i as usize]);
    }
}

/// One octave as the header has it.
fn displacement(cells: &Cells, p: DVec3, octave: u32) -> DVec3 {
    let scale = f64::from(1 << octave);
    let q = p * (cells.frequency * scale) + DVec3::splat(17.3 * f64::from(octave + 1));
    let shifted = |shift| cells.noise.octave(q + DVec3::splat(shift));
    let push = DVec3::new(shifted(0.0), shifted(31.7), shifted(73.1));
    push.clamp_length_max(LONGEST) * (cells.amplitude / scale)
}

#[test]
fn warp_makes_borders_irregular_but_not_speckled() {
    let mesh = mesh(40_000);
    let samples = all(&mesh);
    let centroids = centroids(40);
    let noise = Noise::new(2, Purpose::BorderWarp, 0);
    let plain = warped_voronoi(&mesh, &samples, &centroids, &[], &noise, 0.0);
    let mut warped = warped_voronoi(&mesh, &samples, &centroids, &[], &noise, 0.3);
    let regions = |owner: &[u16]| connected_regions(&mesh, &samples, owner).size.len();
    let stray = regions(&warped) - 40;
    assert!(stray < 200, "{stray} stray pieces");
    keep_connected(&mesh, &samples, &mut warped);
    assert_eq!(regions(&warped), 40);
    let ratio = perimeter(&mesh, &warped) as f64 / perimeter(&mesh, &plain) as f64;
    assert!((1.15..2.5).contains(&ratio), "perimeter grew {ratio} times");
}

/// Share of the samples that the first of two plates has if it has a weight.
fn share_with_weight(mesh: &SphereMesh, weight: f64) -> f64 {
    let centroids = [DVec3::X, DVec3::Y];
    let noise = Noise::new(2, Purpose::BorderWarp, 0);
    let owner = warped_voronoi(mesh, &all(mesh), &centroids, &[weight, 0.0], &noise, 0.0);
    owner.iter().filter(|&&plate| plate == 0).count() as f64 / mesh.len() as f64
}

#[test]
fn weights_move_borders() {
    let mesh = mesh(20_000);
    assert!((share_with_weight(&mesh, 0.0) - 0.5).abs() < 0.002);
    assert!(share_with_weight(&mesh, 0.3) > 0.55);
    assert!(share_with_weight(&mesh, -0.3) < 0.45);
}

#[test]
fn a_part_of_the_mesh_is_its_own_world() {
    let mesh = mesh(4000);
    let samples = all(&mesh).into_iter();
    let part: Vec<u32> = samples.filter(|&i| mesh.point(i).z > 0.3).collect();
    let sites = [0.0, 120.0, 240.0].map(|longitude| math::direction(60.0, longitude));
    let noise = Noise::new(4, Purpose::RiftWarp, 0);
    let mut labels = warped_voronoi(&mesh, &part, &sites, &[], &noise, 0.4);
    keep_connected(&mesh, &part, &mut labels);
    let regions = connected_regions(&mesh, &part, &labels);
    assert_eq!(regions.label.len(), 3);
    let large = |&size: &u32| size as usize * 8 > part.len();
    assert!(regions.size.iter().all(large));
}
