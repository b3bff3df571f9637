//! The edges and faces of the control mesh that a view reaches: what the passes of level 0 run over.
//!
//! It spares the CPU half a million looks at faces beyond the horizon. Nothing is renumbered, so it
//! changes no place of what a level makes: a pass over all faces gives the same ground.

use super::base::Base;
use super::sight::Sight;
use super::sparse::Numbers;
use super::topology::{Face, Items, gather};
use super::view::View;

/// Rings of faces kept around what is split, so that no edge that is split lacks a face.
const MARGIN: i32 = 8;

/// Numbers of the edges and faces of the control mesh that a view reaches.
pub fn items(base: &Base, view: &View) -> Items {
    if view.horizon == i32::MAX && view.radius == i32::MAX {
        return Items::all(&base.level);
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
    let faces = if reach < quarter {
        flood(base, base.locate(view.direction, None), is_near)
    } else {
        all(base, is_near)
    };
    let edges = edges_of(base, &faces);
    Items { edges, faces }
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

/// The edges of some faces, in ascending order.
fn edges_of(base: &Base, faces: &[u32]) -> Vec<u32> {
    let edges = faces
        .iter()
        .flat_map(|&f| base.level.faces[f as usize].edges);
    let mut edges: Vec<u32> = edges.collect();
    edges.sort_unstable();
    edges.dedup();
    edges
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
