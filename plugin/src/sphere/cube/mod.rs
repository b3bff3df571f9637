//! The sphere as the six square faces of a cube around it.
//!
//! A direction is projected from the centre to a face (gnomonic projection). Two grids are laid
//! over the faces, because no single map of a face serves both purposes:
//!
//! ```text
//! bins       equal squares of the flat face, where great circles are straight lines: all bins
//!            within reach of a point follow from bounds on two quotients
//! stretched  coordinates bent so that equal squares cover nearly equal solid angles: every cell
//!            of the seed grid holds about as many samples, and the curve is equally dense
//! curve      a Hilbert curve over the stretched faces, the order of samples in memory
//! ```

mod bins;
mod curve;
mod stretched;

pub(crate) use bins::CubeGrid;
pub(super) use curve::along_curve;
pub(super) use stretched::{stretched_cell, stretched_project, unstretch};

use bevy::math::DVec3;

/// A point of the cube: the face 0..6 (+x, -x, +y, -y, +z, -z) and coordinates in -1..=1 across it.
#[derive(Clone, Copy, Debug)]
pub(super) struct FacePoint {
    pub(super) face: u32,
    pub(super) u: f64,
    pub(super) v: f64,
}

impl FacePoint {
    #[inline(always)]
    fn new(axis: u32, depth: f64, u: f64, v: f64) -> Self {
        let scale = 1.0 / depth.abs();
        Self {
            face: 2 * axis + u32::from(depth < 0.0),
            u: u * scale,
            v: v * scale,
        }
    }
}

/// The gnomonic projection of a direction, which need not be normalised.
#[inline]
fn project(p: DVec3) -> FacePoint {
    let a = p.abs();
    if a.x >= a.y && a.x >= a.z {
        FacePoint::new(0, p.x, p.y, p.z)
    } else if a.y >= a.z {
        FacePoint::new(1, p.y, p.x, p.z)
    } else {
        FacePoint::new(2, p.z, p.x, p.y)
    }
}

/// The direction (not normalised) of gnomonic coordinates on a face: the inverse of [`project`].
pub(super) fn unproject(face: u32, u: f64, v: f64) -> DVec3 {
    let side = if face & 1 == 0 { 1.0 } else { -1.0 };
    match face / 2 {
        0 => DVec3::new(side, u, v),
        1 => DVec3::new(u, side, v),
        _ => DVec3::new(u, v, side),
    }
}
