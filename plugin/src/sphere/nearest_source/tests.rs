//! Both searches against brute force.

use super::*;
use crate::math;
use crate::random::{Purpose, Stream};
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

const REACH: f64 = 0.4;

/// Sources in random places, each at the sample nearest to it.
fn random_sources(mesh: &SphereMesh) -> Vec<(u32, DVec3)> {
    let stream = Stream::new(5, Purpose::PlateCentroids, 0);
    let places = (0..60).map(|k| stream.direction(k));
    places.map(|p| (mesh.nearest(p), p)).collect()
}

/// Distance of every sample that was reached; infinite for the others.
fn distances(mesh: &SphereMesh, found: &ReachedSamples, sources: &[(u32, DVec3)]) -> Vec<f64> {
    let mut distance = vec![f64::INFINITY; mesh.len()];
    for (k, &i) in found.samples.iter().enumerate() {
        distance[i as usize] = f64::from(found.distance[k]);
        let source = sources[found.source[k] as usize].1;
        let angle = math::angle_between(mesh.point(i), source);
        assert!((angle - f64::from(found.distance[k])).abs() < 1e-6);
    }
    distance
}

#[test]
fn equals_brute_force_on_the_whole_sphere() {
    let mesh = SphereMesh::fibonacci(5000).unwrap();
    let sources = random_sources(&mesh);
    let mut scratch = SourceScratch::default();
    // Twice with one scratch memory.
    for _ in 0..2 {
        let found = nearest_sources(&mesh, &mut scratch, &sources, REACH, |_, _| true);
        let distance = distances(&mesh, &found, &sources);
        let mut wrong = 0;
        for (&p, &distance) in mesh.points().iter().zip(&distance) {
            let angles = sources.iter().map(|s| math::angle_between(p, s.1));
            let nearest = angles.fold(9.0, f64::min);
            if nearest < REACH - 1e-3 && (distance - nearest).abs() > 1e-5 {
                wrong += 1;
                // A source cut off by others may be missed by a sample's width, no more.
                assert!(distance - nearest < 0.3 * mesh.spacing());
            }
            assert!(nearest < REACH + 1e-3 || distance == f64::INFINITY);
        }
        assert!(wrong < 5, "{wrong}");
    }
}

#[test]
fn closed_links_are_not_crossed() {
    let mesh = SphereMesh::fibonacci(2000).unwrap();
    let sources = [(mesh.nearest(DVec3::X), DVec3::X)];
    let north = |i: u32| mesh.point(i).z > -0.1;
    let mut scratch = SourceScratch::default();
    let found = nearest_sources(&mesh, &mut scratch, &sources, 1.0, |_, to| north(to));
    assert!(found.samples.iter().all(|&i| north(i)));
    assert!(found.samples.len() > 200);
}

/// Sources in random places with a slowness of 1 to `slowest`.
fn travel_sources(mesh: &SphereMesh, slowest: f64) -> Vec<TravelSource> {
    let stream = Stream::new(4, Purpose::Coast, 99);
    let points = (0..40).map(|k| stream.direction(k));
    let slowness = (200..).map(|k| stream.range(k, 1.0, slowest));
    points
        .zip(slowness)
        .map(|(point, slowness)| TravelSource {
            sample: mesh.nearest(point),
            point,
            slowness,
        })
        .collect()
}

#[test]
fn travel_times_are_along_great_circles() {
    let mesh = SphereMesh::fibonacci(6000).unwrap();
    // Of equal sources the nearest is found almost always; of unequal ones a corner may be missed.
    for (slowest, tolerance) in [(1.0, 0.1), (2.0, 1.0)] {
        let sources = travel_sources(&mesh, slowest);
        let found = least_travel_times(&mesh, &sources);
        for (&p, time) in mesh.points().iter().zip(&found.time) {
            let times = sources
                .iter()
                .map(|s| s.slowness * math::angle_between(p, s.point));
            let least = times.fold(f64::INFINITY, f64::min);
            let late = time - least;
            assert!(late > -0.03 * least - 1e-12, "{late}");
            assert!(late < tolerance * mesh.spacing(), "{slowest}: {late}");
        }
    }
    let nowhere = least_travel_times(&mesh, &[]);
    assert!(nowhere.time.iter().all(|time| *time == f64::INFINITY));
}
