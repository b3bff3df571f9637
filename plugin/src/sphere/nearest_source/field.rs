//! The nearest source of every sample, packed into words that several threads may write.

use crate::sphere::chord::angle_of_chord;
use core::sync::atomic::{AtomicU64, Ordering::Relaxed};
use rayon::prelude::*;

/// Source number of a sample that nothing has reached.
pub const UNREACHED: u32 = u32::MAX;

/// Distance and source of a sample that nothing has reached.
pub(super) const NOTHING: u64 = pack(f32::INFINITY, UNREACHED);

/// Words per unit of parallel work.
const WORDS_PER_TASK: usize = 1 << 14;

/// The nearest source of every sample, and the squared chord to it.
///
/// Both are packed into one word of 64 bits: the bits of the squared chord, an f32, in the upper
/// half, the number of the source in the lower. Words compare as the chords do, since the bits of
/// floats that are not negative rise with them, and words of one chord as the numbers do.
#[derive(Debug, Default)]
pub struct SourceField(Vec<AtomicU64>);

impl Clone for SourceField {
    fn clone(&self) -> Self {
        let words = self.0.iter().map(|word| word.load(Relaxed));
        Self(words.map(AtomicU64::new).collect())
    }
}

#[inline]
pub(super) const fn pack(chord2: f32, source: u32) -> u64 {
    (chord2.to_bits() as u64) << 32 | source as u64
}

#[inline]
fn chord2(word: u64) -> f32 {
    f32::from_bits((word >> 32) as u32)
}

impl SourceField {
    /// The field of `n` samples that nothing has reached.
    pub fn new(n: usize) -> Self {
        Self((0..n).map(|_| AtomicU64::new(NOTHING)).collect())
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are no samples.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The source nearest to sample `i`, or [`UNREACHED`].
    #[inline]
    pub fn source(&self, i: u32) -> u32 {
        self.get(i) as u32
    }

    /// Source and distance in radians of sample `i`, if it was reached.
    #[inline]
    pub fn nearest(&self, i: u32) -> Option<(u32, f32)> {
        let word = self.get(i);
        let source = word as u32;
        (source != UNREACHED).then(|| {
            let chord = f64::from(chord2(word)).sqrt();
            (source, angle_of_chord(chord) as f32)
        })
    }

    /// Makes `source` the nearest source of sample `i`, at the squared chord `chord2`.
    pub fn set(&self, i: u32, source: u32, chord2: f32) {
        self.put(i, pack(chord2, source));
    }

    /// Forgets sample `i`.
    pub fn reset(&self, i: u32) {
        self.put(i, NOTHING);
    }

    /// Forgets all samples.
    pub fn clear(&mut self) {
        let words = self.0.par_iter_mut().with_min_len(WORDS_PER_TASK);
        words.for_each(|word| *word.get_mut() = NOTHING);
    }

    // Words are independent of each other, and no search reads what another one writes: no order is
    // needed.
    #[inline]
    pub(super) fn get(&self, i: u32) -> u64 {
        self.0[i as usize].load(Relaxed)
    }

    #[inline]
    pub(super) fn put(&self, i: u32, word: u64) {
        self.0[i as usize].store(word, Relaxed);
    }
}
