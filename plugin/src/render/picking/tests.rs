use super::*;
use crate::random::{Purpose, Stream};

fn bumpy() -> GlobePicker {
    let mesh = Arc::new(SphereMesh::fibonacci(3000).unwrap());
    let noise = Stream::new(3, Purpose::Relief, 0);
    let radii = (0..mesh.len())
        .map(|i| 1.0 + 0.1 * noise.unit(i as u64) as f32)
        .collect();
    GlobePicker::new(mesh, radii)
}

/// Distance to the nearest triangle of all.
fn brute_force(picker: &GlobePicker, ray: GlobeRay) -> f64 {
    let direction = ray.direction.normalize();
    let hit = |t: &[u32; 3]| hit_triangle(ray.origin, direction, t.map(|i| picker.corner(i)));
    let hits = picker.mesh.triangles().iter().filter_map(hit);
    hits.fold(f64::INFINITY, f64::min)
}

#[test]
fn rays_hit_what_brute_force_hits() {
    let picker = bumpy();
    let random = Stream::new(9, Purpose::Relief, 1);
    let mut hits = 0;
    for i in 0..400 {
        let ray = GlobeRay {
            origin: random.direction(2 * i) * random.range(i, 1.2, 40.0),
            direction: random.direction(2 * i + 1),
        };
        let aimed = GlobeRay {
            direction: 0.9 * ray.direction - ray.origin,
            ..ray
        };
        let expected = brute_force(&picker, aimed);
        match picker.pick(aimed) {
            Some(hit) => {
                hits += 1;
                let error = hit.distance - expected;
                assert!(error.abs() < 1e-9, "{error} {expected}");
                assert_eq!(hit.sample, picker.mesh.nearest(hit.direction));
            }
            None => assert!(expected.is_infinite()),
        }
    }
    assert!(hits > 300, "{hits}");
}

#[test]
fn every_ray_to_the_centre_hits() {
    let picker = bumpy();
    for i in 0..3000 {
        // Straight at corners and through edges: where a ray could slip through.
        let p = picker.mesh.point(i);
        let q = (p + picker.mesh.point(picker.mesh.ring(i)[0])).normalize();
        for up in [p, q] {
            let hit = picker
                .pick(GlobeRay {
                    origin: 1e6 * up,
                    direction: -up,
                })
                .unwrap();
            assert!(hit.direction.dot(up) > 1.0 - 1e-12);
        }
    }
}

#[test]
fn rays_that_miss_or_mean_nothing_hit_nothing() {
    let picker = bumpy();
    let pick = |origin, direction| picker.pick(GlobeRay { origin, direction });
    assert_eq!(pick(DVec3::X * 3.0, DVec3::X), None);
    assert_eq!(pick(DVec3::X * 3.0, DVec3::Y), None);
    assert_eq!(pick(DVec3::X * 3.0, DVec3::ZERO), None);
    assert_eq!(pick(DVec3::NAN, -DVec3::X), None);
    assert_eq!(
        pick(DVec3::X * 3.0, DVec3::new(f64::INFINITY, 0.0, 0.0)),
        None
    );
    assert!(pick(DVec3::ZERO, DVec3::X).is_some());
}

#[test]
fn world_rays_follow_the_planet() {
    let planet =
        GlobalTransform::from(Transform::from_xyz(5.0, 0.0, 0.0).with_scale(Vec3::splat(2.0)));
    let ray = GlobeRay::from_world(Ray3d::new(Vec3::new(5.0, 8.0, 0.0), Dir3::NEG_Y), &planet);
    let hit = bumpy().pick(ray).unwrap();
    assert!((hit.direction - DVec3::Z).length() < 1e-6);
    assert!((2.9..=3.0).contains(&hit.distance), "{}", hit.distance);
}
