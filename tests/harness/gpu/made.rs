//! The passes that give what a level makes its place, and make it, as their Rust twins do them.

use super::columns::{Blocks, STALE, edge_joins, edge_states, face_corners, face_sides, stale};
use super::level::MarkedLevel;
use super::pass::PassCase;
use pangaea_shaders::amplify::count::BLOCK;
use pangaea_shaders::amplify::place::{place_edges, place_faces};
use pangaea_shaders::amplify::rows::{EdgeState, FaceCorners, FaceSides, words};
use pangaea_shaders::amplify::topology::{Edge, Face, Level};

impl<'a> MarkedLevel<'a> {
    pub(super) fn place_edges(&mut self, blocks: &Blocks, halved: &mut [u32]) -> PassCase<'a> {
        let before = edge_states(self.level).into_iter().map(|row| EdgeState {
            mid: STALE,
            child: STALE,
            ..row
        });
        let before = words(before);
        let first = self.sizes.first_vertex;
        let Level { items, edges, .. } = &mut *self.level;
        for (items, row) in items.edges.chunks(BLOCK).zip(&blocks.edges) {
            place_edges(items, row.made, first, edges, halved);
        }
        self.case(
            "place_edges",
            self.args().edge_blocks,
            [
                ("block_counts", blocks.words()),
                ("edge_states", before),
                ("halved", stale(halved.len())),
            ],
            [
                ("edge_states", words(edge_states(self.level))),
                ("halved", halved.to_vec()),
            ],
        )
    }

    pub(super) fn place_faces(&mut self, blocks: &Blocks, decided: &mut [u32]) -> PassCase<'a> {
        let mut before = face_corners(self.level);
        before.iter_mut().for_each(|row| row.child = STALE);
        let Level { items, faces, .. } = &mut *self.level;
        for (items, row) in items.faces.chunks(BLOCK).zip(&blocks.faces) {
            place_faces(items, row.made, faces, decided);
        }
        self.case(
            "place_faces",
            self.args().face_blocks,
            [
                ("block_counts", blocks.words()),
                ("face_sides", words(face_sides(self.level))),
                ("face_corners", words(before)),
                ("decided", stale(decided.len())),
            ],
            [
                ("face_corners", words(face_corners(self.level))),
                ("decided", decided.to_vec()),
            ],
        )
    }

    /// The inner edges of its split faces. `cores` are the rows of all vertices.
    pub(super) fn inner(&self, cores: Vec<u32>, decided: &[u32], inner: &[Edge]) -> PassCase<'a> {
        let halves = self.sizes.made.halves as usize;
        let level = &*self.level;
        let states = inner
            .iter()
            .map(|edge| EdgeState::from((edge, &Default::default())));
        let all = stale(4 * (halves + inner.len()));
        let after = |rows: Vec<u32>| [stale(4 * halves), rows].concat();
        self.case(
            "grow_inner",
            self.args().decided,
            [
                ("vertex_cores", cores),
                ("edge_joins", edge_joins(&level.mesh.edges)),
                ("edge_states", words(edge_states(level))),
                ("face_sides", words(face_sides(level))),
                ("face_corners", words(face_corners(level))),
                ("decided", decided.to_vec()),
                ("finer_edge_joins", all.clone()),
                ("finer_edge_states", all),
            ],
            [
                ("finer_edge_joins", after(edge_joins(inner))),
                ("finer_edge_states", after(words(states))),
            ],
        )
    }

    /// The children of its split faces.
    pub(super) fn children(&self, decided: &[u32], faces: &[Face]) -> PassCase<'a> {
        let level = &*self.level;
        let none = Default::default();
        let sides = faces.iter().map(|face| FaceSides::from((face, &none, 0)));
        let corners = faces.iter().map(|face| FaceCorners::from((face, &none)));
        self.case(
            "grow_faces",
            self.args().decided,
            [
                ("edge_joins", edge_joins(&level.mesh.edges)),
                ("edge_states", words(edge_states(level))),
                ("face_sides", words(face_sides(level))),
                ("face_corners", words(face_corners(level))),
                ("decided", decided.to_vec()),
                ("finer_face_sides", stale(4 * faces.len())),
                ("finer_face_corners", stale(4 * faces.len())),
            ],
            [
                ("finer_face_sides", words(sides)),
                ("finer_face_corners", words(corners)),
            ],
        )
    }
}
