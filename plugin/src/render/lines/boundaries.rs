//! Plate boundaries by kind, and the outline of the selected plate.
//!
//! A boundary runs through the middles of the edges whose ends belong to different plates, and
//! through the centres of triangles where three plates meet.

use super::ground::LineGround;
use super::list::{LineEnd, LineStyle, Lines};
use crate::overlay::palette::Rgba;
use crate::overlay::{BoundaryKind, Overlay, boundaries};
use crate::plate::PlateId;

/// Half width in pixels of a boundary.
const BOUNDARY_HALF_WIDTH: f32 = 1.1;

/// Colour of the outline of the selected plate.
pub(super) const OUTLINE: Rgba = [255, 255, 255, 255];
/// Its half width in pixels.
const OUTLINE_HALF_WIDTH: f32 = 2.0;

/// Adds the boundaries that the globe shows.
pub(super) fn add_boundaries(lines: &mut Lines, ground: &LineGround) {
    let map = BoundaryMap {
        ground,
        kinds: boundaries(ground.input),
    };
    for &triangle in ground.input.mesh.triangles() {
        map.add_triangle(lines, triangle);
    }
}

/// The planet, and the kind of boundary at each sample.
struct BoundaryMap<'a> {
    ground: &'a LineGround<'a>,
    kinds: Vec<BoundaryKind>,
}

impl BoundaryMap<'_> {
    fn plate(&self, i: u32) -> PlateId {
        self.ground.input.surface.plate[i as usize]
    }

    /// Adds the boundaries within a triangle.
    fn add_triangle(&self, lines: &mut Lines, [a, b, c]: [u32; 3]) {
        let crosses = |&(i, j): &(u32, u32)| self.plate(i) != self.plate(j);
        let crossed: Vec<_> = [(a, b), (b, c), (c, a)]
            .into_iter()
            .filter(crosses)
            .collect();
        match crossed[..] {
            [from, to] => {
                if let Some(style) = self.style(from) {
                    lines.add(self.middle(from), self.middle(to), style);
                }
            }
            // Three plates meet.
            [_, _, _] => {
                let centre = self.centre([a, b, c]);
                for &edge in &crossed {
                    if let Some(style) = self.style(edge) {
                        lines.add(self.middle(edge), centre, style);
                    }
                }
            }
            _ => {}
        }
    }

    /// How the boundary across an edge looks, if it is drawn.
    fn style(&self, (i, j): (u32, u32)) -> Option<LineStyle> {
        let globe = self.ground.globe;
        let is_outline = |plate| (self.plate(i) == plate) != (self.plate(j) == plate);
        if globe.selected.is_some_and(is_outline) {
            return Some(LineStyle {
                half_width: OUTLINE_HALF_WIDTH,
                color: OUTLINE,
            });
        }
        let all = globe.boundaries || globe.overlay == Overlay::Plates;
        let kind = [i, j]
            .map(|k| self.kinds[k as usize])
            .into_iter()
            .find(|&kind| kind != BoundaryKind::None)?;
        all.then(|| LineStyle {
            half_width: BOUNDARY_HALF_WIDTH,
            color: kind.color(),
        })
    }

    /// The middle of an edge.
    fn middle(&self, (i, j): (u32, u32)) -> LineEnd {
        let mesh = self.ground.input.mesh;
        LineEnd {
            direction: (mesh.point(i) + mesh.point(j)).normalize(),
            elevation: 0.5 * (self.ground.height(i) + self.ground.height(j)),
        }
    }

    /// The centre of a triangle.
    fn centre(&self, [a, b, c]: [u32; 3]) -> LineEnd {
        let mesh = self.ground.input.mesh;
        let height = |i| self.ground.height(i);
        LineEnd {
            direction: (mesh.point(a) + mesh.point(b) + mesh.point(c)).normalize(),
            elevation: (height(a) + height(b) + height(c)) / 3.0,
        }
    }
}
