//! The items of a pass may be done in any order.

use super::*;
use crate::amplify::base::Base;
use crate::amplify::ground::{Caps, refine};
use crate::amplify::mark::View;
use crate::amplify::seed::pcg;
use crate::amplify::synthetic::control_mesh;

/// The numbers below `count` in a random order.
fn shuffled(count: usize, seed: u32) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    order.sort_unstable_by_key(|&i| pcg(pcg(i) ^ seed));
    order
}

/// Does the items of every pass of a level in a random order.
fn redo(passes: &LevelPasses, level: &Level, vertices: &mut [Vertex]) {
    let edges = shuffled(level.edges.len(), passes.index);
    for &i in &edges {
        let edge = &level.edges[i as usize];
        if edge.mark != SplitMark::Leaf {
            vertices[edge.mid as usize] = passes.split_edge(level, vertices, i);
        }
    }
    for f in shuffled(level.faces.len(), passes.index) {
        let face = &level.faces[f as usize];
        if face.mark != SplitMark::Leaf && passes.index < STRAIGHT_LEVEL {
            assert_eq!(passes.decide_face(level, vertices, f), face.inner);
        }
    }
    for &i in &edges {
        let edge = &level.edges[i as usize];
        if edge.mark == SplitMark::Split {
            let settled = passes.resolve_vertex(level, vertices, i);
            settled.write(&mut vertices[edge.mid as usize]);
        }
    }
}

/// An edge as it was made, before its own level split it.
fn new_edge(edge: &Edge) -> Edge {
    Edge {
        birth: edge.birth,
        arriving: edge.arriving,
        ..Edge::new(edge.kind, edge.vertices, edge.faces)
    }
}

/// A face as it was made, before its own level split it.
fn new_face(face: &Face) -> Face {
    Face::new(face.vertices, face.edges, face.parent)
}

/// Makes the children of the edges and faces of a level in a random order.
fn redo_children(passes: &LevelPasses, [level, next]: [&Level; 2], vertices: &[Vertex]) {
    let is_split = |e: &&Edge| e.mark == SplitMark::Split;
    let halves = 2 * level.edges.iter().filter(is_split).count() as u32;
    for i in shuffled(level.edges.len(), passes.index) {
        let edge = &level.edges[i as usize];
        if edge.mark == SplitMark::Split {
            let want = [0, 1].map(|slot| new_edge(&next.edges[edge.child as usize + slot]));
            let made = face_split::halve(passes.rules, passes.index, edge, &level.faces, vertices);
            assert_eq!(made, want);
        }
    }
    for f in shuffled(level.faces.len(), passes.index) {
        let face = &level.faces[f as usize];
        if face.mark != SplitMark::Split {
            continue;
        }
        let inner = halves + face.child / 4 * 3;
        let want = [0, 1, 2, 3].map(|k| new_face(&next.faces[face.child as usize + k]));
        assert_eq!(face_split::quarter(face, f, inner, &level.edges), want);
        for k in 0..3 {
            let made = face_split::inner_edge(face, passes.index, k, &level.edges, vertices);
            assert_eq!(made, new_edge(&next.edges[inner as usize + k]));
        }
    }
}

#[test]
fn items_are_done_in_any_order() {
    let base = Base::new(&control_mesh(300_000, 3, 7)).unwrap();
    let rules = Rules::default();
    let river = base.vertices.iter().find(|v| v.is_wet()).unwrap();
    let view = View::disc(river.direction, 2_000, 13);
    let want = refine(&base, &rules, &view, &Caps::default());
    let mut vertices = want.vertices.clone();
    for (index, level) in (0..).zip(&want.levels) {
        let passes = LevelPasses {
            scale: &base.scale,
            rules: &rules,
            index,
        };
        redo(&passes, level, &mut vertices);
        if let Some(next) = want.levels.get(index as usize + 1) {
            redo_children(&passes, [level, next], &vertices);
        }
    }
    assert!(vertices.len() > 10_000 && vertices == want.vertices);
}
