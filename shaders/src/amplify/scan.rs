//! Pass: exclusive prefix sums over blocks, which give every block its place among what all make.
//!
//! On a GPU the same pass, one group of it, writes how large the next level is and how many groups
//! run over it: nothing is read back.

use super::count::{BLOCK, LevelCounts};
use super::rows::level::{GROUP, LevelArgs, LevelCaps, LevelSizes};

/// Replaces the counts of every block by those of all blocks before it; returns the sum of all.
pub fn scan(blocks: &mut [LevelCounts]) -> LevelCounts {
    let mut before = LevelCounts::default();
    for block in blocks {
        let counts = *block;
        *block = before;
        before = before.and(counts);
    }
    before
}

impl LevelSizes {
    /// Whether buffers hold what a level makes, and its leaves, which become so many triangles. Of
    /// what it makes all could be leaves. A level that makes more is not split: all its faces are
    /// leaves.
    pub const fn fits(&self, triangles: u32, caps: &LevelCaps) -> bool {
        let made = self.made;
        let all_triangles = self.first_triangle + triangles + made.children;
        self.first_vertex + made.mids <= caps.vertices
            && made.edges() <= caps.edges
            && made.children <= caps.faces
            && all_triangles <= caps.triangles
    }

    /// Sizes of the level after one that becomes so many triangles.
    pub const fn next(&self, triangles: u32) -> Self {
        Self {
            edges: self.made.edges(),
            faces: self.made.children,
            first_vertex: self.first_vertex + self.made.mids,
            first_triangle: self.first_triangle + triangles,
            made: LevelCounts {
                mids: 0,
                halves: 0,
                children: 0,
                decided: 0,
            },
        }
    }
}

impl LevelArgs {
    /// The groups of a level of some sizes.
    pub const fn new(sizes: &LevelSizes) -> Self {
        Self {
            faces: groups(sizes.faces, GROUP),
            edge_blocks: groups(sizes.edges, BLOCK),
            face_blocks: groups(sizes.faces, BLOCK),
            halved: groups(sizes.made.mids, GROUP),
            decided: groups(sizes.made.decided, GROUP),
            unused: 0,
        }
    }
}

/// Groups of a size that hold so many items.
const fn groups(items: u32, size: usize) -> [u32; 3] {
    [items.div_ceil(size as u32), 1, 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts([mids, halves]: [u32; 2]) -> LevelCounts {
        LevelCounts {
            mids,
            halves,
            ..LevelCounts::default()
        }
    }

    #[test]
    fn places_follow_one_another() {
        let mut blocks = [[2, 4], [0, 0], [1, 0], [4, 6]].map(counts);
        assert_eq!(scan(&mut blocks), counts([7, 10]));
        let wanted = [[0, 0], [2, 4], [2, 4], [3, 4]].map(counts);
        assert_eq!(blocks, wanted);
    }
}
