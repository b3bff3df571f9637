//! Pass: the faces of the control mesh that a view reaches, compacted to level 0 of its ground.

use super::base::Base;
use super::mark::View;
use super::sparse::Numbers;
use super::topology::{Edge, Face, Level, NONE};
use super::vertex::Vertex;

/// Rings of faces kept around what is split, so that no edge that is split lacks a face.
const MARGIN: i32 = 8;

/// Level 0 of a view's ground: the vertices and the level.
pub fn cull(base: &Base, view: &View) -> (Vec<Vertex>, Level) {
    if view.horizon == i32::MAX && view.radius == i32::MAX {
        return (base.vertices.clone(), base.level.clone());
    }
    let edge = base.scale.edge.min(i32::MAX as u32 / 16) as i32;
    let reach = view
        .horizon
        .max(view.bound(&base.scale, 0))
        .saturating_add(edge * MARGIN);
    let ground = View {
        altitude: None,
        radius: 0,
        sides: [[0; 3]; 2],
        ..*view
    };
    let near = |face: &Face| {
        let corners = face.vertices.map(|v| &base.vertices[v as usize]);
        ground.distance(&base.scale, corners) < reach.saturating_add(view.radius)
    };
    // A small disc of faces is found by spreading from its middle, a great one by looking at all.
    let quarter = (base.scale.radius_m * 4).min(1 << 28) as i32;
    let kept = if reach.saturating_add(view.radius) < quarter {
        spread(base, base.locate(view.direction, None), near)
    } else {
        (0..)
            .zip(&base.level.faces)
            .filter(|(_, f)| near(f))
            .map(|(i, _)| i)
            .collect()
    };
    compact(base, &kept)
}

/// The faces that fulfil a condition and hang together with the first, in ascending order.
fn spread(base: &Base, first: u32, near: impl Fn(&Face) -> bool) -> Vec<u32> {
    let mut kept = vec![first];
    let mut seen = Numbers::from_iter([first]);
    let mut next = 0;
    while next < kept.len() {
        let face = &base.level.faces[kept[next] as usize];
        next += 1;
        for &f in face.vertices.iter().flat_map(|&v| base.faces_around(v)) {
            if seen.insert(f) && near(&base.level.faces[f as usize]) {
                kept.push(f);
            }
        }
    }
    kept.sort_unstable();
    kept
}

/// Some faces of the control mesh as a level of their own, in the given order.
pub fn compact(base: &Base, kept: &[u32]) -> (Vec<Vertex>, Level) {
    let faces = || kept.iter().map(|&f| &base.level.faces[f as usize]);
    let vertices = sorted(faces().flat_map(|f| f.vertices));
    let edges = sorted(faces().flat_map(|f| f.edges));
    let mut by_index: Vec<(u32, u32)> = kept.iter().copied().zip(0..).collect();
    by_index.sort_unstable();
    let place = |sorted: &[u32], i: u32| sorted.binary_search(&i).map_or(NONE, |p| p as u32);
    let face_place = |f: u32| {
        by_index
            .binary_search_by_key(&f, |p| p.0)
            .map_or(NONE, |p| by_index[p].1)
    };
    let level = Level {
        edges: edges
            .iter()
            .map(|&e| {
                let edge = &base.level.edges[e as usize];
                let ends = edge.vertices.map(|v| place(&vertices, v));
                Edge {
                    vertices: ends,
                    faces: edge.faces.map(face_place),
                    ..*edge
                }
            })
            .collect(),
        faces: kept
            .iter()
            .zip(faces())
            .map(|(&i, f)| {
                Face::new(
                    f.vertices.map(|v| place(&vertices, v)),
                    f.edges.map(|e| place(&edges, e)),
                    i,
                )
            })
            .collect(),
    };
    (
        vertices
            .iter()
            .map(|&v| base.vertices[v as usize])
            .collect(),
        level,
    )
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
            let near = |face: &Face| {
                let corners = face.vertices.map(|v| &base.vertices[v as usize]);
                view.distance(&base.scale, corners) < reach
            };
            let all: Vec<u32> = (0..)
                .zip(&base.level.faces)
                .filter(|(_, f)| near(f))
                .map(|(i, _)| i)
                .collect();
            assert_eq!(
                spread(&base, base.locate(direction, None), near),
                all,
                "{k}"
            );
        }
    }
}
