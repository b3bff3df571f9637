//! The passes that mark and count a level, as their Rust twins do them.
//!
//! Every word that a pass writes is stale before it, so that nothing hangs on a buffer that someone
//! emptied.

use super::columns::{
    Blocks, STALE, block, edge_joins, edge_states, face_sides, face_splits, finer, stale,
    stale_sizes,
};
use super::pass::{ColumnWords, PassCase};
use pangaea_shaders::amplify::columns::LEVELS;
use pangaea_shaders::amplify::count::{BLOCK, count_edges, count_faces};
use pangaea_shaders::amplify::mark::mark_halo;
use pangaea_shaders::amplify::rows::{EdgeState, LevelArgs, LevelSizes, words};
use pangaea_shaders::amplify::rules::Rules;
use pangaea_shaders::amplify::sight::Sight;
use pangaea_shaders::amplify::topology::{Level, SplitMark};

/// A level whose split faces are marked, to be marked further, counted and placed.
pub struct MarkedLevel<'a> {
    /// The view.
    pub sight: &'a Sight,
    /// The rules.
    pub rules: Rules,
    /// Its number.
    pub index: u32,
    /// Its sizes, as the level before wrote them.
    pub sizes: LevelSizes,
    /// The level.
    pub level: &'a mut Level,
    /// Words of its blocks after the scan.
    pub blocks: Vec<u32>,
}

impl<'a> MarkedLevel<'a> {
    /// A level of some sizes, of which nothing is known.
    pub const fn new(
        sight: &'a Sight,
        rules: Rules,
        index: u32,
        sizes: LevelSizes,
        level: &'a mut Level,
    ) -> Self {
        Self {
            sight,
            rules,
            index,
            sizes,
            level,
            blocks: Vec::new(),
        }
    }

    /// A pass over it that runs with so many groups.
    pub fn case<const N: usize, const M: usize>(
        &self,
        entry: &'static str,
        groups: [u32; 3],
        before: [(&'static str, Vec<u32>); N],
        after: [(&'static str, Vec<u32>); M],
    ) -> PassCase<'a> {
        PassCase {
            entry,
            sight: self.sight,
            rules: self.rules,
            level: self.index,
            sizes: self.sizes,
            groups: groups[0],
            before: ColumnWords::from(before),
            after: ColumnWords::from(after),
        }
    }

    /// Groups that its passes run with.
    pub fn args(&self) -> LevelArgs {
        LevelArgs::new(&self.sizes)
    }

    /// Marks, counts and places it; `check` is given each pass. Returns the edges that are halved,
    /// the faces that decide, and the sizes of the next level.
    pub fn place(&mut self, check: &mut impl FnMut(&PassCase)) -> [Vec<u32>; 2] {
        check(&self.halo());
        let mut blocks = Blocks::new(self.level);
        check(&self.count_edges(&mut blocks));
        check(&self.count_faces(&mut blocks));
        check(&self.scan(&mut blocks));
        self.blocks = blocks.words();
        let made = self.sizes.made;
        let [mut halved, mut decided] = [made.mids, made.decided].map(|n| vec![0; n as usize]);
        check(&self.place_edges(&blocks, &mut halved));
        check(&self.place_faces(&blocks, &mut decided));
        [halved, decided]
    }

    fn halo(&mut self) -> PassCase<'a> {
        let splits = face_splits(self.level);
        let mut before = face_sides(self.level);
        before.iter_mut().for_each(|row| row.marks = STALE);
        let Level {
            mesh, items, faces, ..
        } = &mut *self.level;
        mark_halo(mesh, &items.faces, faces);
        let joins = edge_joins(&self.level.mesh.edges);
        self.case(
            "mark_halo",
            self.args().faces,
            [
                ("face_splits", splits),
                ("edge_joins", joins),
                ("face_sides", words(before)),
            ],
            [("face_sides", words(face_sides(self.level)))],
        )
    }

    fn count_edges(&mut self, blocks: &mut Blocks) -> PassCase<'a> {
        let before = edge_states(self.level).into_iter().map(|row| EdgeState {
            mid: STALE,
            child: STALE,
            marks: row.marks | 0xff00_0000,
            ..row
        });
        let before: Vec<EdgeState> = before.collect();
        let counts_before = blocks.words();
        let Level {
            mesh,
            items,
            edges,
            faces,
        } = &mut *self.level;
        let counted = items.edges.chunks(BLOCK);
        let counted = counted.map(|items| block(count_edges(mesh, items, faces, edges), 0));
        blocks.edges = counted.collect();
        let after = edge_states(self.level).into_iter().zip(&before);
        let after = after.map(|(row, &before)| EdgeState {
            marks: row.marks,
            ..before
        });
        self.case(
            "count_edges",
            self.args().edge_blocks,
            [
                ("edge_joins", edge_joins(&self.level.mesh.edges)),
                ("face_sides", words(face_sides(self.level))),
                ("edge_states", words(before.iter().copied())),
                ("block_counts", counts_before),
            ],
            [
                ("edge_states", words(after)),
                ("block_counts", blocks.words()),
            ],
        )
    }

    fn count_faces(&mut self, blocks: &mut Blocks) -> PassCase<'a> {
        let before = blocks.words();
        let Level {
            mesh, items, faces, ..
        } = &*self.level;
        let triangles = |&f: &u32| match faces[f as usize].mark {
            SplitMark::Split => 0,
            _ => 1 + finer(mesh, f, faces),
        };
        let counted = items.faces.chunks(BLOCK).map(|items| {
            let triangles = items.iter().map(triangles).sum();
            block(count_faces(items, faces), triangles)
        });
        blocks.faces = counted.collect();
        self.case(
            "count_faces",
            self.args().face_blocks,
            [
                ("face_sides", words(face_sides(self.level))),
                ("block_counts", before),
            ],
            [("block_counts", blocks.words())],
        )
    }

    fn scan(&mut self, blocks: &mut Blocks) -> PassCase<'a> {
        let before = blocks.words();
        let sizes_before = LevelSizes {
            made: stale_sizes().made,
            ..self.sizes
        };
        let (made, triangles) = blocks.scan();
        self.sizes.made = made;
        let next = self.sizes.next(triangles);
        let at = self.index as usize;
        let mut sizes = [stale_sizes(); LEVELS];
        sizes[at] = sizes_before;
        let sizes_before = words(sizes);
        sizes[at..at + 2].copy_from_slice(&[self.sizes, next]);
        let mut args = stale(16 * LEVELS);
        let args_before = args.clone();
        let written = words([self.args(), LevelArgs::new(&next)]);
        args[16 * at..16 * at + 32].copy_from_slice(&written);
        self.case(
            "scan",
            [1; 3],
            [
                ("block_counts", before),
                ("level_sizes", sizes_before),
                ("level_args", args_before),
            ],
            [
                ("block_counts", blocks.words()),
                ("level_sizes", words(sizes)),
                ("level_args", args),
            ],
        )
    }
}
