//! A patch of triangles around a point, as colliders want it: an origin in f64, positions near it
//! in f32.

use super::check::{check_length, check_radius, checked};
use super::error::GroundError;
use super::ground::Ground;
use super::projection::AzimuthalEquidistant;
use super::raster::MapSquare;
use bevy::math::{DVec3, Vec3};
use bevy::reflect::Reflect;
use rayon::prelude::*;

/// Shortest side and spacing of a patch in m.
const SHORTEST_M: f64 = 1e-3;

/// A square patch of the ground.
#[derive(Clone, Debug, PartialEq, Reflect)]
pub struct Patch {
    /// The point that positions count from: at the middle of the patch on the ground; m from the
    /// planet's centre.
    pub origin: DVec3,
    /// Corners in m from `origin`, in the planet's axes; those of [`collider_patch`] in rows from
    /// the north.
    pub positions: Vec<Vec3>,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// The ground around a direction of any length: a square of `side_m` with corners every `spacing_m`
/// (a little less, so that whole steps fill the side), at `level`.
///
/// ```
/// use bevy::math::DVec3;
/// use bevy_pangaea::query::{PatchTree, PlanetGround, Rules, collider_patch};
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let ground = PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default())?;
/// let patch = collider_patch(&ground, DVec3::X, 4000.0, 500.0, 8)?;
/// assert_eq!(patch.positions.len(), 9 * 9);
///
/// // A ray from 20 km above its middle straight down meets it.
/// let tree = PatchTree::new(patch)?;
/// let hit = tree.cast(DVec3::X * 6_390_000.0, -DVec3::X, 1e5)?;
/// assert!(hit.is_some());
/// # Ok::<(), bevy_pangaea::query::GroundError>(())
/// ```
///
/// # Errors
/// [`GroundError::Length`] for a side or spacing that is zero, NaN or too long,
/// [`GroundError::Count`] for more than 16,383 steps to a side, else as [`Ground::height`].
pub fn collider_patch(
    ground: &(impl Ground + ?Sized),
    direction: DVec3,
    side_m: f64,
    spacing_m: f64,
    level: u8,
) -> Result<Patch, GroundError> {
    let up = checked(direction, level)?;
    let radius = ground.radius_m();
    check_radius(radius)?;
    let largest = AzimuthalEquidistant::largest_square(radius);
    check_length("the side of the patch", side_m, [SHORTEST_M, largest])?;
    check_length("the spacing", spacing_m, [SHORTEST_M, side_m])?;
    // A hair less, so that 64 m at 0.1 m are 640 steps.
    let steps = (side_m / spacing_m - 1e-9).ceil().max(1.0) as usize;
    // Corners are the pixel centres of a square that is half a step larger all around.
    let corners = steps.saturating_add(1);
    let whole = side_m * (corners as f64 / steps as f64);
    let about = AzimuthalEquidistant::about(up, radius);
    let square = MapSquare::new(about, whole.min(largest), corners)?;
    let grid = square.heights(ground, level)?;
    let origin = up * (radius + f64::from(ground.height(up, level)?));
    // In f32 only about the origin: far from it a metre could not be told from the next.
    let positions = (0..grid.values.len())
        .into_par_iter()
        .map(|i| {
            let unit = square.direction(i % corners, i / corners);
            (unit * (radius + f64::from(grid.values[i])) - origin).as_vec3()
        })
        .collect();
    Ok(Patch {
        origin,
        positions,
        triangles: grid_triangles(corners),
    })
}

/// Two triangles for each cell of a square grid of `n` by `n` corners.
fn grid_triangles(n: usize) -> Vec<[u32; 3]> {
    (0..n - 1).flat_map(|y| row_triangles(n, y)).collect()
}

/// Two triangles for each cell between row `y` of a grid of `n` columns of corners and the next
/// row, counter-clockwise seen from outside. Rows begin in the west, the first is in the north.
#[inline]
pub(crate) fn row_triangles(n: usize, y: usize) -> impl Iterator<Item = [u32; 3]> {
    (y * n..y * n + n - 1).flat_map(move |corner| {
        let north_west = corner as u32;
        let south_west = north_west + n as u32;
        [
            [north_west, south_west, north_west + 1],
            [north_west + 1, south_west, south_west + 1],
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    const RADIUS_M: f64 = 1e6;

    /// A ball with a bump of 100 m, 2 km wide, at 0° N 0° E.
    struct Bump;

    impl Ground for Bump {
        fn radius_m(&self) -> f64 {
            RADIUS_M
        }

        fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
            let away = RADIUS_M * math::angle_between(checked(direction, level)?, DVec3::X);
            Ok((100.0 * math::exp(-(away / 1000.0) * (away / 1000.0))) as f32)
        }
    }

    /// Holds the corners of a patch of 64 m at 0.5 m to the ground.
    fn assert_on_ground(patch: &Patch, up: DVec3) {
        let middle = patch.positions[64 * 129 + 64];
        assert!(middle.length() < 1e-5, "the middle is the origin");
        for p in patch.positions.iter().step_by(97) {
            let place = patch.origin + p.as_dvec3();
            let height = f64::from(Bump.height(place, 17).unwrap());
            assert!((place.length() - RADIUS_M - height).abs() < 1e-4);
            assert!(p.length() < 32.0 * 1.5);
        }
        let corner = patch.positions[0].as_dvec3();
        let away = (corner - up * corner.dot(up)).length();
        // On the bump a degree is up to a ten-thousandth longer than at sea level.
        assert!((away - 32.0 * 2.0_f64.sqrt()).abs() < 0.01);
    }

    #[test]
    fn corners_lie_on_the_ground_around_the_origin() {
        for up in [DVec3::X, DVec3::Z, -DVec3::Z, math::direction(0.01, 0.02)] {
            let patch = collider_patch(&Bump, up, 64.0, 0.5, 17).unwrap();
            assert_eq!(patch.positions.len(), 129 * 129);
            assert_eq!(patch.triangles.len(), 2 * 128 * 128);
            assert_on_ground(&patch, up);
        }
    }

    #[test]
    fn triangles_face_outwards_and_cover_the_square_once() {
        let patch = collider_patch(&Bump, DVec3::Y, 10.0, 3.0, 3).unwrap();
        assert_eq!(patch.positions.len(), 25);
        let mut area = 0.0;
        for t in &patch.triangles {
            let [a, b, c] = t.map(|i| patch.positions[i as usize].as_dvec3());
            let facing = (b - a).cross(c - a).dot(DVec3::Y);
            assert!(facing > 0.0);
            area += 0.5 * facing;
        }
        assert!((area - 100.0).abs() < 1e-3, "{area}");
    }

    /// The error of a patch about a direction.
    fn refused(up: DVec3, side: f64, spacing: f64, level: u8) -> GroundError {
        collider_patch(&Bump, up, side, spacing, level).unwrap_err()
    }

    #[test]
    fn bad_patches_are_refused() {
        for (side, spacing) in [
            (0.0, 0.5),
            (f64::NAN, 0.5),
            (64.0, 0.0),
            (64.0, f64::NAN),
            (64.0, 65.0),
            (1e9, 1e5),
        ] {
            let error = refused(DVec3::X, side, spacing, 17);
            assert!(
                matches!(error, GroundError::Length { .. }),
                "{side} {spacing}"
            );
        }
        let many = refused(DVec3::X, 1e5, 1e-3, 17);
        assert!(matches!(many, GroundError::Count { .. }));
        assert_eq!(refused(DVec3::X, 64.0, 1.0, 18), GroundError::Level(18));
        let nowhere = refused(DVec3::ZERO, 64.0, 1.0, 17);
        assert_eq!(nowhere, GroundError::NotADirection);
    }
}
