//! What a ray hits on a globe.
//!
//! Triangles of a lattice are ordered along a curve, so runs of 64 lie close together. obvhs keeps
//! a tree over the boxes of such runs and only prunes; the triangles of a run are tested here in
//! f64, and f64 decides.
//!
//! Policies: the nearest hit wins; of triangles hit at the same distance (an edge, a corner) the
//! first. A ray that starts below the surface sees it from inside. A ray that is not finite hits
//! nothing.

use super::{from_bevy, to_bevy};
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;
use obvhs::Boundable;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::{Ray, RayHit};
use std::sync::Arc;

/// Triangles to a run.
const RUN: usize = 64;

/// How much boxes are grown, in planet radii: more than f32 rounds.
const SLACK: f32 = 2e-6;

/// A ray in planet coordinates, lengths in planet radii, the planet's centre at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlobeRay {
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes; need not have unit length.
    pub direction: DVec3,
}

impl GlobeRay {
    /// The ray of a camera (`Camera::viewport_to_world`) towards the planet with this transform.
    pub fn from_world(ray: Ray3d, planet: &GlobalTransform) -> Self {
        let local = planet.affine().inverse();
        Self {
            origin: from_bevy(local.transform_point3(ray.origin)),
            direction: from_bevy(local.transform_vector3(*ray.direction)),
        }
    }
}

/// Where a ray meets a globe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The sample nearest to the hit.
    pub sample: u32,
    /// Unit direction of the hit in planet coordinates.
    pub direction: DVec3,
    /// Distance from the ray's origin in planet radii.
    pub distance: f64,
}

impl Hit {
    /// The unit direction of the hit in the globe's Bevy axes.
    pub fn bevy_direction(&self) -> Vec3 {
        to_bevy(self.direction)
    }
}

/// Finds what a ray hits on a globe as it is drawn. On the planet's entity, kept by the painter.
#[derive(Component, Clone)]
pub struct GlobePicker {
    mesh: Arc<SphereMesh>,
    /// Distance of every sample from the centre, in planet radii.
    radii: Vec<f32>,
    tree: Bvh2,
    highest: f64,
}

struct RunBox(Aabb);

impl Boundable for RunBox {
    fn aabb(&self) -> Aabb {
        self.0
    }
}

impl GlobePicker {
    /// A picker over the triangles of `mesh` with its samples at these distances from the centre.
    ///
    /// Missing distances count as 1.
    pub fn new(mesh: Arc<SphereMesh>, mut radii: Vec<f32>) -> Self {
        radii.resize(mesh.len(), 1.0);
        let highest = f64::from(radii.iter().copied().fold(0.0, f32::max)) + 1e-5;
        let boxes: Vec<_> = mesh
            .triangles()
            .chunks(RUN)
            .map(|run| run_box(&mesh, &radii, run))
            .collect();
        let tree = build_bvh2(&boxes, BvhBuildParams::fastest_build(), &mut default());
        Self {
            mesh,
            radii,
            tree,
            highest,
        }
    }

    /// What the ray hits first, if anything.
    pub fn pick(&self, ray: GlobeRay) -> Option<Hit> {
        let GlobeRay { origin, direction } = ray;
        let length = direction.length();
        if !(origin.is_finite() && length.is_finite() && length > 0.0) {
            return None;
        }
        let direction = direction / length;
        let entry = entry(origin, direction, self.highest)?;
        let start = origin + entry * direction;
        let (distance, point) = self.nearest_triangle(start, direction)?;
        let up = point.normalize();
        Some(Hit {
            sample: self.mesh.nearest(up),
            direction: up,
            distance: entry + distance,
        })
    }

    fn nearest_triangle(&self, start: DVec3, direction: DVec3) -> Option<(f64, DVec3)> {
        let single = |v: DVec3| v.as_vec3().to_array().into();
        let mut best = (f64::INFINITY, usize::MAX);
        let pruning = Ray::new_inf(single(start), single(direction));
        self.tree
            .ray_traverse(pruning, &mut RayHit::none(), |_, slot| {
                let run = self.tree.primitive_indices[slot] as usize * RUN;
                let triangles = &self.mesh.triangles()[run..];
                for (k, triangle) in triangles.iter().take(RUN).enumerate() {
                    let corners = triangle.map(|i| self.corner(i));
                    if let Some(t) = hit_triangle(start, direction, corners)
                        && (t, run + k) < best
                    {
                        best = (t, run + k);
                    }
                }
                // A little beyond, so that pruning in f32 never hides what f64 would prefer.
                best.0 as f32 * (1.0 + 1e-5) + SLACK
            });
        best.0
            .is_finite()
            .then(|| (best.0, start + best.0 * direction))
    }

    fn corner(&self, i: u32) -> DVec3 {
        self.mesh.point(i) * f64::from(self.radii[i as usize])
    }
}

fn run_box(mesh: &SphereMesh, radii: &[f32], run: &[[u32; 3]]) -> RunBox {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for &i in run.as_flattened() {
        let corner = mesh.point(i).as_vec3() * radii[i as usize];
        low = low.min(corner);
        high = high.max(corner);
    }
    let (low, high) = (low - Vec3::splat(SLACK), high + Vec3::splat(SLACK));
    RunBox(Aabb {
        min: low.to_array().into(),
        max: high.to_array().into(),
    })
}

/// Distance at which the ray enters the sphere of this radius about the origin; 0 from inside.
fn entry(origin: DVec3, direction: DVec3, radius: f64) -> Option<f64> {
    let along = -origin.dot(direction);
    let nearest = (origin + along * direction).length_squared();
    let half = (radius * radius - nearest).max(0.0).sqrt();
    (nearest <= radius * radius && along + half >= 0.0).then(|| (along - half).max(0.0))
}

/// Distance at which the ray crosses a triangle, edges included (Möller and Trumbore 1997).
fn hit_triangle(origin: DVec3, direction: DVec3, [a, b, c]: [DVec3; 3]) -> Option<f64> {
    /// Keeps a ray from slipping between two triangles.
    const EDGE: f64 = 1e-12;
    let (ab, ac) = (b - a, c - a);
    let p = direction.cross(ac);
    let det = ab.dot(p);
    if det.abs() < 1e-300 {
        return None;
    }
    let from = origin - a;
    let u = from.dot(p) / det;
    let q = from.cross(ab);
    let v = direction.dot(q) / det;
    let t = ac.dot(q) / det;
    (u >= -EDGE && v >= -EDGE && u + v <= 1.0 + EDGE && t >= 0.0).then_some(t)
}

#[cfg(test)]
mod tests {
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
            let expected = picker.mesh.triangles().iter().filter_map(|t| {
                hit_triangle(
                    aimed.origin,
                    aimed.direction.normalize(),
                    t.map(|i| picker.corner(i)),
                )
            });
            let expected = expected.fold(f64::INFINITY, f64::min);
            match picker.pick(aimed) {
                Some(hit) => {
                    hits += 1;
                    assert!(
                        (hit.distance - expected).abs() < 1e-9,
                        "{} {expected}",
                        hit.distance
                    );
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
}
