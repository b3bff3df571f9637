//! A patch of triangles around a point, as colliders want it: an origin in f64, positions near it
//! in f32.

use super::{AzimuthalEquidistant, Ground, GroundError, Square, checked};
use bevy::math::{DVec3, Vec3};
use rayon::prelude::*;

/// A square patch of the ground.
#[derive(Clone, Debug, PartialEq)]
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
/// # Errors
/// [`GroundError::Length`] for a side or spacing that makes no patch, [`GroundError::Count`] for
/// more than 16,383 steps to a side, else as [`Ground::height`].
pub fn collider_patch(
    ground: &(impl Ground + ?Sized),
    direction: DVec3,
    side_m: f64,
    spacing_m: f64,
    level: u8,
) -> Result<Patch, GroundError> {
    let up = checked(direction, level)?;
    let radius = ground.radius_m();
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(GroundError::Radius(radius));
    }
    let (min, max) = (1e-3, AzimuthalEquidistant::largest_square(radius));
    if !(min..=max).contains(&side_m) {
        return Err(GroundError::Length {
            what: "the side of the patch",
            value: side_m,
            min,
            max,
        });
    }
    if !(min..=side_m).contains(&spacing_m) {
        return Err(GroundError::Length {
            what: "the spacing",
            value: spacing_m,
            min,
            max: side_m,
        });
    }
    // A hair less, so that 64 m at 0.1 m are 640 steps.
    let steps = (side_m / spacing_m - 1e-9).ceil().max(1.0) as usize;
    // Corners are the pixel centres of a square that is half a step larger all around.
    let corners = steps.saturating_add(1);
    let whole = side_m * (corners as f64 / steps as f64);
    let square = Square::new(
        AzimuthalEquidistant::about(up, radius),
        whole.min(max),
        corners,
    )?;
    let grid = square.heights(ground, level)?;
    let origin = up * (radius + f64::from(ground.height(up, level)?));
    let place = |i: usize| {
        square.direction(i % corners, i / corners) * (radius + f64::from(grid.values[i]))
    };
    let positions = (0..grid.values.len())
        .into_par_iter()
        .map(|i| (place(i) - origin).as_vec3())
        .collect();
    Ok(Patch {
        origin,
        positions,
        triangles: grid_triangles(corners),
    })
}

/// Two triangles for each cell of a square grid of `n` by `n` corners whose rows begin in the north
/// west, counter-clockwise seen from outside.
pub(crate) fn grid_triangles(n: usize) -> Vec<[u32; 3]> {
    let cell = |i: usize| {
        let (x, y) = (i % (n - 1), i / (n - 1));
        let corner = |dx: usize, dy: usize| ((y + dy) * n + x + dx) as u32;
        let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)];
        [[a, c, b], [b, c, d]]
    };
    (0..(n - 1) * (n - 1)).flat_map(cell).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    /// A ball with a bump of 100 m, 2 km wide, at 0° N 0° E.
    struct Bump;

    impl Ground for Bump {
        fn radius_m(&self) -> f64 {
            1e6
        }

        fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
            let away = 1e6 * math::angle_between(checked(direction, level)?, DVec3::X);
            Ok((100.0 * math::exp(-(away / 1000.0) * (away / 1000.0))) as f32)
        }
    }

    #[test]
    fn corners_lie_on_the_ground_around_the_origin() {
        for up in [DVec3::X, DVec3::Z, -DVec3::Z, math::direction(0.01, 0.02)] {
            let patch = collider_patch(&Bump, up, 64.0, 0.5, 17).unwrap();
            assert_eq!(
                (patch.positions.len(), patch.triangles.len()),
                (129 * 129, 2 * 128 * 128)
            );
            assert!(
                patch.positions[64 * 129 + 64].length() < 1e-5,
                "the middle is the origin"
            );
            for p in patch.positions.iter().step_by(97) {
                let place = patch.origin + p.as_dvec3();
                let height = f64::from(Bump.height(place, 17).unwrap());
                assert!((place.length() - 1e6 - height).abs() < 1e-4);
                assert!(p.length() < 32.0 * 1.5);
            }
            let corner = patch.positions[0].as_dvec3();
            // On the bump a degree is up to a ten-thousandth longer than at sea level.
            assert!(((corner - up * corner.dot(up)).length() - 32.0 * 2.0_f64.sqrt()).abs() < 0.01);
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

    #[test]
    fn bad_patches_are_refused() {
        let patch = |side, spacing, level| {
            collider_patch(&Bump, DVec3::X, side, spacing, level).map(|_| ())
        };
        for (side, spacing) in [
            (0.0, 0.5),
            (f64::NAN, 0.5),
            (64.0, 0.0),
            (64.0, f64::NAN),
            (64.0, 65.0),
            (1e9, 1e5),
        ] {
            assert!(
                matches!(patch(side, spacing, 17), Err(GroundError::Length { .. })),
                "{side} {spacing}"
            );
        }
        assert!(matches!(
            patch(1e5, 1e-3, 17),
            Err(GroundError::Count { .. })
        ));
        assert_eq!(patch(64.0, 1.0, 18), Err(GroundError::Level(18)));
        let nowhere = collider_patch(&Bump, DVec3::ZERO, 64.0, 1.0, 17).map(|_| ());
        assert_eq!(nowhere, Err(GroundError::NotADirection));
    }
}
