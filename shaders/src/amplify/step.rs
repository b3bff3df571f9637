//! One level of the subdivision: the passes in their order.
//!
//! Each reads columns and writes its own; in between all items of a pass are done. The lists of
//! edges and faces that take part are in the order of the level, so what is made is, too.

use super::count::{BLOCK, LevelCounts, count_edges, count_faces};
use super::edge_split::edge_split;
use super::face_decide::face_decide;
use super::face_split::{grow_faces, grow_halves, grow_inner};
use super::mark::{mark_halo, mark_split};
use super::place::{place_edges, place_faces};
use super::rules::EdgeKind;
use super::scan::scan;
use super::sight::Sight;
use super::topology::{Edge, Face, Items, Level, LevelMesh, NONE};
use super::uniform::LevelUniform;
use super::vertex_resolve::vertex_resolve;
use super::vertices::Vertices;
use std::sync::Arc;

/// Items that a level makes: its blocks' places, and the numbers of all.
pub struct LevelPlan {
    edges: Vec<LevelCounts>,
    faces: Vec<LevelCounts>,
    /// All that the level makes.
    pub total: LevelCounts,
}

/// Marks what is split of a level, and counts what that makes.
pub fn mark(sight: &Sight, index: u32, level: &mut Level, vertices: &Vertices) -> LevelPlan {
    let Level {
        mesh,
        items,
        edges,
        faces,
    } = level;
    mark_split(sight, index, mesh, vertices.view(), &items.faces, faces);
    mark_halo(mesh, &items.faces, faces);
    let edge_blocks = items.edges.chunks(BLOCK);
    let face_blocks = items.faces.chunks(BLOCK);
    let mut plan = LevelPlan {
        edges: edge_blocks
            .map(|block| count_edges(mesh, block, faces, edges))
            .collect(),
        faces: face_blocks.map(|block| count_faces(block, faces)).collect(),
        total: LevelCounts::default(),
    };
    plan.total = scan(&mut plan.edges).and(scan(&mut plan.faces));
    plan
}

/// Splits the marked faces of a level; returns the next level, and the edges that were halved in the
/// order of their new vertices, by which `vertices` grows. Without `edges` the next level has faces
/// alone, which a finest level needs no more than; its faces name the edges all the same.
pub fn grow(
    uniform: LevelUniform,
    plan: &LevelPlan,
    level: &mut Level,
    vertices: &mut Vertices,
    edges: bool,
) -> (Level, Vec<u32>) {
    let total = &plan.total;
    let [halved, decided] = place(plan, level, vertices.len() as u32);
    let (coarser, new) = vertices.append(total.mids as usize);
    edge_split(uniform, &level.mesh, coarser, &halved, new);
    let Level {
        mesh,
        edges: splits,
        faces,
        ..
    } = level;
    face_decide(uniform, mesh, splits, vertices.view(), &decided, faces);
    vertex_resolve(uniform, level, &halved, vertices);
    let mut finer = LevelMesh::default();
    if edges {
        let blank = Edge::new(EdgeKind::Terrain, [NONE; 2], [NONE; 2]);
        finer.edges = vec![blank; total.edges() as usize];
        let (view, finer) = (vertices.view(), &mut finer.edges);
        grow_halves(uniform, level, view, &halved, finer);
        grow_inner(uniform, level, view, &decided, total.halves, finer);
    }
    finer.faces = vec![Face::default(); total.children as usize];
    grow_faces(level, &decided, total.halves, &mut finer.faces);
    let items = Items::all(&finer);
    (Level::new(Arc::new(finer), items), halved)
}

/// Gives everything that a level makes its place; returns the edges that are halved and the faces
/// that decide.
fn place(plan: &LevelPlan, level: &mut Level, first_vertex: u32) -> [Vec<u32>; 2] {
    let LevelCounts { mids, decided, .. } = plan.total;
    let mut halved = vec![0; mids as usize];
    let mut decided = vec![0; decided as usize];
    for (block, &before) in level.items.edges.chunks(BLOCK).zip(&plan.edges) {
        place_edges(block, before, first_vertex, &mut level.edges, &mut halved);
    }
    for (block, &before) in level.items.faces.chunks(BLOCK).zip(&plan.faces) {
        place_faces(block, before, &mut level.faces, &mut decided);
    }
    [halved, decided]
}

#[cfg(test)]
#[path = "step_tests.rs"]
mod tests;
