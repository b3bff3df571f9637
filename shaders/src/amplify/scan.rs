//! Pass: exclusive prefix sums over blocks, which give every block its place among what all make.

use super::count::LevelCounts;

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_follow_one_another() {
        let counts = |[mids, halves]: [u32; 2]| LevelCounts {
            mids,
            halves,
            ..LevelCounts::default()
        };
        let mut blocks = [[2, 4], [0, 0], [1, 0], [4, 6]].map(counts);
        assert_eq!(scan(&mut blocks), counts([7, 10]));
        let wanted = [[0, 0], [2, 4], [2, 4], [3, 4]].map(counts);
        assert_eq!(blocks, wanted);
    }
}
