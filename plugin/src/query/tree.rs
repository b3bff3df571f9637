//! Many rays against one patch: a tree over its triangles.
//!
//! obvhs keeps the tree, in f32 relative to the patch's origin, and only prunes; the triangles are
//! tested in f64 (Möller and Trumbore 1997). The nearest hit wins, of equally near ones the first
//! triangle. Both sides of a triangle are hit.

use super::check::{check_length, check_position, checked};
use super::error::GroundError;
use super::patch::Patch;
use super::ray::RayHit;
use bevy::math::{DVec3, Vec3};
use obvhs::Boundable;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ray::{Ray, RayHit as PrunedHit};

/// How much boxes are grown, as a share of the patch: more than f32 rounds.
const BOX_SLACK: f32 = 1e-5;

/// A patch in which rays are cast.
pub struct PatchTree {
    patch: Patch,
    tree: Bvh2,
    /// How much boxes were grown, in m.
    slack: f32,
}

struct TriangleBox(Aabb);

impl Boundable for TriangleBox {
    fn aabb(&self) -> Aabb {
        self.0
    }
}

/// A ray in coordinates about the patch's origin. It is cast both ways from its point nearest to
/// the origin, where f32 is as fine as the patch is small.
struct LocalRay {
    /// The nearest point.
    start: DVec3,
    along: DVec3,
    /// Distance of the nearest point from the ray's origin in m; negative behind it.
    shift: f64,
    max_m: f64,
}

/// Distance of a hit from the ray's origin in m, and its triangle: the smaller the better.
type BestHit = Option<(f64, usize)>;

impl PatchTree {
    /// A tree over the triangles of a patch.
    ///
    /// # Errors
    /// [`GroundError::Count`] for a patch without triangles, or with one whose corner is not there.
    pub fn new(patch: Patch) -> Result<Self, GroundError> {
        let corners = patch.positions.len();
        let highest = patch.triangles.as_flattened().iter().max();
        if highest.is_none_or(|&highest| highest as usize >= corners) {
            return Err(GroundError::Count {
                what: "the corners of the patch",
                value: highest.map_or(0, |&highest| highest as usize),
                min: 0,
                max: corners.saturating_sub(1),
            });
        }
        let largest = |reach: f32, p: &Vec3| reach.max(p.abs().max_element());
        let slack = BOX_SLACK * patch.positions.iter().fold(0.0, largest);
        let boxes: Vec<TriangleBox> = patch
            .triangles
            .iter()
            .map(|triangle| triangle_box(&patch, *triangle, slack))
            .collect();
        let mut time = core::time::Duration::default();
        let tree = build_bvh2(&boxes, BvhBuildParams::fastest_build(), &mut time);
        Ok(Self { patch, tree, slack })
    }

    /// The patch.
    pub fn patch(&self) -> &Patch {
        &self.patch
    }

    /// The first point of the patch on the ray from `origin`, in m from the planet's centre, along
    /// `direction` (of any length), at most `max_m` away.
    ///
    /// # Errors
    /// [`GroundError::NotADirection`] for an origin or a direction that is infinite or NaN, and a
    /// direction of zero; [`GroundError::Length`] for a `max_m` that is negative or NaN.
    pub fn cast(
        &self,
        origin: DVec3,
        direction: DVec3,
        max_m: f64,
    ) -> Result<Option<RayHit>, GroundError> {
        let along = checked(direction, 0)?;
        check_position(origin)?;
        check_length("the ray", max_m, [0.0, f64::INFINITY])?;
        let local = origin - self.patch.origin;
        let shift = -local.dot(along);
        let ray = LocalRay {
            start: local + along * shift,
            along,
            shift,
            max_m,
        };
        // The ray's origin may lie on either side of the nearest point: both halves are cast, and
        // hits before the origin are left out.
        let ahead = self.best_hit(&ray, 1.0, None);
        let best = self.best_hit(&ray, -1.0, ahead);
        Ok(best.map(|(distance_m, k)| self.found(origin + along * distance_m, distance_m, k)))
    }

    /// The best hit of the half of a ray that leads ahead (`sign` 1) or back (-1), or one that is
    /// known and better.
    fn best_hit(&self, ray: &LocalRay, sign: f64, mut best: BestHit) -> BestHit {
        let direction = ray.along * sign;
        let single = |v: DVec3| v.as_vec3().to_array().into();
        let pruning = Ray::new_inf(single(ray.start), single(direction));
        self.tree
            .ray_traverse(pruning, &mut PrunedHit::none(), |_, slot| {
                self.meet(ray, sign, slot, &mut best)
            });
        best
    }

    /// Meets the triangle in a slot of the tree. Returns the distance from the ray's start in m
    /// beyond which no box needs to be looked at.
    fn meet(&self, ray: &LocalRay, sign: f64, slot: usize, best: &mut BestHit) -> f32 {
        let k = self.tree.primitive_indices[slot] as usize;
        if let Some(t) = self.hit(k, ray.start, ray.along * sign) {
            let found = (ray.shift + sign * t, k);
            let is_within = (0.0..=ray.max_m).contains(&found.0);
            if is_within && best.is_none_or(|best| found < best) {
                *best = Some(found);
            }
        }
        // Backwards the nearest hit is the last one met: nothing is pruned.
        match best {
            Some((distance, _)) if sign > 0.0 => (*distance - ray.shift) as f32 + self.slack,
            _ => f32::INFINITY,
        }
    }

    fn found(&self, point: DVec3, distance_m: f64, k: usize) -> RayHit {
        let [a, b, c] = self.corners(k);
        RayHit {
            distance_m,
            point,
            normal: (b - a).cross(c - a).try_normalize().unwrap_or(DVec3::Z),
        }
    }

    fn corners(&self, k: usize) -> [DVec3; 3] {
        self.patch.triangles[k].map(|i| self.patch.positions[i as usize].as_dvec3())
    }

    /// How far along the ray it meets triangle `k`.
    fn hit(&self, k: usize, start: DVec3, along: DVec3) -> Option<f64> {
        let [a, b, c] = self.corners(k);
        let (ab, ac) = (b - a, c - a);
        let across = along.cross(ac);
        let determinant = ab.dot(across);
        if determinant == 0.0 {
            return None;
        }
        // Barycentric coordinates u and v of the point, and its distance t.
        let from_a = start - a;
        let u = from_a.dot(across) / determinant;
        let turned = from_a.cross(ab);
        let v = along.dot(turned) / determinant;
        let t = ac.dot(turned) / determinant;
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0).then_some(t)
    }
}

fn triangle_box(patch: &Patch, triangle: [u32; 3], slack: f32) -> TriangleBox {
    let corners = triangle.map(|i| patch.positions[i as usize]);
    let low = corners.into_iter().fold(Vec3::INFINITY, Vec3::min) - Vec3::splat(slack);
    let high = corners.into_iter().fold(Vec3::NEG_INFINITY, Vec3::max) + Vec3::splat(slack);
    TriangleBox(Aabb {
        min: low.to_array().into(),
        max: high.to_array().into(),
    })
}

#[cfg(test)]
#[path = "tree_tests.rs"]
mod tests;
