//! How many points are answered at once: few at first, for a reader who wants few, then as many as
//! are quick. The answers do not depend on it.

use std::time::{Duration, Instant};

/// Points of the first block: what one thread takes at a time.
const FEWEST: usize = 64;
/// Most points of a block: the slowest take half a second on two cores.
const MOST: usize = 1024;

/// Blocks that take less are doubled.
const SHORT: Duration = Duration::from_millis(100);
/// Blocks that take more are halved.
const LONG: Duration = Duration::from_millis(400);

/// How many points are answered at once.
pub(super) struct Pace(usize);

impl Default for Pace {
    fn default() -> Self {
        Self(FEWEST)
    }
}

impl Pace {
    /// Most points of the next block.
    pub(super) fn points(&self) -> usize {
        self.0
    }

    /// Answers a block of so many points, and sees how long that takes.
    pub(super) fn measure<T>(&mut self, points: usize, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        self.adapt(points, start.elapsed());
        result
    }

    fn adapt(&mut self, points: usize, time: Duration) {
        if time > LONG {
            self.0 = (self.0 / 2).max(FEWEST);
        } else if time < SHORT && points == self.0 {
            self.0 = (self.0 * 2).min(MOST);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The points of the block after full ones that take so many ms each.
    fn after(times: &[u64]) -> usize {
        let mut pace = Pace::default();
        for &time in times {
            pace.adapt(pace.points(), Duration::from_millis(time));
        }
        pace.points()
    }

    #[test]
    fn blocks_grow_while_they_are_quick_and_shrink_when_they_are_slow() {
        assert_eq!(after(&[]), 64);
        assert_eq!(after(&[10, 10]), 256);
        assert_eq!(after(&[10, 10, 200]), 256);
        assert_eq!(after(&[10, 10, 500]), 128);
        assert_eq!(after(&[1; 20]), 1024);
        assert_eq!(after(&[9000; 20]), 64);
    }

    #[test]
    fn a_block_that_was_not_full_says_nothing_of_larger_ones() {
        let mut pace = Pace::default();
        assert_eq!(pace.measure(1, || 7), 7);
        assert_eq!(pace.points(), 64);
    }
}
