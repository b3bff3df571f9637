//! Kinds of plate boundaries, from the relative motion of the plates on either side.

use super::OverlayInput;
use super::palette::Rgba;
use crate::named::named_enum;
use crate::parallel;

named_enum! {
    /// The relative motion of plates where they meet.
    #[derive(Default)]
    pub enum BoundaryKind {
        /// No boundary.
        #[default]
        None = "none",
        /// They approach.
        Convergent = "convergent",
        /// They part.
        Divergent = "divergent",
        /// They slide past each other, or rest.
        Transform = "transform",
    }
}

impl BoundaryKind {
    /// Kinds that are drawn: all but [`BoundaryKind::None`].
    pub const DRAWN: [Self; 3] = [Self::Convergent, Self::Divergent, Self::Transform];

    /// Colour of lines of this kind; transparent for [`BoundaryKind::None`].
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
const LEAST_NORMAL_SHARE: f64 = 0.5;

/// Relative speed in radii per My below which plates rest against each other: 1 km in 150 My on
/// Earth.
const RESTING_SPEED: f64 = 1e-6;

/// The kind of boundary at every sample; a boundary is one sample wide on either side.
pub fn boundaries(input: &OverlayInput) -> Vec<BoundaryKind> {
    parallel::map(input.mesh.len(), |i| boundary(input, i))
}

/// The kind at sample `i`, from the mean motion of the neighbours on other plates.
fn boundary(input: &OverlayInput, i: u32) -> BoundaryKind {
    let plate = &input.surface.plate;
    let own = plate[i as usize];
    let p = input.mesh.point(i);
    let mut opening = 0.0;
    let mut speed = 0.0;
    let mut foreign = 0;
    for &j in input.mesh.ring(i) {
        let other = plate[j as usize];
        if other == own {
            continue;
        }
        let q = input.mesh.point(j);
        // Across the boundary: positive where the neighbour moves away.
        let turn = input.plates.angular_velocity(other) - input.plates.angular_velocity(own);
        let relative = turn.cross((p + q).normalize());
        opening += relative.dot((q - p).normalize());
        speed += relative.length();
        foreign += 1;
    }
    if foreign == 0 {
        return BoundaryKind::None;
    }
    kind_of(opening, speed, f64::from(foreign))
}

/// The kind of a boundary with sums over `count` neighbours: speeds of opening and relative speeds,
/// in radii per My.
fn kind_of(opening: f64, speed: f64, count: f64) -> BoundaryKind {
    if speed < RESTING_SPEED * count || opening.abs() < LEAST_NORMAL_SHARE * speed {
        BoundaryKind::Transform
    } else if opening > 0.0 {
        BoundaryKind::Divergent
    } else {
        BoundaryKind::Convergent
    }
}
