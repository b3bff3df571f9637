//! Parallel sweeps with fixed chunks.
//!
//! Work is cut by sample number, never by thread count, and partial results are joined in sample
//! order: the bits of a sum do not depend on how many threads took part.

use core::ops::Range;
use rayon::prelude::*;

/// Samples per chunk: large enough to hide the cost of handing it out, small enough that two
/// threads stay busy at 60,000 samples.
pub const CHUNK: usize = 2048;

/// The ranges that a sweep over `n` samples is cut into.
pub fn chunks(n: usize) -> impl IndexedParallelIterator<Item = Range<usize>> {
    (0..n.div_ceil(CHUNK))
        .into_par_iter()
        .map(move |c| c * CHUNK..((c + 1) * CHUNK).min(n))
}

/// Runs `work` on every chunk and returns its results in sample order.
pub fn map_chunks<T: Send>(n: usize, work: impl Fn(Range<usize>) -> T + Sync + Send) -> Vec<T> {
    chunks(n).map(work).collect()
}

/// `value(i)` for every `i` below `n`, in order.
///
/// ```
/// # use bevy_pangaea::parallel;
/// assert_eq!(parallel::map(5, |i| i * i), [0, 1, 4, 9, 16]);
/// ```
pub fn map<T: Send>(n: usize, value: impl Fn(u32) -> T + Sync + Send) -> Vec<T> {
    // Straight into their places: the cuts change no value, and memory is touched once.
    let numbers = (0..n as u32).into_par_iter().with_min_len(CHUNK);
    numbers.map(value).collect()
}

/// The sum of `value(i)` over all `i` below `n`, added in order within chunks and then over chunks:
/// the same bits on any number of threads.
///
/// ```
/// # use bevy_pangaea::parallel;
/// assert_eq!(parallel::sum(100_000, |i| i as f64), 4_999_950_000.0);
/// ```
pub fn sum(n: usize, value: impl Fn(usize) -> f64 + Sync + Send) -> f64 {
    map_chunks(n, |range| range.map(&value).sum::<f64>())
        .into_iter()
        .sum()
}
