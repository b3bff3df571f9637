//! Tables of a few among half a million items: what a table of all would cost per view or engine.
//! They are only looked up; the order of a hash table decides nothing.

use super::seed::pcg;
use core::hash::{BuildHasherDefault, Hasher};
use std::collections::{HashMap, HashSet};

/// Places of a few among many items.
pub(super) type Places = HashMap<u32, u32, BuildHasherDefault<NumberHasher>>;

/// A few among many items.
pub(super) type Numbers = HashSet<u32, BuildHasherDefault<NumberHasher>>;

/// Hashes one 32-bit number; the standard hasher takes four times as long.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct NumberHasher(u64);

impl Hasher for NumberHasher {
    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.write_u32(u32::from(byte));
        }
    }

    fn write_u32(&mut self, number: u32) {
        // A table uses the low bits and the top ones: pcg mixes the first, 2⁶⁴ over the golden
        // ratio the second.
        self.0 = u64::from(pcg(number ^ self.0 as u32)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }

    fn finish(&self) -> u64 {
        self.0
    }
}
