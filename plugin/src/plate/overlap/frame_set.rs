//! Sets of frames as 64-bit words.

/// Adds a frame to a set.
#[inline]
pub(super) fn insert(words: &mut [u64], id: usize) {
    words[id / 64] |= 1 << (id % 64);
}

/// The frames of a set, in order.
#[inline]
pub(super) fn members(words: &[u64]) -> Members<'_> {
    let (&rest, later) = words.split_first().unwrap_or((&0, &[]));
    Members {
        rest,
        base: 0,
        later,
    }
}

/// See [`members`].
pub(super) struct Members<'a> {
    /// The members of the present word that are still to come.
    rest: u64,
    /// Number of the first frame of the present word.
    base: usize,
    later: &'a [u64],
}

impl Iterator for Members<'_> {
    type Item = usize;

    #[inline]
    fn next(&mut self) -> Option<usize> {
        while self.rest == 0 {
            let (&word, later) = self.later.split_first()?;
            (self.rest, self.later) = (word, later);
            self.base += 64;
        }
        let bit = self.rest.trailing_zeros() as usize;
        // Clears the lowest bit that is set.
        self.rest &= self.rest - 1;
        Some(self.base + bit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_are_what_was_inserted() {
        let mut words = [0; 4];
        let frames = [0, 5, 63, 64, 200];
        frames.iter().rev().for_each(|&id| insert(&mut words, id));
        assert_eq!(members(&words).collect::<Vec<_>>(), frames);
        assert_eq!(members(&[]).next(), None);
    }
}
