//! A whole run on the CPU, pass by pass, and each pass once more on the GPU.

use super::columns::{edge_states, face_corners, face_sides, face_splits, stale};
use super::level::MarkedLevel;
use super::pass::{PassCase, assert_pass};
use super::ruled::{VertexWords, make_vertices};
use pangaea_shaders::amplify::base::Base;
use pangaea_shaders::amplify::emit::emit_leaves;
use pangaea_shaders::amplify::face_split::{grow_faces, grow_halves, grow_inner};
use pangaea_shaders::amplify::ground::{Caps, refine};
use pangaea_shaders::amplify::mark::{View, mark_split};
use pangaea_shaders::amplify::rows::{LevelSizes, words};
use pangaea_shaders::amplify::rules::{EdgeKind, Rules};
use pangaea_shaders::amplify::sight::Sight;
use pangaea_shaders::amplify::topology::{Edge, Face, Items, Level, LevelMesh, NONE};
use pangaea_shaders::amplify::uniform::LevelUniform;
use pangaea_shaders::amplify::vertices::Vertices;
use std::sync::Arc;

/// A run over a planet, level by level.
struct Run<'a> {
    base: &'a Base,
    rules: &'a Rules,
    view: &'a View,
    sight: Sight,
    vertices: Vertices,
    /// Their rows.
    rows: VertexWords,
    /// Triangles of coarser levels.
    triangles: usize,
}

/// Asserts that every pass of every level of a run has its Rust twin's words. Returns the number of
/// levels, and of passes.
pub fn assert_run(base: &Base, rules: &Rules, view: &View) -> [usize; 2] {
    let mut passes = 0;
    let levels = each_pass(base, rules, view, &mut |case| {
        passes += 1;
        assert_pass(case);
    });
    [levels as usize, passes]
}

/// Runs over a planet on the CPU and hands on every pass of every level. Returns how many levels
/// there are.
pub fn each_pass(
    base: &Base,
    rules: &Rules,
    view: &View,
    check: &mut impl FnMut(&PassCase),
) -> u32 {
    let mut run = Run {
        base,
        rules,
        view,
        sight: Sight::new(&base.scale, view),
        vertices: Vertices::new(base.vertices.clone()),
        rows: VertexWords::default(),
        triangles: 0,
    };
    run.rows.add(&*base.vertices);
    // As a GPU runs: level 0 is whole.
    let mut next = Some(Level::new(base.level.clone(), Items::all(&base.level)));
    let mut levels = 0;
    while let Some(level) = next {
        next = run.level(levels, level, check);
        levels += 1;
    }
    let whole = refine(base, rules, view, &Caps::default());
    assert!(
        run.vertices == whole.vertices,
        "a run has the ground of its view"
    );
    assert_eq!(
        run.triangles,
        whole.triangles().len() + run.unseen(&whole.levels[0])
    );
    levels
}

impl Run<'_> {
    /// Faces of level 0 that a view does not reach: leaves that are not refined, nor drawn.
    fn unseen(&self, level: &Level) -> usize {
        level.mesh.faces.len() - level.items.faces.len()
    }

    /// Runs over a level; returns the next, if anything is split.
    fn level(
        &mut self,
        index: u32,
        mut level: Level,
        check: &mut impl FnMut(&PassCase),
    ) -> Option<Level> {
        let before = words(face_corners(&level));
        let cores = self.rows.cores.clone();
        let items = level.items.faces.clone();
        let view = self.vertices.view();
        mark_split(
            &self.sight,
            index,
            &level.mesh,
            view,
            &items,
            &mut level.faces,
        );
        let sizes = LevelSizes {
            edges: level.edges.len() as u32,
            faces: level.faces.len() as u32,
            first_vertex: self.vertices.len() as u32,
            first_triangle: self.triangles as u32,
            ..LevelSizes::default()
        };
        let sight = self.sight;
        let mut marked = MarkedLevel::new(&sight, *self.rules, index, sizes, &mut level);
        check(&marked.case(
            "mark_split",
            marked.args().faces,
            [
                ("vertex_cores", cores),
                ("face_corners", before),
                ("face_splits", stale(items.len())),
            ],
            [("face_splits", face_splits(marked.level))],
        ));
        let lists = marked.place(check);
        self.emitted_and_grown(&mut marked, lists, check)
    }

    /// The triangles of a level's leaves, and the next level.
    fn emitted_and_grown(
        &mut self,
        marked: &mut MarkedLevel<'_>,
        [halved, decided]: [Vec<u32>; 2],
        check: &mut impl FnMut(&PassCase),
    ) -> Option<Level> {
        let uniform = LevelUniform {
            scale: &self.base.scale,
            rules: self.rules,
            level: marked.index,
        };
        make_vertices(
            uniform,
            self.view,
            marked,
            [&halved, &decided],
            &mut self.vertices,
            &mut self.rows,
            check,
        );
        self.emit(marked, check);
        if marked.sizes.made.children == 0 {
            return None;
        }
        let finer = self.grow(uniform, marked, [&halved, &decided], check);
        let items = Items::all(&finer);
        Some(Level::new(Arc::new(finer), items))
    }

    fn emit(&mut self, marked: &MarkedLevel, check: &mut impl FnMut(&PassCase)) {
        let mut triangles = Vec::new();
        let level = &*marked.level;
        let view = self.vertices.view();
        emit_leaves(
            marked.index,
            level,
            view,
            &level.items.faces,
            &mut triangles,
        );
        let before = stale(3 * (self.triangles + triangles.len()));
        let mut after = stale(3 * self.triangles);
        after.extend(triangles.iter().flat_map(|triangle| triangle.vertices));
        self.triangles += triangles.len();
        check(&marked.case(
            "emit_leaves",
            marked.args().face_blocks,
            [
                ("vertex_cores", self.rows.cores.clone()),
                ("edge_states", words(edge_states(level))),
                ("face_sides", words(face_sides(level))),
                ("face_corners", words(face_corners(level))),
                ("block_counts", marked.blocks.clone()),
                ("triangles", before),
            ],
            [("triangles", after)],
        ));
    }

    /// The mesh of the next level.
    fn grow(
        &self,
        uniform: LevelUniform,
        marked: &MarkedLevel,
        [halved, decided]: [&[u32]; 2],
        check: &mut impl FnMut(&PassCase),
    ) -> LevelMesh {
        let made = marked.sizes.made;
        let blank = Edge::new(EdgeKind::Terrain, [NONE; 2], [NONE; 2]);
        let mut edges = vec![blank; made.edges() as usize];
        let level = &*marked.level;
        let view = self.vertices.view();
        grow_inner(uniform, level, view, decided, made.halves, &mut edges);
        check(&marked.inner(
            self.rows.cores.clone(),
            decided,
            &edges[made.halves as usize..],
        ));
        grow_halves(uniform, level, view, halved, &mut edges);
        check(&marked.halves(&self.rows, halved, &edges[..made.halves as usize]));
        let mut faces = vec![Face::default(); made.children as usize];
        grow_faces(level, decided, made.halves, &mut faces);
        check(&marked.children(decided, &faces));
        LevelMesh { edges, faces }
    }
}
