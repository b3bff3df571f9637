//! Pass: leaf faces become triangles.
//!
//! A leaf beside finer ones has midpoints on one, two or three edges and becomes as many triangles
//! more, so that every interior edge is used exactly twice and none has a vertex inside.

use super::carve::{Carved, sheet};
use super::control::VertexKind;
use super::geometry::least_areas;
use super::ground::RefinedGround;
use super::rules::Rules;
use super::rules::valley::Reach;
use super::scale::PlanetScale;
use super::topology::{Level, NONE, SplitMark};
use super::vertex::Vertex;
use super::vertices::VertexView;

/// A triangle of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Triangle {
    /// Its corners, counter-clockwise from outside; indices into [`RefinedGround::vertices`].
    pub vertices: [u32; 3],
    /// The level of its leaf.
    pub level: u32,
    /// The leaf.
    pub face: u32,
}

/// Up to four triangles of a level's leaf; returns how many.
pub fn emit(level: &Level, leaf: u32, vertices: VertexView, out: &mut [[u32; 3]; 4]) -> usize {
    let face = &level.mesh.faces[leaf as usize];
    let mid = face.edges.map(|e| match level.edges.get(e as usize) {
        // Edges of the halo have a middle too, but no triangle ends there.
        Some(edge) if edge.mark == SplitMark::Split => edge.mid,
        _ => NONE,
    });
    let split = mid.map(|m| m != NONE);
    let turned = Turned::new(face.vertices, mid, first_split(split));
    match split.into_iter().filter(|&s| s).count() {
        // Every pattern of split edges is one of four after turning the face.
        0 => {
            out[0] = face.vertices;
            1
        }
        1 => {
            out[..2].copy_from_slice(&turned.halves());
            2
        }
        2 => {
            out[..3].copy_from_slice(&turned.thirds(vertices));
            3
        }
        _ => {
            *out = turned.quarters();
            4
        }
    }
}

/// The first of the split edges, which follow one another: the edge before it is whole. 0 where
/// all three edges are split, or none is.
fn first_split(split: [bool; 3]) -> usize {
    (0..3)
        .find(|&k| split[k] && !split[(k + 2) % 3])
        .unwrap_or(0)
}

/// A face turned so that its first split edge is ab.
struct Turned {
    corners: [u32; 3],
    /// Middles of ab, bc, ca; [`NONE`] where an edge is whole.
    mids: [u32; 3],
}

impl Turned {
    fn new(corners: [u32; 3], mids: [u32; 3], first: usize) -> Self {
        Self {
            corners: [0, 1, 2].map(|i| corners[(first + i) % 3]),
            mids: [0, 1, 2].map(|i| mids[(first + i) % 3]),
        }
    }

    /// The triangles where ab alone is split.
    fn halves(&self) -> [[u32; 3]; 2] {
        let ([a, b, c], ab) = (self.corners, self.mids[0]);
        [[a, ab, c], [ab, b, c]]
    }

    /// The triangles where ab and bc are split. The quadrilateral a, ab, bc, c is cut so that the
    /// lesser of its triangles is as large as can be, which no view changes: along one diagonal a
    /// middle that was moved sideways may turn a triangle over, along both it cannot.
    fn thirds(&self, vertices: VertexView) -> [[u32; 3]; 3] {
        let ([a, b, c], [ab, bc, _]) = (self.corners, self.mids);
        let corners = vertices.gather([a, ab, bc, c]);
        let [by_a, by_c] = least_areas(corners.map(|v| v.direction));
        // Seeds, not indices: those hang on the view.
        let is_drawn = corners[1].seed > corners[2].seed;
        if by_c > by_a || (by_c == by_a && is_drawn) {
            [[ab, b, bc], [a, ab, c], [ab, bc, c]]
        } else {
            [[ab, b, bc], [a, ab, bc], [a, bc, c]]
        }
    }

    /// The triangles where all edges are split.
    fn quarters(&self) -> [[u32; 3]; 4] {
        let ([a, b, c], [ab, bc, ca]) = (self.corners, self.mids);
        [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
    }
}

impl RefinedGround {
    /// The triangles of all leaves, coarse levels first.
    pub fn triangles(&self) -> Vec<Triangle> {
        let mut triangles = Vec::new();
        for (index, level) in (0..).zip(&self.levels) {
            emit_leaves(
                index,
                level,
                self.vertices.view(),
                &level.items.faces,
                &mut triangles,
            );
        }
        triangles
    }
}

/// Pass: the triangles of the leaves among some faces of a level.
pub fn emit_leaves(
    index: u32,
    level: &Level,
    vertices: VertexView,
    items: &[u32],
    triangles: &mut Vec<Triangle>,
) {
    let is_leaf = |f: &&u32| level.faces[**f as usize].mark != SplitMark::Split;
    for &face in items.iter().filter(is_leaf) {
        let mut out = [[0; 3]; 4];
        let made = emit(level, face, vertices, &mut out);
        triangles.extend(out[..made].iter().map(|&vertices| Triangle {
            vertices,
            level: index,
            face,
        }));
    }
}

/// A triangle of the water's surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WaterTriangle {
    /// The triangle of the ground below it.
    pub ground: Triangle,
    /// Heights of the surface over its corners, grains.
    pub water: [i32; 3],
}

/// Pass `water`: the triangles of the water's surface, with the ground's topology. A triangle
/// belongs to it where any corner lies under water.
///
/// A river that is narrower than a triangle's edges is left out: a single wet corner would make
/// it as wide as the edges are long. The surface is the depth test's to clip: it goes on under the
/// banks.
pub fn water(
    ground: &RefinedGround,
    rules: &Rules,
    triangles: &[Triangle],
    carved: &[Carved],
) -> Vec<WaterTriangle> {
    let surfaces = triangles.iter().filter_map(|&triangle| {
        let water = sheet(resolved(ground, rules, &triangle, carved))?;
        let ground = triangle;
        Some(WaterTriangle { ground, water })
    });
    surfaces.collect()
}

/// The corners of a triangle, dry where its edges do not resolve their water.
fn resolved(
    ground: &RefinedGround,
    rules: &Rules,
    triangle: &Triangle,
    carved: &[Carved],
) -> [Carved; 3] {
    triangle.vertices.map(|v| {
        let vertex = &ground.vertices[v as usize];
        let corner = carved[v as usize];
        if is_resolved(&ground.scale, rules, vertex, triangle.level) {
            corner
        } else {
            Carved::dry(corner.ground)
        }
    })
}

/// Whether the water of a vertex is wider than the edges of a level.
pub fn is_resolved(scale: &PlanetScale, rules: &Rules, vertex: &Vertex, level: u32) -> bool {
    let stands = matches!(vertex.kind, VertexKind::Lake | VertexKind::Sea);
    stands || 2 * Reach::of(scale, rules, vertex).half_bed >= scale.edge_grains(level)
}

#[cfg(test)]
#[path = "emit_tests.rs"]
mod tests;
