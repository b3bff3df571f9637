use super::*;
use crate::math;
use crate::query::{Ground, cast_ray, collider_patch};
use proptest::prelude::*;
use std::sync::LazyLock;

/// Waves of 20 m, 200 m long, on a ball.
struct Waves;

impl Ground for Waves {
    fn radius_m(&self) -> f64 {
        1e6
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let up = checked(direction, level)?;
        let wave = |x: f64| math::sin(math::TAU * x * 5e3);
        Ok((20.0 * wave(up.y) * wave(up.z)) as f32)
    }

    fn bounds_m(&self) -> [f64; 2] {
        [-21.0, 21.0]
    }
}

fn tree() -> &'static PatchTree {
    static TREE: LazyLock<PatchTree> = LazyLock::new(|| {
        PatchTree::new(collider_patch(&Waves, DVec3::X, 400.0, 4.0, 17).unwrap()).unwrap()
    });
    &TREE
}

proptest! {
    #[test]
    fn the_tree_finds_what_a_test_of_all_triangles_finds(
        y in -250.0..250.0_f64, z in -250.0..250.0_f64, above in -40.0..300.0_f64,
        dx in -1.0..1.0_f64, dy in -1.0..1.0_f64, dz in -1.0..1.0_f64, max in 0.0..800.0_f64,
    ) {
        let tree = tree();
        let origin = DVec3::new(1e6 + above, y, z);
        let direction = DVec3::new(dx, dy, dz);
        prop_assume!(direction.length() > 0.01);
        let found = tree.cast(origin, direction, max).unwrap();
        let (along, local) = (direction.normalize(), origin - tree.patch.origin);
        let all = (0..tree.patch.triangles.len()).filter_map(|k| tree.hit(k, local, along));
        let nearest = all.filter(|&t| t <= max).fold(f64::INFINITY, f64::min);
        match found.map(|hit| hit.distance_m) {
            Some(t) => prop_assert!((t - nearest).abs() < 1e-6, "{t} {nearest}"),
            // Between two triangles, or at the very end of the ray, rounding decides.
            None => prop_assert!(nearest > max - 1e-6, "{nearest}"),
        }
    }
}

#[test]
fn a_patch_is_hit_where_the_ground_is() {
    let tree = tree();
    for (y, z) in [(3.0, 7.0), (50.5, -41.0), (-120.0, 99.0)] {
        let origin = DVec3::new(1e6 + 500.0, y, z);
        let toward = DVec3::new(-1.0, 0.1, -0.05);
        let ground = cast_ray(&Waves, origin, toward, 1e4, 17).unwrap().unwrap();
        let patch = tree.cast(origin, toward, 1e4).unwrap().unwrap();
        // Chords of 4 m lie up to 4 cm off waves of 200 m.
        assert!((ground.distance_m - patch.distance_m).abs() < 0.1);
        assert!(math::angle_between(ground.normal, patch.normal) < 0.1);
    }
    let above = DVec3::new(1e6 + 500.0, 0.0, 0.0);
    assert_eq!(tree.cast(above, DVec3::X, 1e6), Ok(None));
    assert_eq!(tree.cast(above, -DVec3::X, 400.0), Ok(None));
}

#[test]
fn bad_patches_are_refused() {
    let patch = tree().patch().clone();
    let empty = Patch {
        triangles: Vec::new(),
        ..patch.clone()
    };
    let torn = Patch {
        triangles: vec![[0, 1, 1_000_000]],
        ..patch
    };
    for patch in [empty, torn] {
        let refused = PatchTree::new(patch);
        assert!(matches!(refused, Err(GroundError::Count { .. })));
    }
}

#[test]
fn bad_rays_are_refused() {
    let nowhere = Err(GroundError::NotADirection);
    assert_eq!(tree().cast(DVec3::NAN, DVec3::X, 1.0), nowhere);
    assert_eq!(tree().cast(DVec3::X, DVec3::ZERO, 1.0), nowhere);
    let refused = tree().cast(DVec3::X, DVec3::X, f64::NAN);
    assert!(matches!(refused, Err(GroundError::Length { .. })));
}
