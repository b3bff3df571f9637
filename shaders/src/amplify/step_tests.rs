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
    }
    assert!(vertices.len() > 10_000 && vertices == want.vertices);
}
