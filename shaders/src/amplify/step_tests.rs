//! The items of a pass may be done in any order.

use super::*;
use crate::amplify::base::Base;
use crate::amplify::ground::{Caps, refine};
use crate::amplify::mark::View;
use crate::amplify::rules::Rules;
use crate::amplify::seed::pcg;
use crate::amplify::synthetic::control_mesh;

/// The numbers below `count` in a random order.
fn shuffled(count: usize, seed: u32) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    order.sort_unstable_by_key(|&i| pcg(pcg(i) ^ seed));
    order
}

/// A pass as it runs, but on single items in a random order.
fn one_by_one(items: &[u32], seed: u32, mut pass: impl FnMut(usize, &[u32])) {
    for i in shuffled(items.len(), seed) {
        let i = i as usize;
        pass(i, &items[i..=i]);
    }
}

/// Blocks in a random order, each with its items and what the blocks before it make.
fn blocks_one_by_one(
    items: &[u32],
    before: &[LevelCounts],
    mut pass: impl FnMut(&[u32], LevelCounts),
) {
    for i in shuffled(before.len(), 5) {
        let start = i as usize * BLOCK;
        let end = items.len().min(start + BLOCK);
        pass(&items[start..end], before[i as usize]);
    }
}

/// The lists and places of a level, block by block in a random order.
fn placed_again(plan: &LevelPlan, level: &mut Level, first_vertex: u32) -> [Vec<u32>; 2] {
    let Level {
        items,
        edges,
        faces,
        ..
    } = level;
    let mut halved = vec![0; plan.total.mids as usize];
    let mut decided = vec![0; plan.total.decided as usize];
    blocks_one_by_one(&items.edges, &plan.edges, |block, before| {
        place_edges(block, before, first_vertex, edges, &mut halved);
    });
    blocks_one_by_one(&items.faces, &plan.faces, |block, before| {
        place_faces(block, before, faces, &mut decided);
    });
    [halved, decided]
}

/// Grows a level by single items in random orders; `vertices` are those of coarser levels.
fn grown_again(
    uniform: LevelUniform,
    plan: &LevelPlan,
    level: &mut Level,
    vertices: &mut Vertices,
) -> LevelMesh {
    let total = &plan.total;
    let [halved, decided] = placed_again(plan, level, vertices.len() as u32);
    let (coarser, new) = vertices.append(total.mids as usize);
    one_by_one(&halved, 1, |i, e| {
        edge_split(uniform, &level.mesh, coarser, e, &mut new[i..=i]);
    });
    let view = vertices.view();
    one_by_one(&decided, 2, |_, f| {
        face_decide(
            uniform,
            &level.mesh,
            &level.edges,
            view,
            f,
            &mut level.faces,
        );
    });
    one_by_one(&halved, 3, |_, e| {
        vertex_resolve(uniform, level, e, vertices)
    });
    finer_again(uniform, total, level, vertices, [&halved, &decided])
}

/// The mesh of the next level, by single items in random orders.
fn finer_again(
    uniform: LevelUniform,
    total: &LevelCounts,
    level: &Level,
    vertices: &Vertices,
    [halved, decided]: [&[u32]; 2],
) -> LevelMesh {
    let blank = Edge::new(EdgeKind::Terrain, [NONE; 2], [NONE; 2]);
    let mut edges = vec![blank; total.edges() as usize];
    let mut faces = vec![Face::default(); total.children as usize];
    let view = vertices.view();
    one_by_one(halved, 4, |_, e| {
        grow_halves(uniform, level, view, e, &mut edges)
    });
    one_by_one(decided, 5, |_, f| {
        grow_inner(uniform, level, view, f, total.halves, &mut edges);
        grow_faces(level, f, total.halves, &mut faces);
    });
    LevelMesh { edges, faces }
}

/// Every pass of every level on single items, and blocks, in a random order; level 0 over the whole
/// planet instead of what the view reaches.
#[test]
fn items_are_done_in_any_order() {
    let base = Base::new(&control_mesh(300_000, 3, 7)).unwrap();
    let rules = Rules::default();
    let river = base.vertices.iter().find(|v| v.is_wet()).unwrap();
    let view = View::disc(river.direction, 2_000, 13);
    let want = refine(&base, &rules, &view, &Caps::default());
    let sight = Sight::new(&base.scale, &view);
    let mut vertices = Vertices::new(base.vertices.clone());
    let mut level = Level::new(base.level.clone(), Items::all(&base.level));
    for (index, next) in (0..).zip(&want.levels[1..]) {
        let uniform = LevelUniform {
            scale: &base.scale,
            rules: &rules,
            level: index,
        };
        let plan = mark(&sight, index, &mut level, &vertices);
        let mesh = grown_again(uniform, &plan, &mut level, &mut vertices);
        let done = &want.levels[index as usize];
        assert!(level.edges == done.edges && level.faces == done.faces);
        assert_eq!(mesh, *next.mesh);
        let items = Items::all(&mesh);
        level = Level::new(Arc::new(mesh), items);
    }
    assert!(vertices.len() > 10_000 && vertices == want.vertices);
}
