//! Regular grids of points on a map: what squares, tiles and boxes have in common.

use super::check::check_level;
use super::error::GroundError;
use super::projection::AzimuthalEquidistant;
use crate::math;
use bevy::math::{DVec2, DVec3};
use bevy::reflect::Reflect;

/// From the plane of a map to the sphere.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(opaque, Clone, Debug, PartialEq)]
pub enum GridProjection {
    /// Metres to the east and to the north of a centre.
    Azimuthal(AzimuthalEquidistant),
    /// Plate carrée: degrees east and degrees north; longitudes may go on beyond 180.
    PlateCarree {
        /// Radius of the sphere in m.
        radius_m: f64,
    },
}

impl GridProjection {
    /// Radius of the sphere in m.
    pub fn radius_m(&self) -> f64 {
        match self {
            Self::Azimuthal(projection) => projection.radius_m(),
            Self::PlateCarree { radius_m } => *radius_m,
        }
    }

    /// The unit vector at a point of the plane.
    pub fn direction(&self, plane: DVec2) -> DVec3 {
        match self {
            Self::Azimuthal(projection) => projection.direction(plane),
            Self::PlateCarree { .. } => math::direction(plane.y, plane.x),
        }
    }
}

/// The meaning of a point of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Reflect)]
pub enum GridPoint {
    /// The centre of a pixel: the grid reaches half a step beyond its points.
    PixelCentre,
    /// A vertex: neighbouring grids share the points of their edges.
    Vertex,
}

/// A grid of points in rows from the north, or a window of one.
///
/// A window has the points of the whole grid to the last bit, so windows that share an edge share
/// its ground.
///
/// ```
/// use bevy_pangaea::query::{AzimuthalEquidistant, TileBlock};
///
/// let about = AzimuthalEquidistant::new(60.0, 20.0, 6_370_000.0)?;
/// let block = TileBlock::new(about, 60_000.0, 257, [2, 1])?;
/// let [west, east] = [block.tile(0, 0), block.tile(1, 0)];
/// assert_eq!(west.direction(256, 100), east.direction(0, 100));
/// # Ok::<(), bevy_pangaea::query::GroundError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(opaque, Clone, Debug, PartialEq)]
pub struct MapGrid {
    pub(super) projection: GridProjection,
    /// The middle of the whole grid in the plane.
    pub(super) middle: DVec2,
    /// From a point to the next one to the east and to the north.
    pub(super) step: DVec2,
    pub(super) point: GridPoint,
    /// Columns and rows of the whole grid.
    pub(super) whole: [usize; 2],
    /// The window's first column and row.
    pub(super) first: [usize; 2],
    /// Columns and rows of the window.
    pub(super) size: [usize; 2],
    pub(super) level: u8,
}

impl MapGrid {
    /// A whole grid about the centre of a projection, of points `step_m` apart in both directions.
    pub(super) fn about(
        projection: AzimuthalEquidistant,
        step_m: f64,
        point: GridPoint,
        size: [usize; 2],
        level: u8,
    ) -> Self {
        Self {
            projection: GridProjection::Azimuthal(projection),
            middle: DVec2::ZERO,
            step: DVec2::splat(step_m),
            point,
            whole: size,
            first: [0, 0],
            size,
            level,
        }
    }

    /// The projection.
    pub fn projection(&self) -> &GridProjection {
        &self.projection
    }

    /// From a point to the next one to the east and to the north, in m or degrees.
    pub fn step(&self) -> DVec2 {
        self.step
    }

    /// The meaning of its points.
    pub fn point_kind(&self) -> GridPoint {
        self.point
    }

    /// First column and row within the whole grid.
    pub fn first(&self) -> [usize; 2] {
        self.first
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.size[0]
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.size[1]
    }

    /// Level of detail of the ground.
    pub fn level(&self) -> u8 {
        self.level
    }

    /// The same at another level.
    ///
    /// # Errors
    /// [`GroundError::Level`] beyond the finest.
    pub fn at_level(self, level: u8) -> Result<Self, GroundError> {
        check_level(level)?;
        Ok(Self { level, ..self })
    }

    /// The whole grid, of which this may be a window.
    pub fn whole(self) -> Self {
        Self {
            first: [0, 0],
            size: self.whole,
            ..self
        }
    }

    /// The columns and rows from `first` on of the whole grid; `None` if they leave it.
    pub fn window(self, first: [usize; 2], size: [usize; 2]) -> Option<Self> {
        let fits = (0..2).all(|k| lies_within(first[k], size[k], self.whole[k]));
        fits.then_some(Self {
            first,
            size,
            ..self
        })
    }

    /// A point in the plane, in m or degrees; rows count from the north.
    pub fn plane(&self, column: usize, row: usize) -> DVec2 {
        self.plane_at([column as f64, row as f64])
    }

    /// The north western corner in the plane: the first vertex, or the corner of the first pixel.
    pub fn north_west(&self) -> DVec2 {
        match self.point {
            GridPoint::Vertex => self.plane_at([0.0, 0.0]),
            GridPoint::PixelCentre => self.plane_at([-0.5, -0.5]),
        }
    }

    /// The place of a column and a row, or of one between them.
    fn plane_at(&self, place: [f64; 2]) -> DVec2 {
        let [x, y] = [0, 1].map(|axis| {
            let last = self.whole[axis] as f64 - 1.0;
            self.first[axis] as f64 + place[axis] - 0.5 * last
        });
        self.middle + DVec2::new(x * self.step.x, -y * self.step.y)
    }

    /// The middle of the window in the plane.
    pub fn plane_middle(&self) -> DVec2 {
        let last = self.plane(self.columns() - 1, self.rows() - 1);
        0.5 * (self.plane(0, 0) + last)
    }

    /// Unit vector of a point, rows from the north.
    pub fn direction(&self, column: usize, row: usize) -> DVec3 {
        self.projection.direction(self.plane(column, row))
    }
}

/// Whether `size` places from `first` on, at least one, lie within `whole`.
fn lies_within(first: usize, size: usize, whole: usize) -> bool {
    let end = first.checked_add(size);
    size > 0 && end.is_some_and(|end| end <= whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> MapGrid {
        let about = AzimuthalEquidistant::new(10.0, 20.0, 1e6).unwrap();
        MapGrid {
            projection: GridProjection::Azimuthal(about),
            middle: DVec2::ZERO,
            step: DVec2::splat(100.0),
            point: GridPoint::Vertex,
            whole: [5, 3],
            first: [0, 0],
            size: [5, 3],
            level: 7,
        }
    }

    #[test]
    fn points_count_from_the_north_west() {
        assert_eq!(grid().plane(0, 0), DVec2::new(-200.0, 100.0));
        assert_eq!(grid().plane(4, 2), DVec2::new(200.0, -100.0));
        assert_eq!(grid().plane(2, 1), DVec2::ZERO);
    }

    #[test]
    fn corners_are_vertices_or_half_a_pixel_off() {
        assert_eq!(grid().north_west(), DVec2::new(-200.0, 100.0));
        let pixels = MapGrid {
            point: GridPoint::PixelCentre,
            ..grid()
        };
        assert_eq!(pixels.north_west(), DVec2::new(-250.0, 150.0));
    }

    #[test]
    fn windows_have_the_points_of_the_whole() {
        let window = grid().window([2, 1], [3, 2]).unwrap();
        assert_eq!([window.columns(), window.rows()], [3, 2]);
        assert_eq!(window.plane(0, 0), grid().plane(2, 1));
        assert_eq!(window.direction(2, 1), grid().direction(4, 2));
        assert_eq!(window.plane_middle(), DVec2::new(100.0, -50.0));
        assert_eq!(window.whole(), grid());
    }

    #[test]
    fn windows_that_leave_the_grid_are_none() {
        assert_eq!(grid().window([3, 0], [3, 1]), None);
        assert_eq!(grid().window([0, 0], [0, 1]), None);
        assert_eq!(grid().window([usize::MAX, 0], [2, 1]), None);
    }
}
