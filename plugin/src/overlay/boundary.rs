//! Kinds of plate boundaries, from the relative motion of the plates on either side.

use super::OverlayInput;
use super::palette::Rgba;
use crate::parallel;
use bevy::prelude::*;

/// What plates do where they meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Reflect)]
#[repr(u8)]
pub enum BoundaryKind {
    /// No boundary.
    #[default]
    None = 0,
    /// They approach.
    Convergent = 1,
    /// They part.
    Divergent = 2,
    /// They slide past each other, or rest.
    Transform = 3,
}

impl BoundaryKind {
    /// Kinds of boundaries, without [`BoundaryKind::None`].
    pub const ALL: [Self; 3] = [Self::Convergent, Self::Divergent, Self::Transform];

    /// Name for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Convergent => "convergent",
            Self::Divergent => "divergent",
            Self::Transform => "transform",
        }
    }

    /// Colour of lines of this kind; transparent where there is none.
    pub fn color(self) -> Rgba {
        match self {
            Self::None => [0, 0, 0, 0],
            Self::Convergent => [226, 60, 52, 255],
            Self::Divergent => [255, 204, 64, 255],
            Self::Transform => [96, 214, 140, 255],
        }
    }
}

/// Least share of the relative speed that must be across a boundary, or it counts as transform: the
/// sine of 30 degrees.
const ACROSS: f64 = 0.5;

/// Relative speed in radii per My below which plates rest against each other: 1 km in 150 My on
/// Earth.
const REST: f64 = 1e-6;

/// The kind of boundary at every sample; a boundary is one sample wide on either side.
pub fn boundaries(input: &OverlayInput) -> Vec<BoundaryKind> {
    parallel::map(input.mesh.len(), |i| boundary(input, i))
}

fn boundary(input: &OverlayInput, i: u32) -> BoundaryKind {
    let OverlayInput {
        mesh,
        surface,
        plates,
        ..
    } = *input;
    let (own, p) = (surface.plate[i as usize], mesh.point(i));
    let (mut opening, mut speed, mut foreign) = (0.0, 0.0, 0);
    for &j in mesh.ring(i) {
        let other = surface.plate[j as usize];
        if other == own {
            continue;
        }
        let q = mesh.point(j);
        let relative = (plates.angular_velocity(other) - plates.angular_velocity(own))
            .cross((p + q).normalize());
        opening += relative.dot((q - p).normalize());
        speed += relative.length();
        foreign += 1;
    }
    if foreign == 0 {
        BoundaryKind::None
    } else if speed < REST * f64::from(foreign) || opening.abs() < ACROSS * speed {
        BoundaryKind::Transform
    } else if opening > 0.0 {
        BoundaryKind::Divergent
    } else {
        BoundaryKind::Convergent
    }
}
