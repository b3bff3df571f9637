//! Pass: leaf faces become triangles.
//!
//! A leaf beside finer ones has midpoints on one, two or three edges and becomes as many triangles
//! more, so that every interior edge is used exactly twice and none has a vertex inside.

use super::carve::Carved;
use super::ground::RefinedGround;
use super::topology::{Face, Level, NONE, SplitMark};
use super::vertex::Vertex;

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

/// Up to four triangles of a leaf face; returns how many.
pub fn emit(face: &Face, level: &Level, vertices: &[Vertex], out: &mut [[u32; 3]; 4]) -> usize {
    let v = face.vertices;
    let mid = face.edges.map(|e| match level.edges.get(e as usize) {
        Some(edge) if edge.mark == SplitMark::Split => edge.mid,
        _ => NONE,
    });
    let split = mid.map(|m| m != NONE);
    // The corner from which the fan starts.
    let Some(k) = (0..3)
        .find(|&k| split[k] && !split[(k + 2) % 3])
        .or(split[0].then_some(0))
    else {
        out[0] = v;
        return 1;
    };
    let at = |i: usize| (v[(k + i) % 3], mid[(k + i) % 3]);
    let ((a, ab), (b, bc), (c, ca)) = (at(0), at(1), at(2));
    match (split[(k + 1) % 3], split[(k + 2) % 3]) {
        (false, _) => {
            out[..2].copy_from_slice(&[[a, ab, c], [ab, b, c]]);
            2
        }
        (true, false) => {
            out[0] = [ab, b, bc];
            // The quadrilateral a, ab, bc, c is cut by the seeds, which no view changes.
            let seed = |v: u32| vertices[v as usize].seed;
            let cut = if seed(ab) > seed(bc) {
                [[a, ab, c], [ab, bc, c]]
            } else {
                [[a, ab, bc], [a, bc, c]]
            };
            out[1..3].copy_from_slice(&cut);
            3
        }
        (true, true) => {
            *out = [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]];
            4
        }
    }
}

impl RefinedGround {
    /// The triangles of all leaves, coarse levels first.
    pub fn triangles(&self) -> Vec<Triangle> {
        let mut triangles = Vec::new();
        for (index, level) in (0..).zip(&self.levels) {
            for (f, face) in (0..)
                .zip(&level.faces)
                .filter(|(_, f): &(u32, &Face)| f.mark != SplitMark::Split)
            {
                let mut out = [[0; 3]; 4];
                let made = emit(face, level, &self.vertices, &mut out);
                triangles.extend(out[..made].iter().map(|&vertices| Triangle {
                    vertices,
                    level: index,
                    face: f,
                }));
            }
        }
        triangles
    }
}

/// Pass `water`: the triangles of the water's surface, with the ground's topology. A triangle
/// belongs to it where any corner lies under water; its corners stand at [`Carved::water`], and at
/// the ground where they are dry.
pub fn water(triangles: &[Triangle], carved: &[Carved]) -> Vec<Triangle> {
    let wet = |v: u32| carved[v as usize].water > carved[v as usize].ground;
    triangles
        .iter()
        .filter(|t| t.vertices.into_iter().any(wet))
        .copied()
        .collect()
}
