//! Pass: the faces of the control mesh that a view reaches, compacted to level 0 of its ground.

use super::base::Base;
use super::sight::Sight;
use super::sparse::Numbers;
use super::topology::{Edge, Face, Level, NONE, gather};
use super::vertex::Vertex;
use super::view::View;

/// Rings of faces kept around what is split, so that no edge that is split lacks a face.
const MARGIN: i32 = 8;

/// Level 0 of a view's ground: the vertices and the level.
pub fn cull(base: &Base, view: &View) -> (Vec<Vertex>, Level) {
    if view.horizon == i32::MAX && view.radius == i32::MAX {
        return (base.vertices.clone(), base.level.clone());
    }
    let reach = reach(base, view);
    // Along the ground from the view's centre: an altitude makes no distance less, and `reach` has
    // the radius.
    let ground = View {
        altitude: None,
        radius: 0,
        sides: [[0; 3]; 2],
        ..*view
    };
    let ground = Sight::new(&base.scale, &ground);
    let is_near = |face: &Face| is_within(base, &ground, face, reach);
    // A small disc of faces is found by flooding from its middle, a great one by looking at all. It
    // is small up to a quarter of the radius, in sixteenths of a metre.
    let quarter = (base.scale.radius_m * 4).min(1 << 28) as i32;
    let kept = if reach < quarter {
        flood(base, base.locate(view.direction, None), is_near)
    } else {
        all(base, is_near)
    };
    compact(base, &kept)
}

/// Whether a face is nearer to a view than `reach`, sixteenths of a metre.
fn is_within(base: &Base, ground: &Sight, face: &Face, reach: i32) -> bool {
    ground.distance(gather(&base.vertices, face.vertices)) < reach
}

/// Distance from a view's centre within which faces are kept, sixteenths of a metre.
fn reach(base: &Base, view: &View) -> i32 {
    let edge = base.scale.edge.min(i32::MAX as u32 / 16) as i32;
    Sight::new(&base.scale, view)
        .reach()
        .saturating_add(edge * MARGIN)
}

/// The faces that fulfil a condition, in ascending order.
fn all(base: &Base, is_near: impl Fn(&Face) -> bool) -> Vec<u32> {
    let faces = (0..).zip(&base.level.faces);
    faces.filter(|(_, f)| is_near(f)).map(|(i, _)| i).collect()
}

/// The faces that fulfil a condition and hang together with the first, in ascending order.
fn flood(base: &Base, first: u32, is_near: impl Fn(&Face) -> bool) -> Vec<u32> {
    let mut kept = vec![first];
    // Across corners, not edges alone: a disc of faces hangs together by them.
    let mut seen = Numbers::from_iter([first]);
    let mut next = 0;
    while next < kept.len() {
        let face = &base.level.faces[kept[next] as usize];
        next += 1;
        for &f in face.vertices.iter().flat_map(|&v| base.faces_around(v)) {
            // What is refused counts as seen too, so each face is measured once.
            if seen.insert(f) && is_near(&base.level.faces[f as usize]) {
                kept.push(f);
            }
        }
    }
    kept.sort_unstable();
    kept
}

/// Some faces of the control mesh as a level of their own, in the given order.
pub fn compact(base: &Base, kept: &[u32]) -> (Vec<Vertex>, Level) {
    let places = Kept::new(base, kept);
    let edges = places.edges.iter().map(|&e| places.edge(base, e));
    let faces = kept.iter().map(|&f| places.face(base, f));
    let level = Level {
        edges: edges.collect(),
        faces: faces.collect(),
    };
    let vertices = places.vertices.iter().map(|&v| base.vertices[v as usize]);
    (vertices.collect(), level)
}

/// Items of the control mesh that are kept, by their numbers there, in ascending order.
struct Kept {
    vertices: Vec<u32>,
    edges: Vec<u32>,
    /// Faces of the control mesh, each with its place in the list that the caller gave.
    faces: Vec<(u32, u32)>,
}

impl Kept {
    fn new(base: &Base, kept: &[u32]) -> Self {
        let from = || kept.iter().map(|&f| &base.level.faces[f as usize]);
        let mut faces: Vec<(u32, u32)> = kept.iter().copied().zip(0..).collect();
        faces.sort_unstable();
        Self {
            vertices: sorted(from().flat_map(|f| f.vertices)),
            edges: sorted(from().flat_map(|f| f.edges)),
            faces,
        }
    }

    /// An edge of the control mesh as an edge of the kept part.
    fn edge(&self, base: &Base, edge: u32) -> Edge {
        let edge = &base.level.edges[edge as usize];
        Edge {
            vertices: edge.vertices.map(|v| place(&self.vertices, v)),
            // Beyond the rim of what is kept an edge has no face.
            faces: edge.faces.map(|f| self.face_place(f)),
            ..*edge
        }
    }

    /// A face of the control mesh as a face of the kept part.
    fn face(&self, base: &Base, face: u32) -> Face {
        let from = &base.level.faces[face as usize];
        let vertices = from.vertices.map(|v| place(&self.vertices, v));
        let edges = from.edges.map(|e| place(&self.edges, e));
        Face::new(vertices, edges, face)
    }

    fn face_place(&self, face: u32) -> u32 {
        let found = self.faces.binary_search_by_key(&face, |p| p.0);
        found.map_or(NONE, |p| self.faces[p].1)
    }
}

/// The place of an item in a sorted list; [`NONE`] for an item that is not in it.
fn place(sorted: &[u32], item: u32) -> u32 {
    sorted.binary_search(&item).map_or(NONE, |p| p as u32)
}

fn sorted(items: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut items: Vec<u32> = items.collect();
    items.sort_unstable();
    items.dedup();
    items
}

#[cfg(test)]
mod tests {
    use super::super::seed::{pcg, share};
    use super::super::synthetic::control_mesh;
    use super::*;

    #[test]
    fn a_small_disc_has_the_faces_that_looking_at_all_finds() {
        let base = Base::new(&control_mesh(6_371_000, 5, 3)).unwrap();
        for k in 0..60 {
            let at = base.vertices[pcg(k) as usize % base.vertices.len()].direction;
            let direction = [0, 1, 2].map(|i| at[i as usize] + (share(pcg(k), i) - 32_768) * 300);
            let reach = 3_000_000 + (k as i32) * 300_000;
            let view = View {
                radius: 0,
                ..View::disc(direction, 1, 17)
            };
            let view = Sight::new(&base.scale, &view);
            let is_near = |face: &Face| is_within(&base, &view, face, reach);
            let found = flood(&base, base.locate(direction, None), is_near);
            assert_eq!(found, all(&base, is_near), "{k}");
        }
    }
}
