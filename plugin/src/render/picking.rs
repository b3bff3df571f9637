//! Picking: where a ray meets a globe.
//!
//! Triangles of a lattice are ordered along a curve, so runs of 64 lie close together. obvhs keeps
//! a tree over the boxes of such runs and only prunes; the triangles of a run are tested here in
//! f64, and f64 decides.
//!
//! Policies: the nearest hit wins; of triangles hit at the same distance (an edge, a corner) the
//! first. A ray that starts below the surface sees it from inside. A ray that is not finite hits
//! nothing.

use super::axes::{from_bevy, to_bevy};
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

/// Triangles in a run.
const RUN_TRIANGLES: usize = 64;

/// How much boxes are grown, in planet radii: more than f32 rounds.
const BOX_MARGIN: f32 = 2e-6;

/// How much farther than a hit, relatively, pruning in f32 still looks for a nearer one in f64.
const PRUNING_MARGIN: f32 = 1e-5;

/// Barycentric coordinate up to which a ray outside of a triangle hits it, so that none slips
/// between two triangles.
const EDGE_TOLERANCE: f64 = 1e-12;

/// A ray in planet coordinates, lengths in planet radii, the planet's centre at the origin.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
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
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct GlobeHit {
    /// The sample nearest to the hit.
    pub sample: u32,
    /// Unit direction of the hit in planet coordinates.
    pub direction: DVec3,
    /// Distance from the ray's origin in planet radii.
    pub distance: f64,
}

impl GlobeHit {
    /// The unit direction of the hit in the globe's Bevy axes.
    pub fn bevy_direction(&self) -> Vec3 {
        to_bevy(self.direction)
    }
}

/// Finds where rays meet a globe as it is drawn.
/// [`PangaeaRenderPlugin`](super::PangaeaRenderPlugin) puts one on the planet's entity and keeps it
/// up to date.
///
/// ```
/// use bevy::math::DVec3;
/// use bevy_pangaea::render::{GlobePicker, GlobeRay};
/// use bevy_pangaea::sphere::SphereMesh;
/// use std::sync::Arc;
///
/// let mesh = Arc::new(SphereMesh::fibonacci(1000)?);
/// let sphere = GlobePicker::new(mesh, vec![1.0; 1000]);
/// let down = GlobeRay { origin: 3.0 * DVec3::Z, direction: -DVec3::Z };
/// let hit = sphere.pick(down).ok_or("no hit")?;
/// assert!((hit.distance - 2.0).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Component, Clone)]
pub struct GlobePicker {
    mesh: Arc<SphereMesh>,
    /// Distance of every sample from the centre, in planet radii.
    radii: Vec<f32>,
    tree: Bvh2,
    highest: f64,
}

/// The box around a run of triangles.
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
        // Without a relief, the sphere.
        radii.resize(mesh.len(), 1.0);
        let highest = f64::from(radii.iter().copied().fold(0.0, f32::max)) + 1e-5;
        let boxes: Vec<_> = mesh
            .triangles()
            .chunks(RUN_TRIANGLES)
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

    /// Where the ray meets the globe first, if it does.
    pub fn pick(&self, ray: GlobeRay) -> Option<GlobeHit> {
        let GlobeRay { origin, direction } = ray;
        let length = direction.length();
        if !(origin.is_finite() && length.is_finite() && length > 0.0) {
            return None;
        }
        let direction = direction / length;
        // From the sphere around everything inwards, so that f32 has no long way to go.
        let entry = entry(origin, direction, self.highest)?;
        let start = origin + entry * direction;
        let (distance, point) = self.nearest_triangle(start, direction)?;
        let up = point.normalize();
        Some(GlobeHit {
            sample: self.mesh.nearest(up),
            direction: up,
            distance: entry + distance,
        })
    }

    /// The nearest hit of a ray with a unit `direction`: its distance and place.
    fn nearest_triangle(&self, start: DVec3, direction: DVec3) -> Option<(f64, DVec3)> {
        let mut best = (f64::INFINITY, usize::MAX);
        let single = |v: DVec3| v.as_vec3().to_array().into();
        let pruning = Ray::new_inf(single(start), single(direction));
        let mut no_hit = RayHit::none();
        self.tree.ray_traverse(pruning, &mut no_hit, |_, slot| {
            let run = self.tree.primitive_indices[slot] as usize;
            best = self.nearest_in_run(run, start, direction, best);
            // A little beyond, so that pruning in f32 never hides what f64 would prefer.
            best.0 as f32 * (1.0 + PRUNING_MARGIN) + BOX_MARGIN
        });
        let (distance, _) = best;
        distance
            .is_finite()
            .then(|| (distance, start + distance * direction))
    }

    /// The better of `best` and the hits in a run, by distance and then by triangle.
    fn nearest_in_run(
        &self,
        run: usize,
        start: DVec3,
        direction: DVec3,
        mut best: (f64, usize),
    ) -> (f64, usize) {
        let first = run * RUN_TRIANGLES;
        let triangles = self.mesh.triangles()[first..].iter().take(RUN_TRIANGLES);
        for (k, triangle) in (first..).zip(triangles) {
            let corners = triangle.map(|i| self.corner(i));
            if let Some(t) = hit_triangle(start, direction, corners)
                && (t, k) < best
            {
                best = (t, k);
            }
        }
        best
    }

    /// Where a sample is drawn.
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
    let (low, high) = (
        low - Vec3::splat(BOX_MARGIN),
        high + Vec3::splat(BOX_MARGIN),
    );
    RunBox(Aabb {
        min: low.to_array().into(),
        max: high.to_array().into(),
    })
}

/// Distance at which the ray enters the sphere of this radius about the origin; 0 from inside.
fn entry(origin: DVec3, direction: DVec3, radius: f64) -> Option<f64> {
    let along = -origin.dot(direction);
    // The point of the line that is nearest to the centre; both crossings lie `half` from it.
    let nearest = (origin + along * direction).length_squared();
    let half = (radius * radius - nearest).max(0.0).sqrt();
    (nearest <= radius * radius && along + half >= 0.0).then(|| (along - half).max(0.0))
}

/// Distance at which the ray crosses a triangle, edges included (Möller and Trumbore 1997).
fn hit_triangle(origin: DVec3, direction: DVec3, [a, b, c]: [DVec3; 3]) -> Option<f64> {
    let (ab, ac) = (b - a, c - a);
    let p = direction.cross(ac);
    let det = ab.dot(p);
    // The ray lies in the plane of the triangle.
    if det.abs() < 1e-300 {
        return None;
    }
    // Barycentric coordinates, and the distance along the ray.
    let from = origin - a;
    let u = from.dot(p) / det;
    let q = from.cross(ab);
    let v = direction.dot(q) / det;
    let t = ac.dot(q) / det;
    (u >= -EDGE_TOLERANCE && v >= -EDGE_TOLERANCE && u + v <= 1.0 + EDGE_TOLERANCE && t >= 0.0)
        .then_some(t)
}

#[cfg(test)]
mod tests;
