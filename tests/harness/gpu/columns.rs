//! The columns of a level on the CPU, as words of their rows.

use pangaea_shaders::amplify::count::{BLOCK, LevelCounts};
use pangaea_shaders::amplify::rows::{
    BlockCounts, EdgeJoins, EdgeState, FaceCorners, FaceSides, LevelSizes, from_words, words,
};
use pangaea_shaders::amplify::scan::scan;
use pangaea_shaders::amplify::topology::{Edge, Face, FaceSplit, Level, LevelMesh, SplitMark};

/// A word that no pass writes: what was left in a buffer.
pub(super) const STALE: u32 = 0xa5a5_a5a5;

/// Stale words.
pub(super) fn stale(count: usize) -> Vec<u32> {
    vec![STALE; count]
}

/// 1 for faces that are split.
pub(super) fn face_splits(level: &Level) -> Vec<u32> {
    let split = |face: &FaceSplit| u32::from(face.mark == SplitMark::Split);
    level.faces.iter().map(split).collect()
}

/// How many faces beside a face that is not split are.
pub(super) fn finer(mesh: &LevelMesh, f: u32, faces: &[FaceSplit]) -> u32 {
    if faces[f as usize].mark == SplitMark::Split {
        return 0;
    }
    let beyond = |&e: &u32| mesh.edges[e as usize].beyond(f);
    let around = mesh.faces[f as usize].edges;
    let around = around
        .iter()
        .map(beyond)
        .filter_map(|f| faces.get(f as usize));
    around.filter(|face| face.mark == SplitMark::Split).count() as u32
}

/// Rows of the edges' ends and faces.
pub(super) fn edge_joins(edges: &[Edge]) -> Vec<u32> {
    words(edges.iter().map(EdgeJoins::from))
}

/// Rows of the edges' states.
pub(super) fn edge_states(level: &Level) -> Vec<EdgeState> {
    let edges = level.mesh.edges.iter().zip(&level.edges);
    edges.map(EdgeState::from).collect()
}

/// Rows of the faces' edges and marks.
pub(super) fn face_sides(level: &Level) -> Vec<FaceSides> {
    let faces = (0..).zip(level.mesh.faces.iter().zip(&level.faces));
    let sides = |(f, (face, split)): (u32, (&Face, &FaceSplit))| {
        FaceSides::from((face, split, finer(&level.mesh, f, &level.faces)))
    };
    faces.map(sides).collect()
}

/// Rows of the faces' corners and children.
pub(super) fn face_corners(level: &Level) -> Vec<FaceCorners> {
    let faces = level.mesh.faces.iter().zip(&level.faces);
    faces.map(FaceCorners::from).collect()
}

/// Sizes that were left in a buffer.
pub(super) fn stale_sizes() -> LevelSizes {
    from_words(&stale(8))[0]
}

/// The row of a block that makes so much.
pub(super) fn block(made: LevelCounts, triangles: u32) -> BlockCounts {
    BlockCounts {
        made,
        triangles,
        unused: [0; 3],
    }
}

/// Rows of the blocks of a level.
pub(super) struct Blocks {
    /// Of its edges.
    pub(super) edges: Vec<BlockCounts>,
    /// Of its faces.
    pub(super) faces: Vec<BlockCounts>,
}

impl Blocks {
    /// Stale rows.
    pub(super) fn new(level: &Level) -> Self {
        let [edges, faces] = [level.edges.len(), level.faces.len()].map(|items| {
            let blocks = items.div_ceil(BLOCK);
            from_words(&stale(8 * blocks))
        });
        Self { edges, faces }
    }

    /// Their words, those of the edges first.
    pub(super) fn words(&self) -> Vec<u32> {
        words(self.edges.iter().chain(&self.faces).copied())
    }

    /// Replaces what blocks make by what those before them make; returns what all make, and their
    /// triangles.
    pub(super) fn scan(&mut self) -> (LevelCounts, u32) {
        let all = self.edges.iter_mut().chain(&mut self.faces);
        let mut all: Vec<&mut BlockCounts> = all.collect();
        let mut made: Vec<LevelCounts> = all.iter().map(|row| row.made).collect();
        let total = scan(&mut made);
        let mut triangles = 0;
        for (row, made) in all.iter_mut().zip(made) {
            row.made = made;
            triangles += std::mem::replace(&mut row.triangles, triangles);
        }
        (total, triangles)
    }
}
